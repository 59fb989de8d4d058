// SPDX-License-Identifier: MIT
#include "tests/peers/rounding.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace peers {

using namespace pipeline;

namespace {

constexpr double kRounding      = 0.5;
constexpr double kInterpolation = 15.0 / 256.0 + 1.0 / 128.0;

FragmentError both(double error) {
    return {error, error};
}
FragmentError texture_error(const TextureStage& stage, const TextureBinding& binding) {
    if (!binding.texture && !binding.target) return {};
    double error = stage.filter == TextureFilter::Linear ? kRounding : 0.0;
    if (binding.texture && stage.mip_filter == MipFilter::Linear) error += kRounding;
    return both(error);
}

// The errors of a stage's sources.
struct Sources {
    FragmentError diffuse, current, texture;

    FragmentError of(const TextureArg& arg) const {
        const FragmentError source = arg.source == ArgSource::Diffuse   ? diffuse
                                     : arg.source == ArgSource::Current ? current
                                     : arg.source == ArgSource::Texture ? texture
                                                                        : FragmentError{};
        return arg.alpha_replicate ? both(source.alpha) : source;
    }
};

double combine(TextureOp op, double a, double b, double weight) {
    switch (op) {
        case TextureOp::Disable:
        case TextureOp::SelectArg1:
            return a;
        case TextureOp::SelectArg2:
            return b;
        case TextureOp::Modulate:
            return a + b + kRounding;
        case TextureOp::Modulate2X:
            return 2.0 * (a + b) + kRounding;
        case TextureOp::Modulate4X:
            return 4.0 * (a + b) + kRounding;
        case TextureOp::Add:
        case TextureOp::Subtract:
            return a + b;
        case TextureOp::AddSigned:
            return a + b + kRounding;
        case TextureOp::AddSigned2X:
            return 2.0 * (a + b);
        case TextureOp::BlendDiffuseAlpha:
        case TextureOp::BlendTextureAlpha:
        case TextureOp::BlendFactorAlpha:
        case TextureOp::BlendCurrentAlpha:
            return std::max(a, b) + weight + kRounding;
        case TextureOp::ModulateColorAddAlpha:
            return a + b + weight + kRounding;
    }
    return 0.0;
}

double weight_error(TextureOp op, const TextureArg& a, const Sources& sources) {
    switch (op) {
        case TextureOp::BlendDiffuseAlpha:
            return sources.diffuse.alpha;
        case TextureOp::BlendTextureAlpha:
            return sources.texture.alpha;
        case TextureOp::BlendCurrentAlpha:
            return sources.current.alpha;
        case TextureOp::ModulateColorAddAlpha:
            return sources.of({.source = a.source, .complement = false, .alpha_replicate = true}).alpha;
        default:
            return 0.0;
    }
}

FragmentError combine(const TextureStage& stage, const Sources& sources) {
    return {combine(stage.color_op, sources.of(stage.color_arg1).color, sources.of(stage.color_arg2).color,
                    weight_error(stage.color_op, stage.color_arg1, sources)),
            combine(stage.alpha_op, sources.of(stage.alpha_arg1).alpha, sources.of(stage.alpha_arg2).alpha,
                    weight_error(stage.alpha_op, stage.alpha_arg1, sources))};
}

FragmentError after_stages(const Pass& pass, const TextureBindings& textures, const FragmentError& diffuse) {
    FragmentError current = diffuse;
    for (int i = 0; i < stage_count(pass.state); ++i) {
        const TextureStage& stage   = pass.state.stages[static_cast<std::size_t>(i)];
        const FragmentError texture = texture_error(stage, textures[static_cast<std::size_t>(i)]);
        current                     = combine(stage, {diffuse, current, texture});
    }
    return current;
}

// A vertex's colour is a byte, exact if it is not lit, then a value between those of the vertices, which is rounded
// again.
double vertex_color_error(const Pass& pass) {
    const double at_vertex = pass.state.lighting.enabled ? kRounding : 0.0;
    return pass.state.shade == ShadeMode::Flat ? at_vertex : at_vertex + kRounding + kInterpolation;
}

FragmentError fragment_error(const Pass& pass, const Draw& draw, double interpolation) {
    if (const auto* rectangle = std::get_if<DrawRectangle>(&draw)) return after_stages(pass, rectangle->textures, {});
    if (std::holds_alternative<CopyRectangle>(draw)) return {};

    const double vertex = vertex_color_error(pass) + interpolation;
    FragmentError error = after_stages(pass, std::get<DrawTriangles>(draw).textures, both(vertex));
    if (pass.state.lighting.specular_enable) error.color += vertex;
    if (pass.state.fog.mode != FogMode::None) {
        // The factor is a byte at the vertices, whatever the colours are.
        const double factor =
            kRounding + (pass.state.shade == ShadeMode::Flat ? 0.0 : kRounding + kInterpolation) + interpolation;
        error.color += factor + kRounding;
    }
    return error;
}

// Of a factor, by what it is made of. What the pixel already has is looked at with the layers.
double factor_error(BlendFactor factor, const FragmentError& source) {
    switch (factor) {
        case BlendFactor::SourceColor:
        case BlendFactor::InvSourceColor:
            return std::max(source.color, source.alpha);
        case BlendFactor::SourceAlpha:
        case BlendFactor::InvSourceAlpha:
            return source.alpha;
        default:
            return 0.0;
    }
}

bool reads_dest(BlendFactor factor) {
    return factor == BlendFactor::DestColor || factor == BlendFactor::InvDestColor ||
           factor == BlendFactor::DestAlpha || factor == BlendFactor::InvDestAlpha;
}

bool shares_weight(const BlendState& blend) {
    const auto is = [&](BlendFactor a, BlendFactor b) {
        return (blend.source == a && blend.dest == b) || (blend.source == b && blend.dest == a);
    };
    return is(BlendFactor::SourceAlpha, BlendFactor::InvSourceAlpha) ||
           is(BlendFactor::SourceColor, BlendFactor::InvSourceColor);
}

bool is_fraction(BlendFactor factor) {
    return factor != BlendFactor::Zero && factor != BlendFactor::One;
}

// What one layer is rounded by: once here; in OpenGL the source, and each product.
double blend_roundings(const BlendState& blend) {
    return kRounding * (2 + is_fraction(blend.source) + is_fraction(blend.dest));
}

// Of one channel whose source has this error.
double channel_error(const BlendState& blend, double source, const FragmentError& error, int layers) {
    const double roundings = blend_roundings(blend);
    if (shares_weight(blend)) return source + layers * (factor_error(blend.source, error) + roundings);
    double total = 0.0;
    for (int i = 0; i < layers && total < 255.0; ++i) {
        const double from_source =
            blend.source == BlendFactor::Zero
                ? 0.0
                : source + (reads_dest(blend.source) ? total : factor_error(blend.source, error));
        const double from_dest = blend.dest == BlendFactor::Zero
                                     ? 0.0
                                     : total + (reads_dest(blend.dest) ? total : factor_error(blend.dest, error));
        total                  = from_source + from_dest + roundings;
    }
    return total;
}

}  // namespace

FragmentError fragment_error(const Pass& pass, double interpolation) {
    FragmentError greatest;
    for (const Draw& draw : pass.draws) {
        const FragmentError error = fragment_error(pass, draw, interpolation);
        greatest                  = {std::max(greatest.color, error.color), std::max(greatest.alpha, error.alpha)};
    }
    return greatest;
}

int allowed_difference(const Pass& pass, const FragmentError& error, int layers) {
    if (layers == 0) return 0;
    const BlendState& blend = pass.state.blend;
    // Only the last layer stays, and is rounded once, in OpenGL.
    const double total      = blend == kReplace ? std::max(error.color, error.alpha) + kRounding
                                                : std::max(channel_error(blend, error.color, error, layers),
                                                           channel_error(blend, error.alpha, error, layers));
    return static_cast<int>(std::floor(std::min(total, 255.0)));
}

}  // namespace peers
