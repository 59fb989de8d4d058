// SPDX-License-Identifier: MIT
#include "raster/blend_blocks.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/blend_blocks.cpp"
#include "hwy/foreach_target.h"
#include "raster/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

HWY_INLINE Pixels factor(const BlendFactor& f, const Pixels& s, const Pixels& d) {
    Pixels p{set(0), set(0)};
    switch (f.operand) {
        case BlendFactor::Operand::Zero:
            break;
        case BlendFactor::Operand::Source:
            p = s;
            break;
        case BlendFactor::Operand::Dest:
            p = d;
            break;
    }
    if (f.alpha) p.lo = p.hi = alpha_pair(p);
    return f.invert ? Pixels{invert(p.lo), invert(p.hi)} : p;
}

// Blend rules: s source, d destination, both bytes. The last argument: BlendPlan::dither of this vector's pixels.
struct Replace {
    static HWY_INLINE Pixels apply(const Blend&, const Pixels& s, const Pixels&, VU) { return s; }
};
struct Over {  // SRCALPHA, INVSRCALPHA
    static HWY_INLINE Pixels apply(const Blend&, const Pixels& s, const Pixels& d, VU) {
        const VU a = alpha_pair(s), ia = invert(a);
        return {div255(add16(mul16(s.lo, a), mul16(d.lo, ia))), div255(add16(mul16(s.hi, a), mul16(d.hi, ia)))};
    }
};
struct Multiply {  // ZERO, SRCCOLOR
    static HWY_INLINE Pixels apply(const Blend&, const Pixels& s, const Pixels& d, VU) {
        return {div255(mul16(s.lo, d.lo)), div255(mul16(s.hi, d.hi))};
    }
};
struct Nearest255 {
    static HWY_INLINE Pixels apply(const Blend& blend, const Pixels& s, const Pixels& d, VU) {
        const Pixels fs = factor(blend.source, s, d), fd = factor(blend.dest, s, d);
        return {div255_limited(add_saturated16(mul16(s.lo, fs.lo), mul16(d.lo, fd.lo))),
                div255_limited(add_saturated16(mul16(s.hi, fs.hi), mul16(d.hi, fd.hi)))};
    }
};
struct Trunc256 {
    static HWY_INLINE Pixels apply(const Blend& blend, const Pixels& s, const Pixels& d, VU) {
        const Pixels fs = factor(blend.source, s, d), fd = factor(blend.dest, s, d);
        // A sum of 2^16 and more saturates to one that is 255 once shifted.
        const auto sum = [](VU source, VU source_factor, VU dest, VU dest_factor) HWY_ATTR {
            return shift_right16<8>(
                add_saturated16(mul16(source, expand256(source_factor)), mul16(dest, expand256(dest_factor))));
        };
        return {sum(s.lo, fs.lo, d.lo, fd.lo), sum(s.hi, fs.hi, d.hi, fd.hi)};
    }
};
struct Shift7 {
    static HWY_INLINE Pixels operand(Shift7Blend::Operand which, const Pixels& s, const Pixels& d) {
        switch (which) {
            case Shift7Blend::Operand::Source:
                return s;
            case Shift7Blend::Operand::Dest:
                return d;
            case Shift7Blend::Operand::Zero:
                break;
        }
        return {set(0), set(0)};
    }
    static HWY_INLINE Pixels apply(const Blend& blend, const Pixels& s, const Pixels& d, VU pattern) {
        const Shift7Blend& state = blend.shift7;
        const VU dither          = blend.dither == Dither::Matrix4x4 ? pattern : set(0);
        const Pixels a = operand(state.a, s, d), b = operand(state.b, s, d), base = operand(state.d, s, d);
        const VU c  = state.c == Shift7Blend::Factor::SourceAlpha ? alpha_pair(s)
                      : state.c == Shift7Blend::Factor::DestAlpha ? alpha_pair(d)
                                                                  : set_pair(state.constant);
        const VU as = alpha_pair(s), c_times_4 = mul16(c, set_pair(4));
        const auto channels = [&](VU from, VU to, VU offset, VU plain) HWY_ATTR {
            // The high half of (A - B) * 2^7 * C * 2^2 is floor((A - B) * C / 2^7).
            const VU product = mul_high_signed16(mul16(sub16(from, to), set_pair(128)), c_times_4);
            VU out           = add16(add16(product, offset), dither);
            if (state.only_above_half)
                out = hn::Or(if_less16(set_pair(127), as, out), if_less16(as, set_pair(128), add16(plain, dither)));
            return state.clamp ? clamp_signed16(out, 0, 255) : hn::And(out, set_pair(255));
        };
        const VU alpha = hn::Or(hn::And(s.hi, set(0x00ff0000)), set(state.set_top_bit ? 0x00800000 : 0));
        return {channels(a.lo, b.lo, base.lo, s.lo),
                hn::Or(hn::And(channels(a.hi, b.hi, base.hi, s.hi), set(0x000000ff)), alpha)};
    }
};

// Red, green and blue become c - (c >> 6) + m: 255 at most.
HWY_INLINE Pixels dither_2x2(const Pixels& p, VU m) {
    const auto moved = [m](VU c) HWY_ATTR { return add16(sub16(c, shift_right16<6>(c)), m); };
    return {moved(p.lo), select(set(0xffff0000), p.hi, moved(p.hi))};
}

HWY_INLINE VU store(const StoreMasks& masks, VU argb) {
    const VU sign = hn::BitCast(DU(), hn::ShiftRight<31>(hn::BitCast(DI(), argb)));
    const VU kept = hn::Or(hn::And(argb, set(masks.keep)), set(masks.set));
    const VU five = hn::And(hn::ShiftRight<5>(argb), set(masks.repeat5));
    const VU six  = hn::And(hn::ShiftRight<6>(argb), set(masks.repeat6));
    return hn::Or(hn::Or(kept, five), hn::Or(six, hn::And(sign, set(masks.repeat1))));
}

// kBytes: the target keeps whole bytes, and there is no dither.
template <class Rule, bool kBytes>
void blend(const BlendPlan& plan, Image& target, const FragmentBatch& batch) {
    const VU write_mask = set(plan.blend.write_mask), source_mask = set(plan.source_mask);
    for (int block = 0; block < batch.count; ++block) {
        const auto [x, y]           = batch.at[block];
        std::uint32_t* const pixels = target.row(y) + x;
        const auto& dither          = plan.dither[y & 3];
        for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
            VU source     = hn::Load(DU(), batch.color[block] + lane);
            const VU dest = hn::Load(DU(), pixels + lane);
            const VU mask = hn::And(hn::Load(DU(), batch.mask[block] + lane), write_mask);
            if (!kBytes) source = hn::And(source, source_mask);
            const VU pattern = kBytes ? set(0) : hn::Load(DU(), dither.data() + lane);
            Pixels out       = Rule::apply(plan.blend, unpack(source), unpack(dest), pattern);
            if (!kBytes && plan.blend.dither == Dither::Ordered2x2) out = dither_2x2(out, pattern);
            const VU argb = kBytes ? pack(out) : store(plan.store, pack(out));
            hn::Store(select(mask, argb, dest), DU(), pixels + lane);
        }
    }
}

BlendKernel get_blend_kernel(const BlendPlan& plan, bool generic) {
    using enum BlendFactor::Operand;
    const Blend& state    = plan.blend;
    // All bits that it may write are kept as they are.
    const bool bytes_only = (state.write_mask & ~plan.store.keep) == 0 && state.dither == Dither::None && !generic;
    const auto is         = [&](const BlendFactor& source, const BlendFactor& dest) {
        return state.source == source && state.dest == dest;
    };
    switch (state.rule) {
        case BlendRule::Nearest255:
            if (bytes_only) {
                if (is(kOne, kZero)) return &blend<Replace, true>;
                if (is({Source, true, false}, {Source, true, true})) return &blend<Over, true>;
                if (is(kZero, {Source, false, false})) return &blend<Multiply, true>;
                return &blend<Nearest255, true>;
            }
            return &blend<Nearest255, false>;
        case BlendRule::Trunc256:
            return bytes_only ? &blend<Trunc256, true> : &blend<Trunc256, false>;
        case BlendRule::Shift7:
            return bytes_only ? &blend<Shift7, true> : &blend<Shift7, false>;
    }
    return nullptr;
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raster {

HWY_EXPORT(get_blend_kernel);
BlendKernel blend_kernel(const BlendPlan& plan, bool generic) {
    return HWY_DYNAMIC_DISPATCH(get_blend_kernel)(plan, generic);
}

BlendPlan plan_blend(const Blend& blend, const ColorFormat& format) {
    BlendPlan plan;
    plan.blend = blend;
    plan.store = store_masks(format);
    if (blend.cut_source) plan.source_mask = plan.store.keep | 0xff000000;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < kBlockWidth; ++x) {
            static constexpr std::uint32_t k2x2[2][2] = {{0, 2}, {3, 1}};
            if (blend.dither == Dither::Ordered2x2) plan.dither[y][x] = k2x2[y & 1][x & 1] * 0x10001u;
            if (blend.dither == Dither::Matrix4x4) {
                const auto offset = static_cast<std::uint16_t>(blend.dither_matrix[4 * y + (x & 3)]);
                plan.dither[y][x] = offset | static_cast<std::uint32_t>(offset) << 16;
            }
        }
    return plan;
}

}  // namespace raster
#endif
