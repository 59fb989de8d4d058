// SPDX-License-Identifier: MIT
#include "pipeline/check/needed_pixels.h"

#include <string>

#include "pipeline/legalize/wanted_pixels.h"
#include "tests/support/garbage.h"
#include "tests/support/random_frame.h"
#include "tests/support/rewritten.h"

using namespace pipeline;
using namespace test_support;

namespace {

// "0: x0 y0 x1 y1, x0 y0 x1 y1 | 2: ...": the passes that need anything.
std::string text_of(const std::vector<PixelRegion>& needed) {
    std::string text;
    for (std::size_t pass = 0; pass < needed.size(); ++pass) {
        if (needed[pass].empty()) continue;
        text += (text.empty() ? "" : " | ") + std::to_string(pass) + ':';
        for (const PixelRect& part : needed[pass].parts())
            for (const int side : {part.x0, part.y0, part.x1, part.y1}) text += ' ' + std::to_string(side);
    }
    return text;
}
std::string needed_text(std::string_view frame, int target) {
    return text_of(needed_pixels(parsed(frame), {target}));
}
std::string wanted_text(std::string_view frame, std::size_t target) {
    return text_of(wanted_pixels(parsed(frame))[target]);
}

constexpr std::string_view kTargets = R"(
targets [ "picture" { width 8 height 8 } "other" { width 8 height 8 } "depth" { format D24 width 8 height 8 } ]
)";
std::string with_passes(std::string_view passes) {
    return std::string(kTargets) + "passes [" + std::string(passes) + "]";
}

}  // namespace

TEST_CASE("pixels are needed from what overwrites them to their last use before the next", "[needed_pixels]") {
    const std::string frame = with_passes(R"(
    "draw" { color "other" draws [ rectangle { x1 8 y1 4 color 0xff000000 } ] }
    "over" { color "other" state { blend { source ONE dest ONE } } draws [ rectangle { x1 8 y1 2 color 0xff000000 } ] }
    "copy" { color "picture" draws [ copy { source "other" from { x1 4 y1 4 } } ] }
    "clear" { color "other" clear { color 0x00000000 } state { scissor { x1 8 y1 4 } } }
    "blend" { color "picture" state { blend { source ONE dest ONE } } draws [ rectangle { x1 2 y1 2 } ] }
    )");
    // Where pass 1 draws it uses what pass 0 left; the copy uses the left half.
    CHECK(needed_text(frame, 1) == "0: 0 0 8 4 | 1: 0 0 4 4 4 0 8 2 | 2: 0 0 4 4 | 3: 0 0 8 4");
    // The rest of the picture is never drawn, and so needed from the start.
    CHECK(needed_text(frame, 0) ==
          "0: 0 4 8 8 4 0 8 4 | 1: 0 4 8 8 4 0 8 4 | 2: 0 0 8 8 | 3: 0 0 8 8 | 4: 0 0 8 8 | 5: 0 0 8 8");
}

TEST_CASE("what is tested, masked, blended or made of triangles overwrites nothing", "[needed_pixels]") {
    const auto is_kept = [](std::string_view state) {
        const Frame frame = parsed(with_passes("\"draw\" { color \"picture\" depth \"depth\" state {" +
                                               std::string(state) + "} draws [ rectangle { x1 8 y1 8 } ] }"));
        return overwritten(frame, frame.passes[0]).empty();
    };
    CHECK_FALSE(is_kept(""));
    CHECK_FALSE(is_kept("depth { write true }"));
    CHECK(is_kept("depth { func LESS }"));
    CHECK(is_kept("alpha_test { func LESS }"));
    CHECK(is_kept("dest_alpha_test ONE"));
    CHECK(is_kept("color_mask { alpha false }"));
    CHECK(is_kept("blend { dest ONE }"));
    CHECK(is_kept("gs_blend { c FIX d CD }"));

    Frame frame           = small_frame(8, 8);
    frame.passes[0].draws = {add_quad(frame, 0xffffffff)};
    CHECK(overwritten(frame, frame.passes[0]).empty());
    CHECK(drawn_to(frame, frame.passes[0]).parts() == std::vector{PixelRect{0, 0, 8, 8}});
    // Colours without alpha have none to mask.
    frame.targets[0].format                = TargetFormat::X8R8G8B8;
    frame.passes[0].draws                  = {rectangle({1, 1, 3, 3}, 0xffffffff)};
    frame.passes[0].state.color_mask.alpha = false;
    CHECK(overwritten(frame, frame.passes[0]).parts() == std::vector{PixelRect{1, 1, 3, 3}});
    CHECK(drawn_to(frame, frame.passes[0]).parts() == std::vector{PixelRect{1, 1, 3, 3}});
}

TEST_CASE("a rectangle covers the pixels whose sample points it holds", "[needed_pixels]") {
    DrawRectangle draw{.x0 = 0.5f, .y0 = 1.0f / 32.0f, .x1 = 3.5f, .y1 = 3.5625f};
    CHECK(covered_pixels({}, draw) == PixelRect{0, 0, 3, 4});
    CHECK(covered_pixels({.pixel_center = 9}, draw) == PixelRect{0, 0, 3, 3});
    CHECK(covered_pixels({.pixel_center = 0}, draw) == PixelRect{1, 0, 4, 4});
    draw.y0 = 3.0f / 32.0f;
    CHECK(covered_pixels({.pixel_center = 1}, draw) == PixelRect{1, 1, 4, 4});
    CHECK(covered_pixels({.snap = SnapRule::Truncate, .pixel_center = 1}, draw) == PixelRect{1, 0, 4, 4});
}

TEST_CASE("depth is needed by the passes that it is met in", "[needed_pixels]") {
    CHECK(needed_text(with_passes(R"(
    "clear" { color "picture" depth "depth" clear { depth 1 } }
    "draw" {
        color "picture" depth "depth"
        state { depth { func LESS write true } scissor { x1 4 y1 4 } } draws [ rectangle { x1 8 y1 8 } ]
    }
    "no depth" { color "picture" depth "depth" draws [ rectangle { x1 8 y1 8 } ] }
    "draw" { color "other" depth "depth" state { depth { func LESS } } draws [ rectangle { x1 8 y1 8 } ] }
    "clear" { color "picture" depth "depth" clear { depth 1 } }
    )"),
                      2) == "0: 0 0 8 8 | 1: 0 0 8 8 | 2: 0 0 8 8 | 3: 0 0 8 8 | 4: 0 0 8 8");
}

TEST_CASE("a texture is needed whole, where the pass reads it", "[needed_pixels]") {
    const auto reading = [](std::string_view stages) {
        return needed_text(with_passes("\"draw\" { color \"other\" draws [ rectangle { x1 2 y1 2 } ] }"
                                       "\"show\" { color \"picture\" state {" +
                                       std::string(stages) +
                                       "} draws [ rectangle { x1 8 y1 8 textures [ { target \"other\" } ] } ] }"),
                           1);
    };
    CHECK(reading("") == "0: 0 0 2 2");
    CHECK(reading("stages [ { color_op SELECTARG1 } ]") == "0: 0 0 2 2 | 1: 0 0 8 8");
}

TEST_CASE("what is needed no more may hold anything, in random frames", "[needed_pixels]") {
    std::int64_t spoiled = 0;
    for (std::uint32_t seed = 1; seed <= 200; ++seed) {
        INFO("seed " << seed);
        const Frame frame = random_frame(seed);
        const auto want   = execute(frame).output;
        for (std::size_t i = 0; i < frame.targets.size(); ++i) {
            const TargetId target{static_cast<std::int32_t>(i)};
            const std::vector<PixelRegion> needed = needed_pixels(frame, target);
            Frame spoilt                          = frame;
            std::size_t added                     = 0;
            PixelRegion used;
            for (std::size_t pass = 0; pass < frame.passes.size(); ++pass) {
                const PixelRegion free         = without(used, needed[pass]);
                const std::vector<Pass> passes = garbage_passes(frame, target, free);
                insert_passes(spoilt, pass + added, passes);
                added += passes.size();
                spoiled += free.pixels();
                used.add(needed[pass]);
            }
            REQUIRE((execute(spoilt).output == want));
        }
    }
    CHECK(spoiled > 50000);
}

TEST_CASE("a target needs zeros where a pass is the first to use it, in random frames", "[needed_pixels]") {
    std::int64_t zeros = 0, others = 0;
    for (std::uint32_t seed = 1; seed <= 200; ++seed) {
        INFO("seed " << seed);
        const Frame frame = random_frame(seed);
        const auto want   = execute(frame).output;
        for (std::size_t i = 0; i < frame.targets.size(); ++i) {
            const TargetId target{static_cast<std::int32_t>(i)};
            if (target == frame.output) continue;  // whatever nothing uses of the picture is zeros too
            const PixelRegion whole              = whole_of(frame, target);
            const std::vector<PixelRegion> first = pixels_used_as_zeros(frame, target);
            Frame begun                          = frame;
            insert_passes(begun, 0, garbage_passes(frame, target, whole));
            std::size_t added = whole.parts().size();
            for (std::size_t pass = 0; pass < frame.passes.size(); ++pass) {
                std::vector<Pass> clears = garbage_passes(frame, target, first[pass]);
                for (Pass& clear : clears) {
                    if (clear.clear.color) clear.clear.color = Argb{0};
                    if (clear.clear.depth) clear.clear.depth = 0.0f;
                }
                insert_passes(begun, pass + added, clears);
                added += clears.size();
                zeros += first[pass].pixels();
            }
            others += whole.pixels();
            REQUIRE((execute(begun).output == want));
        }
    }
    CHECK(zeros > 5000);
    CHECK(others > 2 * zeros);
}

TEST_CASE("pixels are wanted where the picture depends on them", "[needed_pixels]") {
    const std::string frame = with_passes(R"(
    "draw" { color "other" draws [ rectangle { x1 8 y1 8 color 0xff000000 } ] }
    "show" {
        color "picture" state { stages [ { color_op SELECTARG1 } ] scissor { x1 4 y1 2 } }
        draws [ rectangle { x1 8 y1 8 textures [ { target "other" } ] } ]
    }
    "hide" { color "picture" draws [ rectangle { x1 2 y1 8 } ] }
    )");
    // Of what is shown the left half is hidden again.
    CHECK(wanted_text(frame, 1) == "1: 2 0 4 2");
    CHECK(wanted_text(frame, 0) == "0: 2 2 8 8 4 0 8 2 | 1: 2 2 8 8 4 0 8 2 | 2: 2 0 8 8 | 3: 0 0 8 8");
}

TEST_CASE("what depth depends on is wanted, though nobody sees the colours", "[needed_pixels]") {
    const auto wanted = [](std::string_view state) {
        return wanted_text(with_passes("\"hole\" { color \"picture\" depth \"depth\" state { "
                                       "stages [ { color_op SELECTARG1 alpha_op SELECTARG1 } ] scissor { x1 4 y1 2 } " +
                                       std::string(state) +
                                       "} draws [ rectangle { x1 8 y1 8 textures [ { target \"other\" } ] } ] }"
                                       "\"hide\" { color \"picture\" clear { color 0xff000000 } }"),
                           1);
    };
    CHECK(wanted("depth { write true }") == "");
    CHECK(wanted("alpha_test { func GREATER }") == "");
    CHECK(wanted("depth { write true } alpha_test { func GREATER }") == "0: 0 0 4 2");
}

TEST_CASE("what is not wanted may hold anything, in random frames", "[needed_pixels]") {
    std::int64_t spoiled = 0;
    for (std::uint32_t seed = 1; seed <= 200; ++seed) {
        INFO("seed " << seed);
        const Frame frame = random_frame(seed);
        const auto wanted = wanted_pixels(frame);
        const auto want   = execute(frame).output;
        for (std::size_t i = 0; i < frame.targets.size(); ++i) {
            if (is_depth(frame.targets[i].format)) continue;
            const TargetId target{static_cast<std::int32_t>(i)};
            for (std::size_t pass = 0; pass <= frame.passes.size(); ++pass) {
                const PixelRegion free = without(whole_of(frame, target), wanted[i][pass]);
                Frame spoilt           = frame;
                insert_passes(spoilt, pass, garbage_passes(frame, target, free));
                spoiled += free.pixels();
                REQUIRE((execute(spoilt).output == want));
            }
        }
    }
    CHECK(spoiled > 500000);
}
