// SPDX-License-Identifier: MIT
// Wrong frames, to show that the comparison sees what is wrong: one side is given a frame with one mistake in it, and
// must not agree with the other. Each is as small as its kind can be and still more than rounding.
#pragma once

#include <span>
#include <string_view>

#include "pipeline/frame/frame.h"

namespace peers {

struct Mistake {
    std::string_view name;
    void (*make)(pipeline::Frame& frame);  // leaves a frame alone that has nothing to get wrong
    bool is_ours = false;                  // in what we draw; else in what the peer draws
};

std::span<const Mistake> mistakes();

}  // namespace peers
