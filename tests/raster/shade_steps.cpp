// SPDX-License-Identifier: MIT
// Steps 2 to 9 of raster/fill_state.h: raster/shade-inl.h on pixels from memory.
#include <cstddef>
#include <utility>

#include "tests/raster/fill_steps.h"
#include "tests/raster/special_parts.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/raster/shade_steps.cpp"
#include "hwy/foreach_target.h"
#include "raster/shade-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fill_steps {
namespace HWY_NAMESPACE {

using namespace raster;
using namespace raster::HWY_NAMESPACE;

struct InputsAt {
    const ColorInputs& inputs;
    int lane;

    HWY_INLINE Pixels load(const Colors& colors) const { return unpack(hn::Load(DU(), colors.data() + lane)); }
    HWY_INLINE Pixels diffuse() const { return load(inputs.diffuse); }
    HWY_INLINE Pixels specular() const { return load(inputs.specular); }
    template <int kStage>
    HWY_INLINE Pixels texel() const {
        return load(inputs.texels[kStage]);
    }
};

template <class Program>
HWY_INLINE void make_colors(Program program, const FillPlan& plan, const ColorInputs& inputs, Colors& out) {
    for (int lane = 0; lane < kLanes; lane += lane_count())
        hn::Store(pack(make_color(program, plan, InputsAt{inputs, lane})), DU(), out.data() + lane);
}

// In the order of the loops of fill_triangle-inl.h and fill_rectangle-inl.h.
template <class Program>
HWY_INLINE void shade(Program program, const FillPlan& plan, const Fragments& fragments, Targets& targets,
                      FillCounts& counts) {
    Counter counter;
    for (int i = 0; i < kLanes; i += lane_count()) {
        const int block = i / kBlockWidth, lane = i % kBlockWidth;
        const unsigned bits = static_cast<unsigned>(fragments.live[block]) >> lane & all_lanes();
        if (bits == 0) continue;
        MU mask = mask_of(bits);
        counter.covered += count_lanes(mask);
        const Place place{targets.color.data() + i, targets.depth.data() + i, lane, fragments.y};
        const auto depth_at = [&fragments, i]() NIMBUS7_LAMBDA { return hn::Load(DU(), fragments.depth.data() + i); };
        if (program->tests_first()) {
            mask = test_stored(program, place, depth_at, mask, mask, counter);
            if (!program->makes_color || hn::AllFalse(DU(), mask)) continue;
        }
        finish(program, plan, place, depth_at, unpack(hn::Load(DU(), fragments.color.data() + i)), mask, counter);
    }
    counter.add_to(counts, program, plan);
}

void make_colors_generally(const FillPlan& plan, const ColorInputs& inputs, Colors& out) {
    make_colors(AnyProgram{&plan.program}, plan, inputs, out);
}
void shade_generally(const FillPlan& plan, const Fragments& fragments, Targets& targets, FillCounts& counts) {
    shade(AnyProgram{&plan.program}, plan, fragments, targets, counts);
}
template <FillProgram kProgram>
void make_colors_specially(const FillPlan& plan, const ColorInputs& inputs, Colors& out) {
    make_colors(OneProgram<kProgram>(), plan, inputs, out);
}
template <FillProgram kProgram>
void shade_specially(const FillPlan& plan, const Fragments& fragments, Targets& targets, FillCounts& counts) {
    shade(OneProgram<kProgram>(), plan, fragments, targets, counts);
}

template <std::size_t... kIndices>
MakeColors special_make_colors(const FillProgram& part, std::index_sequence<kIndices...>) {
    using namespace special_parts;
    MakeColors found = nullptr;
    ((part == color_part(kPrograms[kIndices]) ? found = &make_colors_specially<color_part(kPrograms[kIndices])>
                                              : found),
     ...);
    return found;
}
template <std::size_t... kIndices>
Shade special_shade(const FillProgram& part, std::index_sequence<kIndices...>) {
    using namespace special_parts;
    Shade found = nullptr;
    ((part == shade_part(kPrograms[kIndices]) ? found = &shade_specially<shade_part(kPrograms[kIndices])> : found),
     ...);
    return found;
}

using AllPrograms = std::make_index_sequence<special_parts::kPrograms.size()>;

MakeColors get_make_colors(const FillProgram& program, Kind kind) {
    if (kind == Kind::General) return &make_colors_generally;
    return special_make_colors(special_parts::color_part(program), AllPrograms());
}
Shade get_shade(const FillProgram& program, Kind kind) {
    if (kind == Kind::General) return &shade_generally;
    return special_shade(special_parts::shade_part(program), AllPrograms());
}

void convert_depths(int depth_bits, const Lanes<std::uint32_t>& depth, Lanes<std::uint32_t>& out) {
    for (int lane = 0; lane < kLanes; lane += lane_count())
        hn::Store(depth_units(depth_bits, hn::Load(DU(), depth.data() + lane)), DU(), out.data() + lane);
}
DepthUnits get_depth_units() {
    return &convert_depths;
}

}  // namespace HWY_NAMESPACE
}  // namespace fill_steps
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fill_steps {

HWY_EXPORT(get_make_colors);
HWY_EXPORT(get_shade);
HWY_EXPORT(get_depth_units);

MakeColors make_colors_step(const raster::FillProgram& program, Kind kind) {
    return HWY_DYNAMIC_DISPATCH(get_make_colors)(program, kind);
}
Shade shade_step(const raster::FillProgram& program, Kind kind) {
    return HWY_DYNAMIC_DISPATCH(get_shade)(program, kind);
}
DepthUnits depth_units_step() {
    return HWY_DYNAMIC_DISPATCH(get_depth_units)();
}

}  // namespace fill_steps
#endif
