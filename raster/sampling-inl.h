// SPDX-License-Identifier: MIT
// From texels to a texture's colour at vectors of coordinates: the filters, and which levels they are applied to.
// Highway's per-target include guard.
#if defined(NIMBUS7_RASTER_SAMPLING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NIMBUS7_RASTER_SAMPLING_INL_H_
#undef NIMBUS7_RASTER_SAMPLING_INL_H_
#else
#define NIMBUS7_RASTER_SAMPLING_INL_H_
#endif

#include <cstddef>
#include <type_traits>

#include "raster/fill_program.h"
#include "raster/lanes-inl.h"
#include "raster/sample_plan.h"
#include "raster/texel_loads-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

// a * (one - f) + b * f: exact in 16 bits for bytes and one = 256 at most, and wherever else the sum is less than 2^16.
HWY_INLINE VU mix(VU a, VU b, VU f, VU one_minus_f) {
    return add16(mul16(a, one_minus_f), mul16(b, f));
}
HWY_INLINE Pixels weigh(const Pixels& a, const Pixels& b, VU f, VU one_minus_f) {
    return {mix(a.lo, b.lo, f, one_minus_f), mix(a.hi, b.hi, f, one_minus_f)};
}
// Of one row of texels.
HWY_INLINE Pixels weigh_row(VU left, VU right, VU f, VU one_minus_f) {
    return weigh(unpack(left), unpack(right), f, one_minus_f);
}
// a + floor((b - a) * f / 2^16): the floor is the high half of the unsigned product of (b - a) mod 2^16 and f, less f
// where b < a.
HWY_INLINE VU move_toward(VU a, VU b, VU f) {
    return add16(a, sub16(mul_high16(sub16(b, a), f), if_less16(b, a, f)));
}
// The fraction, the low 8 bits of a coordinate, in both halves; times 256 there.
HWY_INLINE VU fraction_pair(VI coordinate) {
#if HWY_TARGET == HWY_SCALAR
    return twice(hn::And(hn::BitCast(DU(), coordinate), set(0xff)));
#else
    alignas(16) static constexpr std::uint8_t kFrom[16] = {0, 128, 0, 128, 4,  128, 4,  128,
                                                           8, 128, 8, 128, 12, 128, 12, 128};
    const hn::Repartition<std::uint8_t, DU> bytes;
    return hn::BitCast(DU(), hn::TableLookupBytesOr0(hn::BitCast(bytes, coordinate), hn::LoadDup128(bytes, kFrom)));
#endif
}
HWY_INLINE VU fraction_pair_times_256(VI coordinate) {
#if HWY_TARGET == HWY_SCALAR
    return mul16(fraction_pair(coordinate), set_pair(256));
#else
    alignas(16) static constexpr std::uint8_t kFrom[16] = {128, 0, 128, 0, 128, 4,  128, 4,
                                                           128, 8, 128, 8, 128, 12, 128, 12};
    const hn::Repartition<std::uint8_t, DU> bytes;
    return hn::BitCast(DU(), hn::TableLookupBytesOr0(hn::BitCast(bytes, coordinate), hn::LoadDup128(bytes, kFrom)));
#endif
}
// With kBits of it dropped.
template <int kBits>
HWY_INLINE VU fraction_pair_over(VI coordinate) {
    return shift_right16<kBits>(fraction_pair(coordinate));
}

// Of pairs, as numbers with sign: the sum of the products of both halves.
HWY_INLINE VI mul_add_halves(VU a, VU b) {
#if HWY_TARGET <= HWY_AVX3
    return VI{_mm512_madd_epi16(a.raw, b.raw)};
#elif HWY_TARGET == HWY_AVX2
    return VI{_mm256_madd_epi16(a.raw, b.raw)};
#else
    const auto low  = [](VU v) NIMBUS7_LAMBDA { return hn::ShiftRight<16>(hn::BitCast(DI(), hn::ShiftLeft<16>(v))); };
    const auto high = [](VU v) NIMBUS7_LAMBDA { return hn::ShiftRight<16>(hn::BitCast(DI(), v)); };
    return hn::Add(hn::Mul(low(a), low(b)), hn::Mul(high(a), high(b)));
#endif
}

// The filters: weigh_quad() for the neighbours of a position, whose weights are the low 8 bits of u and v; mix_levels() for two mip
// levels, by f of 256.
struct MixHalfUp {
    static HWY_INLINE Pixels mix_levels(const Pixels& a, const Pixels& b, VI f) {
        const VU f8 = fraction_pair(f), half = set_pair(128);
        const Pixels sum = weigh(a, b, f8, sub16(set_pair(256), f8));
        return {shift_right16<8>(add16(sum.lo, half)), shift_right16<8>(add16(sum.hi, half))};
    }
};
struct MixFloor4 {
    static HWY_INLINE Pixels mix_levels(const Pixels& a, const Pixels& b, VI f) {
        const VU f4      = fraction_pair_over<4>(f);
        const Pixels sum = weigh(a, b, f4, sub16(set_pair(16), f4));
        return {shift_right16<4>(sum.lo), shift_right16<4>(sum.hi)};
    }
};

template <class Mix>
struct Point : Mix {
    static constexpr bool kLinear = false;
};
struct Single8 : MixHalfUp {
    static constexpr bool kLinear = true;
    static HWY_INLINE Pixels weigh_quad(const Quad& quad, VI u, VI v) {
        const VU f = fraction_pair(u), one_minus_f = sub16(set_pair(256), f);
        const VU f_times_256 = fraction_pair_times_256(v);
        const Pixels top     = weigh_row(quad.t00, quad.t10, f, one_minus_f);
        const Pixels bottom  = weigh_row(quad.t01, quad.t11, f, one_minus_f);
        // The sum of columns plus 2^15, over 2^8: it fits 16 bits.
        const VU half        = set_pair(128);
        return {shift_right16<8>(add16(move_toward(top.lo, bottom.lo, f_times_256), half)),
                shift_right16<8>(add16(move_toward(top.hi, bottom.hi, f_times_256), half))};
    }
    // The same of one channel, all four in a word, in 32 bits.
    static HWY_INLINE Pixels weigh_alpha_quad(VU four, VI u, VI v) {
        // 256 - f, f
        const VU down   = add16(hn::Xor(fraction_pair(v), set(0x0000ffff)), set(257));
        const VI left   = mul_add_halves(hn::And(four, set_pair(255)), down);
        const VI right  = mul_add_halves(shift_right16<8>(four), down);
        const VI across = hn::Mul(hn::Sub(right, left), hn::And(u, seti(255)));
        const VI sum    = hn::Add(hn::Add(hn::ShiftLeft<8>(left), across), seti(1 << 15));
        return {set(0), hn::And(hn::BitCast(DU(), sum), set(0x00ff0000))};
    }
};
struct Single4 : MixFloor4 {
    static constexpr bool kLinear = true;
    static HWY_INLINE Pixels weigh_quad(const Quad& quad, VI u, VI v) {
        const VU one = set_pair(16), half = set_pair(128);
        const VU fu = fraction_pair_over<4>(u), fv = fraction_pair_over<4>(v), gu = sub16(one, fu), gv = sub16(one, fv);
        const Pixels top = weigh_row(quad.t00, quad.t10, fu, gu), bottom = weigh_row(quad.t01, quad.t11, fu, gu);
        const Pixels sum = weigh(top, bottom, fv, gv);
        return {shift_right16<8>(add16(sum.lo, half)), shift_right16<8>(add16(sum.hi, half))};
    }
};
struct Single7 : MixFloor4 {
    static constexpr bool kLinear = true;
    static HWY_INLINE Pixels weigh_quad(const Quad& quad, VI u, VI v) {
        const VU fu = fraction_pair_over<1>(u), gu = sub16(set_pair(128), fu);
        const VU fv      = mul16(fraction_pair_over<1>(v), set_pair(512));  // over 2^16, not 2^7
        const Pixels top = weigh_row(quad.t00, quad.t10, fu, gu), bottom = weigh_row(quad.t01, quad.t11, fu, gu);
        // floor(floor(sum / 2^7) / 2^7) is floor(sum / 2^14).
        return {shift_right16<7>(move_toward(top.lo, bottom.lo, fv)),
                shift_right16<7>(move_toward(top.hi, bottom.hi, fv))};
    }
};
struct Cascade8 : MixHalfUp {
    static constexpr bool kLinear = true;
    static HWY_INLINE Pixels weigh_quad(const Quad& quad, VI u, VI v) {
        return mix_levels(mix_levels(unpack(quad.t00), unpack(quad.t10), u),
                          mix_levels(unpack(quad.t01), unpack(quad.t11), u), v);
    }
};
struct Cascade4 : MixFloor4 {
    static constexpr bool kLinear = true;
    static HWY_INLINE Pixels weigh_quad(const Quad& quad, VI u, VI v) {
        return mix_levels(mix_levels(unpack(quad.t00), unpack(quad.t10), u),
                          mix_levels(unpack(quad.t01), unpack(quad.t11), u), v);
    }
};

// make(filter) for the filter of a program->
template <class Texture, class Make>
HWY_INLINE Pixels with_filter(Texture program, Make make) {
    switch (program->rule) {
        case FilterRule::Single8:
            break;
        case FilterRule::Single4:
            return program->linear ? make(Single4()) : make(Point<MixFloor4>());
        case FilterRule::Single7:
            return program->linear ? make(Single7()) : make(Point<MixFloor4>());
        case FilterRule::Cascade8:
            return program->linear ? make(Cascade8()) : make(Point<MixHalfUp>());
        case FilterRule::Cascade4:
            return program->linear ? make(Cascade4()) : make(Point<MixFloor4>());
    }
    return program->linear ? make(Single8()) : make(Point<MixHalfUp>());
}

template <class Filter, class Texture>
HWY_INLINE Pixels sample_level(Texture program, const SamplePlan& plan, int index, VI u, VI v) {
    const SamplePlan::Level& level = plan.levels[index];
    u                              = hn::ShiftRightSame(u, index);
    v                              = hn::ShiftRightSame(v, index);
    if constexpr (!Filter::kLinear) {
        const VI i = address(program->address_u, hn::ShiftRight<8>(u), level.last_column);
        const VI j = address(program->address_v, hn::ShiftRight<8>(v), level.last_row);
        return unpack(load_texels(level.texels, hn::Add(mul_small(j, level.stride), i)));
    } else {
        u          = hn::Sub(u, seti(128));
        v          = hn::Sub(v, seti(128));
        const VI i = hn::ShiftRight<8>(u), j = hn::ShiftRight<8>(v);
        if (program->alpha_quads) {
            const VU four = load_alpha_quad(level, i, j);
            if constexpr (std::is_same_v<Filter, Single8>)
                return Filter::weigh_alpha_quad(four, u, v);
            else
                return Filter::weigh_quad(unpack_alpha_quad(four), u, v);
        }
        const VI i0 = address(program->address_u, i, level.last_column),
                 i1 = address(program->address_u, hn::Add(i, seti(1)), level.last_column);
        const VI j0 = address(program->address_v, j, level.last_row),
                 j1 = address(program->address_v, hn::Add(j, seti(1)), level.last_row);
        return Filter::weigh_quad(load_quad(level, i0, i1, j0, j1), u, v);
    }
}

// One round for each level that a lane reads, mostly a single one: the first is that of the first lane. lod: of a vector
// of lanes, in memory, so that the level is known early.
template <class Filter, class Texture>
HWY_INLINE Pixels sample_mips(Texture program, const SamplePlan& plan, VI u, VI v, const std::int32_t* lod) {
    const bool mixes  = program->mip == MipFilter::Linear;
    const int half    = mixes ? 0 : 128;
    const int last    = plan.level_count - 1;
    const VI lods     = hn::Load(DI(), lod);
    const VI level    = hn::ShiftRight<8>(hn::Add(lods, seti(half)));
    const VI fraction = hn::And(lods, seti(255));
    Pixels texel{set(0), set(0)};
    auto rest = hn::Gt(lods, seti(-1));  // every lane
    for (std::ptrdiff_t lane = 0;; lane = hn::FindFirstTrue(DI(), rest)) {
        const int index = (lod[lane] + half) >> 8;
        const auto here = hn::Eq(level, seti(index));
        Pixels sampled  = sample_level<Filter>(program, plan, index, u, v);
        // The next level has no weight where the texture is magnified, nor after the last.
        if (mixes && index < last && !hn::AllFalse(DI(), hn::And(here, hn::Gt(fraction, seti(0)))))
            sampled = Filter::mix_levels(sampled, sample_level<Filter>(program, plan, index + 1, u, v), fraction);
        rest = hn::AndNot(here, rest);
        if (lane == 0 && hn::AllFalse(DI(), rest)) return sampled;
        const VU mask = hn::BitCast(DU(), hn::VecFromMask(DI(), here));
        texel         = {select(mask, sampled.lo, texel.lo), select(mask, sampled.hi, texel.hi)};
        if (hn::AllFalse(DI(), rest)) return texel;
    }
}

template <class Texture>
HWY_INLINE Pixels sample_here(Texture program, const SamplePlan& plan, VI u, VI v, const std::int32_t* lod) {
    return with_filter(program, [&](auto filter) NIMBUS7_LAMBDA {
        using Filter = decltype(filter);
        return program->has_mips ? sample_mips<Filter>(program, plan, u, v, lod)
                                 : sample_level<Filter>(program, plan, 0, u, v);
    });
}
// All filters at once, or two levels, are too much code to repeat at each place.
template <class Texture>
HWY_NOINLINE Pixels sample_elsewhere(Texture program, const SamplePlan& plan, VI u, VI v, const std::int32_t* lod) {
    return sample_here(program, plan, u, v, lod);
}

// A texture at (u, v), in 1/256 texel of level 0, and lod, in 1/256 level and in memory; that may be null without mips.
template <class Texture>
HWY_INLINE Pixels sample(Texture program, const SamplePlan& plan, VI u, VI v, const std::int32_t* lod) {
    if constexpr (Texture::kIsKnown) {
        if (!program->has_mips) return sample_here(program, plan, u, v, lod);
    }
    return sample_elsewhere(program, plan, u, v, lod);
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#endif  // include guard
