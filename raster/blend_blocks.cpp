// SPDX-License-Identifier: MIT
#include "raster/blend_blocks.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/blend_blocks.cpp"
#include "hwy/foreach_target.h"
#include "raster/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

// Blend rules, one line each: s source, d destination.
struct Replace {
    static HWY_INLINE VU apply(const BlendConstants&, VU s, VU) { return s; }
};
struct Over {  // SRCALPHA, INVSRCALPHA
    static HWY_INLINE VU apply(const BlendConstants&, VU source, VU dest) {
        const Pixels s = unpack(source), d = unpack(dest);
        const VU a = alpha_pair(s), ia = invert(a);
        return pack({div255(add16(mul16(s.lo, a), mul16(d.lo, ia))), div255(add16(mul16(s.hi, a), mul16(d.hi, ia)))});
    }
};
struct Multiply {  // ZERO, SRCCOLOR
    static HWY_INLINE VU apply(const BlendConstants&, VU source, VU dest) {
        const Pixels s = unpack(source), d = unpack(dest);
        return pack({div255(mul16(s.lo, d.lo)), div255(mul16(s.hi, d.hi))});
    }
};
struct Any {
    static HWY_INLINE Pixels factor(const BlendFactor& f, Pixels s, Pixels d) {
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
    static HWY_INLINE VU apply(const BlendConstants& constants, VU source, VU dest) {
        const Pixels s = unpack(source), d = unpack(dest);
        const Pixels fs = factor(constants.source, s, d), fd = factor(constants.dest, s, d);
        return pack({div255_limited(add_saturated16(mul16(s.lo, fs.lo), mul16(d.lo, fd.lo))),
                     div255_limited(add_saturated16(mul16(s.hi, fs.hi), mul16(d.hi, fd.hi)))});
    }
};

template <class Rule>
void blend(const BlendConstants& constants, Image& target, const FragmentBatch& batch) {
    const VU write_mask = set(constants.write_mask);
    for (int block = 0; block < batch.count; ++block) {
        std::uint32_t* const pixels = target.row(batch.at[block].y) + batch.at[block].x;
        for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
            const VU source = hn::Load(DU(), batch.color[block] + lane), dest = hn::Load(DU(), pixels + lane);
            const VU mask = hn::And(hn::Load(DU(), batch.mask[block] + lane), write_mask);
            hn::Store(select(mask, Rule::apply(constants, source, dest), dest), DU(), pixels + lane);
        }
    }
}

BlendKernel get_blend_kernel(const BlendConstants& constants, bool generic) {
    using enum BlendFactor::Operand;
    const auto is = [&](const BlendFactor& source, const BlendFactor& dest) {
        return !generic && constants.source == source && constants.dest == dest;
    };
    if (is(kOne, kZero)) return &blend<Replace>;
    if (is({Source, true, false}, {Source, true, true})) return &blend<Over>;
    if (is(kZero, {Source, false, false})) return &blend<Multiply>;
    return &blend<Any>;
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raster {
HWY_EXPORT(get_blend_kernel);
BlendKernel blend_kernel(const BlendConstants& constants, bool generic) {
    return HWY_DYNAMIC_DISPATCH(get_blend_kernel)(constants, generic);
}
}  // namespace raster
#endif
