// SPDX-License-Identifier: MIT
// How the chip that a frame is for computes: what none of its registers changes. Each rule is one enumerator with its
// formula here; which chip has which, from what source and how sure that is, stands in pipeline/profile/. Bytes are 0..255,
// >> is floor division by a power of two, and every result is clamped to a byte unless it says otherwise. All chips have
// 4 subpixel bits and the top-left fill rule.
#pragma once

#include <cstdint>

#include "pipeline/frame/fields.h"

namespace pipeline {

// Window coordinates times 16, to an integer: to the nearest (ties to even), or toward zero.
enum class SnapRule : std::uint8_t { Nearest, Truncate };
template <>
struct EnumNames<SnapRule> {
    static constexpr std::array<std::string_view, 2> names{"NEAREST", "TRUNCATE"};
};

// Depth at the vertices of a triangle: with more bits than the depth buffer, or cut to whole units of it, as registers hold.
enum class VertexDepth : std::uint8_t { Fine, WholeUnits };
template <>
struct EnumNames<VertexDepth> {
    static constexpr std::array<std::string_view, 2> names{"FINE", "WHOLE_UNITS"};
};

// An interpolated colour, to a byte: the nearest, or the floor of what is 1/256 more.
enum class GouraudRule : std::uint8_t { Nearest, Floor };
template <>
struct EnumNames<GouraudRule> {
    static constexpr std::array<std::string_view, 2> names{"NEAREST", "FLOOR"};
};

// Texels t00 t10 / t01 t11 with fractions fu, fv of a texel:
//   REFERENCE8     fu, fv in 1/256: the exact weighted sum, rounded once, half up
//   GS_FLOOR4      in 1/16, truncated: a + ((b - a) * f >> 4), both rows along u, then along v
//   GS_NEAREST4    in 1/16, truncated: the exact sum, rounded once, half up
//   FLIPPER_FLOOR7 in 1/128, truncated: the exact sum, floored once
//   NV2A_HALFUP8   in 1/256: along u, rounded half up to a byte, then along v likewise
// Two mip levels are mixed with a fraction in 1/256 and half up, but by GS_* and FLIPPER_FLOOR7 in 1/16 and floored.
enum class FilterRule : std::uint8_t { Reference8, GsFloor4, GsNearest4, FlipperFloor7, Nv2aHalfUp8 };
template <>
struct EnumNames<FilterRule> {
    static constexpr std::array<std::string_view, 5> names{"REFERENCE8", "GS_FLOOR4", "GS_NEAREST4", "FLIPPER_FLOOR7",
                                                           "NV2A_HALFUP8"};
};

// The products in texture stages, and what AddSigned takes off. See texture_state.h for the ops.
//   NEAREST255   a * b / 255 rounded to nearest; a * c + b * (255 - c) likewise; a + b - 127.5 half up
//   GS_SHIFT7    a * b >> 7, so that 0x80 is one; in one stage, of arguments without complement, and not for all ops
//   TEV          with b' = b + (b >> 7), 0..256: (a * b' + 128) >> 8; a * c' + b * (256 - c') likewise; a + b - 128
enum class CombineRule : std::uint8_t { Nearest255, GsShift7, Tev };
template <>
struct EnumNames<CombineRule> {
    static constexpr std::array<std::string_view, 3> names{"NEAREST255", "GS_SHIFT7", "TEV"};
};

// Colour c, fog colour k, factor f (255: no fog):
//   NEAREST255        (f * c + (255 - f) * k) / 255, rounded to nearest
//   GS_FLOOR256       (f * c + (256 - f) * k) >> 8
//   GS_TWO_FLOORS     (f * c >> 8) + ((255 - f) * k >> 8)
//   FLIPPER_FLOOR256  with f' = f + (f >> 7), 0..256: (f' * c + (256 - f') * k) >> 8
enum class FogRule : std::uint8_t { Nearest255, GsFloor256, GsTwoFloors, FlipperFloor256 };
template <>
struct EnumNames<FogRule> {
    static constexpr std::array<std::string_view, 4> names{"NEAREST255", "GS_FLOOR256", "GS_TWO_FLOORS",
                                                           "FLIPPER_FLOOR256"};
};

// What blend_state.h's states compute:
//   NEAREST255        (source * Fs + dest * Fd) / 255: the exact sum, rounded once, to nearest
//   GS_SHIFT7         ((A - B) * C >> 7) + D on red, green and blue; alpha is written as it is. PipelineState::gs_blend
//                     holds the operands, and PipelineState::blend stays at its default
//   FLIPPER_TRUNC256  with F' = F + (F >> 7), 0..256: (source * Fs' + dest * Fd') >> 8
enum class BlendRule : std::uint8_t { Nearest255, GsShift7, FlipperTrunc256 };
template <>
struct EnumNames<BlendRule> {
    static constexpr std::array<std::string_view, 3> names{"NEAREST255", "GS_SHIFT7", "FLIPPER_TRUNC256"};
};

// What the blender sees of the source's red, green and blue: whole bytes, or the bits that the target keeps, the others
// zero.
enum class BlendSource : std::uint8_t { Bytes, TargetBits };
template <>
struct EnumNames<BlendSource> {
    static constexpr std::array<std::string_view, 2> names{"BYTES", "TARGET_BITS"};
};

// pixel_center: where in a pixel it is sampled, in 1/16 pixel from its left and top edge, 0..15. 8 is the middle.
struct Arithmetic {
    SnapRule snap                            = SnapRule::Nearest;
    std::int32_t pixel_center                = 8;
    VertexDepth vertex_depth                 = VertexDepth::Fine;
    GouraudRule gouraud                      = GouraudRule::Nearest;
    FilterRule filter                        = FilterRule::Reference8;
    CombineRule combine                      = CombineRule::Nearest255;
    FogRule fog                              = FogRule::Nearest255;
    BlendRule blend                          = BlendRule::Nearest255;
    BlendSource blend_source                 = BlendSource::Bytes;
    bool operator==(const Arithmetic&) const = default;
};
template <SameStruct<Arithmetic> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [snap, pixel_center, vertex_depth, gouraud, filter, combine, fog, blend, blend_source] = state;
    visit("snap", snap);
    visit("pixel_center", pixel_center);
    visit("vertex_depth", vertex_depth);
    visit("gouraud", gouraud);
    visit("filter", filter);
    visit("combine", combine);
    visit("fog", fog);
    visit("blend", blend);
    visit("blend_source", blend_source);
}

}  // namespace pipeline
