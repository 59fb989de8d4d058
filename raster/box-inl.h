// SPDX-License-Identifier: MIT
// The mean of 2x2 texels, (a + b + c + d + 2) >> 2 in each channel, without taking the bytes apart: two means of two, each
// rounded up, and their mean, rounded up. Let x = (a + b + 1) >> 1, y = (c + d + 1) >> 1 and e, f be 1 where the first and
// the second sum is odd, 0 elsewhere. Then a + b + c + d + 2 = 2 (x + y + 1) - (e + f), a quarter of which is
// (x + y + 1) >> 1, or one less where 2 (x + y + 1) is a multiple of 4, so x + y odd, and e or f is 1.
// Highway's per-target include guard.
#if defined(NIMBUS7_RASTER_BOX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NIMBUS7_RASTER_BOX_INL_H_
#undef NIMBUS7_RASTER_BOX_INL_H_
#else
#define NIMBUS7_RASTER_BOX_INL_H_
#endif

#include "raster/sampling-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

// (a + b + 1) >> 1 of each byte.
HWY_INLINE VU mean_up(VU a, VU b) {
#if HWY_TARGET == HWY_SCALAR
    return hn::Sub(hn::Or(a, b), hn::And(hn::ShiftRight<1>(hn::Xor(a, b)), set(0x7f7f7f7f)));
#else
    const hn::Repartition<std::uint8_t, DU> bytes;
    return hn::BitCast(DU(), hn::AverageRound(hn::BitCast(bytes, a), hn::BitCast(bytes, b)));
#endif
}

// Of x and y; `odd`: e | f in the lowest bit of each byte. A byte that loses 1 is at least 1.
HWY_INLINE VU mean_of_means(VU x, VU y, VU odd) {
    return hn::Sub(mean_up(x, y), hn::And(hn::And(odd, hn::Xor(x, y)), set(0x01010101)));
}

HWY_INLINE VU mean(const Quad& quad) {
    return mean_of_means(mean_up(quad.t00, quad.t01), mean_up(quad.t10, quad.t11),
                         hn::Or(hn::Xor(quad.t00, quad.t01), hn::Xor(quad.t10, quad.t11)));
}

#if HWY_TARGET != HWY_SCALAR
// The even or, with kOdd = 1, the odd lanes of two vectors, in the order that takes the fewest steps, and from there to
// that of the lanes.
template <int kOdd>
HWY_INLINE VU every_second(VU low, VU high) {
#if HWY_TARGET <= HWY_AVX3
    constexpr int kLanes = _MM_SHUFFLE(2, 0, 2, 0) + kOdd * _MM_SHUFFLE(1, 1, 1, 1);
    return VU{
        _mm512_castps_si512(_mm512_shuffle_ps(_mm512_castsi512_ps(low.raw), _mm512_castsi512_ps(high.raw), kLanes))};
#elif HWY_TARGET == HWY_AVX2
    constexpr int kLanes = _MM_SHUFFLE(2, 0, 2, 0) + kOdd * _MM_SHUFFLE(1, 1, 1, 1);
    return VU{
        _mm256_castps_si256(_mm256_shuffle_ps(_mm256_castsi256_ps(low.raw), _mm256_castsi256_ps(high.raw), kLanes))};
#else
    return kOdd == 1 ? hn::ConcatOdd(DU(), high, low) : hn::ConcatEven(DU(), high, low);
#endif
}
HWY_INLINE VU in_order(VU seconds) {
#if HWY_TARGET <= HWY_AVX3
    return VU{_mm512_permutexvar_epi64(_mm512_setr_epi64(0, 2, 4, 6, 1, 3, 5, 7), seconds.raw)};
#elif HWY_TARGET == HWY_AVX2
    return VU{_mm256_permute4x64_epi64(seconds.raw, _MM_SHUFFLE(3, 1, 2, 0))};
#else
    return seconds;
#endif
}
#endif

// Of the first two columns of two rows, of the next two, and so on.
HWY_INLINE VU mean_halved(const std::uint32_t* row0, const std::uint32_t* row1) {
#if HWY_TARGET == HWY_SCALAR
    return mean({set(row0[0]), set(row0[1]), set(row1[0]), set(row1[1])});
#else
    const DU d;
    const VU a0 = hn::LoadU(d, row0), a1 = hn::LoadU(d, row0 + lane_count());
    const VU b0 = hn::LoadU(d, row1), b1 = hn::LoadU(d, row1 + lane_count());
    const VU x0 = mean_up(a0, b0), x1 = mean_up(a1, b1), odd0 = hn::Xor(a0, b0), odd1 = hn::Xor(a1, b1);
    return in_order(mean_of_means(every_second<0>(x0, x1), every_second<1>(x0, x1),
                                  hn::Or(every_second<0>(odd0, odd1), every_second<1>(odd0, odd1))));
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#endif  // include guard
