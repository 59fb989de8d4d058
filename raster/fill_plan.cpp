// SPDX-License-Identifier: MIT
#include "raster/fill_plan.h"

namespace raster {
namespace {

bool any_stage_reads(const FillState& state, CombineArg::Source source) {
    return reads(state, 0, source) || reads(state, 1, source);
}

bool reads_diffuse(const FillState& state) {
    using enum CombineArg::Source;
    return state.stage_count == 0 || any_stage_reads(state, Diffuse) || reads(state, 0, Current);
}

}  // namespace

FillPlan plan_fill(const FillState& state, bool has_color, const ColorFormat& format, int depth_bits) {
    FillPlan plan;
    plan.state        = state;
    plan.depth_bits   = depth_bits;
    plan.uses_depth   = state.depth_func != Compare::Always || state.depth_write;
    plan.tests_first  = state.alpha_func == Compare::Always;
    plan.writes_color = has_color && state.blend.write_mask != 0;
    plan.fails_on     = !plan.tests_first && state.alpha_fail != AlphaFail::Keep;
    plan.uses_color   = plan.writes_color || state.alpha_func != Compare::Always;

    plan.needs.depth        = plan.uses_depth;
    plan.needs.floor_colors = state.floor_colors;
    plan.needs.diffuse      = plan.uses_color && reads_diffuse(state);
    plan.needs.specular =
        plan.uses_color && (state.add_specular || state.fog || any_stage_reads(state, CombineArg::Source::Specular));

    plan.cover       = cover_kernels();
    plan.interpolate = interpolate_kernels();
    plan.combine     = combine_kernels();
    plan.test        = test_kernels();
    plan.pack        = pack_kernel();
    plan.blend_plan  = plan_blend(state.blend, format);
    plan.blend       = blend_kernel(plan.blend_plan);
    for (int i = 0; i < kMaxTextures; ++i) {
        if (!reads(state, i, CombineArg::Source::Texel)) continue;
        SamplePlan& sampler = plan.samplers[i] = plan_sampler(state.samplers[i]);
        const auto texels                      = static_cast<std::uint64_t>(sampler.texels_per_fragment());
        plan.texels_per_fragment += texels;
        plan.texel_bytes_per_fragment += texels * static_cast<std::uint64_t>(state.samplers[i].texel_bytes);
        if (!plan.uses_color) continue;
        plan.sample[i]           = sample_kernel(sampler);
        plan.sample_rectangle[i] = sample_rectangle_kernel(sampler);
        if (sampler.level_count == 0) continue;
        plan.needs.texture[i] = true;
        plan.needs.lod[i]     = sampler.lod_max() > 0;
        plan.needs.width[i]   = sampler.levels[0].width;
        plan.needs.height[i]  = sampler.levels[0].height;
    }
    return plan;
}

}  // namespace raster
