// SPDX-License-Identifier: MIT
// The memory of the truth: what targets hold, n x n samples for each pixel, rows from the top.
#pragma once

#include <algorithm>
#include <glm/vec4.hpp>
#include <vector>

#include "pipeline/frame/frame.h"

namespace pipeline::truth {

using Color = glm::dvec4;  // red, green, blue, alpha in 0..1

inline Color to_color(Argb argb) {
    const auto channel = [&](int shift) { return static_cast<double>((argb.value >> shift) & 255u) / 255.0; };
    return {channel(16), channel(8), channel(0), channel(24)};
}

// Not-a-number counts as 0.
inline double clamp01(double value) {
    return value > 0.0 ? std::min(value, 1.0) : 0.0;
}
inline Color clamp01(const Color& color) {
    return {clamp01(color.r), clamp01(color.g), clamp01(color.b), clamp01(color.a)};
}

// Of a colour target only `color` is used, of a depth target only `depth`.
struct Samples {
    int width = 0, height = 0;  // in pixels
    int per_axis = 1;
    std::vector<Color> color;
    std::vector<double> depth;

    int columns() const { return width * per_axis; }
    int rows() const { return height * per_axis; }
    std::size_t at(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns()) + static_cast<std::size_t>(column);
    }
};

// Where samples lie, in pixels: sample `i` of an axis, and the pixel that it belongs to.
struct SampleGrid {
    int per_axis  = 1;
    double center = 0.5;  // of a pixel, where it is sampled

    double pixel_position(int pixel) const { return pixel + center; }
    double position(int i) const { return pixel_position(i / per_axis) + offset(i); }
    // From the pixel's own point.
    double offset(int i) const { return (i % per_axis + 0.5) / per_axis - 0.5; }
};

// The channel is there to be written.
constexpr bool has_alpha(TargetFormat format) {
    return format != TargetFormat::X8R8G8B8 && format != TargetFormat::R5G6B5 && format != TargetFormat::Psmct24;
}
// What is read of an alpha that is not there.
constexpr double missing_alpha(TargetFormat format) {
    return format == TargetFormat::Psmct24 ? 128.0 / 255.0 : 1.0;
}

}  // namespace pipeline::truth
