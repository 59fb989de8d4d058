// SPDX-License-Identifier: MIT
#include "demo/tradeoff/knobs.h"

#include "pipeline/legalize/alpha_use.h"

namespace demo {
namespace {

using namespace pipeline;

// Targets with alpha that something reads, as a cloud's, stay: 16 bits would leave it one.
void use_16_bit_colors(Frame& frame) {
    for (std::size_t i = 0; i < frame.targets.size(); ++i) {
        Target& target = frame.targets[i];
        if (!is_depth(target.format) && !is_alpha_read(frame, {static_cast<std::int32_t>(i)}))
            target.format = TargetFormat::R5G6B5;
    }
}

void use_16_bit_depth(Frame& frame) {
    for (Target& target : frame.targets)
        if (is_depth(target.format)) target.format = TargetFormat::D16;
}

void use_nearest_mips(Frame& frame) {
    for (Pass& pass : frame.passes)
        for (TextureStage& stage : pass.state.stages)
            if (stage.mip_filter == MipFilter::Linear) stage.mip_filter = MipFilter::Point;
}

template <auto kMember, auto kRule>
void use_rule(Frame& frame) {
    frame.arithmetic.*kMember = kRule;
}
template <auto kMember, auto kRule>
constexpr KnobSetting rule(std::string_view name) {
    return {.name = name, .change_frame = &use_rule<kMember, kRule>};
}

template <auto kMember, auto kValue>
void use_option(FrameOptions& options) {
    options.mega_particles.*kMember = kValue;
}
template <auto kMember, auto kValue>
constexpr KnobSetting option(std::string_view name) {
    return {.name = name, .change_options = &use_option<kMember, kValue>};
}

std::vector<Knob> make_knobs() {
    using Technique = cloud::MegaParticleOptions;
    return {
        {"target scale",
         {option<&Technique::target_scale, 2>("scale 1/2"), option<&Technique::target_scale, 4>("scale 1/4")}},
        {"blur levels",
         {option<&Technique::blur_levels, -1>("levels -1"), option<&Technique::blur_levels, 1>("levels +1")}},
        {"blur rise", {option<&Technique::blur_rise, cloud::BlurRise::Jump>("rise JUMP")}},
        {"sphere levels",
         {option<&Technique::sphere_levels, -1>("spheres -1"), option<&Technique::sphere_levels, -2>("spheres -2"),
          option<&Technique::sphere_levels, 1>("spheres +1")}},
        {"fractal boxes",
         {option<&Technique::fractal_boxes, 1>("one box"), option<&Technique::fractal_boxes, 2>("two boxes")}},
        {"skirt", {option<&Technique::skirt, false>("no skirt")}},
        {"color bits", {{.name = "R5G6B5", .change_frame = &use_16_bit_colors}}},
        {"depth bits", {{.name = "D16", .change_frame = &use_16_bit_depth}}},
        {"mip filter", {{.name = "mips POINT", .change_frame = &use_nearest_mips}}},
        {"bilinear weights",
         {rule<&Arithmetic::filter, FilterRule::GsFloor4>("filter GS_FLOOR4"),
          rule<&Arithmetic::filter, FilterRule::GsNearest4>("filter GS_NEAREST4"),
          rule<&Arithmetic::filter, FilterRule::FlipperFloor7>("filter FLIPPER_FLOOR7"),
          rule<&Arithmetic::filter, FilterRule::Nv2aHalfUp8>("filter NV2A_HALFUP8")}},
        {"interpolated colors", {rule<&Arithmetic::gouraud, GouraudRule::Floor>("gouraud FLOOR")}},
        {"combiners", {rule<&Arithmetic::combine, CombineRule::Tev>("combine TEV")}},
        {"fog",
         {rule<&Arithmetic::fog, FogRule::GsFloor256>("fog GS_FLOOR256"),
          rule<&Arithmetic::fog, FogRule::GsTwoFloors>("fog GS_TWO_FLOORS"),
          rule<&Arithmetic::fog, FogRule::FlipperFloor256>("fog FLIPPER_FLOOR256")}},
        {"blends", {rule<&Arithmetic::blend, BlendRule::FlipperTrunc256>("blend FLIPPER_TRUNC256")}},
    };
}

}  // namespace

std::span<const Knob> knobs() {
    static const std::vector<Knob> all = make_knobs();
    return all;
}

Choice exact_choice(std::span<const Knob> knobs) {
    return Choice(knobs.size(), 0);
}

std::string name_of(const Choice& choice, std::span<const Knob> knobs) {
    std::string name;
    for (std::size_t i = 0; i < knobs.size(); ++i) {
        if (choice[i] == 0) continue;
        name += (name.empty() ? "" : " + ") + std::string(knobs[i].settings[choice[i] - 1].name);
    }
    return name.empty() ? "exact" : name;
}

FrameOptions options_of(const Choice& choice, std::span<const Knob> knobs, FrameOptions options) {
    for (std::size_t i = 0; i < knobs.size(); ++i) {
        if (choice[i] == 0) continue;
        if (const auto change = knobs[i].settings[choice[i] - 1].change_options) change(options);
    }
    return options;
}

void change_frame(pipeline::Frame& frame, const Choice& choice, std::span<const Knob> knobs) {
    for (std::size_t i = 0; i < knobs.size(); ++i) {
        if (choice[i] == 0) continue;
        if (const auto change = knobs[i].settings[choice[i] - 1].change_frame) change(frame);
    }
}

}  // namespace demo
