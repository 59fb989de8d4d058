// SPDX-License-Identifier: MIT
// Texels of one level, at vectors of addresses.
// Highway's per-target include guard.
#if defined(NIMBUS7_RASTER_TEXEL_LOADS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NIMBUS7_RASTER_TEXEL_LOADS_INL_H_
#undef NIMBUS7_RASTER_TEXEL_LOADS_INL_H_
#else
#define NIMBUS7_RASTER_TEXEL_LOADS_INL_H_
#endif

#include <algorithm>
#include <cstddef>

#include "raster/lanes-inl.h"
#include "raster/sample_plan.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

// last: the level's size less 1.
HWY_INLINE VI address(Address mode, VI i, std::int32_t last) {
    switch (mode) {
        case Address::Wrap:
            return hn::And(i, seti(last));
        case Address::Clamp:
            return hn::Min(hn::Max(i, seti(0)), seti(last));
        case Address::Mirror: {
            const VI m = hn::And(i, seti(2 * last + 1));
            return hn::Min(m, hn::Sub(seti(2 * last + 1), m));
        }
    }
    return i;
}

HWY_INLINE int address(Address mode, int i, std::int32_t last) {
    switch (mode) {
        case Address::Wrap:
            return i & last;
        case Address::Clamp:
            return std::clamp(i, 0, last);
        case Address::Mirror: {
            const int m = i & (2 * last + 1);
            return std::min(m, 2 * last + 1 - m);
        }
    }
    return i;
}

// The four neighbours of each lane's position.
struct Quad {
    VU t00, t10, t01, t11;
};

// a * b, both in 0..2^15 - 1.
HWY_INLINE VI mul_small(VI a, std::int32_t b) {
#if HWY_TARGET <= HWY_AVX3
    return VI{_mm512_madd_epi16(a.raw, _mm512_set1_epi32(b))};
#elif HWY_TARGET == HWY_AVX2
    return VI{_mm256_madd_epi16(a.raw, _mm256_set1_epi32(b))};
#else
    return hn::Mul(a, seti(b));
#endif
}

// The texels at texels[index]: mostly those of a row, where what is drawn pixel by pixel is read again so.
HWY_INLINE VU load_texels(const std::uint32_t* texels, VI index) {
    const std::int32_t first = hn::GetLane(index);
    if (hn::AllTrue(DI(), hn::Eq(index, lane_index(first)))) return hn::LoadU(DU(), texels + first);
    return hn::GatherIndex(DU(), texels, index);
}

// The texels at texels[index], the ones after them, and those `below` texels further on.
HWY_INLINE Quad load_beside(const std::uint32_t* texels, VI index, std::ptrdiff_t below) {
#if HWY_TARGET <= HWY_AVX3
    const auto row = [&](const std::uint32_t* from, VU& first, VU& second) NIMBUS7_LAMBDA {
        const DU d;
        const auto* const pairs = reinterpret_cast<const long long*>(from);
        const VU low{_mm512_i32gather_epi64(_mm512_castsi512_si256(index.raw), pairs, 4)};
        const VU high{_mm512_i32gather_epi64(_mm512_extracti64x4_epi64(index.raw, 1), pairs, 4)};
        first  = hn::ConcatEven(d, high, low);
        second = hn::ConcatOdd(d, high, low);
    };
#elif HWY_TARGET == HWY_AVX2
    // One by one they come sooner than from gathers, and their indices sooner from memory than out of a vector, which gcc
    // would do if it knew what is there.
    alignas(32) std::int32_t at[8];
    hn::Store(index, DI(), at);
    asm("" : "+m"(at));
    const auto row = [&](const std::uint32_t* from, VU& first, VU& second) NIMBUS7_LAMBDA {
        const auto two_pairs = [&](int lane) NIMBUS7_LAMBDA {
            const __m128 low = _mm_castsi128_ps(_mm_loadu_si64(from + at[lane]));
            return _mm_loadh_pi(low, reinterpret_cast<const __m64*>(from + at[lane + 1]));
        };
        const __m256 even = _mm256_set_m128(two_pairs(4), two_pairs(0)),
                     odd  = _mm256_set_m128(two_pairs(6), two_pairs(2));
        first             = VU{_mm256_castps_si256(_mm256_shuffle_ps(even, odd, _MM_SHUFFLE(2, 0, 2, 0)))};
        second            = VU{_mm256_castps_si256(_mm256_shuffle_ps(even, odd, _MM_SHUFFLE(3, 1, 3, 1)))};
    };
#else
    const auto row = [&](const std::uint32_t* from, VU& first, VU& second) NIMBUS7_LAMBDA {
        first  = hn::GatherIndex(DU(), from, index);
        second = hn::GatherIndex(DU(), from + 1, index);
    };
#endif
    Quad quad;
    row(texels, quad.t00, quad.t10);
    row(texels + below, quad.t01, quad.t11);
    return quad;
}

// Of columns i0, i1 and rows j0, j1, which mostly lie next to each other: two texels are then read as one number of twice
// the size. At a border they do not.
HWY_INLINE Quad load_quad(const SamplePlan::Level& level, VI i0, VI i1, VI j0, VI j1) {
    const VI one = seti(1), row0 = mul_small(j0, level.stride);
    const auto is_beside = hn::And(hn::Eq(i1, hn::Add(i0, one)), hn::Eq(j1, hn::Add(j0, one)));
    if (HWY_LIKELY(hn::AllTrue(DI(), is_beside))) return load_beside(level.texels, hn::Add(row0, i0), level.stride);
    const VI row1    = mul_small(j1, level.stride);
    const auto texel = [&](VI row, VI column)
                           NIMBUS7_LAMBDA { return hn::GatherIndex(DU(), level.texels, hn::Add(row, column)); };
    return {texel(row0, i0), texel(row0, i1), texel(row1, i0), texel(row1, i1)};
}

// From a level packed as in raster/alpha_quads.h: (i, j) is the first of the four.
HWY_INLINE VU load_alpha_quad(const SamplePlan::Level& level, VI i, VI j) {
    const auto place = [](VI index, std::int32_t last)
                           NIMBUS7_LAMBDA { return hn::Add(hn::Min(hn::Max(index, seti(-1)), seti(last)), seti(1)); };
    const VI row = mul_small(place(j, level.last_row), level.stride);
    return hn::GatherIndex(DU(), level.texels, hn::Add(row, place(i, level.last_column)));
}
HWY_INLINE Quad unpack_alpha_quad(VU four) {
    const VU alpha = set(0xff000000);
    return {hn::ShiftLeft<24>(four), hn::And(hn::ShiftLeft<16>(four), alpha), hn::And(hn::ShiftLeft<8>(four), alpha),
            hn::And(four, alpha)};
}

// Asks for a texel of level 0 at (u, v), in 1/256 texel, before it is needed.
template <class Texture>
HWY_INLINE void prefetch_texel(Texture program, const SamplePlan& plan, std::int32_t u, std::int32_t v) {
    const SamplePlan::Level& level = plan.levels[0];
    const int i                    = address(program->address_u, u >> 8, level.last_column),
              j                    = address(program->address_v, v >> 8, level.last_row);
    __builtin_prefetch(level.texels + static_cast<std::ptrdiff_t>(j) * level.stride + i);
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#endif  // include guard
