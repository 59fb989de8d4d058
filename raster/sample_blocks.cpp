// SPDX-License-Identifier: MIT
#include "raster/sample_blocks.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/sample_blocks.cpp"
#include "hwy/foreach_target.h"
#include "raster/lanes-inl.h"
#include "raster/sampling-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

template <class Filter>
void sample(const SamplePlan& plan, const SamplePoints& points, int count, BlockRows<std::uint32_t>& out) {
    for (int i = 0; i < count * kBlockWidth; i += lane_count()) {
        const VI u = hn::Load(DI(), points.u.lanes + i), v = hn::Load(DI(), points.v.lanes + i);
        hn::Store(sample_level<Filter>(plan, 0, u, v), DU(), out.lanes + i);
    }
}

// One round for each level that a lane reads, mostly a single one. The first is that of the first lane, straight from
// memory, for no texel can be read before the level is known.
template <class Filter, bool kMixLevels>
void sample_mips(const SamplePlan& plan, const SamplePoints& points, int count, BlockRows<std::uint32_t>& out) {
    constexpr int kHalf = kMixLevels ? 0 : 128;
    const int last      = plan.level_count - 1;
    for (int i = 0; i < count * kBlockWidth; i += lane_count()) {
        const VI u = hn::Load(DI(), points.u.lanes + i), v = hn::Load(DI(), points.v.lanes + i);
        const VI lod      = hn::Load(DI(), points.lod.lanes + i);
        const VI level    = hn::ShiftRight<8>(hn::Add(lod, seti(kHalf)));
        const VI fraction = hn::And(lod, seti(255));
        VU texel          = set(0);
        auto rest         = hn::Gt(lod, seti(-1));  // every lane
        for (std::ptrdiff_t lane = 0;; lane = hn::FindFirstTrue(DI(), rest)) {
            const int index = (points.lod.lanes[i + lane] + kHalf) >> 8;
            const auto here = hn::Eq(level, seti(index));
            VU sampled      = sample_level<Filter>(plan, index, u, v);
            // The next level has no weight where the texture is magnified, nor after the last.
            if (kMixLevels && index < last && !hn::AllFalse(DI(), hn::And(here, hn::Gt(fraction, seti(0))))) {
                const VU next = sample_level<Filter>(plan, index + 1, u, v);
                sampled       = Filter::mix_levels(sampled, next, fraction);
            }
            texel = select(hn::BitCast(DU(), hn::VecFromMask(DI(), here)), sampled, texel);
            rest  = hn::AndNot(here, rest);
            if (hn::AllFalse(DI(), rest)) break;
        }
        hn::Store(texel, DU(), out.lanes + i);
    }
}

void sample_white(const SamplePlan&, const SamplePoints&, int count, BlockRows<std::uint32_t>& out) {
    for (int i = 0; i < count * kBlockWidth; i += lane_count()) hn::Store(set(0xffffffff), DU(), out.lanes + i);
}

int list_live_lanes(const FragmentBatch& batch, std::uint32_t* index) {
    int lanes = 0;
#if HWY_TARGET <= HWY_AVX3
    // A store of a whole vector may write past the live lanes, but never past the lanes that it was read from.
    for (int i = 0; i < batch.count * kBlockWidth; i += lane_count()) {
        const auto live = hn::MaskFromVec(hn::Load(DU(), batch.mask.lanes + i));
        hn::StoreU(hn::Compress(hn::BitCast(DU(), lane_index(i)), live), DU(), index + lanes);
        lanes += static_cast<int>(hn::CountTrue(DU(), live));
    }
#else
    // No instruction for it, and the emulation is slower than this: each lane is written over by the next if it is dead.
    for (int i = 0; i < batch.count * kBlockWidth; ++i) {
        index[lanes] = static_cast<std::uint32_t>(i);
        lanes += static_cast<int>(batch.mask.lanes[i] & 1);
    }
#endif
    return lanes;
}

void pack_points(const FragmentBatch& batch, bool all, PackedPoints& out) {
    std::uint32_t* const index = out.index.lanes;
    out.lanes                  = batch.count * kBlockWidth;
    if (all) {
        for (int i = 0; i < out.lanes; i += lane_count()) hn::Store(hn::BitCast(DU(), lane_index(i)), DU(), index + i);
    } else {
        out.lanes = list_live_lanes(batch, index);
        std::fill(index + out.lanes, index + out.blocks() * kBlockWidth, index[out.lanes - 1]);
    }
}

PackKernel get_pack_kernel() {
    return &pack_points;
}

SampleKernel get_sample_kernel(const SamplePlan& plan) {
    if (plan.level_count == 0) return &sample_white;
    return for_filter(plan, [&plan](auto filter) -> SampleKernel {
        using Filter = decltype(filter);
        if (plan.lod_max() == 0) return &sample<Filter>;
        return plan.mip == MipFilter::Linear ? &sample_mips<Filter, true> : &sample_mips<Filter, false>;
    });
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raster {

HWY_EXPORT(get_sample_kernel);
SampleKernel sample_kernel(const SamplePlan& plan) {
    return HWY_DYNAMIC_DISPATCH(get_sample_kernel)(plan);
}

HWY_EXPORT(get_pack_kernel);
PackKernel pack_kernel() {
    return HWY_DYNAMIC_DISPATCH(get_pack_kernel)();
}

SamplePlan plan_sampler(const Sampler& sampler) {
    SamplePlan plan;
    plan.level_count = static_cast<int>(sampler.levels.size());
    plan.linear      = sampler.linear;
    plan.rule        = sampler.rule;
    plan.mip         = sampler.mip;
    plan.address_u   = sampler.address_u;
    plan.address_v   = sampler.address_v;
    for (int i = 0; i < plan.level_count; ++i) {
        const TextureLevel& level = sampler.levels[i];
        plan.levels[i]            = {level.texels, static_cast<std::int32_t>(level.stride), level.width, level.height};
    }
    return plan;
}

}  // namespace raster
#endif
