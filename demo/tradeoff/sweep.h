// SPDX-License-Identifier: MIT
// A scene's frame drawn with one setting of its knobs after the other, and with combinations of those that pay: how long
// each takes, and how far its picture is from the truth and from the exact picture.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "demo/scene.h"
#include "demo/tradeoff/knobs.h"
#include "demo/tradeoff/picture_error.h"

namespace demo {

inline constexpr int kMaxRuns = 1000;

// runs: those that count, each of all settings in turn; one more comes before them and does not count. threads: 0: all cores.
struct SweepOptions {
    Size size   = {640, 360};
    int frame   = 0;
    int runs    = 7;
    int threads = 1;
};

// Draws what a frame stands for, without rounding.
using DrawTruth = std::function<RealPicture(const pipeline::Frame&)>;

// Time is that of execute() alone, of a frame that was drawn just before as well; with one thread the processor's for it, which other programs do not lengthen by theirs.
// milliseconds: the median. ratio: the median of the times over those of the exact frame
// beside it, which a machine that is busy for a while slows alike; ratio_low, ratio_high: their quartiles.
// name: "(fast)" follows what --precision fast means.
// on_truth_front, on_exact_front: is no other both faster and nearer to the truth, or to the exact picture? Only what is
// faster than exact by more than Sweep::noise counts.
struct MeasuredSetting {
    Choice choice;
    std::string name;
    double milliseconds = 0.0, ratio = 1.0, ratio_low = 1.0, ratio_high = 1.0;
    PictureError to_truth, to_exact;
    bool on_truth_front = false, on_exact_front = false;
    pipeline::ColorImage picture;

    bool on_a_front() const { return on_truth_front || on_exact_front; }
};

// settings: the exact one first. noise: of a ratio, two standard errors of the median, from the exact frame over itself. without_effect: settings that leave the scene's frame as it is.
struct Sweep {
    SweepOptions options;
    std::vector<MeasuredSetting> settings;
    double noise = 0.0;
    std::vector<std::string> without_effect;
    RealPicture truth;
};

Sweep sweep(const Scene& scene, const SweepOptions& options, std::span<const Knob> knobs, const DrawTruth& draw_truth);

// Sets on_truth_front and on_exact_front.
void mark_fronts(Sweep& sweep);

// Those to measure next: all combinations of settings that pay, if they are few, or else what is on a front with one more
// of them. Only new ones; empty at the end.
std::vector<Choice> next_combinations(const Sweep& sweep, std::span<const Knob> knobs);

}  // namespace demo
