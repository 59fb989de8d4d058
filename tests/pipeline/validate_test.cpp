// SPDX-License-Identifier: MIT
// Each rule of validate by a frame that breaks this rule alone: one change to a valid frame, and exactly the findings
// that it must give.
#include "pipeline/validate/validate.h"

#include <limits>

#include "tests/support/random_frame.h"
#include "tests/support/validate_rules.h"

using namespace pipeline;
using test_support::Rule, test_support::text_of;

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan      = std::numeric_limits<float>::quiet_NaN();

// Targets: 0 and 1 colour (odd size), 2 depth, 3 colour of another size. Textures: 0 with mips, 1 of odd size.
// Passes: 0 triangles into target 1 with depth; 1 a rectangle that blits target 1 to target 0.
Frame valid_frame() {
    Frame frame;
    frame.output                      = {0};
    frame.targets                     = {{.name = "back", .width = 60, .height = 40},
                                         {.name = "cloud", .width = 60, .height = 40},
                                         {.name = "depth", .format = TargetFormat::D24, .width = 60, .height = 40},
                                         {.name = "half", .width = 30, .height = 20}};
    frame.cameras.emplace_back().name = "eye";
    frame.textures = {{.name = "rock", .format = TextureFormat::L8, .width = 4, .height = 2, .levels = 3, .texels = {}},
                      {.name = "odd", .format = TextureFormat::A8R8G8B8, .width = 3, .height = 4, .texels = {}}};
    frame.textures[0].texels.resize(8 + 2 + 1);
    frame.textures[1].texels.resize(48);
    frame.vertices.resize(3);
    frame.indices = {0, 1, 2, 2, 1, 0};

    Pass& particles                 = frame.passes.emplace_back();
    particles.label                 = "particles";
    particles.color                 = {1};
    particles.depth                 = {2};
    particles.camera                = {0};
    particles.clear                 = {.color = Argb{0}, .depth = 1.0f};
    particles.state.depth           = {.func = CompareFunc::LessEqual, .write = true};
    particles.state.stages[0]       = {.color_op = TextureOp::Modulate, .alpha_op = TextureOp::SelectArg2};
    particles.state.fog             = {.mode = FogMode::Linear, .start = 1.0f, .end = 2.0f};
    particles.state.lighting.lights = {Light{}, Light{.type = LightType::Point}};
    DrawTriangles triangles;
    triangles.index_count         = 6;
    triangles.textures[0].texture = {0};
    particles.draws               = {triangles};

    Pass& composite           = frame.passes.emplace_back();
    composite.label           = "composite";
    composite.color           = {0};
    composite.state.stages[0] = {.color_op  = TextureOp::SelectArg1,
                                 .alpha_op  = TextureOp::SelectArg1,
                                 .address_u = TextureAddress::Clamp,
                                 .address_v = TextureAddress::Clamp};
    DrawRectangle rectangle;
    rectangle.x1                 = 60.0f;
    rectangle.y1                 = 40.0f;
    rectangle.textures[0].target = {1};
    composite.draws              = {rectangle};
    return frame;
}

Pass& particles(Frame& frame) {
    return frame.passes[0];
}
Pass& composite(Frame& frame) {
    return frame.passes[1];
}
DrawTriangles& triangles(Frame& frame) {
    return std::get<DrawTriangles>(frame.passes[0].draws[0]);
}
DrawRectangle& rectangle(Frame& frame) {
    return std::get<DrawRectangle>(frame.passes[1].draws[0]);
}
Light& point_light(Frame& frame) {
    return frame.passes[0].state.lighting.lights[1];
}

void check_rules(const std::vector<Rule>& rules) {
    test_support::check_rules(&valid_frame, rules);
}

void check_valid(const std::vector<std::pair<const char*, std::function<void(Frame&)>>>& changes) {
    for (const auto& [name, change] : changes) {
        INFO(name);
        Frame frame = valid_frame();
        change(frame);
        CHECK(text_of(validate(frame)).empty());
    }
}

}  // namespace

TEST_CASE("the frame that the rules are tried on is valid") {
    CHECK(text_of(validate(valid_frame())).empty());
}

TEST_CASE("random frames are valid") {
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        INFO("seed " << seed);
        CHECK(text_of(validate(test_support::random_frame(seed))).empty());
    }
}

TEST_CASE("an invalid frame of any kind is no more than findings") {
    int with_findings = 0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        Frame frame = test_support::random_frame(seed);
        for (std::uint32_t i = 0; i < 20; ++i) test_support::mutate_field(frame, seed * 20 + i);
        with_findings += !validate(frame).empty();
    }
    CHECK(with_findings > 250);
}

TEST_CASE("validate: frame, targets, textures") {
    check_rules({
        {"no output", [](Frame& f) { f.output = {}; }, {{"frame: output", "must refer to a colour target"}}},
        {"output is depth", [](Frame& f) { f.output = {2}; }, {{"frame: output", "must be a colour target (got D24)"}}},
        {"output out of range",
         [](Frame& f) { f.output = {4}; },
         {{"frame: output", "must refer to one of the 4 targets, or be nothing, -1 (got 4)"}}},
        {"output below nothing",
         [](Frame& f) { f.output = {-2}; },
         {{"frame: output", "must refer to one of the 4 targets, or be nothing, -1 (got -2)"}}},
        {"no width",
         [](Frame& f) { f.targets[3].width = 0; },
         {{"target 3 'half': width", "must lie within 1..8192 (got 0)"}}},
        {"too high",
         [](Frame& f) { f.targets[3].height = 8193; },
         {{"target 3 'half': height", "must lie within 1..8192 (got 8193)"}}},
        {"no such format",
         [](Frame& f) { f.targets[3].format = static_cast<TargetFormat>(11); },
         {{"target 3 'half': format",
           "must be one of A8R8G8B8 X8R8G8B8 R5G6B5 A1R5G5B5 R6G6B6A6 PSMCT32 PSMCT24 PSMCT16 D16 D24 D32 (got #11)"}}},
        {"texture size",
         [](Frame& f) { f.textures[1].width = -1; },
         {{"texture 1 'odd': width", "must lie within 1..8192 (got -1)"}}},
        {"texture height",
         [](Frame& f) { f.textures[0].height = 100000; },
         {{"texture 0 'rock': height", "must lie within 1..8192 (got 100000)"}}},
        {"too many levels",
         [](Frame& f) { f.textures[0].levels = 4; },
         {{"texture 0 'rock': levels", "must lie within 1..3 for a texture of 4x2 (got 4)"}}},
        {"no level",
         [](Frame& f) { f.textures[0].levels = 0; },
         {{"texture 0 'rock': levels", "must lie within 1..3 for a texture of 4x2 (got 0)"}}},
        {"mips of an odd size",
         [](Frame& f) { f.textures[1].levels = 2, f.textures[1].texels.resize(48 + 8); },
         {{"texture 1 'odd': levels", "must be 1 unless width and height are powers of two (got 2)"}}},
        {"a texel missing",
         [](Frame& f) { f.textures[0].texels.pop_back(); },
         {{"texture 0 'rock': texels", "must hold 11 bytes (got 10)"}}},
        {"texels of a level missing",
         [](Frame& f) { f.textures[1].format = TextureFormat::A8; },
         {{"texture 1 'odd': texels", "must hold 12 bytes (got 48)"}}},
        {"camera not finite",
         [](Frame& f) { f.cameras[0].projection[1][2] = kNan; },
         {{"camera 0 'eye': projection", "must be finite"}}},
        {"vertex not finite",
         [](Frame& f) { f.vertices[1].normal.y = kInfinity; },
         {{"vertex 1: normal", "must be finite (got (0 inf 0))"}}},
        {"vertices not finite",
         [](Frame& f) { f.vertices[1].uv1.x = kNan, f.vertices[0].uv0.y = f.vertices[2].position.x = -kInfinity; },
         {{"vertex 0: uv0", "must be finite (got (0 -inf)); 2 more vertices are not finite"}}},
        {"index beyond the vertices",
         [](Frame& f) { f.indices[4] = 3; },
         {{"frame: indices[4]", "must be less than the number of vertices, 3 (got 3)"}}},
        {"indices beyond the vertices",
         [](Frame& f) { f.vertices.resize(1); },
         {{"frame: indices[1]", "must be less than the number of vertices, 1 (got 1); 3 more are not"}}},
    });
}

TEST_CASE("validate: the targets of a pass") {
    check_rules({
        {"neither target",
         [](Frame& f) { composite(f).color = {}; },
         {{"pass 1 'composite': color", "must refer to a target, or depth must"}}},
        {"colour is depth",
         [](Frame& f) { particles(f).color = {2}; },
         {{"pass 0 'particles': color", "must be a colour target (got D24)"}}},
        {"depth is colour",
         [](Frame& f) { particles(f).depth = {0}; },
         {{"pass 0 'particles': depth", "must be a depth target (got A8R8G8B8)"}}},
        {"depth out of range",
         [](Frame& f) { particles(f).depth = {9}; },
         {{"pass 0 'particles': depth", "must refer to one of the 4 targets, or be nothing, -1 (got 9)"}}},
        {"sizes differ",
         [](Frame& f) { particles(f).color = {3}; },
         {{"pass 0 'particles': depth", "must have the size of the colour target, 30x20 (got 60x40)"}}},
        {"colour cleared, not there",
         [](Frame& f) { particles(f).color = {}; },
         {{"pass 0 'particles': clear.color", "must be left out: the pass has no colour target"}}},
        {"depth cleared, not there",
         [](Frame& f) { composite(f).clear.depth = 0.0f; },
         {{"pass 1 'composite': clear.depth", "must be left out: the pass has no depth target"}}},
        {"cleared beyond 1",
         [](Frame& f) { particles(f).clear.depth = 1.5f; },
         {{"pass 0 'particles': clear.depth", "must lie within 0..1 (got 1.5)"}}},
        {"cleared below 0",
         [](Frame& f) { particles(f).clear.depth = -0.25f; },
         {{"pass 0 'particles': clear.depth", "must lie within 0..1 (got -0.25)"}}},
        {"cleared to nothing",
         [](Frame& f) { particles(f).clear.depth = kNan; },
         {{"pass 0 'particles': clear.depth", "must be finite (got nan)"}}},
        {"depth tested, not there",
         [](Frame& f) { composite(f).state.depth.func = CompareFunc::Less; },
         {{"pass 1 'composite': state.depth.func", "must be ALWAYS: the pass has no depth target (got LESS)"}}},
        {"depth written, not there",
         [](Frame& f) { composite(f).state.depth.write = true; },
         {{"pass 1 'composite': state.depth.write", "must be false: the pass has no depth target"}}},
    });
    check_valid({
        {"depth alone",
         [](Frame& f) {
             particles(f).color       = {};
             particles(f).clear.color = {};
         }},
        {"nothing cleared, nothing drawn",
         [](Frame& f) {
             particles(f).clear = {};
             particles(f).draws.clear();
         }},
    });
}

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

TEST_CASE("validate finds everything at once") {
    Frame frame                               = valid_frame();
    frame.output                              = {};
    frame.targets[3].width                    = 0;
    frame.indices[5]                          = 7;
    composite(frame).state.depth.write        = true;
    particles(frame).state.lighting.ambient.x = kNan;
    rectangle(frame).depth                    = 2.0f;
    CHECK(text_of(validate(frame)) ==
          "frame: output: must refer to a colour target\n"
          "target 3 'half': width: must lie within 1..8192 (got 0)\n"
          "frame: indices[5]: must be less than the number of vertices, 3 (got 7)\n"
          "pass 0 'particles': state.lighting.ambient: must be finite (got (nan 0 0))\n"
          "pass 1 'composite': state.depth.write: must be false: the pass has no depth target\n"
          "pass 1 'composite': draws[0].depth: must lie within 0..1 (got 2)\n");
}
