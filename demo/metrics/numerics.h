// SPDX-License-Identifier: MIT
// M0: bytes against double precision, at the extremes. Blurs run here on pictures of their own, on a small frame.
#pragma once

#include <cstdint>
#include <vector>

#include "cloud/mega_particles/blur_plan.h"
#include "pipeline/execute/execute.h"
#include "pipeline/frame/frame.h"

namespace demo {

// Shows the picture in the frame's output target, of A8R8G8B8, and blurs it there by the plan's chain.
pipeline::Frame blurred_picture(const cloud::BlurPlan& plan, const pipeline::ColorImage& picture);

// One channel: 0 blue .. 3 alpha.
int channel_of(std::uint32_t argb, int channel);

// Greatest difference of any byte from `value`.
int change_of_constant(const cloud::BlurPlan& plan, int width, int height, int value);

// worst, rms: of each byte that a blit writes against the same blit of the same bytes in double, in steps of a byte.
// drift: |mean difference| of the finished picture from the whole chain in double, in steps of a byte, over the number
// of blits.
struct BlurErrors {
    double worst = 0.0, rms = 0.0, drift = 0.0;
};
BlurErrors blur_errors(const cloud::BlurPlan& plan, const pipeline::ColorImage& picture);

// `count` layers of all kinds of colour and alpha over each other (SRCALPHA, INVSRCALPHA): the greatest difference from
// double precision, in steps of a byte, over the number of layers.
double blend_drift(int count);

// Bytes of all values in no order.
pipeline::ColorImage noise_picture(int width, int height);

}  // namespace demo
