// SPDX-License-Identifier: MIT
// Steps 7 to 9 of raster/fill_state.h once more, for tests: in exact integers. A channel is a function of the
// source's byte s, all else being fixed, for then every operand is a line over s.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "raster/fill_state.h"
#include "tests/raster/exact.h"

namespace blend_formula {

using exact::floor_quotient;
using exact::Pixel;
using raster::Blend;
using raster::BlendFactor;
using raster::BlendRule;
using raster::ColorFormat;
using raster::Dither;
using raster::Shift7Blend;

inline constexpr int kAlpha = 3;

struct Line {  // at_0 + slope * s
    int at_0, slope;
    int operator()(int s) const { return at_0 + slope * s; }
};

// What stays the same along a line.
struct Others {
    int dest, source_alpha, dest_alpha;
    int dither = 0;  // of Matrix4x4
};

inline Line factor_line(const BlendFactor& factor, const Others& others) {
    Line line{0, 0};
    if (factor.operand == BlendFactor::Operand::Source) line = factor.alpha ? Line{others.source_alpha, 0} : Line{0, 1};
    if (factor.operand == BlendFactor::Operand::Dest) line = {factor.alpha ? others.dest_alpha : others.dest, 0};
    return factor.invert ? Line{255 - line.at_0, -line.slope} : line;
}

inline Line operand_line(Shift7Blend::Operand operand, const Others& others) {
    if (operand == Shift7Blend::Operand::Source) return {0, 1};
    return {operand == Shift7Blend::Operand::Dest ? others.dest : 0, 0};
}

inline int shift7_factor(const Shift7Blend& state, const Others& others) {
    switch (state.c) {
        case Shift7Blend::Factor::SourceAlpha:
            return others.source_alpha;
        case Shift7Blend::Factor::DestAlpha:
            return others.dest_alpha;
        case Shift7Blend::Factor::Constant:
            break;
    }
    return state.constant;
}

// use(f), f(s) being what step 7 makes of a channel. Not for Shift7's alpha, which is not blended.
template <class Use>
void with_channel(const Blend& blend, const Others& others, Use&& use) {
    const Line fs = factor_line(blend.source, others), fd = factor_line(blend.dest, others);
    const int d = others.dest;
    switch (blend.rule) {
        case BlendRule::Nearest255:
            return use([=](int s) { return std::min(255, exact::nearest_255th(s * fs(s) + d * fd(s))); });
        case BlendRule::Trunc256:
            return use([=](int s) {
                return std::min(255, floor_quotient(s * exact::to_256(fs(s)) + d * exact::to_256(fd(s)), 256));
            });
        case BlendRule::Shift7: {
            const Shift7Blend& state = blend.shift7;
            const Line a = operand_line(state.a, others), b = operand_line(state.b, others);
            const Line base = operand_line(state.d, others);
            const int c = shift7_factor(state, others), dither = others.dither;
            const bool clamp = state.clamp, replaces = state.only_above_half && others.source_alpha < 128;
            return use([=](int s) {
                const int sum = replaces ? s + dither : floor_quotient((a(s) - b(s)) * c, 128) + base(s) + dither;
                return clamp ? std::clamp(sum, 0, 255) : sum - 256 * floor_quotient(sum, 256);
            });
        }
    }
}

inline int blended_channel(const Blend& blend, const Others& others, int s) {
    int value = 0;
    with_channel(blend, others, [&](auto f) { value = f(s); });
    return value;
}

inline int blended_alpha(const Blend& blend, int source_alpha, int dest_alpha) {
    if (blend.rule == BlendRule::Shift7)
        return blend.shift7.set_top_bit ? std::max(source_alpha, 128 + source_alpha % 128) : source_alpha;
    return blended_channel(blend, {dest_alpha, source_alpha, dest_alpha}, source_alpha);
}

// What a format with so many bits gives back of a channel.
inline int stored_channel(int value, int bits, bool zero_fill) {
    if (bits == 0) return zero_fill ? 128 : 255;
    const int unit = 256 >> bits, kept = value / unit;
    if (zero_fill || bits == 8) return kept * unit;
    if (bits == 1) return kept * 255;
    return kept * unit + kept / (bits == 6 ? 16 : 4);  // 6 bits: times 4 and the top 2; 5 bits: times 8 and the top 3
}

inline Pixel stored(const ColorFormat& format, const Pixel& pixel) {
    Pixel out;
    for (int i = 0; i < 4; ++i)
        out.c[i] = stored_channel(pixel.c[i], raster::channel_bits(format, i), format.zero_fill);
    return out;
}

// The whole of it, at pixel (x, y) of the target.
inline std::uint32_t blended(const Blend& blend, const ColorFormat& format, std::uint32_t source, std::uint32_t dest,
                             int x, int y) {
    static constexpr int kOrdered[2][2] = {{0, 2}, {3, 1}};
    Pixel s                             = Pixel::of(source), out;
    const Pixel d                       = Pixel::of(dest);
    for (int i = 0; i < 3; ++i)
        if (blend.cut_source) s.c[i] -= s.c[i] % (256 >> raster::channel_bits(format, i));
    const int matrix = blend.dither == Dither::Matrix4x4 ? blend.dither_matrix[4 * (y % 4) + x % 4] : 0;
    for (int i = 0; i < 3; ++i) {
        out.c[i] = blended_channel(blend, {d.c[i], s.c[kAlpha], d.c[kAlpha], matrix}, s.c[i]);
        if (blend.dither == Dither::Ordered2x2) out.c[i] += kOrdered[y % 2][x % 2] - out.c[i] / 64;
    }
    out.c[kAlpha] = blended_alpha(blend, s.c[kAlpha], d.c[kAlpha]);
    return (stored(format, out).argb() & blend.write_mask) | (dest & ~blend.write_mask);
}

// For a failure's message.
inline std::string name_of(const BlendFactor& factor) {
    static constexpr std::array<const char*, 3> kOperands{"ZERO", "SRC", "DEST"};
    std::string name = kOperands[static_cast<std::size_t>(factor.operand)];
    if (factor.operand == BlendFactor::Operand::Zero) return factor.invert ? "ONE" : name;
    name += factor.alpha ? "ALPHA" : "COLOR";
    return factor.invert ? "INV" + name : name;
}

inline std::string name_of(const Blend& blend) {
    std::string name;
    if (blend.rule == BlendRule::Shift7) {
        const Shift7Blend& s = blend.shift7;
        const auto operand   = [](Shift7Blend::Operand which) { return "SD0"[static_cast<std::size_t>(which)]; };
        static constexpr std::array<const char*, 3> kFactors{"SA", "DA", "constant"};
        name = std::string("Shift7 (") + operand(s.a) + " - " + operand(s.b) + ") * " +
               kFactors[static_cast<std::size_t>(s.c)] + " + " + operand(s.d) + ", constant " +
               std::to_string(s.constant) + (s.clamp ? ", clamp" : "") +
               (s.only_above_half ? ", only above half" : "") + (s.set_top_bit ? ", set top bit" : "");
    } else {
        name = (blend.rule == BlendRule::Nearest255 ? "Nearest255 " : "Trunc256 ") + name_of(blend.source) + ", " +
               name_of(blend.dest);
    }
    name += ", dither " + std::to_string(static_cast<int>(blend.dither));
    return blend.cut_source ? name + ", cut source" : name;
}

}  // namespace blend_formula
