// SPDX-License-Identifier: MIT
// Texels of one level at vectors of coordinates: what the sampling kernels share.
// Highway's per-target include guard.
#if defined(NIMBUS7_RASTER_SAMPLING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NIMBUS7_RASTER_SAMPLING_INL_H_
#undef NIMBUS7_RASTER_SAMPLING_INL_H_
#else
#define NIMBUS7_RASTER_SAMPLING_INL_H_
#endif

#include "raster/lanes-inl.h"
#include "raster/sample_blocks.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

HWY_INLINE VI address(Address mode, VI i, std::int32_t size) {
    switch (mode) {
        case Address::Wrap:
            return hn::And(i, seti(size - 1));
        case Address::Clamp:
            return hn::Min(hn::Max(i, seti(0)), seti(size - 1));
        case Address::Mirror: {
            const VI m = hn::And(i, seti(2 * size - 1));
            return hn::Min(m, hn::Sub(seti(2 * size - 1), m));
        }
    }
    return i;
}

// (a * (256 - f) + b * f + half) >> 8 of one row of texels is exact in 16 bits before the shift; the column needs 32.
HWY_INLINE Pixels weigh_row(VU left, VU right, VU f, VU one_minus_f) {
    const Pixels a = unpack(left), b = unpack(right);
    return {add16(mul16(a.lo, one_minus_f), mul16(b.lo, f)), add16(mul16(a.hi, one_minus_f), mul16(b.hi, f))};
}
HWY_INLINE VU weigh_column(VU top, VU bottom, VI f) {  // pairs of 16-bit sums to pairs of bytes
    const VI low     = seti(0xffff);
    const auto weigh = [&](VI a, VI b) HWY_ATTR {
        const VI sum = hn::Add(hn::ShiftLeft<8>(a), hn::Mul(hn::Sub(b, a), f));
        return hn::ShiftRight<16>(hn::Add(sum, seti(1 << 15)));
    };
    const VI t = hn::BitCast(DI(), top), b = hn::BitCast(DI(), bottom);
    const VI even = weigh(hn::And(t, low), hn::And(b, low));
    const VI odd  = weigh(hn::BitCast(DI(), hn::ShiftRight<16>(top)), hn::BitCast(DI(), hn::ShiftRight<16>(bottom)));
    return hn::BitCast(DU(), hn::Or(even, hn::ShiftLeft<16>(odd)));
}

template <bool kLinear>
HWY_INLINE VU sample_level(const SamplePlan& plan, int index, VI u, VI v) {
    const SamplePlan::Level& level    = plan.levels[index];
    const std::uint32_t* const texels = plan.texels + level.offset;
    const VI stride                   = seti(level.stride);
    u                                 = hn::ShiftRightSame(u, index);
    v                                 = hn::ShiftRightSame(v, index);
    if constexpr (!kLinear) {
        const VI i = address(plan.address_u, hn::ShiftRight<8>(u), level.width);
        const VI j = address(plan.address_v, hn::ShiftRight<8>(v), level.height);
        return hn::GatherIndex(DU(), texels, hn::Add(hn::Mul(j, stride), i));
    } else {
        u          = hn::Sub(u, seti(128));
        v          = hn::Sub(v, seti(128));
        const VI i = hn::ShiftRight<8>(u), j = hn::ShiftRight<8>(v);
        const VI i0      = address(plan.address_u, i, level.width),
                 i1      = address(plan.address_u, hn::Add(i, seti(1)), level.width);
        const VI row0    = hn::Mul(address(plan.address_v, j, level.height), stride);
        const VI row1    = hn::Mul(address(plan.address_v, hn::Add(j, seti(1)), level.height), stride);
        const auto texel = [&](VI row, VI column)
                               HWY_ATTR { return hn::GatherIndex(DU(), texels, hn::Add(row, column)); };

        const VU fu = hn::BitCast(DU(), hn::And(u, seti(255)));
        const VU f = hn::Or(fu, hn::ShiftLeft<16>(fu)), one_minus_f = sub16(set_pair(256), f);
        const Pixels top    = weigh_row(texel(row0, i0), texel(row0, i1), f, one_minus_f);
        const Pixels bottom = weigh_row(texel(row1, i0), texel(row1, i1), f, one_minus_f);
        const VI fv         = hn::And(v, seti(255));
        return pack({weigh_column(top.lo, bottom.lo, fv), weigh_column(top.hi, bottom.hi, fv)});
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#endif  // include guard
