// SPDX-License-Identifier: MIT
// Step 5 and 6 of raster/fill_state.h on vectors of pixels: what passes.
// Highway's per-target include guard.
#if defined(NIMBUS7_RASTER_TESTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NIMBUS7_RASTER_TESTS_INL_H_
#undef NIMBUS7_RASTER_TESTS_INL_H_
#else
#define NIMBUS7_RASTER_TESTS_INL_H_
#endif

#include "raster/fill_program.h"
#include "raster/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

HWY_INLINE MU every_lane() {
    return hn::MaskFromVec(set(0xffffffff));
}
HWY_INLINE MU no_lane() {
    return hn::MaskFromVec(set(0));
}

// Both less than 2^31: then signed comparisons will do, which are the quicker ones.
HWY_INLINE MU passes(Compare func, VI fragment, VI reference) {
    const auto mask = [](auto m) NIMBUS7_LAMBDA { return hn::RebindMask(DU(), m); };
    switch (func) {
        case Compare::Always:
            return every_lane();
        case Compare::LessEqual:
            return hn::Not(mask(hn::Gt(fragment, reference)));
        case Compare::Less:
            return mask(hn::Lt(fragment, reference));
        case Compare::GreaterEqual:
            return hn::Not(mask(hn::Lt(fragment, reference)));
        case Compare::Greater:
            return mask(hn::Gt(fragment, reference));
        case Compare::Equal:
            return mask(hn::Eq(fragment, reference));
        case Compare::NotEqual:
            return hn::Not(mask(hn::Eq(fragment, reference)));
        case Compare::Never:
            break;
    }
    return no_lane();
}

template <class Program>
HWY_INLINE MU passes_depth(Program program, VU fragment, VU reference) {
    // The order of unsigned numbers is that of signed ones once the top bit is flipped.
    const VU flip = set(program->depth_bits == 32 ? 0x80000000 : 0);
    return passes(program->depth_func, hn::BitCast(DI(), hn::Xor(fragment, flip)),
                  hn::BitCast(DI(), hn::Xor(reference, flip)));
}

// `there`: the colour target's pixels.
HWY_INLINE MU passes(DestAlphaTest test, VU there) {
    switch (test) {
        case DestAlphaTest::Off:
            break;
        case DestAlphaTest::Zero:
            return hn::RebindMask(DU(), hn::Gt(hn::BitCast(DI(), there), seti(-1)));
        case DestAlphaTest::One:
            return hn::RebindMask(DU(), hn::Lt(hn::BitCast(DI(), there), seti(0)));
    }
    return every_lane();
}

// In units of the target's format, from 30 bits.
HWY_INLINE VU depth_units(int depth_bits, VU depth) {
    switch (depth_bits) {
        case 16:
            return hn::ShiftRight<kDepthBits - 16>(depth);
        case 24:
            return hn::ShiftRight<kDepthBits - 24>(depth);
        default:
            return hn::Or(hn::ShiftLeft<2>(depth), hn::ShiftRight<28>(depth));
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#endif  // include guard
