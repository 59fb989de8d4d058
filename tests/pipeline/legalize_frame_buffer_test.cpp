// SPDX-License-Identifier: MIT
#include "pipeline/legalize/frame_buffer.h"

#include "pipeline/check/memory_map.h"
#include "pipeline/check/needed_pixels.h"
#include "pipeline/legalize/copies.h"
#include "pipeline/legalize/formats.h"
#include "pipeline/legalize/halving_copy.h"
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

// The picture shows the left half of "whole", which holds a texture's bytes, halved to "half": row y of channel c the sums S = y.
Frame halving(TargetFormat format, const std::vector<std::uint8_t>& texels, int width, int height) {
    Frame frame             = small_frame(width / 2, height / 2);
    frame.targets[0].format = TargetFormat::X8R8G8B8;
    frame.targets.push_back({.name = "whole", .format = format, .width = width, .height = height});
    frame.targets.push_back({.name = "half", .format = format, .width = width / 2, .height = height / 2});
    const auto show = [&](std::int32_t target, const PixelRect& rect, const TextureBinding& shown,
                          TextureFilter filter) {
        Pass pass;
        pass.color                  = {target};
        pass.state.stages[0]        = kTextureOnly;
        pass.state.stages[0].filter = filter;
        DrawRectangle draw          = rectangle(rect, 0xffffffff);
        draw.textures[0]            = shown;
        pass.draws                  = {draw};
        return pass;
    };
    const TextureId texture = add_texture(frame, TextureFormat::A8R8G8B8, width, height, texels);
    const PixelRect whole{0, 0, width, height}, half{0, 0, width / 2, height / 2};
    frame.passes = {show(1, whole, bound(texture), TextureFilter::Point),
                    show(2, half, {.texture = {}, .target = {1}}, TextureFilter::Linear),
                    show(0, half, {.texture = {}, .target = {2}}, TextureFilter::Point)};
    for (Pass& pass : frame.passes)
        pass.state.stages[0].address_u = pass.state.stages[0].address_v = TextureAddress::Clamp;
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

TEST_CASE("a rectangle that halves a target becomes a copy that halves, in tiles", "[frame_buffer]") {
    constexpr std::string_view kBefore = R"(
targets [
    "picture" { format X8R8G8B8 width 32 height 32 }
    "whole" { format R6G6B6A6 width 32 height 32 }
    "half" { format R6G6B6A6 width 16 height 16 }
]
passes [
    "draw" { color "whole" draws [ rectangle { x1 32 y1 32 color 0x80ffffff } ] }
    "halve" {
        color "half"
        state {
            stages [ { color_op SELECTARG1 alpha_op SELECTARG1 filter LINEAR address_u CLAMP address_v CLAMP } ]
            scissor { x0 5 y0 6 x1 9 y1 13 }
        }
        draws [ rectangle { x1 32 y1 32 uv [ { u1 2 v1 2 } ] textures [ { target "whole" } ] } ]
    }
    "show" {
        color "picture"
        state { stages [ { color_op SELECTARG1 alpha_op SELECTARG1 } ] scissor { x0 5 y0 6 x1 9 y1 13 } }
        draws [ rectangle { x1 16 y1 16 textures [ { target "half" } ] } ]
    }
]
)";
    check_rewrite(&share_frame_buffer, "gamecube", kBefore, R"(
targets [
    "picture" { format X8R8G8B8 width 32 height 32 }
    "whole" { format R6G6B6A6 width 32 height 32 }
    "half" { format R6G6B6A6 width 16 height 16 }
    "half, copy" { width 16 height 16 }
]
passes [
    "draw" { color "whole" draws [ rectangle { x1 32 y1 32 color 0x80ffffff } ] }
    "halve" {
        color "half, copy"
        draws [ copy { source "whole" from { x0 8 y0 8 x1 24 y1 32 } x 4 y 4 halve true } ]
    }
    "show" {
        color "picture"
        state { stages [ { color_op SELECTARG1 alpha_op SELECTARG1 } ] scissor { x0 5 y0 6 x1 9 y1 13 } }
        draws [ rectangle { x1 16 y1 16 textures [ { target "half, copy" } ] } ]
    }
]
)");
    // Not what also draws depth, blends, masks, shows another place, or is seen beside its limits.
    const auto halves = [&](auto change) {
        Frame frame = parsed(kBefore);
        change(frame);
        const Frame got = rewritten(frame, &share_frame_buffer, "gamecube");
        return std::any_of(got.passes.begin(), got.passes.end(), [](const Pass& pass) {
            const auto* copy = pass.draws.empty() ? nullptr : std::get_if<CopyRectangle>(&pass.draws[0]);
            return copy != nullptr && copy->halve;
        });
    };
    const auto draw = [](Frame& frame) -> DrawRectangle& { return std::get<DrawRectangle>(frame.passes[1].draws[0]); };
    CHECK(halves([](Frame&) {}));
    CHECK_FALSE(halves([](Frame& frame) { frame.passes[1].state.blend.dest = BlendFactor::One; }));
    CHECK_FALSE(halves([](Frame& frame) { frame.passes[1].state.color_mask.alpha = false; }));
    CHECK_FALSE(halves([](Frame& frame) { frame.passes[1].state.alpha_test.func = CompareFunc::Less; }));
    CHECK_FALSE(halves([](Frame& frame) { frame.passes[1].clear.color = Argb{0}; }));
    CHECK_FALSE(halves([](Frame& frame) { frame.passes[1].state.stages[0].filter = TextureFilter::Point; }));
    CHECK_FALSE(halves([](Frame& frame) { frame.passes[1].state.stages[0].alpha_op = TextureOp::SelectArg2; }));
    CHECK_FALSE(halves([&](Frame& frame) { draw(frame).x0 += 0.0625f; }));
    CHECK_FALSE(halves([&](Frame& frame) { draw(frame).uv[0].v1 = 1.0f; }));
    CHECK_FALSE(halves([&](Frame& frame) { draw(frame).x1 = 8, draw(frame).uv[0].u1 = 0.5f; }));
    CHECK_FALSE(halves([](Frame& frame) { frame.passes[2].state.scissor = {}; }));
    CHECK(halves([](Frame& frame) {
        frame.passes[1].state.scissor = {4, 4, 12, 16};
        frame.passes[2].state.scissor = {};
    }));
}

TEST_CASE("what is halved stands for what was drawn before", "[frame_buffer]") {
    std::vector<std::uint8_t> texels(32 * 32 * 4, 0x80);
    Frame frame  = halving(TargetFormat::R6G6B6A6, texels, 32, 32);
    Pass before  = frame.passes[0];
    before.color = {2};
    before.state = {};
    before.draws = {rectangle({0, 0, 16, 16}, 0xff00ff00)};
    frame.passes.insert(frame.passes.begin() + 1, before);
    const Frame got = rewritten(frame, &share_frame_buffer, "gamecube");
    // Four values of 32 are 128, and that is 130 of 255.
    for (const std::uint32_t pixel : pixels_of(got)) REQUIRE(pixel == 0xff828282);
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

TEST_CASE("halved by a copy, four bytes are S >> 2, and four of 6 bits a whole byte", "[frame_buffer]") {
    // Column x holds four texels with the sum 4 * x + y in row y.
    std::vector<std::uint8_t> texels(512 * 8 * 4);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 256; ++x)
            for (int i = 0; i < 4; ++i)
                for (int channel = 0; channel < 4; ++channel)
                    texels[static_cast<std::size_t>(((2 * y + i / 2) * 512 + 2 * x + i % 2) * 4 + channel)] =
                        static_cast<std::uint8_t>(std::min(255, x + (i < y ? 1 : 0)));
    const TargetFormat format = GENERATE(TargetFormat::X8R8G8B8, TargetFormat::R6G6B6A6);
    Frame frame               = halving(format, texels, 512, 8);
    const Frame got           = rewritten(frame, &share_frame_buffer, "gamecube");
    REQUIRE(std::get<CopyRectangle>(got.passes[1].draws[0]).halve);
    const std::vector<std::uint32_t> pixels = pixels_of(got);
    int wrong                               = 0;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 256; ++x) {
            int sum = 0;
            for (int i = 0; i < 4; ++i) {
                const int byte = std::min(255, x + (i < y ? 1 : 0));
                sum += format == TargetFormat::R6G6B6A6 ? byte >> 2 : byte;
            }
            const int want = format == TargetFormat::R6G6B6A6 ? sum + (sum >> 6) : sum >> 2;
            wrong +=
                pixels[static_cast<std::size_t>(y * 256 + x)] != 0xff000000u + static_cast<unsigned>(want) * 0x010101u;
        }
    CHECK(wrong == 0);
    // Drawn, it is off by rounding: by 1 for bytes, and for 6 bits by what the target cuts off, 3.
    const std::vector<std::uint32_t> drawn = pixels_of(frame);
    const int most                         = format == TargetFormat::R6G6B6A6 ? 4 : 1;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        REQUIRE(std::abs(static_cast<int>(pixels[i] & 255) - static_cast<int>(drawn[i] & 255)) <= most);
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
