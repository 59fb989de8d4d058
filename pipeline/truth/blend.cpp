// SPDX-License-Identifier: MIT
#include <cmath>

#include "pipeline/truth/fragment.h"

namespace pipeline::truth {
namespace {

Color factor(BlendFactor factor, const Color& source, const Color& there) {
    switch (factor) {
        case BlendFactor::Zero:
            return Color(0.0);
        case BlendFactor::One:
            return Color(1.0);
        case BlendFactor::SourceColor:
            return source;
        case BlendFactor::InvSourceColor:
            return 1.0 - source;
        case BlendFactor::DestColor:
            return there;
        case BlendFactor::InvDestColor:
            return 1.0 - there;
        case BlendFactor::SourceAlpha:
            return Color(source.a);
        case BlendFactor::InvSourceAlpha:
            return Color(1.0 - source.a);
        case BlendFactor::DestAlpha:
            return Color(there.a);
        case BlendFactor::InvDestAlpha:
            return Color(1.0 - there.a);
    }
    return Color(0.0);
}

bool has_top_bit(double alpha) {
    return std::floor(alpha * 255.0 + 0.5) >= 128.0;
}

// Not clamped, a value goes round at 256.
double wrapped(double value) {
    const double turns = value * 255.0 / 256.0;
    return (turns - std::floor(turns)) * 256.0 / 255.0;
}

Color gs_blended(const GsBlend& blend, const Color& source, const Color& there) {
    const auto operand = [&](GsColor which) {
        return which == GsColor::Cs ? source : which == GsColor::Cd ? there : Color(0.0);
    };
    const double c = blend.c == GsAlpha::As ? source.a : blend.c == GsAlpha::Ad ? there.a : blend.fix / 255.0;
    Color color    = (operand(blend.a) - operand(blend.b)) * c * (255.0 / 128.0) + operand(blend.d);
    if (blend.pabe && !has_top_bit(source.a)) color = source;
    if (!blend.colclamp) color = Color(wrapped(color.r), wrapped(color.g), wrapped(color.b), 0.0);
    color.a = blend.fba && !has_top_bit(source.a) ? source.a + 128.0 / 255.0 : source.a;
    return clamp01(color);
}

}  // namespace

Color blended(const Arithmetic& arithmetic, const PipelineState& state, const Color& source, const Color& there) {
    if (arithmetic.blend == BlendRule::GsShift7) return gs_blended(state.gs_blend, source, there);
    const BlendState& blend = state.blend;
    if (blend == kReplace) return source;
    return clamp01(source * factor(blend.source, source, there) + there * factor(blend.dest, source, there));
}

}  // namespace pipeline::truth
