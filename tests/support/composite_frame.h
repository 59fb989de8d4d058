// SPDX-License-Identifier: MIT
// A small frame of two passes, and its text as a person would write it.
#pragma once

#include "pipeline/frame/frame.h"

namespace test_support {

using namespace pipeline;

inline constexpr const char* kCompositeText = R"(nimbus7 frame 1
output "back buffer"

targets [
    "back buffer" { width 64 height 32 }
    "cloud" { width 64 height 32 }
    "scene depth" { format D24 width 64 height 32 }
]

cameras [
    "eye" { projection ((2 0 0 0) (0 2 0 0) (0 0 1 -0.5) (0 0 1 0)) }
]

passes [
    "particles" {
        color "cloud"
        depth "scene depth"
        camera "eye"
        clear { color 0x00204060 }
        state {
            depth { func LESSEQUAL write true }
            cull CCW
            lighting {
                enabled true
                lights [
                    { diffuse (0.7 0.679 0.63) direction (0 -1 0) }
                ]
            }
        }
        draws [
            triangles { index_count 3 world ((1 0 0 5) (0 1 0 6) (0 0 1 7) (0 0 0 1)) }
        ]
    }
    "composite" {
        color "back buffer"
        state {
            blend { source SRCALPHA dest INVSRCALPHA }
            color_mask { alpha false }
            stages [{ color_op SELECTARG1 alpha_op MODULATE alpha_arg2 { source TFACTOR } address_u CLAMP }]
        }
        draws [
            rectangle { x1 64 y1 32 uv [{} { u0 0.5 }] textures [{ target "cloud" } { texture "fractal" }] }
        ]
    }
]

textures [
    "fractal" {
        format A8
        width 2
        height 2
        texels [00ff8001]
    }
]

vertices [
    { position (-1 -1 2) normal (0 0 -1) diffuse 0x80ffffff }
    { position (0 1 2) uv0 (0.5 0) }
    { position (1 -1 2) uv0 (1 1) }
]

indices [0 1 2]
)";

inline Vertex vertex_at(const Vec3& position) {
    Vertex vertex;
    vertex.position = position;
    return vertex;
}

inline Vertex with_uv0(Vertex vertex, const Vec2& uv0) {
    vertex.uv0 = uv0;
    return vertex;
}

inline Frame composite_frame() {
    Frame frame;
    frame.output  = {0};
    frame.targets = {{.name = "back buffer", .width = 64, .height = 32},
                     {.name = "cloud", .width = 64, .height = 32},
                     {.name = "scene depth", .format = TargetFormat::D24, .width = 64, .height = 32}};
    Camera camera{.name = "eye"};
    camera.projection = Mat4(Vec4(2, 0, 0, 0), Vec4(0, 2, 0, 0), Vec4(0, 0, 1, 1), Vec4(0, 0, -0.5f, 0));
    frame.cameras     = {camera};
    frame.textures    = {{.name = "fractal", .format = TextureFormat::A8, .width = 2, .height = 2, .texels = {}}};
    frame.textures[0].texels  = {0x00, 0xff, 0x80, 0x01};
    frame.vertices            = {vertex_at(Vec3(-1, -1, 2)), with_uv0(vertex_at(Vec3(0, 1, 2)), Vec2(0.5f, 0)),
                                 with_uv0(vertex_at(Vec3(1, -1, 2)), Vec2(1, 1))};
    frame.vertices[0].normal  = Vec3(0, 0, -1);
    frame.vertices[0].diffuse = {0x80ffffff};
    frame.indices             = {0, 1, 2};

    Pass particles{
        .label = "particles", .color = {1}, .depth = {2}, .camera = {0}, .clear = {}, .state = {}, .draws = {}};
    particles.clear.color            = Argb{0x00204060};
    particles.state.depth            = {.func = CompareFunc::LessEqual, .write = true};
    particles.state.cull             = CullMode::CounterClockwise;
    particles.state.lighting.enabled = true;
    particles.state.lighting.lights  = {{.diffuse = Vec3(0.7f, 0.679f, 0.63f), .direction = Vec3(0, -1, 0)}};
    DrawTriangles triangles;
    triangles.index_count = 3;
    triangles.world[3]    = Vec4(5, 6, 7, 1);
    particles.draws       = {triangles};

    Pass composite{
        .label = "composite", .color = {0}, .depth = {}, .camera = {}, .clear = {}, .state = {}, .draws = {}};
    composite.state.blend            = kAlphaOver;
    composite.state.color_mask.alpha = false;
    TextureStage& stage              = composite.state.stages[0];
    stage.color_op                   = TextureOp::SelectArg1;
    stage.alpha_op                   = TextureOp::Modulate;
    stage.alpha_arg2.source          = ArgSource::TFactor;
    stage.address_u                  = TextureAddress::Clamp;
    DrawRectangle rectangle;
    rectangle.x1 = 64, rectangle.y1 = 32;
    rectangle.uv[1].u0            = 0.5f;
    rectangle.textures[0].target  = {1};
    rectangle.textures[1].texture = {0};
    composite.draws               = {rectangle};

    frame.passes = {particles, composite};
    return frame;
}

}  // namespace test_support
