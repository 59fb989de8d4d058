// SPDX-License-Identifier: MIT
// Rectangles that halve a target, as the GameCube's copies do.
#include "pipeline/legalize/frame_buffer.h"
#include "tests/support/rewritten.h"

using namespace pipeline;
using namespace test_support;

namespace {

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
