// SPDX-License-Identifier: MIT
// Vectors of up to 16 pixels, four bytes each, and arithmetic on them in 16-bit lanes. A colour 0xAARRGGBB is held as two
// vectors of *pairs*: `lo` has blue in the low and red in the high half of each 32-bit lane, `hi` green and alpha. That is
// two masks away from memory, needs no packing, and leaves 8 bits of head room for products.
// Highway's per-target include guard.
#if defined(NIMBUS7_RASTER_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NIMBUS7_RASTER_LANES_INL_H_
#undef NIMBUS7_RASTER_LANES_INL_H_
#else
#define NIMBUS7_RASTER_LANES_INL_H_
#endif

#include <bit>
#include <cstdint>

#include "hwy/highway.h"
#include "raster/lane_tables.h"
#include "raster/tile.h"

// After the parameters of a lambda, which must not become a call.
#ifndef NIMBUS7_LAMBDA
#define NIMBUS7_LAMBDA HWY_ATTR __attribute__((always_inline))
#endif

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using DU = hn::CappedTag<std::uint32_t, kBlockWidth>;
using DI = hn::CappedTag<std::int32_t, kBlockWidth>;
using DF = hn::CappedTag<float, kBlockWidth>;
using VU = hn::Vec<DU>;
using VI = hn::Vec<DI>;
using VF = hn::Vec<DF>;

HWY_INLINE int lane_count() {
    return static_cast<int>(hn::Lanes(DU()));
}
HWY_INLINE VU set(std::uint32_t value) {
    return hn::Set(DU(), value);
}
HWY_INLINE VI seti(std::int32_t value) {
    return hn::Set(DI(), value);
}

// Pair arithmetic. With vectors a pair is two lanes of a 16-bit view; the one-lane fallback has no such view.
#if HWY_TARGET == HWY_SCALAR
template <class Op>
HWY_INLINE VU each_half(VU a, VU b, Op op) {
    const std::uint32_t x = hn::GetLane(a), y = hn::GetLane(b);
    const std::uint32_t low = op(x & 0xffff, y & 0xffff) & 0xffff, high = op(x >> 16, y >> 16) & 0xffff;
    return set(low | high << 16);
}
HWY_INLINE VU add16(VU a, VU b) {
    return each_half(a, b, [](std::uint32_t x, std::uint32_t y) { return x + y; });
}
HWY_INLINE VU sub16(VU a, VU b) {
    return each_half(a, b, [](std::uint32_t x, std::uint32_t y) { return x - y; });
}
HWY_INLINE VU mul16(VU a, VU b) {
    return each_half(a, b, [](std::uint32_t x, std::uint32_t y) { return x * y; });
}
HWY_INLINE VU mul_high16(VU a, VU b) {
    return each_half(a, b, [](std::uint32_t x, std::uint32_t y) { return (x * y) >> 16; });
}
HWY_INLINE VU add_saturated16(VU a, VU b) {
    return each_half(a, b, [](std::uint32_t x, std::uint32_t y) { return x + y > 0xffff ? 0xffff : x + y; });
}
HWY_INLINE VU sub_saturated16(VU a, VU b) {
    return each_half(a, b, [](std::uint32_t x, std::uint32_t y) { return x > y ? x - y : 0; });
}
HWY_INLINE VU min16(VU a, VU b) {
    return each_half(a, b, [](std::uint32_t x, std::uint32_t y) { return x < y ? x : y; });
}
HWY_INLINE VU if_less16(VU a, VU b, VU yes) {  // a < b ? yes : 0
    return hn::And(each_half(a, b, [](std::uint32_t x, std::uint32_t y) { return x < y ? 0xffff : 0; }), yes);
}
template <int kBits>
HWY_INLINE VU shift_right16(VU a) {
    return each_half(a, a, [](std::uint32_t x, std::uint32_t) { return x >> kBits; });
}
template <int kBits>
HWY_INLINE VU shift_right_signed16(VU a) {
    return each_half(a, a, [](std::uint32_t x, std::uint32_t) {
        return static_cast<std::uint32_t>(static_cast<std::int16_t>(x) >> kBits);
    });
}
HWY_INLINE VU mul_high_signed16(VU a, VU b) {
    return each_half(a, b, [](std::uint32_t x, std::uint32_t y) {
        return static_cast<std::uint32_t>((static_cast<std::int16_t>(x) * static_cast<std::int16_t>(y)) >> 16);
    });
}
HWY_INLINE VU clamp_signed16(VU a, std::int16_t least, std::int16_t most) {
    return each_half(a, a, [least, most](std::uint32_t x, std::uint32_t) {
        const auto value = static_cast<std::int16_t>(x);
        return static_cast<std::uint32_t>(value < least ? least : value > most ? most : value);
    });
}
#else
using DU16 = hn::Repartition<std::uint16_t, DU>;
using DI16 = hn::Repartition<std::int16_t, DU>;
HWY_INLINE auto halves(VU a) {
    return hn::BitCast(DU16(), a);
}
template <class V16>
HWY_INLINE VU whole(V16 a) {
    return hn::BitCast(DU(), a);
}
HWY_INLINE VU add16(VU a, VU b) {
    return whole(hn::Add(halves(a), halves(b)));
}
HWY_INLINE VU sub16(VU a, VU b) {
    return whole(hn::Sub(halves(a), halves(b)));
}
HWY_INLINE VU mul16(VU a, VU b) {
    return whole(hn::Mul(halves(a), halves(b)));
}
HWY_INLINE VU mul_high16(VU a, VU b) {
    return whole(hn::MulHigh(halves(a), halves(b)));
}
HWY_INLINE VU add_saturated16(VU a, VU b) {
    return whole(hn::SaturatedAdd(halves(a), halves(b)));
}
HWY_INLINE VU sub_saturated16(VU a, VU b) {
    return whole(hn::SaturatedSub(halves(a), halves(b)));
}
HWY_INLINE VU min16(VU a, VU b) {
    return whole(hn::Min(halves(a), halves(b)));
}
HWY_INLINE VU if_less16(VU a, VU b, VU yes) {
    const auto at_least = hn::Eq(hn::SaturatedSub(halves(b), halves(a)), hn::Zero(DU16()));
    return whole(hn::IfThenZeroElse(at_least, halves(yes)));
}
template <int kBits>
HWY_INLINE VU shift_right16(VU a) {
    return whole(hn::ShiftRight<kBits>(halves(a)));
}
template <int kBits>
HWY_INLINE VU shift_right_signed16(VU a) {
    return whole(hn::ShiftRight<kBits>(hn::BitCast(DI16(), a)));
}
HWY_INLINE VU mul_high_signed16(VU a, VU b) {
    return whole(hn::MulHigh(hn::BitCast(DI16(), a), hn::BitCast(DI16(), b)));
}
HWY_INLINE VU clamp_signed16(VU a, std::int16_t least, std::int16_t most) {
    const DI16 d;
    return whole(hn::Min(hn::Max(hn::BitCast(d, a), hn::Set(d, least)), hn::Set(d, most)));
}
#endif

HWY_INLINE VU set_pair(std::uint32_t both) {
    return set(both | both << 16);
}

// round(v / 255), exact for v in 0..65025: with t = v + 128, floor(257 t / 65536) = floor((t - 1) / 255) = floor((v + 127) / 255).
HWY_INLINE VU div255(VU v) {
    return mul_high16(add16(v, set_pair(128)), set_pair(257));
}
// The same for any 16-bit v, which is first limited to 255 * 255.
HWY_INLINE VU div255_limited(VU v) {
    return div255(min16(v, set_pair(255 * 255)));
}
HWY_INLINE VU invert(VU v) {
    return hn::Xor(v, set_pair(255));
}  // 255 - v for v in 0..255

// v + (v >> 7), for v in 0..255: 0..256.
HWY_INLINE VU expand256(VU v) {
    return add16(v, shift_right16<7>(v));
}
// Two numbers of 16 bits from one.
HWY_INLINE VU twice(VU low_half) {
    return hn::Or(low_half, hn::ShiftLeft<16>(low_half));
}

struct Pixels {
    VU lo, hi;
};
HWY_INLINE Pixels unpack(VU argb) {
    return {hn::And(argb, set_pair(0xff)), shift_right16<8>(argb)};
}
HWY_INLINE VU pack(Pixels p) {
    return hn::Or(p.lo, hn::ShiftLeft<8>(p.hi));
}

// Alpha in every half.
HWY_INLINE VU alpha_pair(Pixels p) {
#if HWY_TARGET == HWY_SCALAR
    return twice(hn::ShiftRight<16>(p.hi));
#else
    alignas(16) static constexpr std::uint8_t kFrom[16] = {2, 3, 2, 3, 6, 7, 6, 7, 10, 11, 10, 11, 14, 15, 14, 15};
    const hn::Repartition<std::uint8_t, DU> bytes;
    return hn::BitCast(DU(), hn::TableLookupBytes(hn::BitCast(bytes, p.hi), hn::LoadDup128(bytes, kFrom)));
#endif
}

// first, first + 1, first + 2, .. : a constant and a sum, for an Iota from a variable goes through memory.
HWY_INLINE VI lane_index(int first) {
    return hn::Add(hn::Iota(DI(), 0), seti(first));
}
HWY_INLINE VU lane_index_pair(int first) {
    return twice(hn::BitCast(DU(), lane_index(first)));
}

HWY_INLINE VU select(VU mask, VU yes, VU no) {
    return hn::Or(hn::And(mask, yes), hn::AndNot(mask, no));
}

// A mask of lanes, as vectors have it and as the low bits of an integer.
using MU = hn::Mask<DU>;
HWY_INLINE unsigned all_lanes() {
    return (1u << lane_count()) - 1;
}
HWY_INLINE MU mask_of(unsigned bits) {
#if HWY_TARGET <= HWY_AVX3
    return MU{static_cast<__mmask16>(bits)};
#else
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits)};
    return hn::LoadMaskBits(DU(), bytes);
#endif
}
HWY_INLINE unsigned bits_of(MU mask) {
#if HWY_TARGET <= HWY_AVX3
    return mask.raw;
#else
    std::uint8_t bytes[8] = {};  // as many as the store may touch
    hn::StoreMaskBits(DU(), mask, bytes);
    return bytes[0];
#endif
}
HWY_INLINE std::uint64_t count_lanes(MU mask) {
    return static_cast<std::uint64_t>(std::popcount(bits_of(mask)));
}

// The numbers at `packed`, in order, to the lanes whose bits are set; the other lanes hold anything. Reads a whole vector.
HWY_INLINE VU expand(const std::uint32_t* packed, unsigned bits) {
#if HWY_TARGET <= HWY_AVX3
    return VU{_mm512_maskz_expandloadu_epi32(static_cast<__mmask16>(bits), packed)};
#elif HWY_TARGET == HWY_SCALAR
    (void)bits;
    return hn::Load(DU(), packed);
#else
    const hn::Rebind<std::uint8_t, DU> bytes;
    const auto rank = hn::PromoteTo(DI(), hn::LoadU(bytes, reinterpret_cast<const std::uint8_t*>(&kRanks[bits])));
    return hn::TableLookupLanes(hn::LoadU(DU(), packed), hn::IndicesFromVec(DU(), rank));
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#endif  // include guard
