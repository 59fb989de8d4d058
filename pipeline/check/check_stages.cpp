// SPDX-License-Identifier: MIT
// Texture stages: how many, their arguments and functions, addressing and mip levels.
#include "pipeline/check/chip_findings.h"
#include "pipeline/check/target_use.h"

namespace pipeline {

namespace {

bool reads(TextureOp op, int argument) {
    return op != TextureOp::Disable && op != (argument == 1 ? TextureOp::SelectArg2 : TextureOp::SelectArg1);
}

void check_argument(const TextureArg& argument, const Place& place, ChipFindings& findings) {
    const ChipStates& states = findings.profile().states;
    if (!is_among(argument.source, states.arguments))
        findings.add(place.field("source"), "stages", text_of(argument.source), names_of(states.arguments));
    if (argument.complement && !states.complement) findings.add(place.field("complement"), "stages", "true", "false");
    if (argument.alpha_replicate && !states.alpha_replicate)
        findings.add(place.field("alpha_replicate"), "stages", "true", "false");
}

void check_arguments(const TextureStage& stage, const Place& place, ChipFindings& findings) {
    const auto check_one = [&](TextureOp op, int number, std::string_view name, const TextureArg& argument) {
        if (reads(op, number)) check_argument(argument, place.field(name), findings);
    };
    check_one(stage.color_op, 1, "color_arg1", stage.color_arg1);
    check_one(stage.color_op, 2, "color_arg2", stage.color_arg2);
    check_one(stage.alpha_op, 1, "alpha_arg1", stage.alpha_arg1);
    check_one(stage.alpha_op, 2, "alpha_arg2", stage.alpha_arg2);
}

// What the Graphics Synthesizer's TFX and TCC can say: each function of colour, with the functions of alpha that go
// with it. Without TEXTURE in either, texturing is off.
enum class GsSource { Other, Vertex, Texel };
GsSource selected(TextureOp op, const TextureArg& arg1, const TextureArg& arg2) {
    if (op != TextureOp::SelectArg1 && op != TextureOp::SelectArg2) return GsSource::Other;
    const ArgSource source = (op == TextureOp::SelectArg1 ? arg1 : arg2).source;
    return source == ArgSource::Texture ? GsSource::Texel : GsSource::Vertex;
}
bool is_gs_function(const TextureStage& stage) {
    const GsSource color = selected(stage.color_op, stage.color_arg1, stage.color_arg2),
                   alpha = selected(stage.alpha_op, stage.alpha_arg1, stage.alpha_arg2);
    if (color == GsSource::Vertex) return alpha == GsSource::Vertex;
    if (color == GsSource::Texel) return alpha != GsSource::Other;  // DECAL
    const auto is_of_both = [](const TextureArg& one, const TextureArg& other) {
        return (one.source == ArgSource::Texture) != (other.source == ArgSource::Texture);
    };
    if (!is_of_both(stage.color_arg1, stage.color_arg2)) return false;
    const bool alphas_meet = is_of_both(stage.alpha_arg1, stage.alpha_arg2);
    if (stage.color_op == TextureOp::Modulate)
        return alpha == GsSource::Vertex || (stage.alpha_op == TextureOp::Modulate && alphas_meet);
    // HIGHLIGHT adds the vertex's alpha; HIGHLIGHT2 has the texel's alpha.
    return stage.color_op == TextureOp::ModulateColorAddAlpha && stage.color_arg2.source == ArgSource::Texture &&
           (alpha != GsSource::Other || (stage.alpha_op == TextureOp::Add && alphas_meet));
}

std::string functions_of(CombineRule rule) {
    std::vector<TextureOp> ops = all_of<TextureOp>();
    std::erase_if(ops, [&](TextureOp op) { return !has_rule(rule, op); });
    return names_of(ops);
}

// "color_op MODULATE alpha_op ADD alpha_arg2 { source DIFFUSE }"
std::string function_text(const TextureStage& stage) {
    std::string text;
    visit_pairs(stage, TextureStage{}, [&](std::string_view name, const auto& field, const auto& plain) {
        using Field = std::remove_cvref_t<decltype(field)>;
        std::string value;
        if constexpr (std::same_as<Field, TextureOp>) value = text_of(field);
        if constexpr (std::same_as<Field, TextureArg>)
            if (field != plain) value = "{ " + differing_fields(field, plain) + " }";
        if (!value.empty()) text += (text.empty() ? "" : " ") + std::string(name) + ' ' + value;
    });
    return text;
}

void check_functions(const TextureStage& stage, const Place& place, ChipFindings& findings) {
    const CombineRule rule = findings.profile().arithmetic.combine;
    const bool has_color = has_rule(rule, stage.color_op), has_alpha = has_rule(rule, stage.alpha_op);
    if (!has_color) findings.add(place.field("color_op"), "stages", text_of(stage.color_op), functions_of(rule));
    if (!has_alpha) findings.add(place.field("alpha_op"), "stages", text_of(stage.alpha_op), functions_of(rule));
    if (has_color && has_alpha && rule == CombineRule::GsShift7 && !is_gs_function(stage))
        findings.add(place, "stages", function_text(stage), "MODULATE DECAL HIGHLIGHT HIGHLIGHT2");
}

// What is bound to a stage by any draw.
struct Bound {
    bool anything = false, mip_levels = false;
};
Bound bound_to(const Frame& frame, const Pass& pass, std::size_t stage) {
    Bound bound;
    for_each_texture(pass, [&](std::size_t, std::size_t of_stage, const TextureBinding& binding) {
        if (of_stage != stage) return;
        const Texture* texture = find_texture(frame, binding.texture);
        bound.anything         = true;
        bound.mip_levels       = bound.mip_levels || (texture != nullptr && texture->levels > 1);
    });
    return bound;
}

void check_sampling(const TextureStage& stage, const Bound& bound, const Place& place, ChipFindings& findings) {
    const ChipStates& states = findings.profile().states;
    if (bound.anything && !is_among(stage.address_u, states.addresses))
        findings.add(place.field("address_u"), "stages", text_of(stage.address_u), names_of(states.addresses));
    if (bound.anything && !is_among(stage.address_v, states.addresses))
        findings.add(place.field("address_v"), "stages", text_of(stage.address_v), names_of(states.addresses));
    if (bound.mip_levels && !is_among(stage.mip_filter, states.mip_filters))
        findings.add(place.field("mip_filter"), "lod", text_of(stage.mip_filter), names_of(states.mip_filters));
}

}  // namespace

void check_stages(const Frame& frame, const Pass& pass, const Place& place, ChipFindings& findings) {
    if (!draws(pass)) return;
    const Place state = place.field("state");
    const int count = stage_count(pass.state), has = findings.profile().states.stages;
    if (count > has) findings.add(state.field("stages"), "stages", std::to_string(count), std::to_string(has));
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const TextureStage& stage = pass.state.stages[i];
        const Place here          = state.entry("stages", i);
        check_arguments(stage, here, findings);
        check_functions(stage, here, findings);
        check_sampling(stage, bound_to(frame, pass, i), here, findings);
    }
}

}  // namespace pipeline
