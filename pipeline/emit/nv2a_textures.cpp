// SPDX-License-Identifier: MIT
#include <bit>

#include "pipeline/emit/nv2a_draw.h"
#include "pipeline/emit/nv2a_values.h"
#include "pipeline/validate/check_pass.h"

namespace pipeline {
namespace {

// What a stage samples.
struct Sampled {
    Nv2aValue format;
    bool is_swizzled   = false;
    std::int32_t width = 0, height = 0, levels = 1;
    const Nv2aPlace& place;
};

Sampled sampled_by(const Nv2aDraw& draw, std::size_t stage) {
    const TextureBindings bindings = textures_of(draw.draw);
    const TextureBinding& binding  = bindings[stage];
    if (binding.target) {
        const Target& target = draw.frame.targets[static_cast<std::size_t>(binding.target.index)];
        return {nv2a_target_as_texture(target.format), false, target.width, target.height, 1,
                draw.memory.of(binding.target)};
    }
    const Texture& texture = draw.frame.textures[static_cast<std::size_t>(binding.texture.index)];
    const bool swizzled    = is_swizzled(texture);
    return {nv2a_texture_format(texture.format, swizzled),
            swizzled,
            texture.width,
            texture.height,
            texture.levels,
            draw.memory.of(binding.texture)};
}

std::uint32_t logarithm(std::int32_t size) {
    return static_cast<std::uint32_t>(std::bit_width(static_cast<std::uint32_t>(size))) - 1;
}

void set_format(Nv2aStream& out, std::size_t stage, const Sampled& texture) {
    std::uint32_t format = pack(nv097::TEXTURE_FORMAT_CONTEXT_DMA, 1) | pack(nv097::TEXTURE_FORMAT_BORDER_SOURCE, 1) |
                           pack(nv097::TEXTURE_FORMAT_DIMENSIONALITY, 2) |
                           pack(nv097::TEXTURE_FORMAT_COLOR, texture.format.value) |
                           pack(nv097::TEXTURE_FORMAT_MIPMAP_LEVELS, static_cast<std::uint32_t>(texture.levels));
    const std::string size = std::to_string(texture.width) + 'x' + std::to_string(texture.height);
    std::string meaning    = std::string(texture.format.name) + ", two dimensions, DMA A";
    if (texture.is_swizzled) {
        format |= pack(nv097::TEXTURE_FORMAT_BASE_SIZE_U, logarithm(texture.width)) |
                  pack(nv097::TEXTURE_FORMAT_BASE_SIZE_V, logarithm(texture.height));
        meaning += ", " + size + ", levels: " + std::to_string(texture.levels);
    }
    out.set(nv097::SET_TEXTURE_OFFSET, stage, {texture.place.address}, texture.place.what);
    out.set(nv097::SET_TEXTURE_FORMAT, stage, {format}, meaning);
    if (texture.is_swizzled) return;
    out.set(nv097::SET_TEXTURE_CONTROL1, stage, {pack(nv097::TEXTURE_CONTROL1_IMAGE_PITCH, texture.place.pitch)},
            "rows of " + std::to_string(texture.place.pitch) + " bytes");
    out.set(nv097::SET_TEXTURE_IMAGE_RECT, stage,
            {pack(nv097::TEXTURE_IMAGE_RECT_WIDTH, static_cast<std::uint32_t>(texture.width)) |
             pack(nv097::TEXTURE_IMAGE_RECT_HEIGHT, static_cast<std::uint32_t>(texture.height))},
            size);
}

void set_sampler(Nv2aStream& out, std::size_t i, const TextureStage& stage, bool is_swizzled) {
    const Nv2aValue u = nv2a_address(stage.address_u), v = nv2a_address(stage.address_v);
    out.set(nv097::SET_TEXTURE_ADDRESS, i,
            {pack(nv097::TEXTURE_ADDRESS_U, u.value) | pack(nv097::TEXTURE_ADDRESS_V, v.value) |
             pack(nv097::TEXTURE_ADDRESS_P, nv2a_address(TextureAddress::Clamp).value)},
            "u " + std::string(u.name) + ", v " + std::string(v.name));
    const bool clamps = stage.address_u == TextureAddress::Clamp && stage.address_v == TextureAddress::Clamp;
    if (!clamps && !is_swizzled)
        out.note_once("Not known: whether a linear texture repeats. It matters only where coordinates leave it.");
    out.set(nv097::SET_TEXTURE_CONTROL0, i,
            {pack(nv097::TEXTURE_CONTROL0_ENABLE, 1) | pack(nv097::TEXTURE_CONTROL0_MIN_LOD_CLAMP, 0) |
             pack(nv097::TEXTURE_CONTROL0_MAX_LOD_CLAMP, nv097::LOD_CLAMP_NONE)},
            "enabled, all levels");
    const Nv2aValue min = nv2a_min_filter(stage.filter, stage.mip_filter), mag = nv2a_mag_filter(stage.filter);
    out.set(nv097::SET_TEXTURE_FILTER, i,
            {pack(nv097::TEXTURE_FILTER_CONVOLUTION_KERNEL, 1) | pack(nv097::TEXTURE_FILTER_MIN, min.value) |
             pack(nv097::TEXTURE_FILTER_MAG, mag.value)},
            "min " + std::string(min.name) + ", mag " + std::string(mag.name) + ", no bias");
}

}  // namespace

Nv2aTexels texels_of(const Nv2aDraw& draw) {
    Nv2aTexels texels{};
    const TextureBindings bindings = textures_of(draw.draw);
    for (int i = 0; i < stage_count(draw.state()); ++i) {
        const TextureBinding& binding = bindings[static_cast<std::size_t>(i)];
        if (!reads_texture(draw.state(), i) || (!binding.texture && !binding.target)) continue;
        const bool is_alpha =
            binding.texture &&
            draw.frame.textures[static_cast<std::size_t>(binding.texture.index)].format == TextureFormat::A8;
        texels[static_cast<std::size_t>(i)] = is_alpha ? Nv2aTexel::Alpha : Nv2aTexel::Color;
    }
    return texels;
}

bool has_texel_coordinates(const Nv2aDraw& draw, std::size_t stage) {
    return !sampled_by(draw, stage).is_swizzled;
}

void set_textures(Nv2aStream& out, const Nv2aDraw& draw) {
    const Nv2aTexels texels = texels_of(draw);
    std::uint32_t programs  = 0;
    for (std::size_t i = 0; i < nv097::kTextures; ++i) {
        if (i >= texels.size() || texels[i] == Nv2aTexel::Nothing) {
            out.set(nv097::SET_TEXTURE_CONTROL0, i, {0}, "disabled");
            out.set(nv097::SET_TEXTURE_MATRIX_ENABLE, i, {0}, "off");
            continue;
        }
        const Sampled texture = sampled_by(draw, i);
        set_format(out, i, texture);
        set_sampler(out, i, draw.state().stages[i], texture.is_swizzled);
        out.set(nv097::SET_TEXTURE_MATRIX_ENABLE, i, {texture.is_swizzled ? 0u : 1u},
                texture.is_swizzled ? "off" : "on: from 0..1 to texels");
        if (!texture.is_swizzled) {
            const float size[2] = {static_cast<float>(texture.width), static_cast<float>(texture.height)};
            for (std::size_t row = 0; row < 4; ++row) {
                float values[4] = {0.0f, 0.0f, 0.0f, 0.0f};
                values[row]     = row < 2 ? size[row] : 1.0f;
                out.set_floats(nv097::SET_TEXTURE_MATRIX, 4 * i + row, values,
                               "texture " + std::to_string(i) + ", row " + std::to_string(row));
            }
        }
        programs |= nv097::PROGRAM_2D_PROJECTIVE << (5 * i);
    }
    const auto program_text = [&](std::size_t i) {
        return (programs >> (5 * i) & 31) == nv097::PROGRAM_NONE ? "none" : "2D_PROJECTIVE";
    };
    out.set(nv097::SET_SHADER_STAGE_PROGRAM, {programs},
            std::string("0 ") + program_text(0) + ", 1 " + program_text(1) + ", 2 none, 3 none");
    out.set(nv097::SET_SHADER_OTHER_STAGE_INPUT, {0}, "no texture reads another's");
}

void set_combiners(Nv2aStream& out, const Nv2aDraw& draw) {
    const PipelineState& state = draw.state();
    const Nv2aCombiners words  = nv2a_combiners(state, texels_of(draw), draw.has_fog());
    out.set(nv097::SET_COMBINER_CONTROL, {words.count},
            std::to_string(words.count) + " general, C0 and C1 the same in all");
    for (std::size_t i = 0; i < words.count; ++i) {
        out.set(nv097::SET_COMBINER_FACTOR0, i, {state.texture_factor.value}, "C0, the texture factor (ARGB)");
        out.set(nv097::SET_COMBINER_COLOR_ICW, i, {words.color_in[i]}, inputs_text(words.color_in[i], false));
        out.set(nv097::SET_COMBINER_COLOR_OCW, i, {words.color_out[i]}, output_text(words.color_out[i]));
        out.set(nv097::SET_COMBINER_ALPHA_ICW, i, {words.alpha_in[i]}, inputs_text(words.alpha_in[i], true));
        out.set(nv097::SET_COMBINER_ALPHA_OCW, i, {words.alpha_out[i]}, output_text(words.alpha_out[i]));
    }
    out.set(nv097::SET_COMBINER_SPECULAR_FOG_CW0, {words.final_abcd},
            draw.has_fog() ? "A = FOG.a, B = R0, C = FOG, D = 0" : "A = 0, B = 0, C = 0, D = R0");
    out.set(nv097::SET_COMBINER_SPECULAR_FOG_CW1, {words.final_efg}, "E = 0, F = 0, G = R0.a");
    out.set(nv097::SET_SPECULAR_FOG_FACTOR, {0, 0}, "not read");
}

}  // namespace pipeline
