// SPDX-License-Identifier: MIT
// No chip: every result is the exact one, rounded once to the nearest byte.
#include "pipeline/profile/tables.h"

namespace pipeline {
namespace {

constexpr std::string_view kExact = "by definition: the exact result, rounded once to nearest";

}  // namespace

Profile make_ideal() {
    using enum TargetFormat;
    return {
        .name       = "ideal",
        .chip       = "no chip: exact arithmetic, no limits",
        .arithmetic = {},
        .formats    = {.draw         = {A8R8G8B8, X8R8G8B8, R5G6B5, A1R5G5B5, R6G6B6A6, Psmct32, Psmct24, Psmct16},
                       .copy_targets = {A8R8G8B8, X8R8G8B8, R5G6B5, A1R5G5B5, R6G6B6A6, Psmct32, Psmct24, Psmct16},
                       .depth        = {D16, D24, D32}},
        .states     = {},
        .evidence =
            {
                {"snap", "by definition: window coordinates to the nearest 1/16 pixel", Grade::Chosen, ""},
                {"pixel_center", "by definition: a pixel is sampled in its middle", Grade::Chosen, ""},
                {"vertex_depth", "by definition: finer than the depth buffer", Grade::Chosen, ""},
                {"gouraud", kExact, Grade::Chosen, ""},
                {"filter", kExact, Grade::Chosen, ""},
                {"combine", kExact, Grade::Chosen, ""},
                {"fog", kExact, Grade::Chosen, ""},
                {"blend", kExact, Grade::Chosen, ""},
                {"blend_source", "by definition: the blender sees whole bytes", Grade::Chosen, ""},
                {"store", "by definition: the top bits are kept; each format reads back as its chip does it",
                 Grade::Chosen, ""},
                {"alpha_test", "by definition: bytes compare as unsigned integers", Grade::Chosen, ""},
                {"dest_alpha_test", "by definition: bit 7 of the alpha that the target gives back", Grade::Chosen, ""},
                {"depth", "by definition: unsigned integers, floored to the format's bits", Grade::Chosen, ""},
                {"copy", "by definition: bytes as they are; four are averaged by a floor", Grade::Chosen, ""},
                {"targets", "by definition: every format, in any pair", Grade::Chosen, ""},
                {"states", "by definition: every state of a pass that is not one chip's dither or blend", Grade::Chosen,
                 ""},
                {"stages", "by definition: two stages of every function and argument", Grade::Chosen, ""},
                {"flat", "by definition: the first vertex, as in Direct3D", Grade::Chosen, ""},
                {"lod", "by definition: from the texels that a pixel spans; see raster/sampling_rules.h", Grade::Chosen,
                 ""},
            },
    };
}

}  // namespace pipeline
