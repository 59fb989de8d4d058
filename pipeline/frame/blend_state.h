// SPDX-License-Identifier: MIT
// How a fragment meets the pixel already there: out = source * Fs + dest * Fd, per channel, clamped to [0, 1].
// As in Direct3D 7 the same two factors serve all four channels, so alpha is blended too; a *Color factor is
// (R, G, B, A) and an *Alpha factor is (A, A, A, A). Rounding: the exact sum of the two products of bytes is
// divided by 255 and rounded once, to nearest.
#pragma once

#include <cstdint>

#include "pipeline/frame/fields.h"

namespace pipeline {

enum class BlendFactor : std::uint8_t {
    Zero,
    One,
    SourceColor,
    InvSourceColor,
    DestColor,
    InvDestColor,
    SourceAlpha,
    InvSourceAlpha,
    DestAlpha,
    InvDestAlpha,
};
template <>
struct EnumNames<BlendFactor> {
    static constexpr std::array<std::string_view, 10> names{"ZERO",      "ONE",          "SRCCOLOR", "INVSRCCOLOR",
                                                            "DESTCOLOR", "INVDESTCOLOR", "SRCALPHA", "INVSRCALPHA",
                                                            "DESTALPHA", "INVDESTALPHA"};
};

// ONE, ZERO is "blending off".
struct BlendState {
    BlendFactor source                       = BlendFactor::One;
    BlendFactor dest                         = BlendFactor::Zero;
    bool operator==(const BlendState&) const = default;
};
template <SameStruct<BlendState> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [source, dest] = state;
    visit("source", source);
    visit("dest", dest);
}

inline constexpr BlendState kReplace{};
inline constexpr BlendState kAlphaOver{.source = BlendFactor::SourceAlpha, .dest = BlendFactor::InvSourceAlpha};
inline constexpr BlendState kMultiply{.source = BlendFactor::Zero, .dest = BlendFactor::SourceColor};

// Which channels of the colour target a pass may change.
struct ColorMask {
    bool red = true, green = true, blue = true, alpha = true;
    bool operator==(const ColorMask&) const = default;
};
template <SameStruct<ColorMask> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [red, green, blue, alpha] = state;
    visit("red", red);
    visit("green", green);
    visit("blue", blue);
    visit("alpha", alpha);
}

}  // namespace pipeline
