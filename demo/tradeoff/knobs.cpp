// SPDX-License-Identifier: MIT
#include "demo/tradeoff/knobs.h"

namespace demo {
namespace {

template <auto kMember, auto kValue>
void use_option(FrameOptions& options) {
    options.mega_particles.*kMember = kValue;
}
template <auto kMember, auto kValue>
constexpr KnobSetting option(std::string_view name) {
    return {.name = name, .change = &use_option<kMember, kValue>};
}

// Those that are on the front of one scene at least.
std::vector<Knob> make_knobs() {
    using Technique = cloud::MegaParticleOptions;
    return {
        {"target scale",
         {option<&Technique::target_scale, 2>("scale 1/2"), option<&Technique::target_scale, 4>("scale 1/4")}},
        {"sphere levels",
         {option<&Technique::fewer_sphere_levels, 1>("spheres -1"),
          option<&Technique::fewer_sphere_levels, 2>("spheres -2")}},
        {"skirt", {option<&Technique::skirt, false>("no skirt")}},
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

FrameOptions options_of(const Choice& choice, std::span<const Knob> knobs) {
    FrameOptions options;
    for (std::size_t i = 0; i < knobs.size(); ++i)
        if (choice[i] > 0) knobs[i].settings[choice[i] - 1].change(options);
    return options;
}

}  // namespace demo
