// SPDX-License-Identifier: MIT
#include "pipeline/legalize/arithmetic.h"

#include "pipeline/check/chip_findings.h"
#include "pipeline/validate/validate.h"

namespace pipeline {

namespace {

// Whether the frame stays valid with it.
template <class Rule>
void use_if_valid(Frame& frame, Rule Arithmetic::*rule, Rule of_chip) {
    if (frame.arithmetic.*rule == of_chip) return;
    const Rule before      = frame.arithmetic.*rule;
    frame.arithmetic.*rule = of_chip;
    if (!validate(frame).empty()) frame.arithmetic.*rule = before;
}

}  // namespace

Frame use_chip_arithmetic(Frame frame, const Profile& profile, RewriteNotes& notes) {
    const Arithmetic before = frame.arithmetic, &chip = profile.arithmetic;
    frame.arithmetic.vertex_depth = chip.vertex_depth;
    frame.arithmetic.gouraud      = chip.gouraud;
    frame.arithmetic.filter       = chip.filter;
    frame.arithmetic.fog          = chip.fog;
    frame.arithmetic.blend_source = chip.blend_source;
    // With the Graphics Synthesizer's one is 0x80: they come with the alpha that is scaled so (gs_alpha.h, gs_blend.h).
    if (chip.combine != CombineRule::GsShift7) use_if_valid(frame, &Arithmetic::combine, chip.combine);
    if (chip.blend != BlendRule::GsShift7) use_if_valid(frame, &Arithmetic::blend, chip.blend);
    if (frame.arithmetic == before) return frame;
    notes.push_back({"arithmetic", "frame",
                     "the chip computes otherwise: " + differing_fields(before, frame.arithmetic),
                     differing_fields(frame.arithmetic, before)});
    return frame;
}

}  // namespace pipeline
