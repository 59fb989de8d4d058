// SPDX-License-Identifier: MIT
#include "pipeline/legalize/masked_alpha.h"

#include "tests/support/random.h"
#include "tests/support/random_frame.h"
#include "tests/support/rewritten.h"

using namespace pipeline;
using namespace test_support;

namespace {

// A 256x256 target: column x has alpha x, row y is drawn with alpha y and `mask`, and colours are at random on both sides.
Frame all_alphas(const BlendState& blend, const ColorMask& mask) {
    Random random(11);
    std::vector<std::uint8_t> there, drawn;
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            for (auto& [texels, alpha] : {std::pair{&there, x}, std::pair{&drawn, y}}) {
                for (int channel = 0; channel < 3; ++channel)
                    texels->push_back(static_cast<std::uint8_t>(random.bits() >> 24));
                texels->push_back(static_cast<std::uint8_t>(alpha));
            }
    Frame frame            = small_frame(256, 256);
    DrawRectangle show     = rectangle({0, 0, 256, 256}, 0xffffffff);
    show.textures[0]       = bound(add_texture(frame, TextureFormat::A8R8G8B8, 256, 256, there));
    Pass& ground           = frame.passes[0];
    ground.state.stages[0] = kTextureOnly;
    ground.draws           = {show};
    Pass pass              = ground;
    show.textures[0]       = bound(add_texture(frame, TextureFormat::A8R8G8B8, 256, 256, drawn));
    pass.state.blend       = blend;
    pass.state.color_mask  = mask;
    pass.draws             = {show};
    frame.passes.push_back(pass);
    return frame;
}

constexpr ColorMask kAlphaAlone{.red = false, .green = false, .blue = false, .alpha = true};
constexpr ColorMask kColorAlone{.red = true, .green = true, .blue = true, .alpha = false};

// Does dx7 get the frame without a mask?
bool loses_mask(const Frame& frame) {
    return rewritten(frame, &mask_by_blending, "dx7").passes.back().state.color_mask == ColorMask{};
}

}  // namespace

TEST_CASE("a fractal that multiplies alpha alone multiplies colour by white") {
    check_rewrite(&mask_by_blending, "dx7", R"(
targets [ "picture" { width 16 height 8 } ]
textures [ "fractal" { format A8 width 1 height 1 texels [80] } ]
passes [
    "multiply" {
        color "picture"
        state {
            blend { source ZERO dest SRCALPHA }
            color_mask { red false green false blue false }
            fog { mode LINEAR end 10 }
            texture_factor 0x40123456
            stages [{ color_op SELECTARG1 alpha_op SELECTARG1 filter LINEAR }]
        }
        draws [ rectangle { x1 16 y1 8 textures [{ texture "fractal" }] } ]
    }
]
)",
                  R"(
targets [ "picture" { width 16 height 8 } ]
textures [ "fractal" { format A8 width 1 height 1 texels [80] } ]
passes [
    "multiply" {
        color "picture"
        state {
            blend { source ZERO dest SRCCOLOR }
            texture_factor 0x40ffffff
            stages [{ color_op SELECTARG1 color_arg1 { source TFACTOR } alpha_op SELECTARG1 filter LINEAR }]
        }
        draws [ rectangle { x1 16 y1 8 textures [{ texture "fractal" }] } ]
    }
]
)");
}

TEST_CASE("a mask of alpha 0 is multiplied in, and one of alpha 255 is added") {
    check_rewrite(&mask_by_blending, "dx7", R"(
targets [ "picture" { width 16 height 8 } "depth" { format D24 width 16 height 8 } ]
cameras [ "eye" {} ]
vertices [ {} { diffuse 0xff123456 } {} { diffuse 0x7f000000 } ]
indices [ 3 0 1 2 ]
passes [
    "nowhere" {
        color "picture"
        state { color_mask { red false green false blue false } }
        draws [ rectangle { x1 16 y1 8 color 0x00000000 } ]
    }
    "where the scene is behind" {
        color "picture"
        depth "depth"
        camera "eye"
        state { color_mask { red false green false blue false } depth { func LESSEQUAL } }
        draws [ triangles { first_index 1 index_count 3 } ]
    }
]
)",
                  R"(
targets [ "picture" { width 16 height 8 } "depth" { format D24 width 16 height 8 } ]
cameras [ "eye" {} ]
vertices [ {} { diffuse 0xff123456 } {} { diffuse 0x7f000000 } ]
indices [ 3 0 1 2 ]
passes [
    "nowhere" {
        color "picture"
        state {
            blend { source ZERO dest SRCCOLOR }
            stages [{ color_op SELECTARG1 color_arg1 { source TFACTOR } alpha_op SELECTARG2 }]
        }
        draws [ rectangle { x1 16 y1 8 color 0x00000000 } ]
    }
    "where the scene is behind" {
        color "picture"
        depth "depth"
        camera "eye"
        state {
            blend { source ONE dest ONE }
            depth { func LESSEQUAL }
            texture_factor 0xff000000
            stages [{ color_op SELECTARG1 color_arg1 { source TFACTOR } alpha_op SELECTARG2 }]
        }
        draws [ triangles { first_index 1 index_count 3 } ]
    }
]
)");
}

TEST_CASE("light that is added to colour alone has alpha 0") {
    check_rewrite(&mask_by_blending, "dx7", R"(
targets [ "picture" { width 16 height 8 } ]
passes [
    "light" {
        color "picture"
        state {
            blend { source DESTCOLOR dest ONE }
            color_mask { alpha false }
            fog { mode LINEAR end 10 }
            stages [{ color_op MODULATE alpha_op SELECTARG2 } { color_op MODULATE alpha_op SELECTARG2 filter LINEAR }]
        }
        draws [ rectangle { x1 16 y1 8 } ]
    }
]
)",
                  R"(
targets [ "picture" { width 16 height 8 } ]
passes [
    "light" {
        color "picture"
        state {
            blend { source DESTCOLOR dest ONE }
            fog { mode LINEAR end 10 }
            stages [
                { color_op MODULATE alpha_op SELECTARG2 }
                { color_op MODULATE alpha_op SUBTRACT alpha_arg1 { source CURRENT } filter LINEAR }
            ]
        }
        draws [ rectangle { x1 16 y1 8 } ]
    }
]
)");
}

TEST_CASE("alpha that stages or lights make is not taken for the vertices'") {
    check_left_alone(&mask_by_blending, "dx7", R"(
targets [ "picture" { width 4 height 4 } ]
passes [
    "textured" {
        color "picture"
        state { color_mask { red false green false blue false } stages [{ color_op MODULATE alpha_op MODULATE }] }
        draws [ rectangle {} ]
    }
    "lit" {
        color "picture"
        state { color_mask { red false green false blue false } lighting { enabled true } }
        draws [ rectangle {} ]
    }
]
)");
}

TEST_CASE("on a target without alpha a mask of alpha alone writes nothing, and one of colour alone is none") {
    check_rewrite(&mask_by_blending, "dx7", R"(
targets [ "picture" { format X8R8G8B8 width 4 height 4 } ]
passes [
    "alpha" {
        color "picture"
        state { color_mask { red false green false blue false } }
        draws [ rectangle { color 0x80ffffff } ]
    }
    "color" { color "picture" state { color_mask { alpha false } } draws [ rectangle {} ] }
]
)",
                  R"(
targets [ "picture" { format X8R8G8B8 width 4 height 4 } ]
passes [
    "alpha" { color "picture" state { blend { source ZERO dest ONE } } draws [ rectangle { color 0x80ffffff } ] }
    "color" { color "picture" state { color_mask { alpha false } } draws [ rectangle {} ] }
]
)");
}

TEST_CASE("a note says for each pass how its mask is replaced") {
    const RewriteNotes notes        = notes_of(parsed(R"(
targets [ "picture" { width 4 height 4 } ]
passes [
    "alpha" {
        color "picture"
        state { blend { source DESTALPHA dest ZERO } color_mask { red false green false blue false } }
        draws [ rectangle {} ]
    }
    "color" {
        color "picture"
        state { blend { source DESTALPHA dest ZERO } color_mask { alpha false } }
        draws [ rectangle {} ]
    }
    "neither" {
        color "picture"
        state { color_mask { red false green false blue false alpha false } }
        draws [ rectangle {} ]
    }
]
)"),
                                               &mask_by_blending, "dx7");
    constexpr std::string_view kWhy = "the chip has no colour mask";
    CHECK(notes ==
          RewriteNotes{{"masked_alpha", "pass 0 'alpha'", std::string(kWhy), "blend ZERO SRCCOLOR of white and alpha"},
                       {"masked_alpha", "pass 1 'color'", std::string(kWhy), "blend DESTALPHA ZERO of alpha 255"},
                       {"masked_alpha", "pass 2 'neither'", std::string(kWhy), "blend ZERO ONE"}});
}

TEST_CASE("masks that the chip has, or that no blend replaces, are left alone") {
    const auto frame = [](std::string_view mask, std::string_view rest) {
        return std::string(
                   "targets [ \"picture\" { width 4 height 4 } \"565\" { format R5G6B5 width 4 height 4 } ] "
                   "passes [ \"draw\" { color \"picture\" state { color_mask { ") +
               std::string(mask) + " } " + std::string(rest) + " } draws [ rectangle { color 0x80ffffff } ] } ]";
    };
    constexpr std::string_view kAlpha = "red false green false blue false", kColor = "alpha false";
    for (const std::string_view chip : {"ideal", "gamecube", "xbox", "ps2"})
        check_left_alone(&mask_by_blending, chip, frame(kAlpha, "blend { source ZERO dest SRCCOLOR }"));
    check_left_alone(&mask_by_blending, "dx7",
                     "arithmetic { blend FLIPPER_TRUNC256 }" + frame(kAlpha, "blend { source ZERO dest SRCCOLOR }"));
    check_left_alone(&mask_by_blending, "dx7", R"(
targets [ "picture" { format A1R5G5B5 width 4 height 4 } ]
passes [
    "dithered" {
        color "picture"
        state { blend { source ONE dest ONE } color_mask { alpha false } dither { mode FLIPPER_2X2 } }
        draws [ rectangle {} ]
    }
]
)");
    for (const std::string& text : {
             frame(kAlpha, ""),  // alpha 0x80 replaces
             frame(kAlpha, "stages [{ color_op SELECTARG1 alpha_op SELECTARG1 }]"),
             frame(kAlpha, "blend { source SRCALPHA dest INVSRCALPHA }"),
             frame(kColor, ""),
             frame(kColor, "blend { source SRCALPHA dest ONE }"),
             frame(kColor, "blend { source SRCALPHA dest INVSRCALPHA }"),
             frame(kColor, "blend { source ONE dest ONE } alpha_test { func GREATER }"),
             frame("red false", "blend { source ONE dest ONE }"),
         })
        check_left_alone(&mask_by_blending, "dx7", text);
}

TEST_CASE("blends without a mask give the same bytes, for all pairs of alpha") {
    using enum BlendFactor;
    std::vector<std::pair<BlendState, ColorMask>> cases;
    for (const BlendState blend : {BlendState{Zero, SourceColor},
                                   {Zero, SourceAlpha},
                                   {DestColor, Zero},
                                   {DestAlpha, Zero},
                                   {Zero, InvSourceColor},
                                   {Zero, InvSourceAlpha},
                                   {One, One},
                                   {One, InvSourceColor},
                                   {One, InvSourceAlpha}})
        cases.push_back({blend, kAlphaAlone});
    for (const BlendState blend : {BlendState{Zero, SourceColor},
                                   {DestColor, Zero},
                                   {DestAlpha, Zero},
                                   {DestColor, One},
                                   {One, One},
                                   {One, InvSourceColor},
                                   {DestAlpha, InvSourceColor},
                                   {InvDestAlpha, One}})
        cases.push_back({blend, kColorAlone});
    for (const BlendState blend : {kReplace, kAlphaOver}) cases.push_back({blend, {false, false, false, false}});
    for (const auto& [blend, mask] : cases) {
        INFO(enum_name(blend.source) << ' ' << enum_name(blend.dest) << ", alpha " << mask.alpha);
        const Frame frame = all_alphas(blend, mask);
        CHECK(loses_mask(frame));
        CHECK(differing_pixels(rewritten(frame, &mask_by_blending, "dx7"), frame) == 0);
    }
}

TEST_CASE("an alpha of 0 or 255 replaces alone, whatever alpha was there") {
    for (const std::uint32_t color : {0x00123456u, 0xff654321u}) {
        Frame frame                  = all_alphas(kReplace, kAlphaAlone);
        frame.passes[1].state.stages = {};
        frame.passes[1].draws        = {rectangle({3, 0, 256, 250}, color)};
        CHECK(loses_mask(frame));
        CHECK(differing_pixels(rewritten(frame, &mask_by_blending, "dx7"), frame) == 0);
    }
}

TEST_CASE("frames without masks give the same bytes, whatever else their passes do") {
    const ColorMask mask =
        GENERATE(kAlphaAlone, kColorAlone, ColorMask{false, false, false, false}, ColorMask{true, false, true, true});
    int without = 0;
    for (std::uint32_t seed = 1; seed <= 400; ++seed) {
        INFO("seed " << seed << ", red " << mask.red << ", alpha " << mask.alpha);
        Frame frame = random_frame(seed);
        for (Pass& pass : frame.passes)
            if (!pass.draws.empty() && !std::holds_alternative<CopyRectangle>(pass.draws[0]))
                pass.state.color_mask = mask;
        const Frame rewritten_frame = rewritten(frame, &mask_by_blending, "dx7");
        for (std::size_t i = 0; i < frame.passes.size(); ++i)
            without += rewritten_frame.passes[i].state.color_mask != frame.passes[i].state.color_mask;
        REQUIRE(differing_pass(rewritten_frame, frame) == -1);
    }
    CHECK(without >= (mask == ColorMask{true, false, true, true} ? 0 : 20));
}
