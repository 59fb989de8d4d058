// SPDX-License-Identifier: MIT
// The rules of validate for a pass: its state, what its draws bind, and the draws themselves.
#include "tests/support/valid_frame.h"

using namespace pipeline;
using namespace test_support;

TEST_CASE("validate: pipeline state") {
    check_rules({
        {"scissor beyond the target",
         [](Frame& f) {
             composite(f).state.scissor = {0, 0, 61, 40};
         },
         {{"pass 1 'composite': state.scissor", "must lie within the target, 60x40 (got 0 0 61 40)"}}},
        {"viewport below 0",
         [](Frame& f) {
             particles(f).state.viewport = {0, -1, 10, 40};
         },
         {{"pass 0 'particles': state.viewport", "must lie within the target, 60x40 (got 0 -1 10 40)"}}},
        {"empty scissor",
         [](Frame& f) {
             composite(f).state.scissor = {5, 5, 5, 6};
         },
         {{"pass 1 'composite': state.scissor",
           "must have x0 < x1 and y0 < y1, or be all zeros for the whole target (got 5 5 5 6)"}}},
        {"viewport inside out",
         [](Frame& f) {
             particles(f).state.viewport = {5, 6, 9, 2};
         },
         {{"pass 0 'particles': state.viewport",
           "must have x0 < x1 and y0 < y1, or be all zeros for the whole target (got 5 6 9 2)"}}},
        {"enumerator without a name",
         [](Frame& f) { composite(f).state.cull = static_cast<CullMode>(77); },
         {{"pass 1 'composite': state.cull", "must be one of NONE CW CCW (got #77)"}}},
        {"alpha goes on after the end",
         [](Frame& f) { particles(f).state.stages[1].alpha_op = TextureOp::Add; },
         {{"pass 0 'particles': state.stages[1].alpha_op", "must be DISABLE, as color_op is (got ADD)"}}},
        {"alpha ends before colour",
         [](Frame& f) { composite(f).state.stages[0].alpha_op = TextureOp::Disable; },
         {{"pass 1 'composite': state.stages[0].alpha_op",
           "must not be DISABLE while color_op is on: Direct3D 7 leaves that undefined; SELECTARG2 with CURRENT keeps "
           "the "
           "alpha"}}},
        {"a stage after the end",
         [](Frame& f) {
             composite(f).state.stages[0].color_op = composite(f).state.stages[0].alpha_op = TextureOp::Disable;
             composite(f).state.stages[1] = {.color_op = TextureOp::Add, .alpha_op = TextureOp::Add};
         },
         {{"pass 1 'composite': state.stages[1].color_op", "must be DISABLE: an earlier stage is (got ADD)"}}},
        {"stage matrix not finite",
         [](Frame& f) { composite(f).state.stages[1].transform[0][0] = kInfinity; },
         {{"pass 1 'composite': state.stages[1].transform", "must be finite"}}},
        {"fog not finite",
         [](Frame& f) { composite(f).state.fog.density = kNan; },
         {{"pass 1 'composite': state.fog.density", "must be finite (got nan)"}}},
        {"light not finite",
         [](Frame& f) { point_light(f).diffuse.z = kInfinity; },
         {{"pass 0 'particles': state.lighting.lights[1].diffuse", "must be finite (got (1 1 inf))"}}},
        {"material not finite",
         [](Frame& f) { particles(f).state.lighting.material.diffuse.w = kNan; },
         {{"pass 0 'particles': state.lighting.material.diffuse", "must be finite (got (1 1 1 nan))"}}},
        {"negative attenuation",
         [](Frame& f) { point_light(f).attenuation.y = -0.5f; },
         {{"pass 0 'particles': state.lighting.lights[1].attenuation", "must not be negative (got (1 -0.5 0))"}}},
        {"no attenuation",
         [](Frame& f) { point_light(f).attenuation = Vec3(0.0f); },
         {{"pass 0 'particles': state.lighting.lights[1].attenuation",
           "must not be all zero: the light would be infinite"}}},
        {"negative range",
         [](Frame& f) { point_light(f).range = -1.0f; },
         {{"pass 0 'particles': state.lighting.lights[1].range", "must be >= 0 (got -1)"}}},
        {"negative power",
         [](Frame& f) { particles(f).state.lighting.material.power = -2.0f; },
         {{"pass 0 'particles': state.lighting.material.power", "must be >= 0 (got -2)"}}},
        {"too many lights",
         [](Frame& f) { particles(f).state.lighting.lights.resize(9); },
         {{"pass 0 'particles': state.lighting.lights", "must be at most 8 (got 9)"}}},
    });
    check_valid({
        {"scissor of the whole target",
         [](Frame& f) {
             composite(f).state.scissor = {0, 0, 60, 40};
         }},
        {"one pixel in the corner",
         [](Frame& f) {
             composite(f).state.viewport = {59, 39, 60, 40};
         }},
        {"fog of no depth, not linear",
         [](Frame& f) {
             particles(f).state.fog.start = 2.0f;
             particles(f).state.fog.mode  = FogMode::Exp;
         }},
        {"directional lights have no attenuation",
         [](Frame& f) { particles(f).state.lighting.lights[0].attenuation = Vec3(0.0f); }},
        {"a light that darkens", [](Frame& f) { point_light(f).diffuse = Vec3(-1.0f); }},
        {"both stages",
         [](Frame& f) {
             composite(f).state.stages[1] = {.color_op = TextureOp::Add, .alpha_op = TextureOp::SelectArg2};
         }},
    });
}

TEST_CASE("validate: bindings") {
    check_rules({
        {"texture and target",
         [](Frame& f) { rectangle(f).textures[0].texture = {0}; },
         {{"pass 1 'composite': draws[0].textures[0]", "must bind a texture or a target, not both"}}},
        {"feedback",
         [](Frame& f) { rectangle(f).textures[0].target = {0}; },
         {{"pass 1 'composite': draws[0].textures[0].target", "must not be the target that the pass draws to"}}},
        {"depth as a texture",
         [](Frame& f) { rectangle(f).textures[1].target = {2}; },
         {{"pass 1 'composite': draws[0].textures[1].target", "must be a colour target (got D24)"}}},
        {"texture out of range",
         [](Frame& f) { triangles(f).textures[1].texture = {2}; },
         {{"pass 0 'particles': draws[0].textures[1].texture",
           "must refer to one of the 2 textures, or be nothing, -1 (got 2)"}}},
        {"wrapped, odd width",
         [](Frame& f) { triangles(f).textures[0].texture = {1}; },
         {{"pass 0 'particles': draws[0].textures[0]",
           "must have a size that is a power of two for address_u WRAP (got 3)"}}},
        {"mirrored target, odd height",
         [](Frame& f) { composite(f).state.stages[0].address_v = TextureAddress::Mirror; },
         {{"pass 1 'composite': draws[0].textures[0]",
           "must have a size that is a power of two for address_v MIRROR (got 40)"}}},
        {"wrapped for alpha only",
         [](Frame& f) {
             composite(f).state.stages[0].color_arg1.source = ArgSource::Diffuse;
             composite(f).state.stages[0].address_u         = TextureAddress::Wrap;
         },
         {{"pass 1 'composite': draws[0].textures[0]",
           "must have a size that is a power of two for address_u WRAP (got 60)"}}},
    });
    check_valid({
        {"mirrored, even width", [](Frame& f) { particles(f).state.stages[0].address_u = TextureAddress::Mirror; }},
        {"odd height is not wrapped",
         [](Frame& f) {
             triangles(f).textures[0].texture       = {1};
             particles(f).state.stages[0].address_u = TextureAddress::Clamp;
         }},
        {"wrapped, but not read",
         [](Frame& f) {
             triangles(f).textures[0].texture               = {1};
             particles(f).state.stages[0].color_arg1.source = ArgSource::TFactor;
         }},
        {"wrapped in an argument that the op leaves out",
         [](Frame& f) {
             triangles(f).textures[0].texture      = {1};
             particles(f).state.stages[0].color_op = TextureOp::SelectArg2;
         }},
        {"bound after the end of the chain", [](Frame& f) { triangles(f).textures[1].texture = {1}; }},
        {"read, with nothing bound", [](Frame& f) { triangles(f).textures[0] = {}; }},
        {"mip filter without mips", [](Frame& f) { composite(f).state.stages[0].mip_filter = MipFilter::Linear; }},
    });
}

TEST_CASE("validate: draws") {
    check_rules({
        {"no camera",
         [](Frame& f) { particles(f).camera = {}; },
         {{"pass 0 'particles': draws[0]", "must have a camera: the pass names none"}}},
        {"camera out of range",
         [](Frame& f) { particles(f).camera = {1}; },
         {{"pass 0 'particles': camera", "must refer to one of the 1 cameras, or be nothing, -1 (got 1)"}}},
        {"not whole triangles",
         [](Frame& f) { triangles(f).index_count = 4; },
         {{"pass 0 'particles': draws[0].index_count", "must be a multiple of 3 (got 4)"}}},
        {"beyond the indices",
         [](Frame& f) { triangles(f).first_index = 3; },
         {{"pass 0 'particles': draws[0]", "must use indices below 6 (got 3..8)"}}},
        {"beyond 32 bits",
         [](Frame& f) { triangles(f).first_index = 4294967293u; },
         {{"pass 0 'particles': draws[0]", "must use indices below 6 (got 4294967293..4294967298)"}}},
        {"world not finite",
         [](Frame& f) { triangles(f).world[3][0] = kNan; },
         {{"pass 0 'particles': draws[0].world", "must be finite"}}},
        {"left of itself",
         [](Frame& f) { rectangle(f).x0 = 61.0f; },
         {{"pass 1 'composite': draws[0].x1", "must be >= x0 (got 60)"}}},
        {"above itself",
         [](Frame& f) { rectangle(f).y1 = -1.0f; },
         {{"pass 1 'composite': draws[0].y1", "must be >= y0 (got -1)"}}},
        {"too far right",
         [](Frame& f) { rectangle(f).x1 = 16385.0f; },
         {{"pass 1 'composite': draws[0].x1", "must lie within 16384 pixels of 0 (got 16385)"}}},
        {"too far up",
         [](Frame& f) { rectangle(f).y0 = -16384.5f; },
         {{"pass 1 'composite': draws[0].y0", "must lie within 16384 pixels of 0 (got -16384.5)"}}},
        {"corner is no number",
         [](Frame& f) { rectangle(f).y0 = kNan; },
         {{"pass 1 'composite': draws[0].y0", "must be finite (got nan)"}}},
        {"beyond the far plane",
         [](Frame& f) { rectangle(f).depth = 1.25f; },
         {{"pass 1 'composite': draws[0].depth", "must lie within 0..1 (got 1.25)"}}},
        {"before the near plane",
         [](Frame& f) { rectangle(f).depth = -0.5f; },
         {{"pass 1 'composite': draws[0].depth", "must lie within 0..1 (got -0.5)"}}},
        {"too many repeats",
         [](Frame& f) { rectangle(f).uv[0].u0 = -274.0f; },
         {{"pass 1 'composite': draws[0].uv[0]", "must stay within 16384 texels of the texture's origin"}}},
        {"too many repeats down",
         [](Frame& f) { rectangle(f).uv[0].v1 = 410.0f; },
         {{"pass 1 'composite': draws[0].uv[0]", "must stay within 16384 texels of the texture's origin"}}},
        {"uv is no number",
         [](Frame& f) { rectangle(f).uv[1].v1 = kNan; },
         {{"pass 1 'composite': draws[0].uv[1].v1", "must be finite (got nan)"}}},
    });
    check_valid({
        {"the last indices",
         [](Frame& f) {
             triangles(f).first_index = 3;
             triangles(f).index_count = 3;
         }},
        {"no indices at the end",
         [](Frame& f) {
             triangles(f).first_index = 6;
             triangles(f).index_count = 0;
         }},
        {"rectangles need no camera", [](Frame& f) { composite(f).camera = {}; }},
        {"a rectangle of no size", [](Frame& f) { rectangle(f).x1 = 0.0f; }},
        {"flipped",
         [](Frame& f) {
             rectangle(f).uv[0] = {1.0f, 1.0f, 0.0f, 0.0f};
         }},
        {"far repeats of nothing", [](Frame& f) { rectangle(f).uv[1].u0 = 1e6f; }},
        {"as far as it goes",
         [](Frame& f) {
             rectangle(f).x0 = rectangle(f).y0 = -16384.0f;
             rectangle(f).x1 = rectangle(f).y1 = 16384.0f;
         }},
    });
}
