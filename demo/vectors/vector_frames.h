// SPDX-License-Identifier: MIT
// The small frames of demo/frames as a profile's chip draws them. Frames whose name begins with a profile's name and
// "_" are that profile's alone; all others are put on its chip (chip_limits.h).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "demo/embedded_texts.h"
#include "pipeline/profile/profile.h"

namespace demo {

// what: the comment at the head of the file, on one line, without the ideal answer where that is another frame's.
// why_not: why the chip cannot draw it; empty if it can.
struct VectorFrame {
    std::string name, what;
    pipeline::Frame frame;
    std::string why_not;
};

// The profile that a frame's name begins with, or null.
const pipeline::Profile* owner_of(std::string_view frame_name);

// Of a profile, without the frames of other profiles. Throws std::runtime_error for a text that is no frame,
// std::logic_error for a frame that breaks a rule of validate but none of chip_limits.h.
std::vector<VectorFrame> vector_frames(const pipeline::Profile& profile, std::span<const EmbeddedText> texts);

// The frame as text, with `what` as a comment.
std::string text_of(const VectorFrame& frame);

}  // namespace demo
