// SPDX-License-Identifier: MIT
#include "raster/fill_plan.h"

#include "raster/fill_kernels.h"

namespace raster {
namespace {

bool any_stage_reads(const FillState& state, CombineArg::Source source) {
    return reads(state, 0, source) || reads(state, 1, source);
}

bool reads_diffuse(const FillState& state) {
    using enum CombineArg::Source;
    return state.stage_count == 0 || any_stage_reads(state, Diffuse) || reads(state, 0, Current);
}

TextureProgram texture_program(const Sampler& sampler) {
    TextureProgram program{.is_read = true};
    if (sampler.levels.empty()) return program;
    program.has_texels = true;
    program.linear     = sampler.linear;
    program.has_mips   = sampler.mip != MipFilter::None && sampler.levels.size() > 1;
    program.mip        = program.has_mips ? sampler.mip : MipFilter::None;
    if (program.linear || program.mip == MipFilter::Linear) program.rule = sampler.rule;
    program.address_u   = sampler.address_u;
    program.address_v   = sampler.address_v;
    program.alpha_quads = !sampler.alpha_quads.empty() && sampler.linear && sampler.address_u == Address::Clamp &&
                          sampler.address_v == Address::Clamp;
    return program;
}

int texels_per_fragment(const Sampler& sampler) {
    if (sampler.levels.empty()) return 0;
    return (sampler.linear ? 4 : 1) * (sampler.mip == MipFilter::Linear ? 2 : 1);
}

Writes writes_of(std::uint32_t mask) {
    return mask == 0            ? Writes::Nothing
           : mask == 0xffffffff ? Writes::All
           : mask == 0xff000000 ? Writes::Alpha
                                : Writes::Some;
}

void set_color_program(const FillState& state, FillProgram& program) {
    program.makes_color    = true;
    program.floor_colors   = state.floor_colors;
    program.reads_diffuse  = reads_diffuse(state);
    program.reads_fog_only = state.fog && !state.add_specular && !any_stage_reads(state, CombineArg::Source::Specular);
    program.reads_specular = state.fog || state.add_specular || any_stage_reads(state, CombineArg::Source::Specular);
    program.stage_count    = static_cast<std::uint8_t>(state.stage_count);
    if (state.stage_count > 0) program.combine_rule = state.combine_rule;
    for (int i = 0; i < state.stage_count; ++i) {
        program.stages[i] = state.stages[i];
        if (reads(state, i, CombineArg::Source::Texel)) program.textures[i] = texture_program(state.samplers[i]);
    }
    program.add_specular = state.add_specular;
    program.fog          = state.fog;
    if (state.fog) program.fog_rule = state.fog_rule;
}

void set_blend_program(const Blend& blend, std::uint32_t kept_bits, FillProgram& program) {
    program.writes      = writes_of(blend.write_mask);
    program.blend       = blend.rule;
    program.dither      = blend.dither;
    // All bits that it may write are kept as they are.
    program.whole_bytes = (blend.write_mask & ~kept_bits) == 0 && blend.dither == Dither::None;
    if (blend.rule == BlendRule::Shift7) {
        program.shift7          = blend.shift7;
        program.shift7.constant = 0;
    } else {
        program.source = blend.source;
        program.dest   = blend.dest;
    }
}

// The bits of the colour target that a fragment may change in spite of the alpha test.
std::uint32_t bits_if_failed(const FillState& state) {
    switch (state.alpha_fail) {
        case AlphaFail::Keep:
        case AlphaFail::DepthOnly:
            break;
        case AlphaFail::ColorOnly:
            return state.blend.write_mask;
        case AlphaFail::RgbOnly:
            return state.blend.write_mask & 0x00ffffff;
    }
    return 0;
}

}  // namespace

FillPlan plan_fill(const FillState& state, bool has_color, const ColorFormat& format, int depth_bits, bool general) {
    FillPlan plan;
    plan.constant        = state.constant;
    plan.fog_color       = state.fog_color;
    plan.alpha_reference = state.alpha_reference;
    plan.bits_if_failed  = bits_if_failed(state);
    plan.blend           = plan_blend(state.blend, format);

    FillProgram& program    = plan.program;
    const bool writes_color = has_color && state.blend.write_mask != 0;
    program.alpha_func      = state.alpha_func;
    if (state.alpha_func != Compare::Always) program.alpha_fail = state.alpha_fail;
    program.dest_alpha_test = state.dest_alpha_test;
    if (state.depth_func != Compare::Always || state.depth_write) {
        program.depth_bits  = static_cast<std::uint8_t>(depth_bits);
        program.depth_func  = state.depth_func;
        program.depth_write = state.depth_write;
    }
    if (writes_color || state.alpha_func != Compare::Always) set_color_program(state, program);
    if (writes_color) set_blend_program(state.blend, plan.blend.store.keep, program);

    plan.needs.depth        = program.depth_bits != 0;
    plan.needs.depth_cut    = state.whole_depth ? std::max(0, kDepthBits - depth_bits) : 0;
    plan.needs.floor_colors = program.floor_colors;
    plan.needs.diffuse      = program.reads_diffuse;
    plan.needs.specular     = program.reads_specular && !program.reads_fog_only;
    plan.needs.fog          = program.reads_fog_only;
    for (int i = 0; i < kMaxTextures; ++i) {
        if (!reads(state, i, CombineArg::Source::Texel)) continue;
        const Sampler& sampler = state.samplers[i];
        const auto texels      = static_cast<std::uint64_t>(texels_per_fragment(sampler));
        plan.texels_per_fragment += texels;
        plan.texel_bytes_per_fragment += texels * static_cast<std::uint64_t>(sampler.texel_bytes);
        if (!program.textures[i].has_texels) continue;
        plan.samplers[i]      = plan_sampler(sampler, program.textures[i].alpha_quads);
        plan.needs.texture[i] = true;
        plan.needs.lod[i]     = program.textures[i].has_mips;
        plan.needs.width[i]   = sampler.levels[0].width;
        plan.needs.height[i]  = sampler.levels[0].height;
    }
    plan.kernel = fill_kernel(program, general);
    return plan;
}

SamplePlan plan_sampler(const Sampler& sampler, bool alpha_quads) {
    SamplePlan plan;
    plan.level_count = static_cast<int>(sampler.levels.size());
    plan.lod_max     = sampler.mip == MipFilter::None ? 0 : 256 * (plan.level_count - 1);
    for (int i = 0; i < plan.level_count; ++i) {
        const TextureLevel& level = (alpha_quads ? sampler.alpha_quads : sampler.levels)[i];
        plan.levels[i]            = {.texels      = level.texels,
                                     .stride      = static_cast<std::int32_t>(level.stride),
                                     .width       = level.width,
                                     .last_column = level.width - 1,
                                     .last_row    = level.height - 1};
    }
    return plan;
}

BlendPlan plan_blend(const Blend& blend, const ColorFormat& format) {
    BlendPlan plan;
    plan.store           = store_masks(format);
    plan.write_mask      = blend.write_mask;
    plan.shift7_constant = blend.shift7.constant;
    if (blend.cut_source) plan.source_mask = plan.store.keep | 0xff000000;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < kBlockWidth; ++x) {
            static constexpr std::uint32_t k2x2[2][2] = {{0, 2}, {3, 1}};
            if (blend.dither == Dither::Ordered2x2) plan.dither[y][x] = k2x2[y & 1][x & 1] * 0x10001u;
            if (blend.dither == Dither::Matrix4x4) {
                const auto offset = static_cast<std::uint16_t>(blend.dither_matrix[4 * y + (x & 3)]);
                plan.dither[y][x] = offset | static_cast<std::uint32_t>(offset) << 16;
            }
        }
    return plan;
}

}  // namespace raster
