// SPDX-License-Identifier: MIT
#include "pipeline/validate/check_pass.h"
#include "pipeline/validate/check_values.h"

namespace pipeline {

namespace {

std::string size_text(std::int32_t width, std::int32_t height) {
    return std::to_string(width) + 'x' + std::to_string(height);
}

void check_targets(const Frame& frame, const Pass& pass, const Place& place, Findings& findings) {
    if (!pass.color && !pass.depth) report(findings, place.field("color"), "must refer to a target, or depth must");
    const Target* color = find_target(frame, pass.color);
    const Target* depth = find_target(frame, pass.depth);
    if (color != nullptr && is_depth(color->format)) {
        report(findings, place.field("color"), "must be a colour target" + got(color->format));
    }
    if (depth != nullptr && !is_depth(depth->format)) {
        report(findings, place.field("depth"), "must be a depth target" + got(depth->format));
    }
    if (color != nullptr && depth != nullptr && (color->width != depth->width || color->height != depth->height)) {
        report(findings, place.field("depth"),
               "must have the size of the colour target, " + size_text(color->width, color->height) + " (got " +
                   size_text(depth->width, depth->height) + ')');
    }
}

void check_clear_and_depth(const Pass& pass, const Place& place, Findings& findings) {
    const Place clear = place.field("clear");
    if (!pass.color && pass.clear.color) {
        report(findings, clear.field("color"), "must be left out: the pass has no colour target");
    }
    if (pass.clear.depth) {
        const Place depth = clear.field("depth");
        if (!pass.depth) report(findings, depth, "must be left out: the pass has no depth target");
        if (*pass.clear.depth < 0.0f || *pass.clear.depth > 1.0f) {
            report(findings, depth, "must lie within 0..1" + got(*pass.clear.depth));
        }
    }
    if (!pass.depth) {
        const Place state = place.field("state"), depth = state.field("depth");
        if (pass.state.depth.func != CompareFunc::Always) {
            report(findings, depth.field("func"),
                   "must be ALWAYS: the pass has no depth target" + got(pass.state.depth.func));
        }
        if (pass.state.depth.write) {
            report(findings, depth.field("write"), "must be false: the pass has no depth target");
        }
    }
}

void check_part(const PixelRect& part, const Target& target, const Place& place, Findings& findings) {
    if (part == PixelRect{}) return;
    const std::string got_part = " (got " + std::to_string(part.x0) + ' ' + std::to_string(part.y0) + ' ' +
                                 std::to_string(part.x1) + ' ' + std::to_string(part.y1) + ')';
    if (part.x0 >= part.x1 || part.y0 >= part.y1) {
        report(findings, place, "must have x0 < x1 and y0 < y1, or be all zeros for the whole target" + got_part);
    }
    if (part.x0 < 0 || part.y0 < 0 || part.x1 > target.width || part.y1 > target.height) {
        report(findings, place, "must lie within the target, " + size_text(target.width, target.height) + got_part);
    }
}

void check_stages(const PipelineState& state, const Place& place, Findings& findings) {
    bool ended = false;
    for (std::size_t i = 0; i < state.stages.size(); ++i) {
        const TextureStage& stage = state.stages[i];
        const Place here          = place.entry("stages", i);
        const bool color_is_off   = stage.color_op == TextureOp::Disable,
                   alpha_is_off   = stage.alpha_op == TextureOp::Disable;
        if (ended && !color_is_off) {
            report(findings, here.field("color_op"), "must be DISABLE: an earlier stage is" + got(stage.color_op));
        } else if (color_is_off && !alpha_is_off) {
            report(findings, here.field("alpha_op"), "must be DISABLE, as color_op is" + got(stage.alpha_op));
        } else if (!color_is_off && alpha_is_off) {
            report(findings, here.field("alpha_op"),
                   "must not be DISABLE while color_op is on: Direct3D 7 leaves that undefined; SELECTARG2 with "
                   "CURRENT keeps the alpha");
        }
        ended = ended || color_is_off;
    }
}

void check_blend(const Frame& frame, const PipelineState& state, const Place& place, Findings& findings) {
    const bool gs_blend = frame.arithmetic.blend == BlendRule::GsShift7;
    if (gs_blend && state.blend != BlendState{}) {
        report(findings, place.field("blend"), "must be left out with arithmetic.blend GS_SHIFT7: gs_blend says it");
    }
    if (!gs_blend && state.gs_blend != GsBlend{}) {
        report(findings, place.field("gs_blend"),
               "must be left out unless arithmetic.blend is GS_SHIFT7" + got(frame.arithmetic.blend));
    }
}

void check_dither(const Frame& frame, const Pass& pass, const Place& place, Findings& findings) {
    const DitherState& dither = pass.state.dither;
    for (std::size_t i = 0; i < dither.matrix.size(); ++i) {
        const std::int32_t offset = dither.matrix[i];
        if (offset < -4 || offset > 3) {
            report(findings, place.entry("matrix", i), "must lie within -4..3" + got(offset));
        }
    }
    const Place mode = place.field("mode");
    if (dither.mode == DitherMode::None) return;
    const bool gs_blend = frame.arithmetic.blend == BlendRule::GsShift7;
    if ((dither.mode == DitherMode::GsDimx) != gs_blend) {
        report(findings, mode,
               "must fit arithmetic.blend " + std::string(enum_name(frame.arithmetic.blend)) + got(dither.mode));
    }
    const Target* target = find_target(frame, pass.color);
    if (!pass.color) {
        report(findings, mode, "must be NONE: the pass has no colour target" + got(dither.mode));
    } else if (target != nullptr && keeps_bytes(target->format)) {
        report(findings, mode, "must be NONE: the target keeps whole bytes" + got(dither.mode));
    }
}

// What GS_SHIFT7 has no rule for.
void check_shift7_stages(const PipelineState& state, const Place& place, Findings& findings) {
    for (std::size_t i = 0; i < state.stages.size(); ++i) {
        const TextureStage& stage = state.stages[i];
        const Place here          = place.entry("stages", i);
        if (i > 0 && stage.color_op != TextureOp::Disable) {
            report(findings, here.field("color_op"),
                   "must be DISABLE: arithmetic.combine GS_SHIFT7 has one stage" + got(stage.color_op));
        }
        for (const auto& [name, op] : {std::pair{"color_op", stage.color_op}, std::pair{"alpha_op", stage.alpha_op}}) {
            if (!has_rule(CombineRule::GsShift7, op)) {
                report(findings, here.field(name), "must be an op that arithmetic.combine GS_SHIFT7 has" + got(op));
            }
        }
        for (const auto& [name, arg] :
             {std::pair{"color_arg1", stage.color_arg1}, std::pair{"color_arg2", stage.color_arg2},
              std::pair{"alpha_arg1", stage.alpha_arg1}, std::pair{"alpha_arg2", stage.alpha_arg2}}) {
            if (arg.complement) {
                const Place argument = here.field(name);
                report(findings, argument.field("complement"),
                       "must be false: arithmetic.combine GS_SHIFT7 has no complement");
            }
        }
    }
}

// What the frame's arithmetic has no rule for.
void check_arithmetic(const Frame& frame, const Pass& pass, const Place& place, Findings& findings) {
    check_blend(frame, pass.state, place, findings);
    check_dither(frame, pass, place.field("dither"), findings);
    if (frame.arithmetic.combine == CombineRule::GsShift7) check_shift7_stages(pass.state, place, findings);
    if (pass.state.dest_alpha_test != DestAlphaTest::Off && !pass.color) {
        report(findings, place.field("dest_alpha_test"),
               "must be OFF: the pass has no colour target" + got(pass.state.dest_alpha_test));
    }
}

void check_light(const Light& light, const Place& place, Findings& findings) {
    if (light.type != LightType::Point) return;
    if (light.range < 0.0f) report(findings, place.field("range"), "must be >= 0" + got(light.range));
    const Vec3& a = light.attenuation;
    if (a.x < 0.0f || a.y < 0.0f || a.z < 0.0f) {
        report(findings, place.field("attenuation"), "must not be negative" + got(a));
    } else if (a == Vec3(0.0f)) {
        report(findings, place.field("attenuation"), "must not be all zero: the light would be infinite");
    }
}

void check_lighting(const LightingState& lighting, const Place& place, Findings& findings) {
    if (lighting.lights.size() > static_cast<std::size_t>(kMaxLights)) {
        report(findings, place.field("lights"),
               "must be at most " + std::to_string(kMaxLights) + got(lighting.lights.size()));
    }
    for (std::size_t i = 0; i < lighting.lights.size(); ++i) {
        check_light(lighting.lights[i], place.entry("lights", i), findings);
    }
    if (lighting.material.power < 0.0f) {
        const Place material = place.field("material");
        report(findings, material.field("power"), "must be >= 0" + got(lighting.material.power));
    }
}

}  // namespace

void check_pass_state(const Frame& frame, const Pass& pass, const Place& place, Findings& findings) {
    check_targets(frame, pass, place, findings);
    check_clear_and_depth(pass, place, findings);

    const Place state      = place.field("state");
    const Target* drawn_to = find_target(frame, pass.color ? pass.color : pass.depth);
    if (drawn_to != nullptr) {
        check_part(pass.state.viewport, *drawn_to, state.field("viewport"), findings);
        check_part(pass.state.scissor, *drawn_to, state.field("scissor"), findings);
    }
    check_stages(pass.state, state, findings);
    check_arithmetic(frame, pass, state, findings);
    check_lighting(pass.state.lighting, state.field("lighting"), findings);
}

}  // namespace pipeline
