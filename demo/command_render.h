// SPDX-License-Identifier: MIT
// nimbus7 render: draws frames of a scene, writes them as image files and reports on standard output.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "demo/arguments.h"
#include "pipeline/profile/profile.h"

namespace demo {

enum class StatisticsFormat : std::uint8_t { None, Text, Json };

struct RenderOptions {
    std::string scene;
    std::optional<std::string> output;  // else the scene's name, with .png or .####.png
    std::optional<Size> size;           // else the scene's
    std::optional<FrameRange> frames;   // else frame 0 alone
    std::optional<std::string> passes_directory;
    int limit   = 1;                             // how many times pipeline::kMostWork a frame may take
    int threads = 0;                             // 0: all cores
    std::string simd_target;                     // "": the best
    FrameOptions changes;                        // of how the scene draws its clouds
    const pipeline::Profile* profile = nullptr;  // the chip that the frames are rewritten for; null: drawn as they are
    bool reduce                      = false;    // until the first frame fits the chip, and the others like it
    StatisticsFormat statistics      = StatisticsFormat::None;
};

void render(const RenderOptions& options);

}  // namespace demo
