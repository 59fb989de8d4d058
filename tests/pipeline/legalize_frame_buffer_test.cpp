// SPDX-License-Identifier: MIT
#include "pipeline/legalize/frame_buffer.h"

#include "pipeline/check/memory_map.h"
#include "pipeline/check/needed_pixels.h"
#include "pipeline/legalize/copies.h"
#include "pipeline/legalize/formats.h"
#include "tests/support/garbage.h"
#include "tests/support/one_buffer.h"
#include "tests/support/random.h"
#include "tests/support/random_frame.h"
#include "tests/support/rewritten.h"

using namespace pipeline;
using namespace test_support;

namespace {

const Profile& gamecube() {
    return *find_profile("gamecube");
}

// Those of depth come first.
bool is_clash_of_depth(const Frame& frame, const MemoryClash& clash) {
    return is_depth(frame.targets[static_cast<std::size_t>(clash.one.index)].format);
}

// A random frame with the chip's formats and copies.
Frame random_gamecube_frame(std::uint32_t seed) {
    RewriteNotes notes;
    return draw_copies(rewrite_formats(random_frame(seed), gamecube(), notes), gamecube(), notes);
}

// No buffer starts as zeros: each target is cleared before it is used.
Frame with_starts(Frame frame) {
    for (std::size_t i = 0; i < frame.targets.size(); ++i) {
        if (is_depth(frame.targets[i].format)) continue;
        const TargetId target{static_cast<std::int32_t>(i)};
        std::size_t first = 0;
        while (first < frame.passes.size() && needed_pixels(frame, target)[first].empty()) ++first;
        Pass clear;
        clear.color       = target;
        clear.clear.color = Argb{0};
        insert_passes(frame, first, {clear});
    }
    return frame;
}

}  // namespace

TEST_CASE("what is read is copied before, in tiles, once", "[frame_buffer]") {
    check_rewrite(&share_frame_buffer, "gamecube", R"(
targets [ "picture" { format X8R8G8B8 width 16 height 16 } "part" { format R6G6B6A6 width 16 height 16 } ]
passes [
    "draw" { color "part" state { scissor { x0 3 y0 4 x1 10 y1 8 } } draws [ rectangle { x1 16 y1 16 color 0x80ffffff } ] }
    "show" {
        color "picture"
        state { stages [ { color_op SELECTARG1 alpha_op SELECTARG1 } ] }
        draws [ rectangle { x1 16 y1 16 textures [ { target "part" } ] } ]
    }
    "show again" {
        color "picture"
        state { stages [ { color_op SELECTARG1 alpha_op SELECTARG1 } ] }
        draws [ rectangle { x1 4 y1 4 textures [ { target "part" } ] } ]
    }
]
)",
                  R"(
targets [
    "picture" { format X8R8G8B8 width 16 height 16 }
    "part" { format R6G6B6A6 width 16 height 16 }
    "part, copy" { width 16 height 16 }
]
passes [
    "draw" { color "part" state { scissor { x0 3 y0 4 x1 10 y1 8 } } draws [ rectangle { x1 16 y1 16 color 0x80ffffff } ] }
    "part: copied" { color "part, copy" draws [ copy { source "part" from { x1 16 y1 8 } } ] }
    "show" {
        color "picture"
        state { stages [ { color_op SELECTARG1 alpha_op SELECTARG1 } ] }
        draws [ rectangle { x1 16 y1 16 textures [ { target "part, copy" } ] } ]
    }
    "show again" {
        color "picture"
        state { stages [ { color_op SELECTARG1 alpha_op SELECTARG1 } ] }
        draws [ rectangle { x1 4 y1 4 textures [ { target "part, copy" } ] } ]
    }
]
)");
}

TEST_CASE("a target makes room for another with its depth, and is brought back", "[frame_buffer]") {
    check_rewrite(&share_frame_buffer, "gamecube", R"(
arithmetic { pixel_center 9 }
targets [
    "picture" { format X8R8G8B8 width 64 height 64 }
    "cloud" { format R6G6B6A6 width 64 height 64 }
    "depth" { format D24 width 64 height 64 }
]
passes [
    "ground" {
        color "picture" depth "depth" clear { color 0xff336699 depth 1 }
        state { depth { func LESSEQUAL write true } }
        draws [ rectangle { x1 64 y1 40 depth 0.5 color 0xff994411 } ]
    }
    "cloud" {
        color "cloud" depth "depth" clear { color 0x00ffffff }
        state { depth { func LESSEQUAL } scissor { x0 10 y0 12 x1 30 y1 33 } }
        draws [ rectangle { x0 4 y0 4 x1 50 y1 28 depth 0.25 color 0x80ffffff } ]
    }
    "composite" {
        color "picture"
        state {
            blend { source SRCALPHA dest INVSRCALPHA }
            stages [ { color_op SELECTARG1 alpha_op SELECTARG1 address_u CLAMP address_v CLAMP } ]
            scissor { x0 10 y0 12 x1 24 y1 24 }
        }
        draws [ rectangle { x1 64 y1 64 textures [ { target "cloud" } ] } ]
    }
]
)",
                  R"(
arithmetic { pixel_center 9 }
targets [
    "picture" { format X8R8G8B8 width 64 height 64 }
    "cloud" { format R6G6B6A6 width 64 height 64 }
    "depth" { format D24 width 64 height 64 }
    "picture, copy" { width 64 height 64 }
    "cloud, copy" { width 64 height 64 }
]
passes [
    "ground" {
        color "picture" depth "depth" clear { color 0xff336699 depth 1 }
        state { depth { func LESSEQUAL write true } }
        draws [ rectangle { x1 64 y1 40 depth 0.5 color 0xff994411 } ]
    }
    "picture: copied" {
        color "picture, copy"
        draws [ copy { source "picture" from { x0 8 y0 8 x1 32 y1 40 } x 8 y 8 } ]
    }
    "cloud" { color "cloud" clear { color 0x00ffffff } state { scissor { x0 8 y0 8 x1 32 y1 40 } } }
    "cloud" {
        color "cloud" depth "depth"
        state { depth { func LESSEQUAL } scissor { x0 10 y0 12 x1 30 y1 33 } }
        draws [ rectangle { x0 4 y0 4 x1 50 y1 28 depth 0.25 color 0x80ffffff } ]
    }
    "cloud: copied" {
        color "cloud, copy"
        draws [ copy { source "cloud" from { x0 8 y0 8 x1 24 y1 24 } x 8 y 8 } ]
    }
    "picture: brought back" {
        color "picture"
        state { stages [ { color_op SELECTARG1 alpha_op SELECTARG1 address_u CLAMP address_v CLAMP } ] }
        draws [
            rectangle {
                x0 8.0625 y0 8.0625 x1 24.0625 y1 24.0625
                uv [ { u0 0.125 v0 0.125 u1 0.375 v1 0.375 } ] textures [ { target "picture, copy" } ]
            }
        ]
    }
    "composite" {
        color "picture"
        state {
            blend { source SRCALPHA dest INVSRCALPHA }
            stages [ { color_op SELECTARG1 alpha_op SELECTARG1 address_u CLAMP address_v CLAMP } ]
            scissor { x0 10 y0 12 x1 24 y1 24 }
        }
        draws [ rectangle { x1 64 y1 64 textures [ { target "cloud, copy" } ] } ]
    }
    "picture: brought back" {
        color "picture"
        state { stages [ { color_op SELECTARG1 alpha_op SELECTARG1 address_u CLAMP address_v CLAMP } ] }
        draws [
            rectangle {
                x0 8.0625 y0 24.0625 x1 32.0625 y1 40.0625
                uv [ { u0 0.125 v0 0.375 u1 0.5 v1 0.625 } ] textures [ { target "picture, copy" } ]
            }
            rectangle {
                x0 24.0625 y0 8.0625 x1 32.0625 y1 24.0625
                uv [ { u0 0.375 v0 0.125 u1 0.5 v1 0.375 } ] textures [ { target "picture, copy" } ]
            }
        ]
    }
]
)");
}

TEST_CASE("what a pass cleared is kept while it copies a target that is brought back", "[frame_buffer]") {
    check_rewrite(&share_frame_buffer, "gamecube", R"(
targets [
    "picture" { format X8R8G8B8 width 640 height 400 }
    "part" { format R6G6B6A6 width 640 height 400 }
]
passes [
    "part" { color "part" draws [ rectangle { x1 640 y1 400 color 0x80ffffff } ] }
    "picture" {
        color "picture" clear { color 0xff336699 }
        draws [ copy { source "part" from { x0 8 y0 8 x1 24 y1 16 } x 16 y 8 } ]
    }
]
)",
                  R"(
targets [
    "picture" { format X8R8G8B8 width 640 height 400 }
    "part" { format R6G6B6A6 width 640 height 400 }
    "part, copy" { width 640 height 400 }
    "picture, copy" { width 640 height 400 }
]
passes [
    "part" { color "part" draws [ rectangle { x1 640 y1 400 color 0x80ffffff } ] }
    "part: copied" {
        color "part, copy"
        draws [ copy { source "part" from { x0 8 y0 8 x1 24 y1 16 } x 8 y 8 } ]
    }
    "picture" { color "picture" clear { color 0xff336699 } }
    "picture: copied" {
        color "picture, copy"
        draws [ copy { source "picture" from { x0 8 y0 8 x1 16 y1 16 } x 8 y 8 } ]
    }
    "part: brought back" {
        color "part"
        state { stages [ { color_op SELECTARG1 alpha_op SELECTARG1 address_u CLAMP address_v CLAMP } ] }
        draws [
            rectangle {
                x0 8 y0 8 x1 24 y1 16
                uv [ { u0 0.0125 v0 0.02 u1 0.0375 v1 0.04 } ] textures [ { target "part, copy" } ]
            }
        ]
    }
    "picture: copied" {
        color "picture, copy"
        draws [ copy { source "picture" from { x0 24 y0 8 x1 32 y1 16 } x 24 y 8 } ]
    }
    "picture" {
        color "picture, copy"
        draws [ copy { source "part" from { x0 8 y0 8 x1 24 y1 16 } x 16 y 8 } ]
    }
    "picture: brought back" {
        color "picture"
        state { stages [ { color_op SELECTARG1 alpha_op SELECTARG1 address_u CLAMP address_v CLAMP } ] }
        draws [
            rectangle {
                x0 8 y0 8 x1 32 y1 16
                uv [ { u0 0.0125 v0 0.02 u1 0.05 v1 0.04 } ] textures [ { target "picture, copy" } ]
            }
        ]
    }
]
)");
}

TEST_CASE("what writes depth keeps to its limits", "[frame_buffer]") {
    Frame frame     = parsed(R"(
targets [
    "picture" { format X8R8G8B8 width 64 height 64 }
    "cloud" { format R6G6B6A6 width 64 height 64 }
    "depth" { format D24 width 64 height 64 }
]
passes [
    "ground" { color "picture" depth "depth" clear { color 0xff336699 depth 1 } }
    "cloud" {
        color "cloud" depth "depth"
        state { depth { write true } scissor { x0 10 y0 12 x1 30 y1 33 } }
        draws [ rectangle { x1 64 y1 64 depth 0.25 color 0x80ffffff } ]
    }
    "behind" {
        color "picture" depth "depth"
        state { depth { func GREATER } }
        draws [ rectangle { x1 64 y1 64 depth 0.5 color 0xff994411 } ]
    }
]
)");
    const Frame got = rewritten(frame, &share_frame_buffer, "gamecube");
    CHECK(differing_pixels(got, frame) == 0);
    CHECK(lay_out(got, gamecube()).clashes.empty());
}

TEST_CASE("a frame that has room and reads no target is left alone, and so are other chips' and what is too large",
          "[frame_buffer]") {
    constexpr std::string_view kShown = R"(
targets [ "picture" { format X8R8G8B8 width 641 height 16 } "part" { format R6G6B6A6 width 16 height 16 } ]
passes [
    "draw" { color "part" draws [ rectangle { x1 16 y1 16 color 0x80ffffff } ] }
    "show" {
        color "picture"
        state { stages [ { color_op SELECTARG1 alpha_op SELECTARG1 } ] }
        draws [ rectangle { x1 16 y1 16 textures [ { target "part" } ] } ]
    }
]
)";
    for (const std::string_view chip : {"ideal", "dx7", "ps2", "xbox", "gamecube"})
        check_left_alone(&share_frame_buffer, chip, kShown);
    check_left_alone(&share_frame_buffer, "gamecube", R"(
targets [
    "picture" { format X8R8G8B8 width 640 height 400 }
    "part" { format R6G6B6A6 width 64 height 64 }
    "copy" { width 64 height 64 }
    "depth" { format D24 width 640 height 400 }
]
passes [
    "draw" { color "picture" depth "depth" clear { color 0xff000000 depth 1 } }
    "part" { color "part" draws [ rectangle { x1 16 y1 16 color 0x80ffffff } ] }
    "copy" { color "copy" draws [ copy { source "part" from { x1 16 y1 16 } } ] }
    "show" {
        color "picture"
        state { stages [ { color_op SELECTARG1 alpha_op SELECTARG1 } ] }
        draws [ rectangle { x1 16 y1 16 textures [ { target "copy" } ] } ]
    }
]
)");
}

TEST_CASE("random frames keep each byte, and fit in one buffer", "[frame_buffer]") {
    // The largest of their targets fits, and not much beside it.
    Profile chip                   = gamecube();
    chip.limits.frame_buffer_width = chip.limits.frame_buffer_height = 150;
    int apart = 0, in_one_place = 0, lost = 0;
    for (std::uint32_t seed = 1; seed <= 3000; ++seed) {
        INFO("seed " << seed);
        const Frame frame = with_starts(random_gamecube_frame(seed));
        RewriteNotes notes;
        const Frame got = share_frame_buffer(frame, chip, notes);
        require_valid(got);
        REQUIRE(notes.empty() == (got == frame));
        const auto want = pixels_of(frame);
        REQUIRE((pixels_of(got) == want));
        // Only depth is left to be needed for two at one place, or to need more than one.
        const MemoryMap before = lay_out(frame, chip), map = lay_out(got, chip);
        for (const MemoryClash& clash : map.clashes) REQUIRE(is_clash_of_depth(got, clash));
        const auto depths = std::count_if(got.targets.begin(), got.targets.end(),
                                          [](const Target& target) { return is_depth(target.format); });
        if (depths <= 1) REQUIRE(map.regions[0].over == 0);
        REQUIRE((pixels_of(with_one_buffer(got, chip)) == want));
        RewriteNotes again;
        if (depths <= 1) REQUIRE((share_frame_buffer(got, chip, again) == got));
        if (got == frame) continue;
        const bool had_room = before.clashes.empty() && before.regions[0].over == 0;
        ++(had_room ? apart : in_one_place);
        lost += !had_room && pixels_of(with_one_buffer(frame, chip)) != want;
    }
    CHECK(apart > 80);
    CHECK(in_one_place > 20);
    CHECK(lost > 0);
}

TEST_CASE("no target of the buffer is read as a texture, whatever the frame", "[frame_buffer]") {
    int read = 0;
    for (std::uint32_t seed = 1; seed <= 500; ++seed) {
        INFO("seed " << seed);
        const auto finds = [](const Frame& frame) {
            const std::vector<ChipFinding> found = check(frame, gamecube());
            return std::any_of(found.begin(), found.end(), [](const ChipFinding& finding) {
                return finding.where.ends_with(".target") && (finding.uses == "R6G6B6A6" || finding.uses == "X8R8G8B8");
            });
        };
        const Frame frame = random_gamecube_frame(seed);
        read += finds(frame);
        REQUIRE_FALSE(finds(rewritten(frame, &share_frame_buffer, "gamecube")));
    }
    CHECK(read > 40);
}
