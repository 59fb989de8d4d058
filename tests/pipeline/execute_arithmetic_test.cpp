// SPDX-License-Identifier: MIT
// Each rule of the frame's arithmetic, from the frame to the bytes. The answers are worked out by hand from
// pipeline/frame/arithmetic.h.
#include "tests/support/small_frame.h"

using namespace pipeline;
using namespace test_support;

namespace {

constexpr std::uint32_t kGrey = 0x010101;

// The one grey that the output has everywhere.
std::uint32_t grey(const Frame& frame) {
    const std::uint32_t color = color_on_both(frame) & 0x00ffffff;
    REQUIRE(color == (color & 0xff) * kGrey);
    return color & 0xff;
}

// The stage combines a grey texel and a grey factor.
Frame staged(CombineRule rule, TextureOp op, std::uint32_t texel, std::uint32_t factor) {
    Frame frame               = small_frame(17, 1);
    frame.arithmetic.combine  = rule;
    Pass& pass                = frame.passes[0];
    pass.state.texture_factor = {factor * 0x01010101};
    pass.state.stages[0]      = {.color_op   = op,
                                 .color_arg1 = {.source = ArgSource::Texture},
                                 .color_arg2 = {.source = ArgSource::TFactor},
                                 .alpha_op   = TextureOp::SelectArg1};
    DrawRectangle draw        = rectangle({0, 0, 17, 1}, 0x40000000);
    const auto byte           = static_cast<std::uint8_t>(texel);
    draw.textures[0]          = bound(add_texture(frame, TextureFormat::A8R8G8B8, 1, 1, {byte, byte, byte, byte}));
    pass.draws                = {draw};
    return frame;
}

// A rectangle of `source` over a target cleared to `dest`.
Frame blended(const BlendState& blend, std::uint32_t source, std::uint32_t dest) {
    Frame frame      = small_frame(17, 2);
    Pass& pass       = frame.passes[0];
    pass.clear.color = Argb{dest};
    pass.state.blend = blend;
    pass.draws       = {rectangle({0, 0, 17, 2}, source)};
    return frame;
}

}  // namespace

TEST_CASE("each rule for snapping window coordinates", "[execute]") {
    // From 1.05 pixels, that is 16.8 subpixels, with pixels sampled at their left edges: is pixel 1 in?
    const struct Row {
        SnapRule rule;
        bool covered;
    } rows[] = {{SnapRule::Nearest, false}, {SnapRule::Truncate, true}};
    check_table(rows, &Row::rule, &Row::covered);
    for (const Row& row : rows)
        for (const bool as_triangles : {false, true}) {
            INFO(enum_name(row.rule) << as_triangles);
            Frame frame                   = small_frame(4, 4);
            frame.arithmetic.snap         = row.rule;
            frame.arithmetic.pixel_center = 0;
            if (as_triangles) {
                const DrawTriangles quad = add_quad(frame, 0xffffffff);
                for (Vertex& vertex : frame.vertices)  // x of -1..1 is 1.05..4 pixels
                    if (vertex.position.x < 0.0f) vertex.position.x = 1.05f / 2.0f - 1.0f;
                frame.passes[0].draws = {quad};
            } else {
                DrawRectangle draw    = rectangle({0, 0, 4, 4}, 0xffffffff);
                draw.x0               = 1.05f;
                frame.passes[0].draws = {draw};
            }
            CHECK(pixels_on_both(frame)[1] == (row.covered ? 0xffffffff : 0));
        }
}

TEST_CASE("a pixel is sampled where the arithmetic says", "[execute]") {
    for (int center = 0; center < 16; ++center)
        for (int edge = 0; edge < 16; ++edge) {
            INFO(center << ' ' << edge);
            Frame frame                   = small_frame(3, 3);
            frame.arithmetic.pixel_center = center;
            DrawRectangle draw            = rectangle({0, 0, 3, 3}, 0xffffffff);
            draw.x0                       = 1.0f + static_cast<float>(edge) / 16.0f;
            draw.y1                       = 2.0f + static_cast<float>(edge) / 16.0f;
            frame.passes[0].draws         = {draw};
            const auto pixels             = pixels_on_both(frame);
            CHECK(pixels[1] == (edge <= center ? 0xffffffff : 0));         // a left edge is in
            CHECK(pixels[2 * 3 + 2] == (edge > center ? 0xffffffff : 0));  // a bottom edge is out
        }
}

TEST_CASE("each rule for interpolated colours", "[execute]") {
    // One more from pixel to pixel, and a half in between at the centres.
    const struct Row {
        GouraudRule rule;
        std::uint32_t at_pixel_5;
    } rows[] = {{GouraudRule::Nearest, 6}, {GouraudRule::Floor, 5}};
    check_table(rows, &Row::rule, &Row::at_pixel_5);
    for (const Row& row : rows) {
        INFO(enum_name(row.rule));
        Frame frame              = small_frame(16, 1);
        frame.arithmetic.gouraud = row.rule;
        frame.passes[0].draws    = {add_quad(frame, 0)};
        for (Vertex& vertex : frame.vertices)
            if (vertex.position.x > 0.0f) vertex.diffuse = {0x10101010};
        CHECK(pixels_on_both(frame)[5] == row.at_pixel_5 * 0x01010101);
    }
}

TEST_CASE("a floored colour is exact where a division leaves nothing, whatever the slope", "[execute]") {
    for (const int size : {7, 24, 30, 150})
        for (const std::uint32_t most : {1u, 16u, 100u, 255u}) {
            INFO(size << ' ' << most);
            Frame frame                   = small_frame(size, size);
            frame.arithmetic.gouraud      = GouraudRule::Floor;
            frame.arithmetic.pixel_center = 0;
            frame.passes[0].draws         = {add_quad(frame, 0)};
            for (Vertex& vertex : frame.vertices) {
                const std::uint32_t along_x = vertex.position.x > 0.0f ? most : 0;
                const std::uint32_t along_y = vertex.position.y < 0.0f ? most : 0;
                vertex.diffuse = {along_y << 24 | along_x << 16 | (most - along_x) << 8 | (most - along_y)};
            }
            const auto pixels = pixels_on_both(frame);
            std::size_t wrong = 0;
            for (std::uint32_t y = 0, i = 0; y < static_cast<std::uint32_t>(size); ++y)
                for (std::uint32_t x = 0; x < static_cast<std::uint32_t>(size); ++x, ++i) {
                    const auto at = [&](std::uint32_t units) {
                        return most * units / static_cast<std::uint32_t>(size);
                    };
                    const auto rest = static_cast<std::uint32_t>(size);
                    wrong += pixels[i] != (at(y) << 24 | at(x) << 16 | at(rest - x) << 8 | at(rest - y));
                }
            CHECK(wrong == 0);
        }
}

TEST_CASE("each filter rule", "[execute]") {
    // Fractions of 17/256 and 5/256: in sixteenths 1 and 0, in 1/128 8 and 2.
    const struct Row {
        FilterRule rule;
        std::uint32_t expected;
    } rows[] = {
        {FilterRule::Reference8, 24},     // (251 * (239 * 10 + 17 * 201) + 5 * (239 * 90 + 17 * 255)) / 65536 = 24.2
        {FilterRule::GsFloor4, 21},       // 10 + (191 * 1 >> 4)
        {FilterRule::GsNearest4, 22},     // (15 * 10 + 201) / 16 = 21.9
        {FilterRule::FlipperFloor7, 23},  // (126 * (120 * 10 + 8 * 201) + 2 * (120 * 90 + 8 * 255)) / 16384 = 23.2
        {FilterRule::Nv2aHalfUp8, 25},    // 22.7 becomes 23, 101.0 stays; (251 * 23 + 5 * 101) / 256 = 24.5
    };
    check_table(rows, &Row::rule, &Row::expected);
    for (const Row& row : rows) {
        INFO(enum_name(row.rule));
        Frame frame                 = small_frame(1, 1);
        frame.arithmetic.filter     = row.rule;
        Pass& pass                  = frame.passes[0];
        pass.state.stages[0]        = kTextureOnly;
        pass.state.stages[0].filter = TextureFilter::Linear;
        DrawRectangle draw          = rectangle({0, 0, 1, 1}, 0);
        draw.textures[0]            = bound(add_texture(frame, TextureFormat::L8, 2, 2, {10, 201, 90, 255}));
        draw.uv[0].u0 = draw.uv[0].u1 = (128.0f + 17.0f) / 512.0f;
        draw.uv[0].v0 = draw.uv[0].v1 = (128.0f + 5.0f) / 512.0f;
        pass.draws                    = {draw};
        CHECK(grey(frame) == row.expected);
    }
}

TEST_CASE("each filter rule between mip levels", "[execute]") {
    // Levels of 3 and 250 at a fraction of 44/256, or 2/16.
    for (const FilterRule rule : {FilterRule::Reference8, FilterRule::GsFloor4, FilterRule::GsNearest4,
                                  FilterRule::FlipperFloor7, FilterRule::Nv2aHalfUp8}) {
        INFO(enum_name(rule));
        Frame frame                     = small_frame(1, 1);
        frame.arithmetic.filter         = rule;
        Pass& pass                      = frame.passes[0];
        pass.state.stages[0]            = kTextureOnly;
        pass.state.stages[0].mip_filter = MipFilter::Linear;
        DrawRectangle draw              = rectangle({0, 0, 1, 1}, 0);
        draw.textures[0]                = bound(add_texture(frame, TextureFormat::L8, 2, 2, {3, 3, 3, 3, 250}, 2));
        draw.uv[0].u1                   = 1.162f / 2.0f;  // 1.162 texels a pixel: squared 1.35, and 0.35 of 128 is 44
        draw.uv[0].v1                   = 1.162f / 2.0f;
        pass.draws                      = {draw};
        const bool is_half_up           = rule == FilterRule::Reference8 || rule == FilterRule::Nv2aHalfUp8;
        // (3 * 212 + 250 * 44 + 128) >> 8 = 45; (3 * 14 + 250 * 2) >> 4 = 33
        CHECK(grey(frame) == (is_half_up ? 45 : 33));
    }
}

TEST_CASE("each rule for texture stages", "[execute]") {
    struct Row {
        CombineRule rule;
        std::uint32_t modulate, add_alpha;
    };
    const Row rows[] = {
        {CombineRule::Nearest255, 78, 178},  // 100 * 200 / 255 = 78.4
        {CombineRule::GsShift7, 156, 255},   // 100 * 200 / 128 = 156.25; 256 is clamped
        {CombineRule::Tev, 79, 179},         // 100 * 201 / 256 = 78.5
    };
    check_table(rows, &Row::rule, &Row::modulate);
    check_table(rows, &Row::rule, &Row::add_alpha);
    for (const Row& row : rows) {
        INFO(enum_name(row.rule));
        CHECK(grey(staged(row.rule, TextureOp::Modulate, 100, 200)) == row.modulate);
        CHECK(grey(staged(row.rule, TextureOp::ModulateColorAddAlpha, 100, 200)) == row.add_alpha);
        CHECK(grey(staged(row.rule, TextureOp::Add, 100, 200)) == 255);
    }
    // The argument's order counts in TEV: 200 * 100 / 256 = 78.1.
    CHECK(grey(staged(CombineRule::Tev, TextureOp::Modulate, 200, 100)) == 78);
    CHECK(grey(staged(CombineRule::Tev, TextureOp::AddSigned, 100, 200)) == 172);
    CHECK(grey(staged(CombineRule::Tev, TextureOp::AddSigned2X, 60, 100)) == 64);
    CHECK(grey(staged(CombineRule::Tev, TextureOp::Modulate4X, 20, 30)) == 9);  // 4 * 600 / 256 = 9.4
    // (100 * 64 + 200 * 192) / 256 = 175, with 64 the alpha of the diffuse colour
    CHECK(grey(staged(CombineRule::Tev, TextureOp::BlendDiffuseAlpha, 100, 200)) == 175);
}

TEST_CASE("each fog rule", "[execute]") {
    // Colour 200, fog colour 100, factor 77.
    const struct Row {
        FogRule rule;
        std::uint32_t expected;
    } rows[] = {
        {FogRule::Nearest255, 130},       // (77 * 200 + 178 * 100) / 255 = 130.2
        {FogRule::GsFloor256, 130},       // (77 * 200 + 179 * 100) / 256 = 130.1
        {FogRule::GsTwoFloors, 129},      // 60 and 69
        {FogRule::FlipperFloor256, 130},  // 77 is below 128: as GS_FLOOR256
    };
    for (const Row& row : rows) {
        INFO(enum_name(row.rule));
        Frame frame          = small_frame(17, 1);
        frame.arithmetic.fog = row.rule;
        Pass& pass           = frame.passes[0];
        // At a distance of 0: f = end / (end - start).
        pass.state.fog       = {.mode = FogMode::Linear, .color = {100 * kGrey}, .start = -178.0f, .end = 77.0f};
        pass.draws           = {add_quad(frame, 200 * kGrey)};
        CHECK(grey(frame) == row.expected);
    }
    // A factor of 255 is not quite one for the GS. A rectangle has no fog.
    const auto unfogged = [](FogRule rule, std::uint32_t fog_color) {
        Frame frame               = small_frame(17, 1);
        frame.arithmetic.fog      = rule;
        frame.passes[0].state.fog = {.mode = FogMode::Linear, .color = {fog_color * kGrey}, .start = 1.0f, .end = 2.0f};
        frame.passes[0].draws     = {add_quad(frame, 128 * kGrey)};
        return grey(frame);
    };
    CHECK(unfogged(FogRule::Nearest255, 200) == 128);
    CHECK(unfogged(FogRule::GsFloor256, 200) == 128);  // (255 * 128 + 200) / 256 = 128.3
    CHECK(unfogged(FogRule::GsFloor256, 100) == 127);  // (255 * 128 + 100) / 256 = 127.9
    CHECK(unfogged(FogRule::GsTwoFloors, 200) == 127);
    CHECK(unfogged(FogRule::FlipperFloor256, 100) == 128);
    Frame frame               = small_frame(17, 1);
    frame.arithmetic.fog      = FogRule::GsTwoFloors;
    frame.passes[0].state.fog = {.mode = FogMode::Linear, .color = {100 * kGrey}};
    frame.passes[0].draws     = {rectangle({0, 0, 17, 1}, 128 * kGrey)};
    CHECK(grey(frame) == 128);
}

TEST_CASE("each blend rule", "[execute]") {
    // Source 200 with alpha 100 over 50.
    const struct Row {
        BlendRule rule;
        std::uint32_t expected;
    } rows[] = {
        {BlendRule::Nearest255, 109},       // (200 * 100 + 50 * 155) / 255 = 108.8
        {BlendRule::GsShift7, 167},         // (150 * 100 >> 7) + 50
        {BlendRule::FlipperTrunc256, 108},  // (200 * 100 + 50 * 156) / 256 = 108.6
    };
    check_table(rows, &Row::rule, &Row::expected);
    for (const Row& row : rows) {
        INFO(enum_name(row.rule));
        Frame frame            = blended(kAlphaOver, 0x64c8c8c8, 50 * kGrey);
        frame.arithmetic.blend = row.rule;
        if (row.rule == BlendRule::GsShift7) {
            frame.passes[0].state.blend    = {};
            frame.passes[0].state.gs_blend = {.a = GsColor::Cs, .b = GsColor::Cd, .c = GsAlpha::As, .d = GsColor::Cd};
        }
        CHECK(grey(frame) == row.expected);
    }
}

TEST_CASE("what the blender sees of the source", "[execute]") {
    // Red 0xcf, of which five bits are 0xc8, added to 0x29: 0xf8 is kept as 0xff, 0xf1 as 0xf7.
    const struct Row {
        BlendSource source;
        std::uint32_t expected;
    } rows[] = {{BlendSource::Bytes, 0xff}, {BlendSource::TargetBits, 0xf7}};
    check_table(rows, &Row::source, &Row::expected);
    for (const Row& row : rows) {
        INFO(enum_name(row.source));
        Frame frame                   = blended({BlendFactor::One, BlendFactor::One}, 0xffcf0000, 0xff290000);
        frame.targets[0].format       = TargetFormat::R5G6B5;
        frame.arithmetic.blend_source = row.source;
        CHECK(color_on_both(frame) == (0xff000000 | row.expected << 16));
    }
}
