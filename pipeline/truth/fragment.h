// SPDX-License-Identifier: MIT
// What becomes of a sample that a primitive covers, in the order of raster/fill_state.h: texels, stages, specular, fog, tests,
// depth, blend, write.
#pragma once

#include <array>

#include "pipeline/truth/texture.h"

namespace pipeline::truth {

// specular: its alpha is the fog factor.
struct Fragment {
    double depth = 0.0;
    Color diffuse{1.0}, specular{0.0, 0.0, 0.0, 1.0};
    std::array<TexturePoint, kTextureStages> points;
};

// A draw of a pass. color, depth: null if there is none.
struct FragmentSetup {
    const Arithmetic& arithmetic;
    const PipelineState& state;
    TargetFormat format = TargetFormat::A8R8G8B8;  // of `color`
    Samples* color      = nullptr;
    Samples* depth      = nullptr;
    bool has_fog        = false;
    std::array<BoundTexture, kTextureStages> textures;
};

// at: the sample's place in both targets.
void draw_fragment(const FragmentSetup& setup, const Fragment& fragment, std::size_t at);

// Of its colour: stages, specular and fog. pipeline/truth/combine.cpp.
Color combined(const FragmentSetup& setup, const Fragment& fragment);

// pipeline/truth/blend.cpp.
Color blended(const Arithmetic& arithmetic, const PipelineState& state, const Color& source, const Color& there);

}  // namespace pipeline::truth
