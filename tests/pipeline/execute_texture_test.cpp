// SPDX-License-Identifier: MIT
// Textures from the frame's bytes to pixels: formats, levels, bindings, addressing and filters. Expected texels are
// worked out by hand from raster/sampling_rules.h.
#include "pipeline/frame/frame_text.h"
#include "tests/support/small_frame.h"

using namespace pipeline;
using namespace test_support;

namespace {

using Pixels = std::vector<std::uint32_t>;

// The whole target from `texture`, whose part `uv` covers it.
void blit(Frame& frame, const TextureStage& stage, TextureId texture, const UvRect& uv = {}) {
    const Target& target            = frame.targets[0];
    DrawRectangle draw              = rectangle({0, 0, target.width, target.height}, 0);
    draw.uv[0]                      = uv;
    draw.textures[0]                = bound(texture);
    frame.passes[0].state.stages[0] = stage;
    frame.passes[0].draws           = {draw};
}

TextureStage clamped() {
    TextureStage stage = kTextureOnly;
    stage.address_u = stage.address_v = TextureAddress::Clamp;
    return stage;
}

// What an L8 texel reads as.
Pixels greys(const std::vector<int>& values) {
    Pixels pixels;
    for (const int value : values) pixels.push_back(0xff000000 | static_cast<std::uint32_t>(value) * 0x010101);
    return pixels;
}

std::vector<std::uint8_t> bytes(const std::vector<int>& values) {
    std::vector<std::uint8_t> out;
    for (const int value : values) out.push_back(static_cast<std::uint8_t>(value));
    return out;
}

}  // namespace

TEST_CASE("each texture format reads as its header says", "[execute]") {
    const struct Row {
        TextureFormat format;
        std::vector<std::uint8_t> texels;
        Pixels expected;
    } rows[] = {
        {TextureFormat::A8,
         {0x00, 0xff, 0x80, 0x01, 0x7f, 0xc0},
         {0x00000000, 0xff000000, 0x80000000, 0x01000000, 0x7f000000, 0xc0000000}},
        {TextureFormat::L8,
         {0x00, 0xff, 0x80, 0x01, 0x7f, 0xc0},
         {0xff000000, 0xffffffff, 0xff808080, 0xff010101, 0xff7f7f7f, 0xffc0c0c0}},
        {TextureFormat::A8R8G8B8,
         {0x01, 0x02, 0x03, 0x04, 0xf1, 0x00, 0x00, 0x00, 0x00, 0xf2, 0x00, 0x00,
          0x00, 0x00, 0xf3, 0x00, 0x00, 0x00, 0x00, 0xf4, 0x80, 0x81, 0x7f, 0xff},
         {0x04030201, 0x000000f1, 0x0000f200, 0x00f30000, 0xf4000000, 0xff7f8180}},
    };
    check_table(rows, &Row::format, &Row::expected);
    for (const Row& row : rows) {
        INFO(enum_name(row.format));
        Frame frame = small_frame(3, 2);
        blit(frame, clamped(), add_texture(frame, row.format, 3, 2, row.texels));
        CHECK(pixels_on_both(frame) == row.expected);
    }
}

TEST_CASE("a stage that reads a texture with nothing bound gets white", "[execute]") {
    const auto color = [](Frame& frame, const TextureBindings& textures) {
        DrawRectangle draw    = rectangle({0, 0, 2, 1}, 0x40302010);
        draw.textures         = textures;
        frame.passes[0].draws = {draw};
        return color_on_both(frame);
    };
    Frame frame           = small_frame(2, 1);
    const TextureId black = add_texture(frame, TextureFormat::A8, 1, 1, {0x00});
    TextureStage& stage   = frame.passes[0].state.stages[0];
    stage                 = kTextureOnly;
    stage.filter          = TextureFilter::Linear;
    stage.mip_filter      = MipFilter::Linear;
    CHECK(color(frame, {}) == 0xffffffff);
    CHECK(color(frame, {TextureBinding{}, bound(black)}) == 0xffffffff);
    CHECK(color(frame, {bound(black), TextureBinding{}}) == 0x00000000);

    stage.color_op = stage.alpha_op = TextureOp::Modulate;
    CHECK(color(frame, {}) == 0x40302010);
}

TEST_CASE("each draw has its own textures", "[execute]") {
    Frame frame                     = small_frame(3, 1);
    frame.passes[0].state.stages[0] = kTextureOnly;
    for (const int x : {0, 1, 2}) {
        DrawRectangle draw = rectangle({x, 0, x + 1, 1}, 0);
        if (x != 1) draw.textures[0] = bound(add_texture(frame, TextureFormat::A8, 1, 1, bytes({0x10 + x})));
        frame.passes[0].draws.emplace_back(draw);
    }
    CHECK(pixels_on_both(frame) == Pixels{0x10000000, 0xffffffff, 0x12000000});
}

TEST_CASE("each way to address a texture beyond its borders, on each axis", "[execute]") {
    // From one texture's size before the texture to one after it, a texel for each pixel.
    const struct Row {
        TextureAddress address;
        std::vector<int> u, v;
    } rows[] = {
        {TextureAddress::Wrap, {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3}, {0, 1, 0, 1, 0, 1}},
        {TextureAddress::Clamp, {0, 0, 0, 0, 0, 1, 2, 3, 3, 3, 3, 3}, {0, 0, 0, 1, 1, 1}},
        {TextureAddress::Mirror, {3, 2, 1, 0, 0, 1, 2, 3, 3, 2, 1, 0}, {1, 0, 0, 1, 1, 0}},
    };
    check_table(rows, &Row::address, &Row::u);
    check_table(rows, &Row::address, &Row::v);
    for (const Row& u : rows)
        for (const Row& v : rows) {
            INFO(enum_name(u.address) << ", " << enum_name(v.address));
            Frame frame        = small_frame(12, 6);
            TextureStage stage = kTextureOnly;
            stage.address_u    = u.address;
            stage.address_v    = v.address;
            blit(frame, stage, add_texture(frame, TextureFormat::L8, 4, 2, bytes({10, 11, 12, 13, 20, 21, 22, 23})),
                 {-1.0f, -1.0f, 2.0f, 2.0f});
            std::vector<int> expected;
            for (const int j : v.v)
                for (const int i : u.u) expected.push_back(10 * (j + 1) + i);
            CHECK(pixels_on_both(frame) == greys(expected));
        }
}

TEST_CASE("each texture filter", "[execute]") {
    // A texel for each two pixels: their centres lie a quarter of a texel from the texels' centres.
    const struct Row {
        TextureFilter filter;
        std::vector<int> expected;
    } rows[] = {
        {TextureFilter::Point, {0, 0, 160, 160, 0, 0, 160, 160, 240, 240, 80, 80, 240, 240, 80, 80}},
        {TextureFilter::Linear, {0, 40, 120, 160, 60, 80, 120, 140, 180, 160, 120, 100, 240, 200, 120, 80}},
    };
    check_table(rows, &Row::filter, &Row::expected);
    for (const Row& row : rows) {
        INFO(enum_name(row.filter));
        Frame frame        = small_frame(4, 4);
        TextureStage stage = clamped();
        stage.filter       = row.filter;
        blit(frame, stage, add_texture(frame, TextureFormat::L8, 2, 2, bytes({0, 160, 240, 80})));
        CHECK(pixels_on_both(frame) == greys(row.expected));
    }
}

TEST_CASE("each mip filter", "[execute]") {
    // 8x8 and its mips, each of one grey. The level is half the logarithm of the square of the scale (texels for each
    // pixel), taken as linear between powers of two: 1.25 * 1.25 = 1.5625 is level 72/256, 1.5 * 1.5 = 2.25 is 144/256.
    std::vector<std::uint8_t> texels;
    for (const auto& [count, grey] : {std::pair{64, 20}, {16, 120}, {4, 220}, {1, 60}})
        texels.insert(texels.end(), static_cast<std::size_t>(count), static_cast<std::uint8_t>(grey));
    const float scales[] = {0.5f, 1.0f, 1.25f, 1.5f, 2.0f, 4.0f, 8.0f, 16.0f};
    const struct Row {
        MipFilter filter;
        std::vector<int> expected;  // at each scale
    } rows[] = {
        {MipFilter::None, {20, 20, 20, 20, 20, 20, 20, 20}},
        {MipFilter::Point, {20, 20, 20, 120, 120, 220, 60, 60}},
        // (20 * 184 + 120 * 72) / 256 = 48.1 and (20 * 112 + 120 * 144) / 256 = 76.3
        {MipFilter::Linear, {20, 20, 48, 76, 120, 220, 60, 60}},
    };
    check_table(rows, &Row::filter, &Row::expected);
    for (const Row& row : rows)
        for (const TextureFilter filter : {TextureFilter::Point, TextureFilter::Linear})
            for (std::size_t i = 0; i < std::size(scales); ++i)
                for (const bool both_axes : {true, false}) {
                    INFO(enum_name(row.filter) << ' ' << enum_name(filter) << ' ' << scales[i]);
                    Frame frame        = small_frame(4, 4);
                    TextureStage stage = kTextureOnly;
                    stage.filter       = filter;
                    stage.mip_filter   = row.filter;
                    const float end    = 4.0f * scales[i] / 8.0f;
                    blit(frame, stage, add_texture(frame, TextureFormat::L8, 8, 8, texels, 4),
                         {0.0f, 0.0f, both_axes ? end : 0.125f, end});
                    CHECK(color_on_both(frame) == greys({row.expected[i]})[0]);
                }
}

TEST_CASE("a mip filter on a texture of one level reads that", "[execute]") {
    for (const MipFilter mip : {MipFilter::None, MipFilter::Point, MipFilter::Linear}) {
        Frame frame        = small_frame(1, 1);
        TextureStage stage = kTextureOnly;
        stage.mip_filter   = mip;
        blit(frame, stage, add_texture(frame, TextureFormat::L8, 4, 1, bytes({1, 2, 77, 4})));
        CHECK(pixels_on_both(frame) == greys({77}));
    }
}

TEST_CASE("each level is found behind the one before, as wide and high as it is", "[execute]") {
    const std::vector<std::uint8_t> texels =
        bytes({1, 2, 3, 4, 5, 6, 7, 8, 11, 12, 13, 14, 15, 16, 17, 18, 21, 22, 23, 24, 31, 32, 41});
    const struct {
        int width, height;  // of the blit: a texel for each pixel of its level
        std::vector<int> expected;
    } rows[] = {
        {8, 2, {1, 2, 3, 4, 5, 6, 7, 8, 11, 12, 13, 14, 15, 16, 17, 18}},
        {4, 1, {21, 22, 23, 24}},
        {2, 1, {31, 32}},
        {1, 1, {41}},
    };
    for (const auto& row : rows) {
        INFO(row.width << 'x' << row.height);
        Frame frame        = small_frame(row.width, row.height);
        TextureStage stage = clamped();
        stage.mip_filter   = MipFilter::Point;
        blit(frame, stage, add_texture(frame, TextureFormat::L8, 8, 2, texels, 4));
        CHECK(pixels_on_both(frame) == greys(row.expected));
    }
}

TEST_CASE("a texture of the greatest size has all its 14 levels", "[execute]") {
    constexpr int kLevels = 14;
    std::vector<std::uint8_t> texels;
    for (int level = 0; level < kLevels; ++level)
        texels.insert(texels.end(), std::size_t{8192} >> level, static_cast<std::uint8_t>(10 * (level + 1)));
    for (const TextureFormat format : {TextureFormat::A8, TextureFormat::L8})
        for (const bool is_wide : {true, false})
            for (const MipFilter mip : {MipFilter::Point, MipFilter::Linear}) {
                INFO(enum_name(format) << (is_wide ? ", wide, " : ", high, ") << enum_name(mip));
                Frame frame         = small_frame(kLevels, 1);
                TextureStage& stage = frame.passes[0].state.stages[0];
                stage               = kTextureOnly;
                stage.mip_filter    = mip;
                const TextureId texture =
                    add_texture(frame, format, is_wide ? 8192 : 1, is_wide ? 1 : 8192, texels, kLevels);
                Pixels expected;
                for (int level = 0; level < kLevels; ++level) {
                    DrawRectangle draw = rectangle({level, 0, level + 1, 1}, 0);
                    const float end    = static_cast<float>(1 << level) / 8192.0f;  // 2^level texels in this pixel
                    draw.uv[0]         = is_wide ? UvRect{0, 0, end, 1} : UvRect{0, 0, 1, end};
                    draw.textures[0]   = bound(texture);
                    frame.passes[0].draws.emplace_back(draw);
                    const auto value = static_cast<std::uint32_t>(10 * (level + 1));
                    expected.push_back(format == TextureFormat::A8 ? value << 24 : greys({10 * (level + 1)})[0]);
                }
                CHECK(pixels_on_both(frame) == expected);
            }
}

TEST_CASE("a target is read as the texture it looks like", "[execute]") {
    // Rows of all these widths lie further apart than they are long.
    const struct { int width, height; } sizes[] = {{1, 1}, {5, 3}, {17, 2}, {1024, 2}, {2048, 3}};
    for (const auto& [width, height] : sizes) {
        INFO(width << 'x' << height);
        Frame frame = small_frame(width, height);
        frame.targets.push_back(frame.targets[0]);
        Pass copy   = frame.passes[0];
        Pass& drawn = frame.passes[0];
        drawn.color = {1};
        Pixels expected;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const auto column = static_cast<std::uint32_t>(x), row = static_cast<std::uint32_t>(y);
                expected.push_back((row + 1) << 24 | (column & 0xfff) << 12 | 0x0f0);
                drawn.draws.emplace_back(rectangle({x, y, x + 1, y + 1}, expected.back()));
            }
        DrawRectangle draw      = rectangle({0, 0, width, height}, 0);
        draw.textures[0].target = {1};
        copy.draws              = {draw};
        copy.state.stages[0]    = clamped();
        frame.passes.push_back(copy);
        CHECK(pixels_on_both(frame) == expected);
    }
}

TEST_CASE("a target read as a texture is filtered, and has its pixels of that moment", "[execute]") {
    const Frame frame = parse_frame(R"(nimbus7 frame 1
        output "picture"
        targets ["picture" { width 2 height 1 } "small" { width 2 height 1 }]
        passes [
            "first" { color "small" draws [rectangle { x1 1 y1 1 color 0xff402010 }] }
            "read" {
                color "picture"
                state {
                    stages [{ color_op SELECTARG1 alpha_op SELECTARG1 filter LINEAR address_u CLAMP address_v CLAMP }]
                }
                draws [rectangle { x1 2 y1 1 uv [{ u0 0.25 u1 0.75 }] textures [{ target "small" }] }]
            }
            "later" { color "small" clear { color 0xffffffff } }
        ])");
    // Texels 0xff402010 and 0, read at 3/4 and 5/4 texels: 3/4 and 1/4 of the first.
    CHECK(pixels_on_both(frame) == Pixels{0xbf30180c, 0x40100804});
}
