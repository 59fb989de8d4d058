// SPDX-License-Identifier: MIT
// Registers of small frames, known by hand.
#include "pipeline/emit/emit_gs.h"

#include <bit>
#include <catch2/catch.hpp>

#include "pipeline/emit/gs_copies.h"
#include "pipeline/emit/gs_sprites.h"
#include "tests/support/gs_frames.h"

using namespace pipeline;
using namespace test_support;

namespace {

// All that is written to a register in the steps whose name begins so.
std::vector<std::uint64_t> written(const Frame& frame, GsReg reg, std::string_view step) {
    std::vector<std::uint64_t> values;
    for (const GsGroup& group : emit_gs(legal_gs_frame(frame)).groups)
        for (const GsStep& each : group.steps)
            if (each.what.starts_with(step))
                for (const GsWrite& write : each.writes)
                    if (write.reg == reg) values.push_back(write.value);
    return values;
}
std::uint64_t one_written(const Frame& frame, GsReg reg, std::string_view step) {
    const std::vector<std::uint64_t> values = written(frame, reg, step);
    REQUIRE(values.size() == 1);
    return values[0];
}

DrawRectangle rectangle(float x0, float y0, float x1, float y1) {
    DrawRectangle draw;
    draw.x0 = x0;
    draw.y0 = y0;
    draw.x1 = x1;
    draw.y1 = y1;
    return draw;
}

constexpr TextureStage kDecal{.color_op = TextureOp::SelectArg1, .alpha_op = TextureOp::SelectArg1};

using Values = std::vector<std::uint64_t>;

std::uint64_t corner(int x, int y, std::uint64_t z = 0) {
    return static_cast<std::uint64_t>(32768 + 16 * x) | static_cast<std::uint64_t>(32768 + 16 * y) << 16 | z << 32;
}
std::uint64_t uv(std::uint64_t u, std::uint64_t v) {
    return u | v << 16;
}

}  // namespace

TEST_CASE("State of a pass as registers of the GS") {
    Frame frame           = gs_frame(100, 50, TargetFormat::Psmct16, TargetFormat::D16);
    PipelineState& state  = frame.passes[0].state;
    state.gs_blend        = {.a        = GsColor::Cs,
                             .b        = GsColor::Cd,
                             .c        = GsAlpha::Fix,
                             .d        = GsColor::Cd,
                             .fix      = 0x40,
                             .pabe     = true,
                             .colclamp = false,
                             .fba      = true};
    state.color_mask      = {.red = false, .green = true, .blue = true, .alpha = false};
    state.depth           = {.func = CompareFunc::Greater, .write = false};
    state.alpha_test      = {.func = CompareFunc::NotEqual, .reference = 0x21, .fail = AlphaFail::ZbOnly};
    state.dest_alpha_test = DestAlphaTest::One;
    state.dither.mode     = DitherMode::GsDimx;
    state.dither.matrix   = {-4, 3, -1};
    state.viewport        = {10, 0, 90, 50};
    state.scissor         = {0, 5, 80, 45};
    state.fog             = {.mode = FogMode::Linear, .color = {0xff102030}};
    frame.passes[0].draws.push_back(rectangle(0, 0, 8, 8));
    CHECK(one_written(frame, GsReg::Alpha, "state") == 0x4000000064);
    CHECK(one_written(frame, GsReg::Pabe, "state") == 1);
    CHECK(one_written(frame, GsReg::ColClamp, "state") == 0);
    CHECK(one_written(frame, GsReg::Fba, "state") == 1);
    // Two pages of 64x64 each: depth follows colour at page 2.
    CHECK(one_written(frame, GsReg::Frame, "state") == 0xff0000ff02020000);
    CHECK(one_written(frame, GsReg::Zbuf, "state") == 0x0000000102000002);
    CHECK(one_written(frame, GsReg::Test, "state") ==
          (1 | 7 << 1 | 0x21 << 4 | 2 << 12 | 1 << 14 | 1 << 15 | 1 << 16 | 3 << 17));
    CHECK(one_written(frame, GsReg::Dthe, "state") == 1);
    CHECK(one_written(frame, GsReg::Dimx, "state") == 0x734);
    CHECK(one_written(frame, GsReg::Scissor, "state") ==
          (10 | 79 << 16 | std::uint64_t{5} << 32 | std::uint64_t{44} << 48));
    CHECK(one_written(frame, GsReg::FogCol, "state") == 0x302010);
}

TEST_CASE("A depth target that a pass does not use is not named beside colours of another family") {
    Frame frame = gs_frame(64, 32, TargetFormat::Psmct16, TargetFormat::D24);
    frame.passes[0].draws.push_back(rectangle(0, 0, 8, 8));
    CHECK(one_written(frame, GsReg::Zbuf, "state") == 0x0000000102000000);  // masked PSMZ16
    frame.passes[0].clear.depth = 1.0f;
    const Values zbufs          = written(frame, GsReg::Zbuf, "clear");
    REQUIRE(zbufs.size() == 1);
    CHECK(zbufs[0] == 0x0000000001000001);
    CHECK(one_written(frame, GsReg::Frame, "clear") ==
          0xffffffff00010001);  // PSMCT32, all bits kept, at the depth's page
}

TEST_CASE("Clears are sprites of a page's width, of both targets at once") {
    Frame frame                   = gs_frame(100, 50, TargetFormat::Psmct32, TargetFormat::D24);
    frame.passes[0].clear         = {.color = Argb{0x80402010}, .depth = 0.5f};
    frame.passes[0].state.scissor = {10, 5, 100, 50};
    const std::uint64_t depth     = 0x800000;  // half of 2^30 - 1 to the nearest even number, over 2^6
    CHECK(written(frame, GsReg::Xyz2, "clear") ==
          Values{corner(10, 5, depth), corner(64, 50, depth), corner(64, 5, depth), corner(100, 50, depth)});
    CHECK(one_written(frame, GsReg::Rgbaq, "clear") == 0x3f80000080102040);
    CHECK(one_written(frame, GsReg::Test, "clear") == 0x30002);  // no alpha test, depth always passes
    CHECK(one_written(frame, GsReg::Zbuf, "clear") == 0x0000000001000004);
    // Not all is cleared: both start at zero.
    CHECK(written(frame, GsReg::Rgbaq, "target 0 'color'") == Values{0x3f80000000000000});
    CHECK(written(frame, GsReg::Xyz2, "target 1 'depth'").size() == 4);
}

TEST_CASE("A rectangle pixel by pixel has whole and half sixteenths, in strips of powers of two") {
    Frame frame = gs_frame(100, 24);
    frame.targets.push_back({.name = "source", .format = TargetFormat::Psmct32, .width = 100, .height = 24});
    Pass& pass                     = frame.passes[0];
    pass.state.stages[0]           = kDecal;
    pass.state.stages[0].address_u = pass.state.stages[0].address_v = TextureAddress::Clamp;
    DrawRectangle draw                                              = rectangle(0, 0, 100, 24);
    draw.textures[0]                                                = {.texture = {}, .target = {1}};
    pass.draws.push_back(draw);
    CHECK(one_written(frame, GsReg::Prim, "rectangle") == 0x116);
    // 64, 32 and 4 pixels across, 16 and 8 down.
    const Values corners{corner(0, 0),  corner(64, 16),  corner(0, 16),  corner(64, 24),
                         corner(64, 0), corner(96, 16),  corner(64, 16), corner(96, 24),
                         corner(96, 0), corner(100, 16), corner(96, 16), corner(100, 24)};
    CHECK(written(frame, GsReg::Xyz2, "rectangle") == corners);
    const Values texels{uv(0, 0),      uv(1024, 256), uv(0, 256),  uv(1024, 384), uv(1024, 0),   uv(1536, 256),
                        uv(1024, 256), uv(1536, 384), uv(1536, 0), uv(1600, 256), uv(1536, 256), uv(1600, 384)};
    CHECK(written(frame, GsReg::Uv, "rectangle") == texels);
    // REGION_CLAMP both ways only for sizes that are no powers of two; DECAL, alpha of the texture.
    CHECK(one_written(frame, GsReg::Clamp, "rectangle") == (2 | 2 << 2 | 99 << 14 | std::uint64_t{23} << 34));
    CHECK(one_written(frame, GsReg::Tex0, "rectangle") ==
          (64 | 2 << 14 | 7 << 26 | std::uint64_t{5} << 30 | std::uint64_t{1} << 34 | std::uint64_t{1} << 35));
}

TEST_CASE("Texels that sixteenths do not name are told by S and T, exactly") {
    const GsAxis thirds{0, 16 * 48, 0.0, 16.0, true};
    CHECK(strips_by_uv(thirds, 0, 48).empty());
    const std::vector<GsStrip> strips = strips_by_st(thirds, 0, 48, 4);
    REQUIRE(!strips.empty());
    CHECK(strips.front().from == 0);
    for (const GsStrip& strip : strips) {
        const GsAxis written_axis{16 * strip.first, 16 * strip.end, 16.0 * double{std::bit_cast<float>(strip.from)},
                                  16.0 * double{std::bit_cast<float>(strip.to)}, true};
        for (std::int32_t x = strip.first; x < strip.end; ++x)
            CHECK(sixteenths_at(written_axis, x) == sixteenths_at(thirds, x));
    }
    // Outside 0..1023.9375 texels.
    CHECK(strips_by_uv({0, 256, -1.0, 15.0, true}, 0, 16).empty());
    CHECK(strips_by_uv({0, 256, 1008.0, 1024.0, true}, 0, 16).empty());
    CHECK(strips_by_uv({0, 256, 1.5, 17.5, true}, 0, 16) == std::vector<GsStrip>{{0, 16, 24, 280}});
}

TEST_CASE("A texture of 5 x 3 has rows of whole blocks, and a palette in the chip's order") {
    Frame frame                    = gs_frame(8, 8);
    Texture& texture               = frame.textures.emplace_back();
    texture                        = {.name   = "l",
                                      .format = TextureFormat::L8,
                                      .width  = 5,
                                      .height = 3,
                                      .levels = 1,
                                      .texels = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}};
    Pass& pass                     = frame.passes[0];
    pass.state.stages[0]           = kDecal;
    pass.state.stages[0].address_u = pass.state.stages[0].address_v = TextureAddress::Clamp;
    DrawRectangle draw                                              = rectangle(0, 0, 5, 3);
    draw.textures[0]                                                = {.texture = {0}, .target = {}};
    pass.draws.push_back(draw);
    const GsStream stream = emit_gs(legal_gs_frame(frame));
    const GsStep& upload  = stream.groups.at(1).steps.at(0);
    REQUIRE(upload.image.size() == 48);
    CHECK(upload.image[4] == 5);
    CHECK(upload.image[5] == 0);
    CHECK(upload.image[16] == 6);
    CHECK(upload.writes == std::vector<GsWrite>{{GsReg::BitBltBuf, 32ull << 32 | 2ull << 48 | 0x13ull << 56},
                                                {GsReg::TrxPos, 0},
                                                {GsReg::TrxReg, 16 | 3ull << 32},
                                                {GsReg::TrxDir, 0}});
    const GsStep& palette = stream.groups.at(1).steps.at(1);
    REQUIRE(palette.image.size() == 1024);
    // Entry 8 stands where 16 would.
    CHECK(palette.image[4 * 16] == 8);
    CHECK(palette.image[4 * 8] == 16);
    CHECK(palette.image[4 * 24 + 3] == 255);
    CHECK(palette.image[4 * 200 + 1] == 208);
    CHECK(decode(GsReg::Tex0, "CBP", one_written(frame, GsReg::Tex0, "rectangle")) == 33);
    CHECK(decode(GsReg::Tex0, "CLD", one_written(frame, GsReg::Tex0, "rectangle")) == 1);
}

TEST_CASE("Vertices of triangles") {
    Frame frame          = gs_frame(64, 64, TargetFormat::Psmct32, TargetFormat::D24);
    Pass& pass           = frame.passes[0];
    pass.state.depth     = {.func = CompareFunc::GreaterEqual, .write = true};
    pass.state.fog.mode  = FogMode::Linear;
    pass.state.stages[0] = {.color_op = TextureOp::Modulate, .alpha_op = TextureOp::Modulate};
    WindowVertex vertex{.x        = -1.97f,
                        .y        = 2.5f,
                        .z        = 1.0f,
                        .rhw      = 0.5f,
                        .diffuse  = {0x80402010},
                        .specular = {0x21000000},
                        .uv0      = {3.0f, 1.0f, 2.0f}};
    Random random(1);
    const TextureId texture        = add_random_texture(frame, TextureFormat::A8R8G8B8, 48, 16, random);
    pass.state.stages[0].address_u = TextureAddress::Clamp;
    add_triangle(frame, pass, {vertex, {.x = 20.0f}, {.y = 20.0f}}, {.texture = texture, .target = {}});
    // Towards zero: -31 sixteenths.
    CHECK(written(frame, GsReg::Xyzf2, "triangles")[0] ==
          (std::uint64_t{0x21} << 56 | std::uint64_t{0xffffff} << 32 | std::uint64_t{32768 + 40} << 16 | (32768 - 31)));
    CHECK(written(frame, GsReg::Rgbaq, "triangles")[0] == 0x3f80000080102040);  // Q 2 * 0.5
    // S 3 * 0.5 * 48/64, T 0.5
    CHECK(written(frame, GsReg::St, "triangles")[0] ==
          (std::uint64_t{std::bit_cast<std::uint32_t>(0.5f)} << 32 | std::bit_cast<std::uint32_t>(1.125f)));
    CHECK(one_written(frame, GsReg::Prim, "triangles") == (3 | 1 << 3 | 1 << 4 | 1 << 5));
}

TEST_CASE("32 bits of depth and fog are two registers") {
    Frame frame         = gs_frame(64, 64, TargetFormat::Psmct32, TargetFormat::D32);
    Pass& pass          = frame.passes[0];
    pass.state.fog.mode = FogMode::Linear;
    add_triangle(frame, pass, {WindowVertex{.z = 1.0f, .specular = {0x21000000}}, {.x = 20.0f}, {.y = 20.0f}});
    CHECK(written(frame, GsReg::Xyzf2, "triangles").empty());
    CHECK(written(frame, GsReg::Fog, "triangles")[0] == 0x2100000000000000);
    CHECK(written(frame, GsReg::Xyz2, "triangles")[0] == 0xffffffff80008000);
}

TEST_CASE("Copies are transfers within the memory") {
    Frame frame = gs_frame(100, 50);
    frame.targets.push_back({.name = "source", .format = TargetFormat::Psmct32, .width = 70, .height = 40});
    frame.passes[0].draws.push_back(CopyRectangle{.source = {1}, .from = {3, 4, 60, 34}, .x = 7, .y = 9});
    CHECK(one_written(frame, GsReg::BitBltBuf, "copy") == (128 | 2 << 16 | 2ull << 48));
    CHECK(one_written(frame, GsReg::TrxPos, "copy") == (3 | 4 << 16 | 7ull << 32 | 9ull << 48));
    CHECK(one_written(frame, GsReg::TrxReg, "copy") == (57 | 30ull << 32));
    CHECK(one_written(frame, GsReg::TrxDir, "copy") == 2);
}

TEST_CASE("Green to alpha: a page has four columns of 8 by 64") {
    const CopyRectangle whole{.source = {1}, .from = {0, 0, 64, 32}, .channels = CopyChannels::GreenToAlpha};
    std::vector<GsShuffle> columns = shuffle_columns(whole, 1, 1);
    std::erase_if(columns, [](const GsShuffle& column) { return column.width == 8 && column.height == 64; });
    CHECK(columns.empty());
    CHECK(shuffle_columns(whole, 1, 1).size() == 4);
    CHECK(shuffle_columns(whole, 1, 1)[3] == GsShuffle{0, 0, 48, 0, 48, 0, 8, 64});
    // A pixel of its own: block (1, 2) of the page is block (2, 1) of the view.
    const CopyRectangle pixel{
        .source = {1}, .from = {9, 18, 10, 19}, .x = 64 + 3, .y = 32 + 5, .channels = CopyChannels::GreenToAlpha};
    CHECK(shuffle_columns(pixel, 1, 2) == std::vector<GsShuffle>{{0, 3, 33, 10, 3, 5, 1, 1}});
}

TEST_CASE("Alpha to colour reads PSMT8H by a palette of greys") {
    Frame frame = gs_frame(64, 32);
    frame.targets.push_back({.name = "source", .format = TargetFormat::Psmct32, .width = 64, .height = 32});
    frame.passes[0].draws.push_back(
        CopyRectangle{.source = {1}, .from = {0, 0, 64, 32}, .channels = CopyChannels::AlphaToColor});
    const std::uint64_t tex0 = one_written(frame, GsReg::Tex0, "copy");
    CHECK(decode(GsReg::Tex0, "PSM", tex0) == 0x1b);
    CHECK(decode(GsReg::Tex0, "TBP0", tex0) == 32);
    CHECK(decode(GsReg::Tex0, "CBP", tex0) == 64);
    CHECK(decode(GsReg::Tex0, "TFX", tex0) == 1);
    CHECK(decode(GsReg::Frame, "FBMSK", one_written(frame, GsReg::Frame, "copy")) == 0xff000000);
    CHECK(written(frame, GsReg::Uv, "copy") == Values{uv(8, 8), uv(1032, 520)});
}

TEST_CASE("What the registers cannot hold is refused") {
    Frame frame = gs_frame(64, 64);
    add_triangle(frame, frame.passes[0], {WindowVertex{.x = 2047.9f}, {.x = -2048.0f}, {.y = 20.0f}});
    CHECK_NOTHROW(emit_gs({.frame = frame, .notes = {}, .left = {}}));
    frame.window_vertices[0].x = 2048.0f;
    CHECK_THROWS_WITH(emit_gs({.frame = frame, .notes = {}, .left = {}}),
                      Catch::Contains("2048") && Catch::Contains("-2048..2047.9375"));

    Frame other = gs_frame(8, 8, TargetFormat::Psmct16);
    other.targets.push_back({.name = "source", .format = TargetFormat::Psmct16, .width = 8, .height = 8});
    other.passes[0].draws.push_back(
        CopyRectangle{.source = {1}, .from = {0, 0, 8, 8}, .channels = CopyChannels::AlphaToColor});
    CHECK_THROWS_AS(emit_gs({.frame = other, .notes = {}, .left = {}}), std::invalid_argument);

    CHECK_THROWS_WITH(emit_gs({.frame = gs_frame(8, 8), .notes = {}, .left = {{"frame", "memory", "much", "little"}}}),
                      Catch::Contains("frame uses much, the chip has little"));

    Frame full                     = gs_frame(1024, 1024);
    full.passes[0].state.stages[0] = kDecal;
    full.passes[0].draws.push_back(rectangle(0, 0, 8, 8));
    CHECK_THROWS_AS(emit_gs({.frame = full, .notes = {}, .left = {}}),
                    std::invalid_argument);  // a white texel behind 4 MB
}
