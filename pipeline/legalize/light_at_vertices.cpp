// SPDX-License-Identifier: MIT
#include "pipeline/legalize/light_at_vertices.h"

#include <algorithm>
#include <cmath>

#include "pipeline/check/chip_findings.h"
#include "pipeline/check/target_use.h"
#include "pipeline/legalize/window_map.h"

namespace pipeline {

namespace {

constexpr BlendState kByOneMore{.source = BlendFactor::DestColor, .dest = BlendFactor::One};
constexpr std::array<std::string_view, 3> kChannelNames{"blue", "green", "red"};

using Rgb = std::array<double, 3>;  // blue, green, red; 0..1

Rgb rgb_of(Argb color) {
    Rgb rgb;
    for (std::size_t c = 0; c < 3; ++c) rgb[c] = (color.value >> (8 * c) & 255) / 255.0;
    return rgb;
}

Rgb texel(const Texture& texture, std::size_t x, std::size_t y) {
    const std::size_t i = y * static_cast<std::size_t>(texture.width) + x;
    switch (texture.format) {
        case TextureFormat::A8:
            return {};
        case TextureFormat::L8:
            return {texture.texels[i] / 255.0, texture.texels[i] / 255.0, texture.texels[i] / 255.0};
        case TextureFormat::A8R8G8B8:
            return {texture.texels[4 * i] / 255.0, texture.texels[4 * i + 1] / 255.0,
                    texture.texels[4 * i + 2] / 255.0};
    }
    return {};
}

std::size_t addressed(double index, std::int32_t size, TextureAddress address) {
    if (address == TextureAddress::Clamp) return static_cast<std::size_t>(std::clamp(index, 0.0, size - 1.0));
    return static_cast<std::size_t>(index - std::floor(index / size) * size);
}

Rgb sample(const Texture& texture, const TextureStage& stage, const Vec3& uv) {
    // As raster/sampling_rules.h raises it.
    const double q = std::max(static_cast<double>(uv.z), 1e-30);
    double u = uv.x / q * texture.width, v = uv.y / q * texture.height;
    const auto at = [&](double x, double y) {
        return texel(texture, addressed(x, texture.width, stage.address_u),
                     addressed(y, texture.height, stage.address_v));
    };
    if (stage.filter == TextureFilter::Point) return at(std::floor(u), std::floor(v));
    u -= 0.5, v -= 0.5;
    const double x = std::floor(u), y = std::floor(v), fu = u - x, fv = v - y;
    const Rgb a = at(x, y), b = at(x + 1, y), c = at(x, y + 1), d = at(x + 1, y + 1);
    Rgb rgb;
    for (std::size_t i = 0; i < 3; ++i)
        rgb[i] = (1 - fv) * ((1 - fu) * a[i] + fu * b[i]) + fv * ((1 - fu) * c[i] + fu * d[i]);
    return rgb;
}

bool is_plain(const TextureArg& arg) {
    return !arg.complement && !arg.alpha_replicate && arg.source != ArgSource::Specular;
}

bool can_evaluate(const Frame& frame, const Pass& pass, std::size_t index) {
    const TextureStage& stage = pass.state.stages[index];
    const bool has_op         = stage.color_op == TextureOp::SelectArg1 || stage.color_op == TextureOp::SelectArg2 ||
                        stage.color_op == TextureOp::Modulate || stage.color_op == TextureOp::Modulate2X;
    const auto can_address = [](TextureAddress address) {
        return address == TextureAddress::Wrap || address == TextureAddress::Clamp;
    };
    if (!has_op || !is_plain(stage.color_arg1) || !is_plain(stage.color_arg2)) return false;
    if (!reads_texture(pass.state, static_cast<int>(index))) return true;
    return can_address(stage.address_u) && can_address(stage.address_v) &&
           std::all_of(pass.draws.begin(), pass.draws.end(), [&](const Draw& draw) {
               return find_texture(frame, textures_of(draw)[index].texture) != nullptr;
           });
}

bool is_thrown_light(const Frame& frame, const Pass& pass) {
    const PipelineState& state = pass.state;
    const bool in_window       = std::all_of(pass.draws.begin(), pass.draws.end(), [](const Draw& draw) {
        return std::holds_alternative<DrawWindowTriangles>(draw);
    });
    if (pass.draws.empty() || !in_window || state.blend != kByOneMore || state.color_mask.alpha || state.depth.write ||
        stage_count(state) == 0 || state.lighting.specular_enable || state.alpha_test.func != CompareFunc::Always)
        return false;
    for (std::size_t i = 0; i < static_cast<std::size_t>(stage_count(state)); ++i)
        if (!can_evaluate(frame, pass, i)) return false;
    return true;
}

// What a draw's fragment would be at one of its vertices.
class Evaluator {
  public:
    Evaluator(const Frame& frame, const PipelineState& state, const TextureBindings& textures)
        : frame_(frame), state_(state), textures_(textures) {}

    Argb color_at(const WindowVertex& vertex) const {
        Rgb current = rgb_of(vertex.diffuse);
        for (std::size_t i = 0; i < static_cast<std::size_t>(stage_count(state_)); ++i)
            current = after(i, current, vertex);
        if (state_.fog.mode != FogMode::None) {
            const double f = (vertex.specular.value >> 24) / 255.0;
            const Rgb fog  = rgb_of(state_.fog.color);
            for (std::size_t c = 0; c < 3; ++c) current[c] = f * current[c] + (1 - f) * fog[c];
        }
        std::uint32_t color = 0;
        for (std::size_t c = 0; c < 3; ++c)
            color |= static_cast<std::uint32_t>(std::floor(current[c] * 255 + 0.5)) << (8 * c);
        return {color};
    }

  private:
    Rgb after(std::size_t index, const Rgb& current, const WindowVertex& vertex) const {
        const TextureStage& stage = state_.stages[index];
        const Rgb one             = argument(stage.color_arg1, index, current, vertex),
                  other           = argument(stage.color_arg2, index, current, vertex);
        if (stage.color_op == TextureOp::SelectArg1) return one;
        if (stage.color_op == TextureOp::SelectArg2) return other;
        const double scale = stage.color_op == TextureOp::Modulate2X ? 2 : 1;
        Rgb rgb;
        for (std::size_t c = 0; c < 3; ++c) rgb[c] = std::min(1.0, scale * one[c] * other[c]);
        return rgb;
    }

    Rgb argument(const TextureArg& arg, std::size_t index, const Rgb& current, const WindowVertex& vertex) const {
        switch (arg.source) {
            case ArgSource::Texture: {
                const Texture* texture = find_texture(frame_, textures_[index].texture);
                return texture == nullptr
                           ? Rgb{1, 1, 1}
                           : sample(*texture, state_.stages[index], index == 0 ? vertex.uv0 : vertex.uv1);
            }
            case ArgSource::TFactor:
                return rgb_of(state_.texture_factor);
            case ArgSource::Current:
                return current;
            default:
                return rgb_of(vertex.diffuse);
        }
    }

    const Frame& frame_;
    const PipelineState& state_;
    const TextureBindings& textures_;
};

// A draw's lit triangles in one channel; the vertices are the draw's, in that channel's grey.
DrawWindowTriangles append_channel(Frame& frame, const DrawWindowTriangles& draw, const std::vector<Argb>& light,
                                   std::size_t channel) {
    const auto level = [&](std::size_t i) { return light[i].value >> (8 * channel) & 255; };
    DrawWindowTriangles out{.first_index = static_cast<std::uint32_t>(frame.indices.size()), .textures = {}};
    for (std::uint32_t i = 0; i + 2 < draw.index_count; i += 3) {
        if ((level(i) | level(i + 1) | level(i + 2)) == 0) continue;
        for (std::uint32_t k = i; k < i + 3; ++k) {
            WindowVertex vertex = frame.window_vertices[frame.indices[draw.first_index + k]];
            vertex.diffuse      = {level(k) * 0x01010101u};
            vertex.specular     = {0xff000000};
            vertex.uv0 = vertex.uv1 = Vec3(0.0f, 0.0f, 1.0f);
            frame.indices.push_back(static_cast<std::uint32_t>(frame.window_vertices.size()));
            frame.window_vertices.push_back(vertex);
        }
    }
    out.index_count = static_cast<std::uint32_t>(frame.indices.size()) - out.first_index;
    return out;
}

std::vector<Pass> split(Frame& frame, const Pass& pass) {
    std::vector<Pass> passes;
    std::vector<std::vector<Argb>> light;  // of each draw, at each of its indices
    for (const Draw& draw : pass.draws) {
        const auto& triangles = std::get<DrawWindowTriangles>(draw);
        const Evaluator evaluator(frame, pass.state, triangles.textures);
        std::vector<Argb>& of_draw = light.emplace_back();
        for (std::uint32_t i = 0; i < triangles.index_count; ++i)
            of_draw.push_back(evaluator.color_at(frame.window_vertices[frame.indices[triangles.first_index + i]]));
    }
    const ColorMask& mask = pass.state.color_mask;
    for (std::size_t channel = 3; channel-- > 0;) {
        Pass one             = pass;
        one.label            = pass.label + ": " + std::string(kChannelNames[channel]);
        one.state.stages     = {};
        one.state.fog        = {};
        one.state.color_mask = {.red   = mask.red && channel == 2,
                                .green = mask.green && channel == 1,
                                .blue  = mask.blue && channel == 0,
                                .alpha = false};
        if (channel != 2) one.clear = {};
        for (std::size_t i = 0; i < one.draws.size(); ++i)
            one.draws[i] = append_channel(frame, std::get<DrawWindowTriangles>(pass.draws[i]), light[i], channel);
        passes.push_back(std::move(one));
    }
    return passes;
}

}  // namespace

Frame rewrite_light_at_vertices(Frame frame, const Profile& profile, RewriteNotes& notes) {
    if (profile.states.stages != 1 || profile.arithmetic.blend != BlendRule::GsShift7) return frame;
    std::vector<Pass> passes;
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        const Pass pass = frame.passes[i];
        if (!is_thrown_light(frame, pass)) {
            passes.push_back(pass);
            continue;
        }
        notes.push_back({"light_at_vertices", place_of(frame, i),
                         "the chip has 1 stage, and no colour as a blend's factor",
                         "light evaluated at the vertices, in 3 passes"});
        std::ranges::move(split(frame, pass), std::back_inserter(passes));
    }
    frame.passes = std::move(passes);
    return frame;
}

}  // namespace pipeline
