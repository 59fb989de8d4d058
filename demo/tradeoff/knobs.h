// SPDX-License-Identifier: MIT
// What a scene's picture can be drawn with for less time than exactly: knobs, each with settings that change how the
// frame is made, or the frame that is made. All that they change stands in the frame in the end.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "demo/scene.h"
#include "pipeline/frame/frame.h"

namespace demo {

// Either function may be null.
struct KnobSetting {
    std::string_view name;
    void (*change_options)(FrameOptions&)  = nullptr;
    void (*change_frame)(pipeline::Frame&) = nullptr;
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

FrameOptions options_of(const Choice& choice, std::span<const Knob> knobs, FrameOptions options = {});
void change_frame(pipeline::Frame& frame, const Choice& choice, std::span<const Knob> knobs);

}  // namespace demo
