// SPDX-License-Identifier: MIT
// Ten thousand blends onto the same pixel, by each rule: how far bytes drift from real numbers, and where they get stuck.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "pipeline/frame/frame.h"
#include "tests/extremes/extremes.h"

namespace extremes {

inline constexpr int kBlends = 10000;

// A chip's blender onto one of its targets.
struct Blender {
    std::string_view name;
    pipeline::BlendRule rule;
    pipeline::BlendSource source;
    pipeline::TargetFormat format;
    int bits;      // that the target keeps of red
    bool repeats;  // them, down to the byte that is read
};
std::span<const Blender> blenders();

// Over: source alpha. Multiply: the destination by the source's colour, which the Graphics Synthesizer cannot.
enum class BlendKind : std::uint8_t { Over, Multiply };
bool has_kind(const Blender& blender, BlendKind kind);

// Red after each of kBlends: [start][source red / 85][factor], start 0 and 255, factor the alpha of 0..255, or, of Multiply,
// the source's red (whose second index is then without effect).
using Ends = std::array<std::array<std::array<std::uint8_t, 256>, 4>, 2>;
Ends blended(const Blender& blender, BlendKind kind);

// What one blend may be off by, in 255ths: rounding (see blends.cpp), and what the format drops. The error of one is taken
// over by the next times 1 - f, with f the factor that draws it to its end, so that it stays below 1 / f of this.
double blend_error(const Blender& blender);
double factor_of(const Blender& blender, BlendKind kind, int factor);

// Over all starts, sources and factors: the greatest drift, in 255ths, and drift over its bound, at most 1.
struct Drift {
    double greatest = 0.0, of_bound = 0.0;
};
Drift drift(const Blender& blender, BlendKind kind, const Ends& ends);

}  // namespace extremes
