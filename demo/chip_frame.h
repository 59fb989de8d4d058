// SPDX-License-Identifier: MIT
// A scene's frame rewritten for a chip, as the scene has it or reduced until it fits.
#pragma once

#include <exception>
#include <optional>
#include <string>
#include <utility>

#include "demo/frame_source.h"
#include "pipeline/cost/cost.h"
#include "pipeline/legalize/legalize.h"

namespace demo {

// What a chip cannot do. The message is one line; `details` is the whole list, empty if it has been printed already.
class ChipCannot : public std::exception {
  public:
    explicit ChipCannot(std::string text, std::string details = {})
        : text_(std::move(text)), details_(std::move(details)) {}
    const char* what() const noexcept override { return text_.c_str(); }
    const std::string& details() const { return details_; }

  private:
    std::string text_, details_;
};

// reduce: until nothing is lacking and the least time is that of a sixtieth of a second.
struct ChipFrameOptions {
    std::string scene;  // as FrameSource takes it
    const pipeline::Profile* profile = nullptr;
    std::optional<Size> size;  // else the scene's
    int frame = 0;
    FrameOptions changes;  // of how the scene draws its clouds
    int halvings = 0;      // of textures
    bool reduce  = false;
};

// What was given up so that it fits: the picture's size, and how often textures lost half of theirs.
struct Reduction {
    Size size, from;
    int halvings = 0;
};

struct ChipFrame {
    pipeline::LegalFrame legal;
    std::optional<pipeline::FrameCost> cost;  // none of a profile that is no chip
    std::optional<Reduction> reduction;       // none if not asked for
};

// With `reduce` the largest picture, in sixteenths of the size, down to a half, that fits with textures halved at most twice, and
// of these the largest textures. The last attempt if none fits: see `legal.left`.
ChipFrame make_chip_frame(const FrameSource& source, const ChipFrameOptions& options);

// Its frame, if the chip can draw it; else throws ChipCannot with the list of what it lacks. What it was reduced to stands in
// `options` then, so that further frames of an animation are like it.
pipeline::LegalFrame drawable_chip_frame(const FrameSource& source, ChipFrameOptions& options);

// "576x400 in place of 640x448, textures halved once"
std::string reduction_text(const Reduction& reduction);

// A line for each kind of finding, with where it is and what the rules rest on. Empty if there is none.
std::string findings_text(const std::vector<pipeline::ChipFinding>& findings, const pipeline::Profile& profile);

}  // namespace demo
