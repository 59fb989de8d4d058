// SPDX-License-Identifier: MIT
#include "raster/reference_color.h"

#include <algorithm>

namespace raster::reference {

namespace {

constexpr int kAlpha = 3;  // channels count from the low byte: blue, green, red, alpha

int channel(std::uint32_t color, int c) {
    return static_cast<int>((color >> (8 * c)) & 255);
}

std::uint32_t at_channel(int value, int c) {
    return static_cast<std::uint32_t>(value) << (8 * c);
}

int clamp_byte(int value) {
    return std::clamp(value, 0, 255);
}

int nearest(int value) {
    return (value + 127) / 255;
}

// f' of the rules.
int expanded(int f) {
    return f + (f >> 7);
}

int read(const CombineArg& arg, const FillState& state, const FragmentColors& fragment, std::uint32_t current,
         std::uint32_t texel, int c) {
    std::uint32_t color = 0;
    switch (arg.source) {
        case CombineArg::Source::Diffuse:
            color = fragment.diffuse;
            break;
        case CombineArg::Source::Current:
            color = current;
            break;
        case CombineArg::Source::Texel:
            color = texel;
            break;
        case CombineArg::Source::Constant:
            color = state.constant;
            break;
        case CombineArg::Source::Specular:
            color = fragment.specular | 0xff000000;
            break;
    }
    const int value = channel(color, arg.alpha_replicate ? kAlpha : c);
    return arg.complement ? 255 - value : value;
}

// The columns of step 2, before the clamp.
int combine_nearest255(CombineOp op, int a, int b, int c) {
    switch (op) {
        case CombineOp::Select:
            return a;
        case CombineOp::Modulate:
            return nearest(std::min(65025, a * b));
        case CombineOp::Modulate2X:
            return nearest(std::min(65025, 2 * a * b));
        case CombineOp::Modulate4X:
            return nearest(std::min(65025, 4 * a * b));
        case CombineOp::Add:
            return a + b;
        case CombineOp::AddSigned:
            return a + b - 127;
        case CombineOp::AddSigned2X:
            return 2 * a + 2 * b - 255;
        case CombineOp::Subtract:
            return a - b;
        case CombineOp::Lerp:
            return nearest(a * c + b * (255 - c));
        case CombineOp::MultiplyAdd:
            return nearest(a * b) + c;
    }
    return 0;
}

int combine_expanded256(CombineOp op, int a, int b, int c) {
    switch (op) {
        case CombineOp::Select:
            return a;
        case CombineOp::Modulate:
            return (a * expanded(b) + 128) >> 8;
        case CombineOp::Modulate2X:
            return (2 * a * expanded(b) + 128) >> 8;
        case CombineOp::Modulate4X:
            return (4 * a * expanded(b) + 128) >> 8;
        case CombineOp::Add:
            return a + b;
        case CombineOp::AddSigned:
            return a + b - 128;
        case CombineOp::AddSigned2X:
            return 2 * a + 2 * b - 256;
        case CombineOp::Subtract:
            return a - b;
        case CombineOp::Lerp:
            return (a * expanded(c) + b * (256 - expanded(c)) + 128) >> 8;
        case CombineOp::MultiplyAdd:
            return ((a * expanded(b) + 128) >> 8) + c;
    }
    return 0;
}

int combine_shift7(CombineOp op, int a, int b, int c) {
    switch (op) {
        case CombineOp::Select:
            return a;
        case CombineOp::Modulate:
            return (a * b) >> 7;
        case CombineOp::Add:
            return a + b;
        case CombineOp::MultiplyAdd:
            return ((a * b) >> 7) + c;
        case CombineOp::Modulate2X:
        case CombineOp::Modulate4X:
        case CombineOp::AddSigned:
        case CombineOp::AddSigned2X:
        case CombineOp::Subtract:
        case CombineOp::Lerp:
            return 0;  // not to be asked
    }
    return 0;
}

int combine(CombineRule rule, CombineOp op, int a, int b, int c) {
    switch (rule) {
        case CombineRule::Nearest255:
            return clamp_byte(combine_nearest255(op, a, b, c));
        case CombineRule::Expanded256:
            return clamp_byte(combine_expanded256(op, a, b, c));
        case CombineRule::Shift7:
            return clamp_byte(combine_shift7(op, a, b, c));
    }
    return 0;
}

// f: 255 for no fog; k: the fog's colour.
int fogged(FogRule rule, int f, int c, int k) {
    switch (rule) {
        case FogRule::Nearest255:
            return nearest(f * c + (255 - f) * k);
        case FogRule::Floor256:
            return (f * c + (256 - f) * k) >> 8;
        case FogRule::TwoFloors:
            return ((f * c) >> 8) + (((255 - f) * k) >> 8);
        case FogRule::Expanded256: {
            const int expanded = f + f / 128;
            return (expanded * c + (256 - expanded) * k) >> 8;
        }
    }
    return 0;
}

int factor(const BlendFactor& f, std::uint32_t source, std::uint32_t dest, int c) {
    const int from = f.alpha ? kAlpha : c;
    int value      = 0;
    switch (f.operand) {
        case BlendFactor::Operand::Zero:
            value = 0;
            break;
        case BlendFactor::Operand::Source:
            value = channel(source, from);
            break;
        case BlendFactor::Operand::Dest:
            value = channel(dest, from);
            break;
    }
    return f.invert ? 255 - value : value;
}

int shift7_operand(Shift7Blend::Operand operand, std::uint32_t source, std::uint32_t dest, int c) {
    switch (operand) {
        case Shift7Blend::Operand::Source:
            return channel(source, c);
        case Shift7Blend::Operand::Dest:
            return channel(dest, c);
        case Shift7Blend::Operand::Zero:
            return 0;
    }
    return 0;
}

int shift7_factor(const Shift7Blend& blend, std::uint32_t source, std::uint32_t dest) {
    switch (blend.c) {
        case Shift7Blend::Factor::SourceAlpha:
            return channel(source, kAlpha);
        case Shift7Blend::Factor::DestAlpha:
            return channel(dest, kAlpha);
        case Shift7Blend::Factor::Constant:
            return blend.constant;
    }
    return 0;
}

int shift7_channel(const Shift7Blend& blend, std::uint32_t source, std::uint32_t dest, int dither, int c) {
    const int s = channel(source, c);
    if (c == kAlpha) return blend.set_top_bit ? s | 128 : s;

    int value = 0;
    if (blend.only_above_half && channel(source, kAlpha) < 128) {
        value = s + dither;
    } else {
        const int a = shift7_operand(blend.a, source, dest, c), b = shift7_operand(blend.b, source, dest, c);
        value =
            (((a - b) * shift7_factor(blend, source, dest)) >> 7) + shift7_operand(blend.d, source, dest, c) + dither;
    }
    return blend.clamp ? clamp_byte(value) : value & 255;
}

// Step 7 for one channel. `dither`: of the rule Shift7.
int blended_channel(const Blend& blend, std::uint32_t source, std::uint32_t dest, int dither, int c) {
    const int s = channel(source, c), d = channel(dest, c);
    const int fs = factor(blend.source, source, dest, c), fd = factor(blend.dest, source, dest, c);
    switch (blend.rule) {
        case BlendRule::Nearest255:
            return nearest(std::min(65025, s * fs + d * fd));
        case BlendRule::Trunc256:
            return clamp_byte((s * expanded(fs) + d * expanded(fd)) >> 8);
        case BlendRule::Shift7:
            return shift7_channel(blend.shift7, source, dest, dither, c);
    }
    return 0;
}

// Red, green and blue without the bits that the target has no room for.
std::uint32_t cut(const ColorFormat& format, std::uint32_t color) {
    std::uint32_t result = color & 0xff000000;
    for (int c = 0; c < kAlpha; ++c) {
        const int lost = 8 - channel_bits(format, c);
        result |= at_channel((channel(color, c) >> lost) << lost, c);
    }
    return result;
}

}  // namespace

std::uint32_t combined_color(const FillState& state, const FragmentColors& fragment) {
    std::uint32_t current = fragment.diffuse;
    for (int i = 0; i < state.stage_count; ++i) {
        std::uint32_t next = 0;  // both combines of a stage read what the stage before left
        for (int ch = 0; ch < 4; ++ch) {
            const Combine& how  = ch == kAlpha ? state.stages[i].alpha : state.stages[i].color;
            const auto argument = [&](const CombineArg& arg) {
                return read(arg, state, fragment, current, fragment.texels[i], ch);
            };
            next |=
                at_channel(combine(state.combine_rule, how.op, argument(how.a), argument(how.b), argument(how.c)), ch);
        }
        current = next;
    }

    const int fog        = channel(fragment.specular, kAlpha);
    std::uint32_t result = current & 0xff000000;
    for (int c = 0; c < kAlpha; ++c) {
        int value = channel(current, c);
        if (state.add_specular) value = clamp_byte(value + channel(fragment.specular, c));
        if (state.fog) value = fogged(state.fog_rule, fog, value, channel(state.fog_color, c));
        result |= at_channel(value, c);
    }
    return result;
}

bool passes(Compare func, std::uint32_t fragment, std::uint32_t reference) {
    switch (func) {
        case Compare::Always:
            return true;
        case Compare::LessEqual:
            return fragment <= reference;
        case Compare::Less:
            return fragment < reference;
        case Compare::GreaterEqual:
            return fragment >= reference;
        case Compare::Greater:
            return fragment > reference;
        case Compare::Equal:
            return fragment == reference;
        case Compare::NotEqual:
            return fragment != reference;
        case Compare::Never:
            return false;
    }
    return false;
}

std::uint32_t blended_color(const Blend& blend, const ColorFormat& format, std::uint32_t source, std::uint32_t dest,
                            int x, int y) {
    static constexpr int kOrdered[2][2] = {{0, 2}, {3, 1}};
    const std::uint32_t s               = blend.cut_source ? cut(format, source) : source;
    const int matrix      = blend.dither == Dither::Matrix4x4 ? blend.dither_matrix[4 * (y & 3) + (x & 3)] : 0;
    std::uint32_t written = 0;
    for (int c = 0; c < 4; ++c) {
        int value = blended_channel(blend, s, dest, matrix, c);
        if (blend.dither == Dither::Ordered2x2 && c != kAlpha) value = value - (value >> 6) + kOrdered[y & 1][x & 1];
        written |= at_channel(value, c);
    }
    return (dest & ~blend.write_mask) | (stored_color(format, written) & blend.write_mask);
}

std::uint32_t stored_color(const ColorFormat& format, std::uint32_t argb) {
    std::uint32_t result = 0;
    for (int c = 0; c < 4; ++c) {
        const int n    = channel_bits(format, c);
        const int kept = channel(argb, c) >> (8 - n);
        int read       = 0;
        if (n == 0) {
            read = format.zero_fill ? 128 : 255;
        } else if (format.zero_fill) {
            read = kept << (8 - n);
        } else {
            // Bit by bit from the top, starting over when `kept` has no more.
            for (int i = 0; i < 8; ++i) read = 2 * read + ((kept >> (n - 1 - i % n)) & 1);
        }
        result |= at_channel(read, c);
    }
    return result;
}

}  // namespace raster::reference
