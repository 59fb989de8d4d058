// SPDX-License-Identifier: MIT
#include "raster/fill_state.h"

namespace raster {
namespace {

bool reads(const Combine& combine, CombineArg::Source source) {
    const bool ternary = combine.op == CombineOp::Lerp || combine.op == CombineOp::MultiplyAdd;
    return combine.a.source == source || (combine.op != CombineOp::Select && combine.b.source == source) ||
           (ternary && combine.c.source == source);
}

}  // namespace

bool reads(const FillState& state, int i, CombineArg::Source source) {
    return i < state.stage_count && (reads(state.stages[i].color, source) || reads(state.stages[i].alpha, source));
}

}  // namespace raster
