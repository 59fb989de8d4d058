// SPDX-License-Identifier: MIT
// How a fragment meets the pixel already there, rounded by Arithmetic::blend. BlendState is Direct3D's: out = source * Fs +
// dest * Fd, per channel, clamped to [0, 1]; the same two factors serve all four channels, so alpha is blended too; a
// *Color factor is (R, G, B, A) and an *Alpha factor is (A, A, A, A). GsBlend is the Graphics Synthesizer's.
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

// Red, green and blue become ((A - B) * C >> 7) + D, the shift flooring, so that C = 0x80 is one; alpha becomes the fragment's.
// Register ALPHA: A, B, D of CS (fragment), CD (pixel there), ZERO; C of AS (fragment's alpha), AD (alpha there), FIX.
// PABE: fragments whose alpha is below 0x80 replace the pixel. COLCLAMP: results are clamped to 0..255, or else taken
// modulo 256. FBA: bit 7 of the alpha that is written becomes 1. The defaults are "blending off".
enum class GsColor : std::uint8_t { Cs, Cd, Zero };
template <>
struct EnumNames<GsColor> {
    static constexpr std::array<std::string_view, 3> names{"CS", "CD", "ZERO"};
};
enum class GsAlpha : std::uint8_t { As, Ad, Fix };
template <>
struct EnumNames<GsAlpha> {
    static constexpr std::array<std::string_view, 3> names{"AS", "AD", "FIX"};
};

struct GsBlend {
    GsColor a                             = GsColor::Cs;
    GsColor b                             = GsColor::Cs;
    GsAlpha c                             = GsAlpha::As;
    GsColor d                             = GsColor::Cs;
    std::uint8_t fix                      = 0;
    bool pabe                             = false;
    bool colclamp                         = true;
    bool fba                              = false;
    bool operator==(const GsBlend&) const = default;
};
template <SameStruct<GsBlend> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [a, b, c, d, fix, pabe, colclamp, fba] = state;
    visit("a", a);
    visit("b", b);
    visit("c", c);
    visit("d", d);
    visit("fix", fix);
    visit("pabe", pabe);
    visit("colclamp", colclamp);
    visit("fba", fba);
}

// What is added to red, green and blue before a target that keeps less than 8 bits of each does so, by the pixel's place. Not
// in clears.
//   FLIPPER_2X2  c becomes c - (c >> 6) + {0, 2; 3, 1}[y & 1][x & 1]
//   GS_DIMX      matrix[4 * (y & 3) + (x & 3)], -4..3 each, is added to the blend's result before COLCLAMP
enum class DitherMode : std::uint8_t { None, Flipper2x2, GsDimx };
template <>
struct EnumNames<DitherMode> {
    static constexpr std::array<std::string_view, 3> names{"NONE", "FLIPPER_2X2", "GS_DIMX"};
};
struct DitherState {
    DitherMode mode = DitherMode::None;
    std::array<std::int32_t, 16> matrix{};
    bool operator==(const DitherState&) const = default;
};
template <SameStruct<DitherState> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [mode, matrix] = state;
    visit("mode", mode);
    visit("matrix", matrix);
}

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
