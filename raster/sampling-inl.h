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

// The four neighbours of each lane's position.
struct Quad {
    VU t00, t10, t01, t11;
};

// a * (256 - f) + b * f of one row of texels: exact in 16 bits.
HWY_INLINE Pixels weigh_row(VU left, VU right, VU f, VU one_minus_f) {
    const Pixels a = unpack(left), b = unpack(right);
    return {add16(mul16(a.lo, one_minus_f), mul16(b.lo, f)), add16(mul16(a.hi, one_minus_f), mul16(b.hi, f))};
}
// (a * (256 - f) + b * f + 2^15) >> 8 of two such sums: a + 128 + floor((b - a) * f / 256), which fits 16 bits. The floor
// is the high half of the unsigned product of (b - a) mod 2^16 and 256 f, less 256 f where b < a.
HWY_INLINE VU weigh_column(VU a, VU b, VU f_times_256) {
    const VU change = sub16(mul_high16(sub16(b, a), f_times_256), if_less16(b, a, f_times_256));
    return add16(add16(a, set_pair(128)), change);
}
// The weights are the low 8 bits of u and v.
HWY_INLINE VU weigh(const Quad& quad, VI u, VI v) {
    const VU fu = hn::And(hn::BitCast(DU(), u), set(0xff)), fv = hn::BitCast(DU(), v);
    const VU f = hn::Or(fu, hn::ShiftLeft<16>(fu)), one_minus_f = sub16(set_pair(256), f);
    const VU f_times_256 = hn::Or(hn::ShiftLeft<24>(fv), hn::And(hn::ShiftLeft<8>(fv), set(0xff00)));
    const Pixels top     = weigh_row(quad.t00, quad.t10, f, one_minus_f);
    const Pixels bottom  = weigh_row(quad.t01, quad.t11, f, one_minus_f);
    const VU lo = weigh_column(top.lo, bottom.lo, f_times_256), hi = weigh_column(top.hi, bottom.hi, f_times_256);
    return hn::Or(shift_right16<8>(lo), hn::And(hi, set_pair(0xff00)));
}

template <bool kLinear>
HWY_INLINE VU sample_level(const SamplePlan& plan, int index, VI u, VI v) {
    const SamplePlan::Level& level    = plan.levels[index];
    const std::uint32_t* const texels = level.texels;
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
        return weigh({texel(row0, i0), texel(row0, i1), texel(row1, i0), texel(row1, i1)}, u, v);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#endif  // include guard
