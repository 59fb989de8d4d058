// SPDX-License-Identifier: MIT
// What happens to a vector of covered pixels: tests, colour, blend, store, in the order of raster/fill_state.h.
// Highway's per-target include guard.
#if defined(NIMBUS7_RASTER_SHADE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NIMBUS7_RASTER_SHADE_INL_H_
#undef NIMBUS7_RASTER_SHADE_INL_H_
#else
#define NIMBUS7_RASTER_SHADE_INL_H_
#endif

#include "raster/blend-inl.h"
#include "raster/combine-inl.h"
#include "raster/fill_plan.h"
#include "raster/lanes-inl.h"
#include "raster/tests-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

// Counts of one primitive in one tile, if they are asked for. What follows from others is only added up in the end.
class Counter {
  public:
    bool is_asked         = true;
    std::uint64_t covered = 0, dest_alpha_tested = 0, alpha_passed = 0, depth_passed = 0, depth_written = 0,
                  color_written = 0;

    template <class Program>
    HWY_INLINE void add_to(FillCounts& counts, Program program, const FillPlan& plan) const {
        const bool all_pass_alpha = program->tests_first() && program->dest_alpha_test == DestAlphaTest::Off;
        const std::uint64_t alpha = all_pass_alpha ? covered : alpha_passed;
        const std::uint64_t depth = program->depth_bits == 0 ? alpha : depth_passed;
        counts.covered += covered;
        counts.alpha_passed += alpha;
        counts.depth_passed += depth;
        if (program->depth_write) counts.depth_written += program->fails_on() ? depth_written : depth;
        if (program->writes != Writes::Nothing) counts.color_written += program->fails_on() ? color_written : depth;
        counts.texels += covered * plan.texels_per_fragment;
        counts.texel_bytes += covered * plan.texel_bytes_per_fragment;
        counts.dest_alpha_tested += dest_alpha_tested;
    }
};

// A vector of pixels in the targets: the first one in each (null without), and where in its block and in the image.
struct Place {
    std::uint32_t *color, *depth;
    int lane, y;
};

// The tests that need no colour. depth_at(): the fragments' depth, in units of the format. `writers` may write it.
template <class Program, class DepthAt>
HWY_INLINE MU test_stored(Program program, const Place& place, DepthAt depth_at, MU mask, MU writers,
                          Counter& counter) {
    if (program->dest_alpha_test != DestAlphaTest::Off) {
        if (counter.is_asked) counter.dest_alpha_tested += count_lanes(mask);
        mask = hn::And(mask, passes(program->dest_alpha_test, hn::Load(DU(), place.color)));
    }
    if (counter.is_asked && (!program->tests_first() || program->dest_alpha_test != DestAlphaTest::Off))
        counter.alpha_passed += count_lanes(mask);
    if (program->depth_bits == 0) return mask;
    const VU depth = depth_at(), there = hn::Load(DU(), place.depth);
    mask = hn::And(mask, passes_depth(program, depth, there));
    if (counter.is_asked) counter.depth_passed += count_lanes(mask);
    if (program->depth_write) {
        const MU written = program->fails_on() ? hn::And(mask, writers) : mask;
        if (counter.is_asked && program->fails_on()) counter.depth_written += count_lanes(written);
        hn::Store(hn::IfThenElse(written, depth, there), DU(), place.depth);
    }
    return mask;
}

template <int kStage, class Program, class Source>
HWY_INLINE void apply_stage(Program program, const Source& source, StageInputs& inputs) {
    if (kStage >= program->stage_count) return;
    if (program->textures[kStage].is_read) {
        if (program->textures[kStage].has_texels)
            inputs.texel = source.template texel<kStage>();
        else
            inputs.texel = unpack(set(0xffffffff));
    }
    if constexpr (Program::kIsKnown)
        inputs.current = combine(program->combine_rule, program->stages[kStage], inputs);
    else
        inputs.current = combine_any(program->combine_rule, program->stages[kStage], inputs);
}

// A fragment's colour. source: diffuse(), specular(), texel<stage>(), each as Pixels.
template <class Program, class Source>
HWY_INLINE Pixels make_color(Program program, const FillPlan& plan, const Source& source) {
    static_assert(kMaxTextures == 2);
    const Pixels none{set(0), set(0)};
    StageInputs inputs{none, none, none, unpack(set(plan.constant)), none};
    if (program->reads_diffuse) inputs.current = inputs.diffuse = source.diffuse();
    if (program->reads_specular) inputs.specular = source.specular();
    apply_stage<0>(program, source, inputs);
    apply_stage<1>(program, source, inputs);
    Pixels color = inputs.current;
    if (program->add_specular) color = add_specular(color, inputs.specular);
    if (program->fog) color = apply_fog(program->fog_rule, color, unpack(set(plan.fog_color)), inputs.specular);
    return color;
}

// From its colour on; `mask` has passed the tests that come first.
template <class Program, class DepthAt>
HWY_INLINE void finish(Program program, const FillPlan& plan, const Place& place, DepthAt depth_at, const Pixels& color,
                       MU mask, Counter& counter) {
    MU passed = mask;
    if (!program->tests_first()) {
        const VI alpha = hn::BitCast(DI(), hn::ShiftRight<16>(color.hi));
        passed         = hn::And(mask, passes(program->alpha_func, alpha, seti(plan.alpha_reference)));
        if (program->alpha_fail == AlphaFail::Keep) mask = passed;
        const MU writers = program->alpha_fail == AlphaFail::DepthOnly ? mask : passed;
        mask             = test_stored(program, place, depth_at, mask, writers, counter);
        if (hn::AllFalse(DU(), mask)) return;
    }
    if (program->writes == Writes::Nothing) return;
    const VU dest = hn::Load(DU(), place.color);
    const VU next = blend(program, plan.blend, color, dest, place.lane, place.y);
    if (program->writes == Writes::All && !program->fails_on()) {
        hn::Store(hn::IfThenElse(mask, next, dest), DU(), place.color);
        return;
    }
    VU bits = hn::VecFromMask(DU(), mask);  // of the target that may change
    if (program->fails_on()) {
        bits = hn::And(bits, hn::Or(hn::VecFromMask(DU(), passed), set(plan.bits_if_failed)));
        if (counter.is_asked) counter.color_written += count_lanes(hn::Ne(bits, set(0)));
    }
    hn::Store(select(hn::And(bits, set(plan.blend.write_mask)), next, dest), DU(), place.color);
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#endif  // include guard
