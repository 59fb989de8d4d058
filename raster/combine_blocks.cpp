// SPDX-License-Identifier: MIT
#include "raster/combine_blocks.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/combine_blocks.cpp"
#include "hwy/foreach_target.h"
#include "raster/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

// What a rule makes of products of bytes, on pairs.
struct Nearest255 {
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
struct Expanded256 {
    // (k * p + 128) >> 8 = (p + 128 / k) >> (8 - log2 k), which stays within 16 bits.
    static HWY_INLINE VU product(VU a, VU b) { return shift_right16<8>(add16(mul16(a, expand256(b)), set_pair(128))); }
    static HWY_INLINE VU product_2x(VU a, VU b) {
        return shift_right16<7>(add16(mul16(a, expand256(b)), set_pair(64)));
    }
    static HWY_INLINE VU product_4x(VU a, VU b) {
        return shift_right16<6>(add16(mul16(a, expand256(b)), set_pair(32)));
    }
    static HWY_INLINE VU lerp(VU a, VU b, VU c) {
        const VU f = expand256(c);
        return shift_right16<8>(add16(add16(mul16(a, f), mul16(b, sub16(set_pair(256), f))), set_pair(128)));
    }
    static constexpr std::uint32_t kHalf = 128, kOne = 256;
};
struct Shift7 : Nearest255 {  // whatever it has no rule for is never asked of it
    static HWY_INLINE VU product(VU a, VU b) { return shift_right16<7>(mul16(a, b)); }
};

// The ops, on pairs of bytes. Sums stay below 2^16.
template <class Rule>
HWY_INLINE VU combine(CombineOp op, VU a, VU b, VU c) {
    const VU most = set_pair(255);
    switch (op) {
        case CombineOp::Select:
            return a;
        case CombineOp::Modulate:
            return min16(Rule::product(a, b), most);
        case CombineOp::Modulate2X:
            return min16(Rule::product_2x(a, b), most);
        case CombineOp::Modulate4X:
            return min16(Rule::product_4x(a, b), most);
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

// The arguments of a stage at one vector of pixels.
struct Arguments {
    VU diffuse, current, texel, constant, specular;

    HWY_INLINE Pixels operator()(const CombineArg& arg) const {
        VU argb = current;
        switch (arg.source) {
            case CombineArg::Source::Diffuse:
                argb = diffuse;
                break;
            case CombineArg::Source::Current:
                break;
            case CombineArg::Source::Texel:
                argb = texel;
                break;
            case CombineArg::Source::Constant:
                argb = constant;
                break;
            case CombineArg::Source::Specular:
                argb = hn::Or(specular, set(0xff000000));
                break;
        }
        Pixels p = unpack(argb);
        if (arg.alpha_replicate) p.lo = p.hi = alpha_pair(p);
        return arg.complement ? Pixels{invert(p.lo), invert(p.hi)} : p;
    }
};

template <class Rule>
HWY_INLINE Pixels combine(const Combine& how, const Arguments& argument) {
    const Pixels a = argument(how.a), b = argument(how.b);
    const bool ternary = how.op == CombineOp::Lerp || how.op == CombineOp::MultiplyAdd;
    const Pixels c     = ternary ? argument(how.c) : a;
    return {combine<Rule>(how.op, a.lo, b.lo, c.lo), combine<Rule>(how.op, a.hi, b.hi, c.hi)};
}

template <class Rule>
void combine_stage(const CombineStage& stage, int index, std::uint32_t constant, FragmentBatch& batch) {
    const bool alike = stage.color == stage.alpha;
    for (int block = 0; block < batch.count; ++block) {
        const std::uint32_t* const current = index == 0 ? batch.diffuse[block] : batch.color[block];
        for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
            const Arguments argument{hn::Load(DU(), batch.diffuse[block] + lane), hn::Load(DU(), current + lane),
                                     hn::Load(DU(), batch.texel[index][block] + lane), set(constant),
                                     hn::Load(DU(), batch.specular[block] + lane)};
            Pixels out = combine<Rule>(stage.color, argument);
            if (!alike) out.hi = select(set(0xffff0000), combine<Rule>(stage.alpha, argument).hi, out.hi);
            hn::Store(pack(out), DU(), batch.color[block] + lane);
        }
    }
}

void combine_stage(const CombineStage& stage, CombineRule rule, int index, std::uint32_t constant,
                   FragmentBatch& batch) {
    switch (rule) {
        case CombineRule::Nearest255:
            return combine_stage<Nearest255>(stage, index, constant, batch);
        case CombineRule::Expanded256:
            return combine_stage<Expanded256>(stage, index, constant, batch);
        case CombineRule::Shift7:
            return combine_stage<Shift7>(stage, index, constant, batch);
    }
}

template <class Change>
HWY_INLINE void for_each_color(FragmentBatch& batch, Change change) {
    for (int block = 0; block < batch.count; ++block)
        for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
            std::uint32_t* const color = batch.color[block] + lane;
            const VU argb              = hn::Load(DU(), color);
            const VU changed           = change(argb, hn::Load(DU(), batch.specular[block] + lane));
            hn::Store(select(set(0x00ffffff), changed, argb), DU(), color);  // alpha stays
        }
}

void add_specular(FragmentBatch& batch) {
    for_each_color(batch, [](VU argb, VU specular) HWY_ATTR {
        const Pixels c = unpack(argb), s = unpack(specular);
        return pack({min16(add16(c.lo, s.lo), set_pair(255)), min16(add16(c.hi, s.hi), set_pair(255))});
    });
}

void apply_fog(FogRule rule, std::uint32_t fog_color, FragmentBatch& batch) {
    for_each_color(batch, [rule, fog_color](VU argb, VU specular) HWY_ATTR {
        const Pixels c = unpack(argb), fog = unpack(set(fog_color));
        const VU f = alpha_pair(unpack(specular)), rest = invert(f), f256 = expand256(f);
        const auto mix = [&](VU color, VU k) HWY_ATTR {
            const VU product = mul16(color, f);
            switch (rule) {
                case FogRule::Nearest255:
                    break;
                case FogRule::Floor256:
                    return shift_right16<8>(add16(product, mul16(k, sub16(set_pair(256), f))));
                case FogRule::Expanded256:
                    return shift_right16<8>(add16(mul16(color, f256), mul16(k, sub16(set_pair(256), f256))));
                case FogRule::TwoFloors:
                    return add16(shift_right16<8>(product), shift_right16<8>(mul16(k, rest)));
            }
            return div255(add16(product, mul16(k, rest)));
        };
        return pack({mix(c.lo, fog.lo), mix(c.hi, fog.hi)});
    });
}

CombineKernels get_combine_kernels() {
    return {&combine_stage, &add_specular, &apply_fog};
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raster {
HWY_EXPORT(get_combine_kernels);
CombineKernels combine_kernels() {
    return HWY_DYNAMIC_DISPATCH(get_combine_kernels)();
}
}  // namespace raster
#endif
