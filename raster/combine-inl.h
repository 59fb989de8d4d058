// SPDX-License-Identifier: MIT
// Steps 2 to 4 of raster/fill_state.h on vectors of pixels: the stages, specular, fog.
// Highway's per-target include guard.
#if defined(NIMBUS7_RASTER_COMBINE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NIMBUS7_RASTER_COMBINE_INL_H_
#undef NIMBUS7_RASTER_COMBINE_INL_H_
#else
#define NIMBUS7_RASTER_COMBINE_INL_H_
#endif

#include "raster/fill_program.h"
#include "raster/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

// What a rule makes of products of bytes, on pairs: bytes again.
struct CombineNearest255 {
    static HWY_INLINE VU product(VU a, VU b) { return div255(mul16(a, b)); }
    static HWY_INLINE VU product_2x(VU a, VU b) {
        const VU once = mul16(a, b);
        return div255_limited(add_saturated16(once, once));
    }
    static HWY_INLINE VU product_4x(VU a, VU b) {
        const VU once = mul16(a, b), two = add_saturated16(once, once);
        return div255_limited(add_saturated16(two, two));
    }
    static HWY_INLINE VU lerp(VU a, VU b, VU c) { return div255(add16(mul16(a, c), mul16(b, invert(c)))); }
    static constexpr std::uint32_t kHalf = 127, kOne = 255;  // of AddSigned and AddSigned2X
};
struct CombineExpanded256 {
    // (k * p + 128) >> 8 = (p + 128 / k) >> (8 - log2 k), which stays within 16 bits.
    static HWY_INLINE VU product(VU a, VU b) { return shift_right16<8>(add16(mul16(a, expand256(b)), set_pair(128))); }
    static HWY_INLINE VU product_2x(VU a, VU b) {
        return min16(shift_right16<7>(add16(mul16(a, expand256(b)), set_pair(64))), set_pair(255));
    }
    static HWY_INLINE VU product_4x(VU a, VU b) {
        return min16(shift_right16<6>(add16(mul16(a, expand256(b)), set_pair(32))), set_pair(255));
    }
    static HWY_INLINE VU lerp(VU a, VU b, VU c) {
        const VU f = expand256(c);
        return shift_right16<8>(add16(add16(mul16(a, f), mul16(b, sub16(set_pair(256), f))), set_pair(128)));
    }
    static constexpr std::uint32_t kHalf = 128, kOne = 256;
};
struct CombineShift7 : CombineNearest255 {  // whatever it has no rule for is never asked of it
    static HWY_INLINE VU product(VU a, VU b) { return min16(shift_right16<7>(mul16(a, b)), set_pair(255)); }
};

// The ops, on pairs of bytes. Sums stay below 2^16.
template <class Rule>
HWY_INLINE VU combine(CombineOp op, VU a, VU b, VU c) {
    const VU most = set_pair(255);
    switch (op) {
        case CombineOp::Select:
            return a;
        case CombineOp::Modulate:
            return Rule::product(a, b);
        case CombineOp::Modulate2X:
            return Rule::product_2x(a, b);
        case CombineOp::Modulate4X:
            return Rule::product_4x(a, b);
        case CombineOp::Add:
            return min16(add16(a, b), most);
        case CombineOp::AddSigned:
            return min16(sub_saturated16(add16(a, b), set_pair(Rule::kHalf)), most);
        case CombineOp::AddSigned2X: {
            const VU sum = add16(a, b);
            return min16(sub_saturated16(add16(sum, sum), set_pair(Rule::kOne)), most);
        }
        case CombineOp::Subtract:
            return sub_saturated16(a, b);
        case CombineOp::Lerp:
            return Rule::lerp(a, b, c);
        case CombineOp::MultiplyAdd:
            return min16(add16(Rule::product(a, b), c), most);
    }
    return a;
}

// What the arguments of a stage are taken from, as Pixels.
struct StageInputs {
    Pixels diffuse, current, texel, constant, specular;

    HWY_INLINE Pixels operator()(const CombineArg& arg) const {
        Pixels p = current;
        switch (arg.source) {
            case CombineArg::Source::Diffuse:
                p = diffuse;
                break;
            case CombineArg::Source::Current:
                break;
            case CombineArg::Source::Texel:
                p = texel;
                break;
            case CombineArg::Source::Constant:
                p = constant;
                break;
            case CombineArg::Source::Specular:
                p = {specular.lo, hn::Or(specular.hi, set(0x00ff0000))};
                break;
        }
        if (arg.alpha_replicate) p.lo = p.hi = alpha_pair(p);
        return arg.complement ? Pixels{invert(p.lo), invert(p.hi)} : p;
    }
};

template <class Rule>
HWY_INLINE Pixels combine(const Combine& how, const StageInputs& inputs) {
    const Pixels a = inputs(how.a), b = inputs(how.b), c = inputs(how.c);
    return {combine<Rule>(how.op, a.lo, b.lo, c.lo), combine<Rule>(how.op, a.hi, b.hi, c.hi)};
}

template <class Rule>
HWY_INLINE Pixels combine(const CombineStage& stage, const StageInputs& inputs) {
    Pixels out = combine<Rule>(stage.color, inputs);
    if (!(stage.color == stage.alpha)) out.hi = select(set(0xffff0000), combine<Rule>(stage.alpha, inputs).hi, out.hi);
    return out;
}

HWY_INLINE Pixels combine(CombineRule rule, const CombineStage& stage, const StageInputs& inputs) {
    switch (rule) {
        case CombineRule::Nearest255:
            break;
        case CombineRule::Expanded256:
            return combine<CombineExpanded256>(stage, inputs);
        case CombineRule::Shift7:
            return combine<CombineShift7>(stage, inputs);
    }
    return combine<CombineNearest255>(stage, inputs);
}

// All operations at once are too much code to repeat at each place.
template <class Inputs>
HWY_NOINLINE Pixels combine_any(CombineRule rule, const CombineStage& stage, const Inputs& inputs) {
    return combine(rule, stage, inputs);
}

// Red, green and blue of `changed`, alpha of `p`.
HWY_INLINE Pixels keep_alpha(const Pixels& p, const Pixels& changed) {
    return {changed.lo, select(set(0xffff0000), p.hi, changed.hi)};
}

HWY_INLINE Pixels add_specular(const Pixels& c, const Pixels& s) {
    const VU most = set_pair(255);
    return keep_alpha(c, {min16(add16(c.lo, s.lo), most), min16(add16(c.hi, s.hi), most)});
}

HWY_INLINE Pixels apply_fog(FogRule rule, const Pixels& c, const Pixels& fog, const Pixels& specular) {
    const VU f     = alpha_pair(specular);
    const auto mix = [&](VU color, VU k) NIMBUS7_LAMBDA {
        switch (rule) {
            case FogRule::Nearest255:
                break;
            case FogRule::Floor256:
                return shift_right16<8>(add16(mul16(color, f), mul16(k, sub16(set_pair(256), f))));
            case FogRule::Expanded256: {
                const VU f256 = expand256(f);
                return shift_right16<8>(add16(mul16(color, f256), mul16(k, sub16(set_pair(256), f256))));
            }
            case FogRule::TwoFloors:
                return add16(shift_right16<8>(mul16(color, f)), shift_right16<8>(mul16(k, invert(f))));
        }
        // f * c + (255 - f) * k, modulo 2^16 on the way.
        return div255(add16(mul16(sub16(color, k), f), mul16(k, set_pair(255))));
    };
    return keep_alpha(c, {mix(c.lo, fog.lo), mix(c.hi, fog.hi)});
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#endif  // include guard
