// SPDX-License-Identifier: MIT
// A sky of one colour and a wall in the upper left corner, for clouds to be drawn over. The targets are the back buffer and its
// depth, the camera is the view's.
#pragma once

#include "cloud/mega_particles/mega_particles.h"
#include "pipeline/frame/frame.h"
#include "tests/cloud/coverage.h"

// width, height: pixels. depth: in the depth buffer.
struct Wall {
    float width = 0.0f, height = 0.0f, depth = 0.5f;
    pipeline::Argb color;
};

inline pipeline::Frame walled_scene(const cloud::View& view, pipeline::Argb sky, const Wall& wall) {
    using namespace pipeline;
    const AppendClouds none = [](Frame&, const cloud::SceneTargets&, const cloud::View&) {};
    Frame frame             = plain_scene(none, view, sky);
    Pass& pass              = frame.passes.front();
    pass.state.depth        = {.func = CompareFunc::LessEqual, .write = true};
    DrawRectangle rectangle;
    rectangle.x1    = wall.width;
    rectangle.y1    = wall.height;
    rectangle.depth = wall.depth;
    rectangle.color = wall.color;
    pass.draws      = {rectangle};
    return frame;
}

inline constexpr cloud::SceneTargets kWalledTargets{.back_buffer = {0}, .depth = {1}, .camera = {0}, .fog = {}};
