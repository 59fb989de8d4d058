// SPDX-License-Identifier: MIT
// Blending, masks, tests, scissor, culling and shading. A state matters where something is drawn that it acts on.
#include "pipeline/check/chip_findings.h"
#include "pipeline/check/target_use.h"

namespace pipeline {

namespace {

void check_blend(const PipelineState& state, const Place& place, ChipFindings& findings) {
    const ChipStates& states = findings.profile().states;
    const bool is_gs         = findings.profile().arithmetic.blend == BlendRule::GsShift7;
    const Place blend        = place.field("blend");
    if (is_gs && state.blend != kReplace)
        findings.add(blend, "states", differing_fields(state.blend, kReplace), "gs_blend");
    if (!is_gs && !is_among(state.blend.source, states.source_factors))
        findings.add(blend.field("source"), "states", text_of(state.blend.source), names_of(states.source_factors));
    if (!is_gs && !is_among(state.blend.dest, states.dest_factors))
        findings.add(blend.field("dest"), "states", text_of(state.blend.dest), names_of(states.dest_factors));
    if (!is_gs && state.gs_blend != GsBlend{})
        findings.add(place.field("gs_blend"), "states", differing_fields(state.gs_blend, {}), "blend");
}

void check_dither(const PipelineState& state, const Place& place, ChipFindings& findings) {
    const ChipStates& states = findings.profile().states;
    if (is_among(state.dither.mode, states.dithers)) return;
    const Place dither = place.field("dither");
    findings.add(dither.field("mode"), findings.topic_or("dither", "states"), text_of(state.dither.mode),
                 names_of(states.dithers));
}

bool has_alpha(TargetFormat format) {
    return format != TargetFormat::X8R8G8B8 && format != TargetFormat::R5G6B5 && format != TargetFormat::Psmct24;
}

void check_color_mask(const ColorMask& mask, const Target& target, const Place& place, ChipFindings& findings) {
    ColorMask acts = mask;
    if (!has_alpha(target.format)) acts.alpha = acts.red;
    const MaskKind kind   = findings.profile().states.color_mask;
    const bool rgb_is_one = acts.red == acts.green && acts.green == acts.blue;
    const bool is_there =
        acts == ColorMask{} || kind == MaskKind::Channels || (kind == MaskKind::ColorAndAlpha && rgb_is_one);
    if (!is_there) findings.add(place.field("color_mask"), "states", differing_fields(mask, {}), text_of(kind));
}

void check_tests(const Pass& pass, const Place& place, ChipFindings& findings) {
    const ChipStates& states    = findings.profile().states;
    const DepthState& depth     = pass.state.depth;
    const AlphaTestState& alpha = pass.state.alpha_test;
    const DestAlphaTest dest    = pass.state.dest_alpha_test;
    if (pass.depth && !is_among(depth.func, states.depth_funcs)) {
        const Place at = place.field("depth");
        findings.add(at.field("func"), "depth", text_of(depth.func), names_of(states.depth_funcs));
    }
    if (alpha.func != CompareFunc::Always && !is_among(alpha.fail, states.alpha_fails)) {
        const Place at = place.field("alpha_test");
        findings.add(at.field("fail"), "alpha_test", text_of(alpha.fail), names_of(states.alpha_fails));
    }
    if (dest != DestAlphaTest::Off && !states.dest_alpha_test)
        findings.add(place.field("dest_alpha_test"), findings.topic_or("dest_alpha_test", "states"), text_of(dest),
                     "none");
}

// Does the scissor keep anything that the viewport does not?
bool cuts_viewport(const PipelineState& state, const Target& target) {
    if (state.scissor == PixelRect{}) return false;
    const PixelRect all{0, 0, target.width, target.height};
    const PixelRect& viewport = state.viewport == PixelRect{} ? all : state.viewport;
    const PixelRect& scissor  = state.scissor;
    return scissor.x0 > viewport.x0 || scissor.y0 > viewport.y0 || scissor.x1 < viewport.x1 || scissor.y1 < viewport.y1;
}

void check_scissor(const Frame& frame, const Pass& pass, const Place& place, ChipFindings& findings) {
    const bool acts      = draws(pass) || pass.clear.color || pass.clear.depth;
    const Target* target = find_target(frame, pass.color ? pass.color : pass.depth);
    if (findings.profile().states.scissor || !acts || target == nullptr || !cuts_viewport(pass.state, *target)) return;
    findings.add(place.field("scissor"), "states", differing_fields(pass.state.scissor, {}), "none");
}

void check_triangles(const Pass& pass, const Place& place, ChipFindings& findings) {
    const ChipStates& states   = findings.profile().states;
    const PipelineState& state = pass.state;
    if (state.cull != CullMode::None && !states.culling)
        findings.add(place.field("cull"), "states", text_of(state.cull), "NONE");
    if (state.shade == ShadeMode::Flat && states.flat != FlatVertex::First)
        findings.add(place.field("shade"), "flat", "FLAT, by the first vertex",
                     states.flat == FlatVertex::None ? "GOURAUD" : "FLAT, by the last vertex");
    if (state.lighting.specular_enable && !states.specular_addition) {
        const Place lighting = place.field("lighting");
        findings.add(lighting.field("specular_enable"), "states", "true", "false");
    }
}

void check_window_space(const Pass& pass, const Place& place, ChipFindings& findings) {
    if (findings.profile().states.transforms) return;
    for (std::size_t i = 0; i < pass.draws.size(); ++i)
        if (std::holds_alternative<DrawTriangles>(pass.draws[i]))
            findings.add(place.entry("draws", i), "states", "triangles", "window_triangles");
}

}  // namespace

void check_states(const Frame& frame, const Pass& pass, const Place& place, ChipFindings& findings) {
    const Place state    = place.field("state");
    const Target* target = find_target(frame, pass.color);
    if (draws(pass) && target != nullptr) {
        check_blend(pass.state, state, findings);
        check_dither(pass.state, state, findings);
        check_color_mask(pass.state.color_mask, *target, state, findings);
    }
    if (draws(pass)) check_tests(pass, state, findings);
    if (draws_triangles(pass)) check_triangles(pass, state, findings);
    check_window_space(pass, place, findings);
    check_scissor(frame, pass, state, findings);
}

}  // namespace pipeline
