// SPDX-License-Identifier: MIT
#include "tests/extremes/blends.h"

#include <algorithm>
#include <cmath>

#include "pipeline/execute/execute.h"
#include "tests/support/one_pass_frame.h"

namespace extremes {

using namespace pipeline;

namespace {

constexpr int kReds = 4;

// Rows: reds from a start of 0, then those from 255; columns: factors.
Frame blend_frame(const Blender& blender, BlendKind kind) {
    Frame frame                   = test_support::one_pass_frame(256, 2 * kReds);
    frame.targets[0].format       = blender.format;
    frame.arithmetic.blend        = blender.rule;
    frame.arithmetic.blend_source = blender.source;
    Texture& texture              = frame.textures.emplace_back();
    texture.width                 = 256;
    texture.height                = 2 * kReds;
    for (int row = 0; row < texture.height; ++row)
        for (int factor = 0; factor < 256; ++factor) {
            const int red = kind == BlendKind::Over ? row % kReds * 85 : factor;
            for (const int byte : {0, 0, red, factor}) texture.texels.push_back(static_cast<std::uint8_t>(byte));
        }

    const auto rectangle = [](int y0, int y1, std::uint32_t color) {
        DrawRectangle draw;
        draw.y0    = static_cast<float>(y0);
        draw.x1    = 256.0f;
        draw.y1    = static_cast<float>(y1);
        draw.color = {color};
        return draw;
    };
    frame.passes[0].draws = {rectangle(kReds, 2 * kReds, 0xffffffff)};

    Pass& pass           = frame.passes.emplace_back(Pass(frame.passes[0]));
    pass.state.stages[0] = {.color_op = TextureOp::SelectArg1, .alpha_op = TextureOp::SelectArg1};
    if (blender.rule == BlendRule::GsShift7)
        pass.state.gs_blend = {.a = GsColor::Cs, .b = GsColor::Cd, .c = GsAlpha::As, .d = GsColor::Cd};
    else
        pass.state.blend = kind == BlendKind::Over ? kAlphaOver : kMultiply;
    DrawRectangle again       = rectangle(0, 2 * kReds, 0xffffffff);
    again.textures[0].texture = {0};
    pass.draws.assign(kBlends, again);
    return frame;
}

// What the blender sees of the source.
double source_of(const Blender& blender, int red) {
    return blender.source == BlendSource::TargetBits ? red >> (8 - blender.bits) << (8 - blender.bits) : red;
}

}  // namespace

std::span<const Blender> blenders() {
    using enum BlendRule;
    using enum TargetFormat;
    static constexpr Blender kAll[]{
        {"ideal and dx7, 8 bits", Nearest255, BlendSource::Bytes, A8R8G8B8, 8, true},
        {"ideal and dx7, 5 bits", Nearest255, BlendSource::Bytes, R5G6B5, 5, true},
        {"xbox, 5 bits", Nearest255, BlendSource::TargetBits, R5G6B5, 5, true},
        {"gamecube, 8 bits", FlipperTrunc256, BlendSource::Bytes, X8R8G8B8, 8, true},
        {"gamecube, 6 bits", FlipperTrunc256, BlendSource::Bytes, R6G6B6A6, 6, true},
        {"ps2, 8 bits", GsShift7, BlendSource::Bytes, Psmct32, 8, false},
        {"ps2, 5 bits", GsShift7, BlendSource::Bytes, Psmct16, 5, false},
    };
    return kAll;
}

bool has_kind(const Blender& blender, BlendKind kind) {
    return kind == BlendKind::Over || blender.rule != BlendRule::GsShift7;
}

Ends blended(const Blender& blender, BlendKind kind) {
    const ColorImage image = execute(blend_frame(blender, kind)).output;
    Ends ends{};
    for (std::size_t row = 0; row < 2 * kReds; ++row)
        for (std::size_t factor = 0; factor < 256; ++factor)
            ends[row / kReds][row % kReds][factor] = static_cast<std::uint8_t>(image.pixels[row * 256 + factor] >> 16);
    return ends;
}

// NEAREST255 rounds 255ths to the nearest, FLIPPER_TRUNC256 cuts 256ths, GS_SHIFT7 128ths. Bits that a format drops and
// repeats are off by less than the lowest it keeps; without repeating as well.
double blend_error(const Blender& blender) {
    const double rounding = blender.rule == BlendRule::Nearest255        ? 127.0 / 255.0
                            : blender.rule == BlendRule::FlipperTrunc256 ? 255.0 / 256.0
                                                                         : 127.0 / 128.0;
    return rounding + ((1 << (8 - blender.bits)) - 1);
}

double factor_of(const Blender& blender, BlendKind kind, int factor) {
    const auto expanded = [](int f) { return (f + (f >> 7)) / 256.0; };
    switch (blender.rule) {
        case BlendRule::Nearest255:
            return kind == BlendKind::Over ? factor / 255.0 : 1.0 - source_of(blender, factor) / 255.0;
        case BlendRule::FlipperTrunc256:
            return kind == BlendKind::Over ? expanded(factor) : 1.0 - expanded(factor);
        case BlendRule::GsShift7:
            break;
    }
    return factor / 128.0;
}

Drift drift(const Blender& blender, BlendKind kind, const Ends& ends) {
    Drift drift;
    const double error = blend_error(blender);
    for (int start = 0; start < 2; ++start)
        for (int red = 0; red < kReds; ++red)
            for (int factor = 0; factor < 256; ++factor) {
                const double f = factor_of(blender, kind, factor);
                // With 0x80 as one the Graphics Synthesizer's factors above go past the source, and further than 2 grow.
                if (f > 1.0) continue;
                const double target = kind == BlendKind::Over ? source_of(blender, red * 85) : 0.0;
                // Of the start the target keeps what it can.
                const int white     = blender.repeats ? 255 : 255 >> (8 - blender.bits) << (8 - blender.bits);
                double exact        = start * white;
                for (int i = 0; i < kBlends && std::abs(target - exact) > 1e-9 && f > 0.0; ++i)
                    exact += (target - exact) * f;
                const double off   = std::abs(ends[start][red][factor] - exact);
                // Without a factor nothing is rounded.
                const double bound = f > 0.0 ? error / f : 0.0;
                drift.greatest     = std::max(drift.greatest, off);
                if (off > 1e-6) drift.of_bound = std::max(drift.of_bound, bound > 0.0 ? off / bound : 1e9);
            }
    return drift;
}

std::vector<Row> blend_rows() {
    std::vector<Row> rows;
    for (const Blender& blender : blenders())
        for (const BlendKind kind : {BlendKind::Over, BlendKind::Multiply}) {
            if (!has_kind(blender, kind)) continue;
            const Ends ends   = blended(blender, kind);
            const Drift found = drift(blender, kind, ends);
            const bool over   = kind == BlendKind::Over;
            const auto last   = [&](int start, std::size_t red) {
                // Of the factors that are least and do something, and at 16.
                return std::to_string(ends[static_cast<std::size_t>(start)][red][1]) + " (alpha 1), " +
                       std::to_string(ends[static_cast<std::size_t>(start)][red][16]) + " (16)";
            };
            rows.push_back(
                {std::string(over ? "SRCALPHA INVSRCALPHA, " : "ZERO SRCCOLOR, ") + std::string(blender.name),
                 over ? "10,000 blends, all alphas" : "10,000 blends, all factors",
                 ceil_text(blend_error(blender), 3) + " / f of 255",
                 ceil_text(found.greatest, 0) + " of 255, " + ceil_text(found.of_bound, 2) + " of the bound",
                 over ? "black on white ends at " + last(1, 0) + "; white on black at " + last(0, 3)
                      : "white times 254 ends at " + std::to_string(ends[1][0][254]) + ", times 128 at " +
                            std::to_string(ends[1][0][128])});
        }
    return rows;
}

}  // namespace extremes
