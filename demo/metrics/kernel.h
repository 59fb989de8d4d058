// SPDX-License-Identifier: MIT
// M4: the blur's kernel. It is measured in double precision; M0 holds the bytes to that. A blit treats rows and columns
// alike, so a kernel is the product of two of one dimension, and those are what is measured.
#pragma once

#include <span>
#include <vector>

#include "demo/metrics/grid.h"
#include "pipeline/frame/frame.h"

namespace demo {

// What becomes of one bright column, for each place that the column can have in a cell of the coarsest level: as many
// responses as a cell is wide, all of one length, with the column at the middle (size() / 2) of each.
using Responses = std::vector<std::vector<double>>;

// Of passes that are blits (blits.h), from the target `image` and back to it. They are run far from any border, without
// scissors. levels: how often they halve.
Responses column_responses(const pipeline::Frame& frame, std::span<const pipeline::Pass> blits,
                           pipeline::TargetId image, int levels);

// sigma_px: about the place of the column, mean over all places. sigma_variation: its standard deviation over its mean.
// anisotropy: greatest variance along an axis over the smallest, of one kernel. energy_error: greatest |sum - 1|.
// phase_error: greatest half sum of |kernel - mean kernel|.
struct KernelFigures {
    double sigma_px = 0.0, sigma_variation = 0.0, anisotropy = 1.0, energy_error = 0.0, phase_error = 0.0;
};
KernelFigures kernel_figures(const Responses& responses);

// Mean |second difference| in the columns and rows on both sides of a cell's border, over that elsewhere; 1 without
// blocks, and in a plane without any bend.
double blockiness(const Plane& plane, int cell);

}  // namespace demo
