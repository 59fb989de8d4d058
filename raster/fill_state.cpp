// SPDX-License-Identifier: MIT
#include "raster/fill_state.h"

namespace raster {

namespace {

bool reads_texel(const Combine& combine) {
    const auto is_texel = [](const CombineArg& arg) { return arg.source == CombineArg::Source::Texel; };
    return is_texel(combine.a) || (combine.op != CombineOp::Select && is_texel(combine.b));
}

}  // namespace

bool reads_texel(const FillState& state, int i) {
    if (i < 0 || i >= state.stage_count || i >= kMaxTextures) return false;
    return reads_texel(state.stages[i].color) || reads_texel(state.stages[i].alpha);
}

}  // namespace raster
