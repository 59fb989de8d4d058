// SPDX-License-Identifier: MIT
// A valid frame, and changes to it that each break one rule of validate, or none.
#pragma once

#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "tests/support/validate_rules.h"

namespace test_support {

using namespace pipeline;

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();
inline constexpr float kNan      = std::numeric_limits<float>::quiet_NaN();

// Targets: 0 and 1 colour (odd size), 2 depth, 3 colour of another size. Textures: 0 with mips, 1 of odd size.
// Passes: 0 triangles into target 1 with depth; 1 a rectangle that blits target 1 to target 0.
inline Frame valid_frame() {
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

inline Pass& particles(Frame& frame) {
    return frame.passes[0];
}
inline Pass& composite(Frame& frame) {
    return frame.passes[1];
}
inline DrawTriangles& triangles(Frame& frame) {
    return std::get<DrawTriangles>(frame.passes[0].draws[0]);
}
inline DrawRectangle& rectangle(Frame& frame) {
    return std::get<DrawRectangle>(frame.passes[1].draws[0]);
}
inline Light& point_light(Frame& frame) {
    return frame.passes[0].state.lighting.lights[1];
}

inline void check_rules(const std::vector<Rule>& rules) {
    test_support::check_rules(&valid_frame, rules);
}

inline void check_valid(const std::vector<std::pair<const char*, std::function<void(Frame&)>>>& changes) {
    for (const auto& [name, change] : changes) {
        INFO(name);
        Frame frame = valid_frame();
        change(frame);
        CHECK(text_of(validate(frame)).empty());
    }
}

}  // namespace test_support
