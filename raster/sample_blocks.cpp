// SPDX-License-Identifier: MIT
#include "raster/sample_blocks.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/sample_blocks.cpp"
#include "hwy/foreach_target.h"
#include "raster/lanes-inl.h"
#include "raster/sampling-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

// Two levels, by f of 256.
HWY_INLINE VU mix_levels(VU a, VU b, VU f) {
    const VU f2 = hn::Or(f, hn::ShiftLeft<16>(f)), one_minus_f = sub16(set_pair(256), f2), half = set_pair(128);
    const Pixels sum   = weigh_row(a, b, f2, one_minus_f);
    const auto rounded = [&](VU v) HWY_ATTR { return hn::And(hn::ShiftRight<8>(add16(v, half)), set_pair(0xff)); };
    return pack({rounded(sum.lo), rounded(sum.hi)});
}

template <bool kLinear>
void sample(const SamplePlan& plan, const SamplePoints& points, const BlockRows<std::uint32_t>&, int count,
            BlockRows<std::uint32_t>& out) {
    for (int block = 0; block < count; ++block)
        for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
            const VI u = hn::Load(DI(), points.u[block] + lane), v = hn::Load(DI(), points.v[block] + lane);
            hn::Store(sample_level<kLinear>(plan, 0, u, v), DU(), out[block] + lane);
        }
}

// One round for each level that a live lane reads: mostly a single one.
template <bool kLinear, bool kMixLevels>
void sample_mips(const SamplePlan& plan, const SamplePoints& points, const BlockRows<std::uint32_t>& mask, int count,
                 BlockRows<std::uint32_t>& out) {
    const int last = plan.level_count - 1;
    for (int block = 0; block < count; ++block)
        for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
            const VI u = hn::Load(DI(), points.u[block] + lane), v = hn::Load(DI(), points.v[block] + lane);
            const VI lod      = hn::Load(DI(), points.lod[block] + lane);
            const VI alive    = hn::BitCast(DI(), hn::Load(DU(), mask[block] + lane));
            const VI level    = hn::ShiftRight<8>(kMixLevels ? lod : hn::Add(lod, seti(128)));
            const auto live   = hn::MaskFromVec(alive);
            const int lowest  = hn::GetLane(hn::MinOfLanes(DI(), hn::IfThenElse(live, level, seti(last))));
            const int highest = hn::GetLane(hn::MaxOfLanes(DI(), hn::IfThenElse(live, level, seti(0))));
            VU texel          = set(0);
            for (int index = lowest; index <= highest; ++index) {
                VU here = sample_level<kLinear>(plan, index, u, v);
                if constexpr (kMixLevels) {
                    const VU next = sample_level<kLinear>(plan, index < last ? index + 1 : last, u, v);
                    here          = mix_levels(here, next, hn::BitCast(DU(), hn::And(lod, seti(255))));
                }
                texel = select(hn::BitCast(DU(), hn::VecFromMask(DI(), hn::Eq(level, seti(index)))), here, texel);
            }
            hn::Store(texel, DU(), out[block] + lane);
        }
}

void sample_white(const SamplePlan&, const SamplePoints&, const BlockRows<std::uint32_t>&, int count,
                  BlockRows<std::uint32_t>& out) {
    for (int block = 0; block < count; ++block)
        for (int lane = 0; lane < kBlockWidth; lane += lane_count())
            hn::Store(set(0xffffffff), DU(), out[block] + lane);
}

void pack_points(const FragmentBatch& batch, PackedPoints& out) {
    std::uint32_t* const index = out.index.lanes;
    int lanes                  = 0;
#if HWY_TARGET == HWY_SCALAR
    for (int i = 0; i < batch.count * kBlockWidth; ++i)
        if (batch.mask.lanes[i] != 0) index[lanes++] = static_cast<std::uint32_t>(i);
#else
    // A store of a whole vector may write past the live lanes, but never past the lane it was read from plus its width.
    for (int i = 0; i < batch.count * kBlockWidth; i += lane_count()) {
        const auto live = hn::MaskFromVec(hn::Load(DU(), batch.mask.lanes + i));
        hn::StoreU(hn::Compress(hn::BitCast(DU(), lane_index(i)), live), DU(), index + lanes);
        lanes += static_cast<int>(hn::CountTrue(DU(), live));
    }
#endif
    out.lanes = lanes;
    for (int i = lanes; i < out.blocks() * kBlockWidth; ++i) index[i] = 0;
    for (int i = 0; i < out.blocks() * kBlockWidth; i += lane_count()) {
        const VI from = hn::BitCast(DI(), hn::Load(DU(), index + i));
        hn::Store(hn::GatherIndex(DI(), batch.points.u.lanes, from), DI(), out.points.u.lanes + i);
        hn::Store(hn::GatherIndex(DI(), batch.points.v.lanes, from), DI(), out.points.v.lanes + i);
        hn::Store(hn::GatherIndex(DI(), batch.points.lod.lanes, from), DI(), out.points.lod.lanes + i);
        const auto used = hn::Lt(lane_index(i), seti(lanes));
        hn::Store(hn::BitCast(DU(), hn::VecFromMask(DI(), used)), DU(), out.mask.lanes + i);
    }
}

PackKernel get_pack_kernel() {
    return &pack_points;
}

SampleKernel get_sample_kernel(const SamplePlan& plan) {
    if (plan.level_count == 0) return &sample_white;
    if (plan.lod_max() == 0) return plan.linear ? &sample<true> : &sample<false>;
    if (plan.mip == MipFilter::Linear) return plan.linear ? &sample_mips<true, true> : &sample_mips<false, true>;
    return plan.linear ? &sample_mips<true, false> : &sample_mips<false, false>;
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
    plan.mip         = sampler.mip;
    plan.address_u   = sampler.address_u;
    plan.address_v   = sampler.address_v;
    if (sampler.levels.empty()) return plan;
    plan.texels = sampler.levels[0].texels;
    for (int i = 0; i < plan.level_count; ++i) {
        const TextureLevel& level = sampler.levels[i];
        plan.levels[i]            = {.offset = static_cast<std::int32_t>(level.texels - plan.texels),
                                     .stride = static_cast<std::int32_t>(level.stride),
                                     .width  = level.width,
                                     .height = level.height};
    }
    return plan;
}

}  // namespace raster
#endif
