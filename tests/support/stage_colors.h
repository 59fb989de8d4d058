// SPDX-License-Identifier: MIT
// A frame's texture stages in real numbers, by the words of pipeline/frame/texture_state.h: what is written for a chip must come
// to the same.
#pragma once

#include <array>

#include "pipeline/frame/frame.h"

namespace test_support {

using RealColor = std::array<double, 4>;  // red, green, blue, alpha; 0..1

RealColor real_color(pipeline::Argb color);

// What flows into the stages. Of the texels that a stage has none of, nothing is asked.
struct StageColors {
    RealColor diffuse{}, specular{};
    std::array<RealColor, pipeline::kTextureStages> texels{};
    double fog = 1.0;
};
// How the stages' result, the second colour and fog come out of the frame's state.
RealColor shaded(const pipeline::PipelineState& state, const StageColors& colors, bool has_fog);

}  // namespace test_support
