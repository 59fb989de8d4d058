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

// a * (one - f) + b * f of one row of texels: exact in 16 bits, one being 256 at most.
HWY_INLINE Pixels weigh_row(VU left, VU right, VU f, VU one_minus_f) {
    const Pixels a = unpack(left), b = unpack(right);
    return {add16(mul16(a.lo, one_minus_f), mul16(b.lo, f)), add16(mul16(a.hi, one_minus_f), mul16(b.hi, f))};
}
// The same of two rows in pairs, whose sum is less than 2^16.
HWY_INLINE VU mix(VU a, VU b, VU f, VU one_minus_f) {
    return add16(mul16(a, one_minus_f), mul16(b, f));
}
// a + floor((b - a) * f / 2^16): the floor is the high half of the unsigned product of (b - a) mod 2^16 and f, less f
// where b < a.
HWY_INLINE VU move_toward(VU a, VU b, VU f) {
    return add16(a, sub16(mul_high16(sub16(b, a), f), if_less16(b, a, f)));
}
// The fraction in the low 8 bits, with kBits of them dropped, in both halves.
template <int kBits>
HWY_INLINE VU fraction_pair(VI coordinate) {
    return twice(hn::ShiftRight<kBits>(hn::And(hn::BitCast(DU(), coordinate), set(0xff))));
}
template <>
HWY_INLINE VU fraction_pair<0>(VI coordinate) {
    return twice(hn::And(hn::BitCast(DU(), coordinate), set(0xff)));
}

// The filters: weigh() for the neighbours of a position, whose weights are the low 8 bits of u and v; mix_levels() for two mip
// levels, by f of 256.
struct MixHalfUp {
    static HWY_INLINE VU mix_levels(VU a, VU b, VI f) {
        const VU f8 = fraction_pair<0>(f), half = set_pair(128);
        const Pixels sum = weigh_row(a, b, f8, sub16(set_pair(256), f8));
        return hn::Or(shift_right16<8>(add16(sum.lo, half)), hn::And(add16(sum.hi, half), set_pair(0xff00)));
    }
};
struct MixFloor4 {
    static HWY_INLINE VU mix_levels(VU a, VU b, VI f) {
        const VU f4      = fraction_pair<4>(f);
        const Pixels sum = weigh_row(a, b, f4, sub16(set_pair(16), f4));
        return pack({shift_right16<4>(sum.lo), shift_right16<4>(sum.hi)});
    }
};

template <class Mix>
struct Point : Mix {
    static constexpr bool kLinear = false;
};
struct Single8 : MixHalfUp {
    static constexpr bool kLinear = true;
    static HWY_INLINE VU weigh(const Quad& quad, VI u, VI v) {
        const VU f = fraction_pair<0>(u), one_minus_f = sub16(set_pair(256), f);
        const VU f_times_256 = mul16(fraction_pair<0>(v), set_pair(256));
        const Pixels top     = weigh_row(quad.t00, quad.t10, f, one_minus_f);
        const Pixels bottom  = weigh_row(quad.t01, quad.t11, f, one_minus_f);
        // The sum of columns plus 2^15, over 2^8: it fits 16 bits.
        const VU half        = set_pair(128);
        const VU lo          = add16(move_toward(top.lo, bottom.lo, f_times_256), half);
        const VU hi          = add16(move_toward(top.hi, bottom.hi, f_times_256), half);
        return hn::Or(shift_right16<8>(lo), hn::And(hi, set_pair(0xff00)));
    }
};
struct Single4 : MixFloor4 {
    static constexpr bool kLinear = true;
    static HWY_INLINE VU weigh(const Quad& quad, VI u, VI v) {
        const VU one = set_pair(16), half = set_pair(128);
        const VU fu = fraction_pair<4>(u), fv = fraction_pair<4>(v), gu = sub16(one, fu), gv = sub16(one, fv);
        const Pixels top = weigh_row(quad.t00, quad.t10, fu, gu), bottom = weigh_row(quad.t01, quad.t11, fu, gu);
        return hn::Or(shift_right16<8>(add16(mix(top.lo, bottom.lo, fv, gv), half)),
                      hn::And(add16(mix(top.hi, bottom.hi, fv, gv), half), set_pair(0xff00)));
    }
};
struct Single7 : MixFloor4 {
    static constexpr bool kLinear = true;
    static HWY_INLINE VU weigh(const Quad& quad, VI u, VI v) {
        const VU fu = fraction_pair<1>(u), gu = sub16(set_pair(128), fu);
        const VU fv      = mul16(fraction_pair<1>(v), set_pair(512));  // over 2^16, not 2^7
        const Pixels top = weigh_row(quad.t00, quad.t10, fu, gu), bottom = weigh_row(quad.t01, quad.t11, fu, gu);
        // floor(floor(sum / 2^7) / 2^7) is floor(sum / 2^14).
        return pack({shift_right16<7>(move_toward(top.lo, bottom.lo, fv)),
                     shift_right16<7>(move_toward(top.hi, bottom.hi, fv))});
    }
};
struct Cascade8 : MixHalfUp {
    static constexpr bool kLinear = true;
    static HWY_INLINE VU weigh(const Quad& quad, VI u, VI v) {
        return mix_levels(mix_levels(quad.t00, quad.t10, u), mix_levels(quad.t01, quad.t11, u), v);
    }
};
struct Cascade4 : MixFloor4 {
    static constexpr bool kLinear = true;
    static HWY_INLINE VU weigh(const Quad& quad, VI u, VI v) {
        return mix_levels(mix_levels(quad.t00, quad.t10, u), mix_levels(quad.t01, quad.t11, u), v);
    }
};

// make(filter) for the filter of a plan.
template <class Make>
auto for_filter(const SamplePlan& plan, Make make) {
    switch (plan.rule) {
        case FilterRule::Single8:
            break;
        case FilterRule::Single4:
            return plan.linear ? make(Single4()) : make(Point<MixFloor4>());
        case FilterRule::Single7:
            return plan.linear ? make(Single7()) : make(Point<MixFloor4>());
        case FilterRule::Cascade8:
            return plan.linear ? make(Cascade8()) : make(Point<MixHalfUp>());
        case FilterRule::Cascade4:
            return plan.linear ? make(Cascade4()) : make(Point<MixFloor4>());
    }
    return plan.linear ? make(Single8()) : make(Point<MixHalfUp>());
}

template <class Filter>
HWY_INLINE VU sample_level(const SamplePlan& plan, int index, VI u, VI v) {
    const SamplePlan::Level& level    = plan.levels[index];
    const std::uint32_t* const texels = level.texels;
    const VI stride                   = seti(level.stride);
    u                                 = hn::ShiftRightSame(u, index);
    v                                 = hn::ShiftRightSame(v, index);
    if constexpr (!Filter::kLinear) {
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
        return Filter::weigh({texel(row0, i0), texel(row0, i1), texel(row1, i0), texel(row1, i1)}, u, v);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#endif  // include guard
