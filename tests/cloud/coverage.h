// SPDX-License-Identifier: MIT
// A plain scene for clouds of any technique, and how much of each of its pixels a cloud covers.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "cloud/mega_particles/mega_particles.h"
#include "pipeline/execute/execute.h"
#include "pipeline/frame/frame.h"

// Appends a cloud's passes to a frame with a scene.
using AppendClouds = std::function<void(pipeline::Frame&, const cloud::SceneTargets&, const cloud::View&)>;

// One colour, at the given depth-buffer value.
inline pipeline::Frame plain_scene(const AppendClouds& append, const cloud::View& view, pipeline::Argb color,
                                   float depth = 1.0f) {
    using namespace pipeline;
    Frame frame;
    frame.targets = {{.name = "back buffer", .width = view.width, .height = view.height},
                     {.name = "depth", .format = TargetFormat::D24, .width = view.width, .height = view.height}};
    frame.cameras = {{.name = "camera", .view = view.view, .projection = view.projection}};
    frame.output  = {0};
    frame.passes.push_back(
        {.label = "scene", .color = {0}, .depth = {1}, .clear = {.color = color, .depth = depth}, .draws = {}});
    append(frame, {.back_buffer = {0}, .depth = {1}, .camera = {0}, .fog = {}}, view);
    return frame;
}

// 0..1 for each pixel: what a black and a white scene have not in common.
inline std::vector<float> coverage(const AppendClouds& append, const cloud::View& view) {
    const pipeline::ColorImage black = pipeline::execute(plain_scene(append, view, {0xff000000})).output;
    const pipeline::ColorImage white = pipeline::execute(plain_scene(append, view, {0xffffffff})).output;
    std::vector<float> covered;
    for (std::size_t i = 0; i < black.pixels.size(); ++i) {
        const auto green = [](std::uint32_t argb) { return static_cast<float>(argb >> 8 & 255); };
        covered.push_back(1.0f - (green(white.pixels[i]) - green(black.pixels[i])) / 255.0f);
    }
    return covered;
}

// Of the pixels that at least one of both covers by half, the share that both do.
inline double overlap(const std::vector<float>& a, const std::vector<float>& b) {
    double both = 0.0, any = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        both += a[i] > 0.5f && b[i] > 0.5f;
        any += a[i] > 0.5f || b[i] > 0.5f;
    }
    return both / any;
}

// Blended pixels of all passes but the first.
inline std::uint64_t blended_pixels(const pipeline::Frame& frame) {
    const pipeline::Execution execution = pipeline::execute(frame);
    std::uint64_t blended               = 0;
    for (std::size_t i = 1; i < execution.counts.size(); ++i) blended += execution.counts[i].blended;
    return blended;
}
