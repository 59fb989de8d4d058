// SPDX-License-Identifier: MIT
// Steps 7 to 9 of raster/fill_program->shift7.h on vectors of pixels: from a fragment's colour and what is there to what is
// there next.
// Highway's per-target include guard.
#if defined(NIMBUS7_RASTER_BLEND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NIMBUS7_RASTER_BLEND_INL_H_
#undef NIMBUS7_RASTER_BLEND_INL_H_
#else
#define NIMBUS7_RASTER_BLEND_INL_H_
#endif

#include "raster/blend_plan.h"
#include "raster/fill_program.h"
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

// s: the source, d: the destination, both bytes.
template <class Program>
HWY_INLINE Pixels blend_nearest255(Program program, const Pixels& s, const Pixels& d) {
    if (program->is_replace()) return s;
    const Pixels fs = factor(program->source, s, d), fd = factor(program->dest, s, d);
    const auto channel = [&](VU source, VU source_factor, VU dest, VU dest_factor) NIMBUS7_LAMBDA {
        if (program->source == kZero) return div255(mul16(dest, dest_factor));
        if (program->dest == kZero) return div255(mul16(source, source_factor));
        const VU a = mul16(source, source_factor), b = mul16(dest, dest_factor);
        return program->may_exceed_bytes() ? div255_limited(add_saturated16(a, b)) : div255(add16(a, b));
    };
    return {channel(s.lo, fs.lo, d.lo, fd.lo), channel(s.hi, fs.hi, d.hi, fd.hi)};
}

template <class Program>
HWY_INLINE Pixels blend_trunc256(Program program, const Pixels& s, const Pixels& d) {
    if (program->is_replace()) return s;
    const Pixels fs = factor(program->source, s, d), fd = factor(program->dest, s, d);
    // A sum of 2^16 and more saturates to one that is 255 once shifted.
    const auto sum = [](VU source, VU source_factor, VU dest, VU dest_factor) NIMBUS7_LAMBDA {
        return shift_right16<8>(
            add_saturated16(mul16(source, expand256(source_factor)), mul16(dest, expand256(dest_factor))));
    };
    return {sum(s.lo, fs.lo, d.lo, fd.lo), sum(s.hi, fs.hi, d.hi, fd.hi)};
}

HWY_INLINE Pixels shift7_operand(Shift7Blend::Operand which, const Pixels& s, const Pixels& d) {
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

// pattern: BlendPlan::dither of these pixels.
template <class Program>
HWY_INLINE Pixels blend_shift7(Program program, const BlendPlan& plan, const Pixels& s, const Pixels& d, VU pattern) {
    const VU dither = program->dither == Dither::Matrix4x4 ? pattern : set(0);
    const Pixels a = shift7_operand(program->shift7.a, s, d), b = shift7_operand(program->shift7.b, s, d);
    const Pixels base = shift7_operand(program->shift7.d, s, d);
    const VU c        = program->shift7.c == Shift7Blend::Factor::SourceAlpha ? alpha_pair(s)
                        : program->shift7.c == Shift7Blend::Factor::DestAlpha ? alpha_pair(d)
                                                                              : set_pair(plan.shift7_constant);
    const VU as = alpha_pair(s), c_times_4 = mul16(c, set_pair(4));
    const auto channels = [&](VU from, VU to, VU offset, VU plain) NIMBUS7_LAMBDA {
        VU out = offset;
        // The high half of (A - B) * 2^7 * C * 2^2 is floor((A - B) * C / 2^7).
        if (program->shift7.a != program->shift7.b)
            out = add16(out, mul_high_signed16(mul16(sub16(from, to), set_pair(128)), c_times_4));
        out = add16(out, dither);
        if (program->shift7.only_above_half)
            out = hn::Or(if_less16(set_pair(127), as, out), if_less16(as, set_pair(128), add16(plain, dither)));
        return program->shift7.clamp ? clamp_signed16(out, 0, 255) : hn::And(out, set_pair(255));
    };
    const VU alpha = hn::Or(hn::And(s.hi, set(0x00ff0000)), set(program->shift7.set_top_bit ? 0x00800000 : 0));
    return {channels(a.lo, b.lo, base.lo, s.lo),
            hn::Or(hn::And(channels(a.hi, b.hi, base.hi, s.hi), set(0x000000ff)), alpha)};
}

// Red, green and blue become c - (c >> 6) + m: 255 at most.
HWY_INLINE Pixels dither_2x2(const Pixels& p, VU m) {
    const auto moved = [m](VU c) NIMBUS7_LAMBDA { return add16(sub16(c, shift_right16<6>(c)), m); };
    return {moved(p.lo), select(set(0xffff0000), p.hi, moved(p.hi))};
}

HWY_INLINE VU store(const StoreMasks& masks, VU argb) {
    const VU sign = hn::BitCast(DU(), hn::ShiftRight<31>(hn::BitCast(DI(), argb)));
    const VU kept = hn::Or(hn::And(argb, set(masks.keep)), set(masks.set));
    const VU five = hn::And(hn::ShiftRight<5>(argb), set(masks.repeat5));
    const VU six  = hn::And(hn::ShiftRight<6>(argb), set(masks.repeat6));
    return hn::Or(hn::Or(kept, five), hn::Or(six, hn::And(sign, set(masks.repeat1))));
}

template <class Program>
HWY_INLINE VU blend_here(Program program, const BlendPlan& plan, Pixels source, VU dest, int lane, int y) {
    const Pixels d   = unpack(dest);
    const VU pattern = program->dither == Dither::None ? set(0) : hn::Load(DU(), plan.dither[y & 3].data() + lane);
    if (!program->whole_bytes) source = unpack(hn::And(pack(source), set(plan.source_mask)));
    Pixels out = source;
    switch (program->blend) {
        case BlendRule::Nearest255:
            out = blend_nearest255(program, source, d);
            break;
        case BlendRule::Trunc256:
            out = blend_trunc256(program, source, d);
            break;
        case BlendRule::Shift7:
            out = blend_shift7(program, plan, source, d, pattern);
            break;
    }
    if (program->writes == Writes::Alpha) out.lo = d.lo;
    if (program->dither == Dither::Ordered2x2) out = dither_2x2(out, pattern);
    return program->whole_bytes ? pack(out) : store(plan.store, pack(out));
}

// All rules at once are too much code to repeat at each place.
template <class Program>
HWY_NOINLINE VU blend_any(Program program, const BlendPlan& plan, Pixels source, VU dest, int lane, int y) {
    return blend_here(program, plan, source, dest, lane, y);
}

// What the pixels hold once they are written, all bits of them. (lane, y): where in a block and in the target.
template <class Program>
HWY_INLINE VU blend(Program program, const BlendPlan& plan, Pixels source, VU dest, int lane, int y) {
    if constexpr (Program::kIsKnown)
        return blend_here(program, plan, source, dest, lane, y);
    else
        return blend_any(program, plan, source, dest, lane, y);
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#endif  // include guard
