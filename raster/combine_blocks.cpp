// SPDX-License-Identifier: MIT
#include "raster/combine_blocks.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/combine_blocks.cpp"
#include "hwy/foreach_target.h"
#include "raster/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

// The ops, on pairs of bytes.
HWY_INLINE VU combine(CombineOp op, VU a, VU b) {
    const VU most = set_pair(255);
    switch (op) {
        case CombineOp::Select:
            return a;
        case CombineOp::Modulate:
            return div255(mul16(a, b));
        case CombineOp::Modulate2X: {
            const VU product = mul16(a, b);
            return div255_limited(add_saturated16(product, product));
        }
        case CombineOp::Modulate4X: {
            const VU product = mul16(a, b), twice = add_saturated16(product, product);
            return div255_limited(add_saturated16(twice, twice));
        }
        case CombineOp::Add:
            return min16(add16(a, b), most);
        case CombineOp::AddSigned:
            return min16(sub_saturated16(add16(a, b), set_pair(127)), most);
        case CombineOp::AddSigned2X: {
            const VU sum = add16(a, b);
            return min16(sub_saturated16(add16(sum, sum), most), most);
        }
        case CombineOp::Subtract:
            return sub_saturated16(a, b);
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

void combine_stage(const CombineStage& stage, int index, std::uint32_t constant, FragmentBatch& batch) {
    const bool alike = stage.color == stage.alpha;
    for (int block = 0; block < batch.count; ++block) {
        const std::uint32_t* const current = index == 0 ? batch.diffuse[block] : batch.color[block];
        for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
            const Arguments argument{hn::Load(DU(), batch.diffuse[block] + lane), hn::Load(DU(), current + lane),
                                     hn::Load(DU(), batch.texel[index][block] + lane), set(constant),
                                     hn::Load(DU(), batch.specular[block] + lane)};
            const Pixels a = argument(stage.color.a), b = argument(stage.color.b);
            Pixels out{combine(stage.color.op, a.lo, b.lo), combine(stage.color.op, a.hi, b.hi)};
            if (!alike) {
                const VU alpha = combine(stage.alpha.op, argument(stage.alpha.a).hi, argument(stage.alpha.b).hi);
                out.hi         = select(set(0xffff0000), alpha, out.hi);
            }
            hn::Store(pack(out), DU(), batch.color[block] + lane);
        }
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

void apply_fog(std::uint32_t fog_color, FragmentBatch& batch) {
    for_each_color(batch, [fog_color](VU argb, VU specular) HWY_ATTR {
        const Pixels c = unpack(argb), fog = unpack(set(fog_color));
        const VU f = alpha_pair(unpack(specular)), rest = invert(f);
        return pack(
            {div255(add16(mul16(c.lo, f), mul16(fog.lo, rest))), div255(add16(mul16(c.hi, f), mul16(fog.hi, rest)))});
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
