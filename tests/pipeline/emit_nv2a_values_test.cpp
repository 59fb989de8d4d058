// SPDX-License-Identifier: MIT
// Each enumerator that a frame may have on the Xbox as the NV2A's number for it, written by hand from nxdk's lib/pbkit/nv_regs.h and
// xemu's hw/xbox/nv2a. Texture stages: emit_nv2a_stages_test.cpp.
#include <cmath>

#include "tests/support/nv2a_written.h"

using namespace pipeline;
using namespace test_support;

TEST_CASE("blend factors", "[emit][nv2a]") {
    const std::pair<BlendFactor, std::uint32_t> rows[] = {
        {BlendFactor::Zero, 0x0000},        {BlendFactor::One, 0x0001},
        {BlendFactor::SourceColor, 0x0300}, {BlendFactor::InvSourceColor, 0x0301},
        {BlendFactor::DestColor, 0x0306},   {BlendFactor::InvDestColor, 0x0307},
        {BlendFactor::SourceAlpha, 0x0302}, {BlendFactor::InvSourceAlpha, 0x0303},
        {BlendFactor::DestAlpha, 0x0304},   {BlendFactor::InvDestAlpha, 0x0305},
    };
    check_table(
        rows, [](const auto& row) { return row.first; }, [](const auto& row) { return row.second; });
    for (const auto& [factor, code] : rows) {
        const Written source = with_state([&](PipelineState& state) { state.blend = {factor, BlendFactor::One}; });
        CHECK(source[0x344] == code);
        CHECK(source[0x348] == 1);
        CHECK(source[0x304] == 1);
        const Written dest = with_state([&](PipelineState& state) {
            state.blend = {BlendFactor::SourceAlpha, factor};
        });
        CHECK(dest[0x348] == code);
    }
    const Written off = with_state([](PipelineState&) {});
    CHECK(off[0x304] == 0);
    CHECK(off[0x350] == 0x8006);
}

TEST_CASE("comparisons", "[emit][nv2a]") {
    const std::pair<CompareFunc, std::uint32_t> rows[] = {
        {CompareFunc::Always, 0x207},       {CompareFunc::LessEqual, 0x203}, {CompareFunc::Less, 0x201},
        {CompareFunc::GreaterEqual, 0x206}, {CompareFunc::Greater, 0x204},   {CompareFunc::Equal, 0x202},
        {CompareFunc::NotEqual, 0x205},     {CompareFunc::Never, 0x200},
    };
    check_table(
        rows, [](const auto& row) { return row.first; }, [](const auto& row) { return row.second; });
    for (const auto& [func, code] : rows) {
        const Written written = with_state([&](PipelineState& state) {
            state.depth      = {func, false};
            state.alpha_test = {.func = func, .reference = 0x81};
        });
        CHECK(written[0x354] == code);
        CHECK(written[0x33c] == code);
        CHECK(written[0x340] == 0x81);
        CHECK(written[0x30c] == (func != CompareFunc::Always));
        CHECK(written[0x300] == (func != CompareFunc::Always));
        CHECK(written[0x35c] == 0);
    }
    // Depth is written only where the test is on.
    const Written writes = with_state([](PipelineState& state) { state.depth = {CompareFunc::Always, true}; });
    CHECK(writes[0x30c] == 1);
    CHECK(writes[0x35c] == 1);
}

TEST_CASE("masks, culling and shading", "[emit][nv2a]") {
    CHECK(with_state([](PipelineState&) {})[0x358] == 0x01010101);
    const auto mask = [](ColorMask channels) {
        return with_state([&](PipelineState& state) { state.color_mask = channels; })[0x358];
    };
    CHECK(mask({true, false, false, false}) == 0x00010000);
    CHECK(mask({false, true, false, false}) == 0x00000100);
    CHECK(mask({false, false, true, false}) == 0x00000001);
    CHECK(mask({false, false, false, true}) == 0x01000000);

    const auto cull = [](CullMode mode) { return with_state([&](PipelineState& state) { state.cull = mode; }); };
    CHECK(cull(CullMode::None)[0x308] == 0);
    CHECK(cull(CullMode::Clockwise)[0x308] == 1);
    CHECK(cull(CullMode::Clockwise)[0x3a0] == 0x900);
    CHECK(cull(CullMode::Clockwise)[0x39c] == 0x404);
    CHECK(cull(CullMode::CounterClockwise)[0x3a0] == 0x900);
    CHECK(cull(CullMode::CounterClockwise)[0x39c] == 0x405);

    const auto shade = [](ShadeMode mode) { return with_state([&](PipelineState& state) { state.shade = mode; }); };
    CHECK(shade(ShadeMode::Flat)[0x37c] == 0x1d00);
    CHECK(shade(ShadeMode::Gouraud)[0x37c] == 0x1d01);
    CHECK(shade(ShadeMode::Flat)[0x9fc] == 1);
}

TEST_CASE("fog", "[emit][nv2a]") {
    const auto fog = [](const FogState& fog_state) {
        return with_state([&](PipelineState& state) { state.fog = fog_state; });
    };
    CHECK(fog({})[0x2a4] == 0);
    // f = p0 + p1 d - 1: (8 - d) / (8 - 4) has p1 = -1/4, p0 = 3.
    const Written linear = fog({.mode = FogMode::Linear, .color = {0x44332211}, .start = 4.0f, .end = 8.0f});
    CHECK(linear[0x2a4] == 1);
    CHECK(linear[0x29c] == 0x2601);
    CHECK(linear[0x2a0] == 3);
    CHECK(linear.real(0x9c0) == 3.0f);
    CHECK(linear.real(0x9c4) == -0.25f);
    CHECK(linear[0x2a8] == 0x44112233);
    CHECK(linear.real(0x9d8) == 1.0f);
    // e^(-d / 2) = 2^(16 p1 d): p1 = -1 / (32 ln 2).
    const Written exp = fog({.mode = FogMode::Exp, .density = 0.5f, .range = true});
    CHECK(exp[0x29c] == 0x800);
    CHECK(exp[0x2a0] == 1);
    CHECK(exp.real(0x9c0) == 1.5f);
    CHECK(exp.real(0x9c4) == Approx(-1.0 / (32.0 * std::log(2.0))));
    // e^(-(d / 2)^2) = 2^(-32 p1^2 d^2): p1^2 = 1 / (128 ln 2).
    const Written exp2 = fog({.mode = FogMode::Exp2, .density = 0.5f});
    CHECK(exp2[0x29c] == 0x801);
    CHECK(exp2.real(0x9c4) == Approx(-1.0 / std::sqrt(128.0 * std::log(2.0))));
    // Where it starts and ends at once, all is fog.
    const Written wall = fog({.mode = FogMode::Linear, .start = 4.0f, .end = 4.0f});
    CHECK(wall.real(0x9c0) == 1.0f);
    CHECK(wall.real(0x9c4) == 0.0f);
    // FOG.a R0 + (1 - FOG.a) FOG, or R0.
    CHECK(linear[0x288] == 0x130c0300);
    CHECK(fog({})[0x288] == 0x0000000c);
    CHECK(linear[0x28c] == 0x00001c00);
}

TEST_CASE("targets' formats", "[emit][nv2a]") {
    struct Row {
        TargetFormat color, depth;
        std::uint32_t surface, texture, color_clear, zeta_clear, clip_max;
    };
    const Row rows[] = {
        {TargetFormat::A8R8G8B8, TargetFormat::D24, 0x128, 0x12, 0x80ff8040, 0x7fffff00, 0x4b7fffff},
        {TargetFormat::X8R8G8B8, TargetFormat::D24, 0x124, 0x1e, 0x80ff8040, 0x7fffff00, 0x4b7fffff},
        // 31, 32, 8 of 31, 63, 31.
        {TargetFormat::R5G6B5, TargetFormat::D16, 0x113, 0x11, 0xfc08, 0x7fff, 0x477fff00},
    };
    for (const Row& row : rows) {
        CAPTURE(row.color);
        Frame frame             = quad_frame(row.depth);
        frame.targets[0].format = row.color;
        frame.passes[0].clear   = {.color = Argb{0x80ff8040}, .depth = 0.5f};
        const Written first(frame);
        CHECK(first.at_clear(0x1d90) == row.color_clear);
        // Half of the greatest of 30 bits, rounded to even: 0x20000000, of which the first 24 or 16 are kept.
        CHECK(first.at_clear(0x1d8c) == (row.depth == TargetFormat::D16 ? 0x8000u : 0x80000000u));
        CHECK(first[0x208] == row.surface);
        CHECK(first[0x398] == row.clip_max);
        // Read by a second pass.
        frame.targets.push_back({.name = "second", .width = 16, .height = 8});
        Pass& pass           = frame.passes.emplace_back();
        pass.color           = {2};
        pass.state.stages[0] = kTextureOnly;
        DrawRectangle draw   = rectangle({0, 0, 16, 8}, 0xffffffff);
        draw.textures[0]     = {.texture = {}, .target = {0}};
        pass.draws.push_back(draw);
        const Written second(frame);
        CHECK(second[0x1b04] == (0x10029u | row.texture << 8));
        CHECK(second[0x1b10] == 64u << 16);
        CHECK(second[0x1b1c] == (16u << 16 | 8u));
    }
}

TEST_CASE("lights and materials", "[emit][nv2a]") {
    PipelineState base;
    LightingState& lighting    = base.lighting;
    lighting.enabled           = true;
    lighting.ambient           = {0.5f, 0.25f, 1.0f};
    lighting.diffuse_source    = ColorSource::Material;
    lighting.material.diffuse  = {0.5f, 1.0f, 0.25f, 0.75f};
    lighting.material.ambient  = {0.5f, 0.5f, 0.5f};
    lighting.material.emissive = {0.125f, 0.0f, 0.0f};
    lighting.lights.push_back({.type      = LightType::Directional,
                               .diffuse   = {1.0f, 0.5f, 2.0f},
                               .ambient   = {0.5f, 0.0f, 0.0f},
                               .direction = {0.0f, 0.0f, 2.0f}});
    lighting.lights.push_back(
        {.type = LightType::Point, .position = {1.0f, 2.0f, 3.0f}, .range = 9.0f, .attenuation = {1.0f, 0.5f, 0.25f}});
    const auto lit = [&](const std::function<void(LightingState&)>& change) {
        return with_state([&](PipelineState& state) {
            state = base;
            change(state.lighting);
        });
    };
    const Written written = lit([](LightingState&) {});
    CHECK(written[0x314] == 1);
    CHECK(written[0x3bc] == 0x9);  // 0 infinite, 1 local
    CHECK(written[0x298] == 0);
    CHECK(written[0x3a4] == 0);
    CHECK(written.real(0x3b4) == 0.75f);
    CHECK(written.real(0xa10) == 0.375f);  // 1/8 + 1/2 * 1/2
    CHECK(written.real(0xa14) == 0.125f);
    CHECK(written.real(0x3a8) == 0.0f);
    CHECK(written.real(0x1000) == 0.25f);
    CHECK(written.real(0x100c) == 0.5f);
    CHECK(written.real(0x1010) == 0.5f);
    CHECK(written.real(0x1014) == 0.5f);
    CHECK(written.real(0x1024) == 1e30f);
    CHECK(written.real(0x103c) == -1.0f);  // toward the light
    CHECK(written.real(0x1080 + 0x24) == 9.0f);
    CHECK(written.real(0x1080 + 0x5c) == 1.0f);
    CHECK(written.real(0x1080 + 0x64) == 3.0f);
    CHECK(written.real(0x1080 + 0x6c) == 0.5f);
    CHECK(lit([](LightingState& state) { state.normalize_normals = true; })[0x3a4] == 1);

    const Written from_diffuse = lit([](LightingState& state) { state.diffuse_source = ColorSource::Color1; });
    CHECK(from_diffuse[0x298] == 0x10);
    CHECK(from_diffuse.real(0x100c) == 1.0f);
    CHECK(lit([](LightingState& state) { state.diffuse_source = ColorSource::Color2; })[0x298] == 0x20);

    // What the sources do not say for sure is lit by the program.
    CHECK(lit([](LightingState& state) { state.ambient_source = ColorSource::Color1; })[0x314] == 0);
    CHECK(lit([](LightingState& state) { state.emissive_source = ColorSource::Color2; })[0x314] == 0);
    const auto highlight = [](LightingState& state) {
        state.specular_enable    = true;
        state.lights[0].specular = Vec3(1.0f);
    };
    const Written shiny = lit(highlight);
    CHECK(shiny[0x314] == 0);
    CHECK(shiny[0x3b8] == 1);
    // Highlights that nothing adds, or that no light has, are none.
    CHECK(lit([](LightingState& state) { state.lights[0].specular = Vec3(1.0f); })[0x314] == 1);
    CHECK(lit([](LightingState& state) { state.specular_enable = true; })[0x314] == 1);
    CHECK(lit([](LightingState& state) { state.enabled = false; })[0x314] == 0);
}

TEST_CASE("coordinates", "[emit][nv2a]") {
    const auto with_coords = [](CoordSource source) {
        TextureStage stage = kTextureOnly;
        stage.coords       = source;
        stage.transform    = Mat4(1.0f);
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row) stage.transform[column][row] = static_cast<float>(10 * row + column);
        return with_stage(stage);
    };
    const Written first = with_coords(CoordSource::Vertex0), second = with_coords(CoordSource::Vertex1);
    CHECK(first[0x3c0] == 0);
    CHECK(first[0x3cc] == 0);
    // Attribute 9, two floats, every 48 bytes; the second pair is 8 bytes after the first.
    CHECK(first[0x1784] == 0x3022);
    CHECK(second[0x1744] == first[0x1744] + 8);
    const Written camera = with_coords(CoordSource::CameraPosition);
    CHECK(camera[0x3c0] == 0x2400);
    CHECK(camera[0x3c4] == 0x2400);
    CHECK(camera[0x3c8] == 0);
    CHECK(camera[0x3cc] == 0x2400);
    CHECK(camera.real(0x840 + 4) == 1.0f);
    CHECK(camera.real(0x850 + 4) == 11.0f);
    CHECK(camera.real(0x870 + 8) == 22.0f);  // Q takes the third row
    CHECK(camera[0x1784] == 2);              // no array
}

TEST_CASE("the composite matrix holds the viewport", "[emit][nv2a]") {
    Frame frame                    = quad_frame(TargetFormat::D24);
    frame.passes[0].state.viewport = {4, 2, 12, 6};
    const Written written(frame);
    // The camera's is the identity: x = 4 + (1 + x) 4, y = 2 + (1 - y) 2, z in units of 2^24 - 1.
    CHECK(written.real(0x680) == 4.0f);
    CHECK(written.real(0x68c) == 8.0f);
    CHECK(written.real(0x694) == -2.0f);
    CHECK(written.real(0x69c) == 4.0f);
    CHECK(written.real(0x6a8) == 16777215.0f);
    CHECK(written.real(0x6bc) == 1.0f);
    CHECK(written.real(0xa20) == 0.0f);
    CHECK(written[0x2c0] == 0x000b0004);
    CHECK(written[0x2e0] == 0x00050002);
    CHECK(written[0x200] == 0x00100000);
    CHECK(written[0x204] == 0x00080000);
    // A position, a diffuse colour.
    CHECK(written[0x1760] == 0x3032);
    CHECK(written[0x176c] == 0x3040);
    CHECK(written[0x172c] == written[0x1720] + 24);
}
