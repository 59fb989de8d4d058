// SPDX-License-Identifier: MIT
// What a scene's picture can be drawn with for less time than exactly: knobs, each with settings that change how the
// frame is made. All that they change stands in the frame.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "demo/scene.h"

namespace demo {

struct KnobSetting {
    std::string_view name;
    void (*change)(FrameOptions&);
};

// The exact setting is not among them.
struct Knob {
    std::string_view name;
    std::vector<KnobSetting> settings;
};
std::span<const Knob> knobs();

// One setting of each knob, in the order of knobs(): 0 exact, else counted from 1.
using Choice = std::vector<std::size_t>;
Choice exact_choice(std::span<const Knob> knobs);

// "scale 1/2 + spheres -1"; "exact".
std::string name_of(const Choice& choice, std::span<const Knob> knobs);

FrameOptions options_of(const Choice& choice, std::span<const Knob> knobs);

}  // namespace demo
