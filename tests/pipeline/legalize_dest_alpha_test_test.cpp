// SPDX-License-Identifier: MIT
#include "pipeline/legalize/dest_alpha_test.h"

#include "pipeline/legalize/masked_alpha.h"
#include "tests/support/random.h"
#include "tests/support/rewritten.h"

using namespace pipeline;
using namespace test_support;

namespace {

// Alpha alone becomes 0 in all of the 256x256 picture and 255 in columns 128 and beyond; then a texture is blended over, row y
// with alpha y, where alpha passes. Colours are at random.
Frame masked_layer() {
    Random random(5);
    std::vector<std::uint8_t> there, layer;
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            for (auto& [texels, alpha] : {std::pair{&there, random.from(0, 255)}, std::pair{&layer, y}}) {
                for (int channel = 0; channel < 3; ++channel)
                    texels->push_back(static_cast<std::uint8_t>(random.bits() >> 24));
                texels->push_back(static_cast<std::uint8_t>(alpha));
            }
    Frame frame     = small_frame(256, 256, TargetFormat::D24);
    const auto show = [&](const std::vector<std::uint8_t>& texels) {
        DrawRectangle draw = rectangle({0, 0, 256, 256}, 0xffffffff);
        draw.textures[0]   = bound(add_texture(frame, TextureFormat::A8R8G8B8, 256, 256, texels));
        return draw;
    };
    Pass ground                = frame.passes[0];
    Pass start                 = ground;
    start.state.color_mask     = {.red = false, .green = false, .blue = false, .alpha = true};
    Pass mask                  = start;
    ground.state.stages[0]     = kTextureOnly;
    Pass over                  = ground;
    over.state.blend           = kAlphaOver;
    over.state.color_mask      = {.alpha = false};
    over.state.dest_alpha_test = DestAlphaTest::One;
    over.state.scissor         = {3, 0, 250, 256};
    mask.state.depth.func      = CompareFunc::GreaterEqual;
    ground.draws               = {show(there)};
    start.draws                = {rectangle({0, 0, 256, 256}, 0x00123456)};
    mask.draws                 = {rectangle({128, 0, 256, 256}, 0xff123456, 0.5f)};
    over.draws                 = {show(layer)};
    frame.passes               = {ground, start, mask, over};
    return frame;
}

}  // namespace

TEST_CASE("a tested layer becomes a product in alpha, a blend by it, and the mask again") {
    check_rewrite(&test_by_blending, "dx7", R"(
targets [ "picture" { width 4 height 4 } ]
passes [
    "mask" {
        color "picture"
        state { color_mask { red false green false blue false } }
        draws [ rectangle { x1 4 y1 4 color 0xff000000 } ]
    }
    "layer" {
        color "picture"
        state { blend { source SRCALPHA dest INVSRCALPHA } color_mask { alpha false } dest_alpha_test ONE }
        draws [ rectangle { x1 4 y1 4 color 0x80ffffff } ]
    }
]
)",
                  R"(
targets [ "picture" { width 4 height 4 } ]
passes [
    "mask" {
        color "picture"
        state { color_mask { red false green false blue false } }
        draws [ rectangle { x1 4 y1 4 color 0xff000000 } ]
    }
    "layer" {
        color "picture"
        state { blend { source ZERO dest SRCALPHA } color_mask { red false green false blue false } }
        draws [ rectangle { x1 4 y1 4 color 0x80ffffff } ]
    }
    "layer" {
        color "picture"
        state { blend { source DESTALPHA dest INVDESTALPHA } }
        draws [ rectangle { x1 4 y1 4 color 0x80ffffff } ]
    }
    "mask" {
        color "picture"
        state { color_mask { red false green false blue false } }
        draws [ rectangle { x1 4 y1 4 color 0xff000000 } ]
    }
]
)");
}

TEST_CASE("a layer over a mask of alpha gives the same bytes without the test, alpha too") {
    const Frame frame = masked_layer();
    const Frame got   = rewritten(frame, &test_by_blending, "dx7");
    REQUIRE(got.passes.size() == 7);
    CHECK(got.passes[5] == frame.passes[1]);
    CHECK(got.passes[6] == frame.passes[2]);
    CHECK(differing_pixels(got, frame) == 0);
    const Frame without_masks = rewritten(got, &mask_by_blending, "dx7");
    CHECK(!is_found(without_masks, "dx7", "color_mask"));
    CHECK(!is_found(without_masks, "dx7", "dest_alpha_test"));
    CHECK(differing_pixels(without_masks, frame) == 0);
}

TEST_CASE("a test of alpha that is not known to be 0 or 255, or of more than one layer, is left alone") {
    const auto check_left = [](void (*change)(Frame&)) {
        Frame frame = masked_layer();
        change(frame);
        CHECK(rewritten(frame, &test_by_blending, "dx7") == frame);
    };
    check_left([](Frame& frame) { frame.passes.erase(frame.passes.begin() + 1); });
    check_left([](Frame& frame) { frame.passes[1].state.scissor = {0, 0, 249, 256}; });
    check_left([](Frame& frame) { std::get<DrawRectangle>(frame.passes[1].draws[0]).x0 = 3.5f; });
    check_left([](Frame& frame) { frame.passes[1].state.depth.func = CompareFunc::Equal; });
    check_left([](Frame& frame) { std::get<DrawRectangle>(frame.passes[2].draws[0]).color = {0x80000000}; });
    check_left([](Frame& frame) { frame.passes[2].state.color_mask = {}; });
    check_left([](Frame& frame) { frame.passes[3].draws.push_back(frame.passes[3].draws[0]); });
    check_left([](Frame& frame) { frame.passes[3].state.blend = {BlendFactor::One, BlendFactor::InvSourceAlpha}; });
    check_left([](Frame& frame) { frame.passes[3].state.dest_alpha_test = DestAlphaTest::Zero; });
    // Depth is no longer what the mask was tested against.
    check_left([](Frame& frame) {
        Pass depth        = {.label = "depth", .depth = {1}};
        depth.clear.depth = 1.0f;
        frame.passes.insert(frame.passes.begin() + 3, depth);
    });
    CHECK(rewritten(masked_layer(), &test_by_blending, "ps2") == masked_layer());
}

TEST_CASE("where alpha costs bits, what is tested becomes a texture that multiplies the layer's alpha") {
    check_rewrite(&test_by_texture, "gamecube", R"(
targets [ "picture" { width 8 height 8 } "depth" { format D24 width 8 height 8 } ]
passes [
    "nowhere" {
        color "picture" state { color_mask { red false green false blue false } scissor { x1 6 y1 4 } }
        draws [ rectangle { x1 8 y1 8 color 0x00000000 } ]
    }
    "behind" {
        color "picture" depth "depth"
        state { color_mask { red false green false blue false } depth { func LESSEQUAL } }
        draws [ rectangle { x0 2 y0 2 x1 8 y1 8 depth 0.5 } ]
    }
    "layer" {
        color "picture"
        state {
            blend { source SRCALPHA dest INVSRCALPHA }
            color_mask { alpha false }
            dest_alpha_test ONE
            scissor { x1 6 y1 4 }
        }
        draws [ rectangle { x1 16 y1 4 color 0x80ffffff } ]
    }
]
)",
                  R"(
targets [ "picture" { width 8 height 8 } "depth" { format D24 width 8 height 8 } "picture, mask" { width 8 height 8 } ]
passes [
    "nowhere" {
        color "picture, mask" state { scissor { x1 6 y1 4 } }
        draws [ rectangle { x1 8 y1 8 color 0x00000000 } ]
    }
    "behind" {
        color "picture, mask" depth "depth"
        state { depth { func LESSEQUAL } }
        draws [ rectangle { x0 2 y0 2 x1 8 y1 8 depth 0.5 } ]
    }
    "layer" {
        color "picture"
        state {
            blend { source SRCALPHA dest INVSRCALPHA }
            color_mask { alpha false }
            stages [
                {
                    color_op SELECTARG1
                    color_arg1 { source CURRENT }
                    alpha_op MODULATE
                    alpha_arg1 { source CURRENT }
                    alpha_arg2 { source TEXTURE }
                    address_u CLAMP
                    address_v CLAMP
                }
            ]
            scissor { x1 6 y1 4 }
        }
        draws [
            rectangle {
                x1 16 y1 4 color 0x80ffffff
                uv [ { u1 2 v1 0.5 } ] textures [ { target "picture, mask" } ]
            }
        ]
    }
]
)");
}

TEST_CASE("a layer over a mask that is a texture gives the same colours, by the frame's rules and by the chip's") {
    Frame frame       = masked_layer();
    const Frame plain = rewritten(frame, &test_by_texture, "gamecube");
    REQUIRE(plain.passes.size() == frame.passes.size());
    CHECK(!is_found(plain, "gamecube", "dest_alpha_test"));
    const auto same_colors = [](const Frame& a, const Frame& b) {
        const std::vector<std::uint32_t> of_a = pixels_of(a), of_b = pixels_of(b);
        return std::equal(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                          [](std::uint32_t one, std::uint32_t other) { return ((one ^ other) & 0xffffff) == 0; });
    };
    CHECK(same_colors(plain, frame));
    // Layers of no stage, and of one that is off by half a pixel.
    frame.arithmetic = find_profile("gamecube")->arithmetic;
    CHECK(same_colors(rewritten(frame, &test_by_texture, "gamecube"), frame));
    frame.passes[3].state.stages[0] = {};
    CHECK(same_colors(rewritten(frame, &test_by_texture, "gamecube"), frame));
    auto& layer = std::get<DrawRectangle>(frame.passes[3].draws[0]);
    layer.x0 = 3.5f, layer.y1 = 200.25f, layer.color = {0x5a336699};
    CHECK(same_colors(rewritten(frame, &test_by_texture, "gamecube"), frame));
}

TEST_CASE("a mask stays in the target where another pass reads its alpha, and for chips with the test or whole bytes") {
    for (const std::string_view chip : {"ideal", "dx7", "ps2", "xbox"})
        CHECK(rewritten(masked_layer(), &test_by_texture, chip) == masked_layer());
    const auto check_left = [](void (*change)(Frame&)) {
        Frame frame = masked_layer();
        change(frame);
        CHECK(rewritten(frame, &test_by_texture, "gamecube") == frame);
    };
    check_left([](Frame& frame) { frame.passes[3].state.blend = {BlendFactor::One, BlendFactor::InvSourceAlpha}; });
    check_left([](Frame& frame) { frame.passes[2].state.color_mask = {}; });
    check_left([](Frame& frame) { frame.passes[3].state.stages[1] = kTextureOnly; });
    check_left([](Frame& frame) {
        Pass other               = frame.passes[0];
        other.state.blend.source = BlendFactor::DestAlpha;
        frame.passes.push_back(other);
    });
    check_left([](Frame& frame) {
        Pass other                  = frame.passes[0];
        other.state.dest_alpha_test = DestAlphaTest::One;
        frame.passes.push_back(other);
    });
    // What a second layer tests is not made by masks alone.
    Frame twice = masked_layer();
    twice.passes.push_back(twice.passes[3]);
    CHECK(rewritten(twice, &test_by_texture, "gamecube") == twice);
}
