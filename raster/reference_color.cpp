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

int div255(int value) {
    return (value + 127) / 255;
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

int combine(CombineOp op, int a, int b) {
    switch (op) {
        case CombineOp::Select:
            return a;
        case CombineOp::Modulate:
            return div255(std::min(65025, a * b));
        case CombineOp::Modulate2X:
            return div255(std::min(65025, 2 * a * b));
        case CombineOp::Modulate4X:
            return div255(std::min(65025, 4 * a * b));
        case CombineOp::Add:
            return clamp_byte(a + b);
        case CombineOp::AddSigned:
            return clamp_byte(a + b - 127);
        case CombineOp::AddSigned2X:
            return clamp_byte(2 * a + 2 * b - 255);
        case CombineOp::Subtract:
            return clamp_byte(a - b);
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

}  // namespace

std::uint32_t combined_color(const FillState& state, const FragmentColors& fragment) {
    std::uint32_t current = fragment.diffuse;
    for (int i = 0; i < state.stage_count; ++i) {
        std::uint32_t next = 0;  // both combines of a stage read what the stage before left
        for (int c = 0; c < 4; ++c) {
            const Combine& how = c == kAlpha ? state.stages[i].alpha : state.stages[i].color;
            const int a        = read(how.a, state, fragment, current, fragment.texels[i], c);
            const int b        = read(how.b, state, fragment, current, fragment.texels[i], c);
            next |= at_channel(combine(how.op, a, b), c);
        }
        current = next;
    }

    const int fog        = channel(fragment.specular, kAlpha);
    std::uint32_t result = current & 0xff000000;
    for (int c = 0; c < kAlpha; ++c) {
        int value = channel(current, c);
        if (state.add_specular) value = clamp_byte(value + channel(fragment.specular, c));
        if (state.fog) value = div255(fog * value + (255 - fog) * channel(state.fog_color, c));
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
    }
    return false;
}

std::uint32_t blended_color(const FillState& state, std::uint32_t source, std::uint32_t dest) {
    std::uint32_t result = 0;
    for (int c = 0; c < 4; ++c) {
        const int fs  = factor(state.source_factor, source, dest, c);
        const int fd  = factor(state.dest_factor, source, dest, c);
        const int sum = channel(source, c) * fs + channel(dest, c) * fd;
        result |= at_channel(div255(std::min(65025, sum)), c);
    }
    return (dest & ~state.write_mask) | (result & state.write_mask);
}

}  // namespace raster::reference
