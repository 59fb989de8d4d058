// SPDX-License-Identifier: MIT
#include "pipeline/legalize/legalize.h"

#include <utility>

#include "pipeline/legalize/arithmetic.h"
#include "pipeline/legalize/copies.h"
#include "pipeline/legalize/dest_alpha_test.h"
#include "pipeline/legalize/formats.h"
#include "pipeline/legalize/frame_buffer.h"
#include "pipeline/legalize/gs_alpha.h"
#include "pipeline/legalize/gs_blend.h"
#include "pipeline/legalize/light_at_vertices.h"
#include "pipeline/legalize/masked_alpha.h"
#include "pipeline/legalize/mip_levels.h"
#include "pipeline/legalize/pixel_center.h"
#include "pipeline/legalize/reversed_depth.h"
#include "pipeline/legalize/rewrites.h"
#include "pipeline/legalize/scissor.h"
#include "pipeline/legalize/second_alpha.h"
#include "pipeline/legalize/stages.h"
#include "pipeline/legalize/unused.h"
#include "pipeline/legalize/vertex_constants.h"
#include "pipeline/legalize/window_triangles.h"

namespace pipeline {

namespace {

// What a rewrite leaves behind must still be seen by the one that serves it: passes for later stages have constants, formats
// decide which copies convert, the test of destination alpha needs masks, or else comes before formats, where alpha costs
// bits; what shares a frame buffer is known when all passes are there; the arithmetic comes when nothing asks for the frame's
// own any more.
constexpr NamedRewrite kRewrites[] = {
    {"rewrite_window_triangles", rewrite_window_triangles},
    {"rewrite_second_alpha", rewrite_second_alpha},
    {"rewrite_light_at_vertices", rewrite_light_at_vertices},
    {"rewrite_stages", rewrite_stages},
    {"rewrite_vertex_constants", rewrite_vertex_constants},
    {"test_by_texture", test_by_texture},
    {"rewrite_formats", rewrite_formats},
    {"draw_copies", draw_copies},
    {"test_by_blending", test_by_blending},
    {"mask_by_blending", mask_by_blending},
    {"rewrite_reversed_depth", rewrite_reversed_depth},
    {"rewrite_gs_alpha", rewrite_gs_alpha},
    {"rewrite_gs_blend", rewrite_gs_blend},
    {"rewrite_mip_levels", rewrite_mip_levels},
    {"limit_by_viewport", limit_by_viewport},
    {"share_frame_buffer", share_frame_buffer},
    {"move_to_pixel_centers", move_to_pixel_centers},
    {"use_chip_arithmetic", use_chip_arithmetic},
    {"drop_unused", drop_unused},
};

}  // namespace

std::span<const NamedRewrite> rewrites() {
    return kRewrites;
}

LegalFrame legalize(Frame frame, const Profile& profile) {
    LegalFrame legal{.frame = std::move(frame), .notes = {}, .left = {}};
    for (const NamedRewrite& next : kRewrites) legal.frame = next.rewrite(std::move(legal.frame), profile, legal.notes);
    legal.left = check(legal.frame, profile);
    return legal;
}

}  // namespace pipeline
