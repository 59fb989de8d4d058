// SPDX-License-Identifier: MIT
// The frames that are timed. Each is built from its name, "group/case", anew in every process that draws it, so that
// all executors are given the same one.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/frame/frame.h"

namespace bench {

struct FrameCase {
    std::string name;
    std::function<pipeline::Frame()> build;
    double work           = 0.0;  // that one drawing does, of `unit` each; 0: only the time counts
    std::string_view unit = {};   // "pixels" or "triangles"
    double size           = 0.0;  // of growth/*: how many pixels, spheres or clouds
};

const std::vector<FrameCase>& frame_cases();

// Throws std::invalid_argument if there is none.
const FrameCase& find_frame_case(std::string_view name);

// Parts of the list.
std::vector<FrameCase> fill_cases();
std::vector<FrameCase> triangle_cases();
std::vector<FrameCase> scene_cases();  // frame/*, growth/canyon/*
std::vector<FrameCase> cloud_cases();  // growth/spheres/*, growth/clouds/*
std::vector<FrameCase> image_cases();  // downsample/*, blend/*

inline constexpr int kFillWidth = 1920, kFillHeight = 1080, kFillLayers = 32;
inline constexpr int kImageWidth = 480, kImageHeight = 270, kImageRounds = 32;

}  // namespace bench
