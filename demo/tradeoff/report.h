// SPDX-License-Identifier: MIT
// A sweep in words and figures: CSV, Markdown, and a chart of time against error.
#pragma once

#include <string>

#include "demo/drawing.h"
#include "demo/tradeoff/sweep.h"

namespace demo {

// All settings, one line each below one of names; times in milliseconds, errors of 255, PSNR in dB ("inf" for equal
// pictures). RFC 4180, lines end with \n.
std::string to_csv(const Sweep& sweep);

// What is on a front, the slowest first, with times as ratios to exact.
std::vector<const MeasuredSetting*> front_of(const Sweep& sweep);

// These as a Markdown table, with the scene before each, so that the tables of several can be put together.
std::string to_markdown(const Sweep& sweep, const std::string& scene);

// Two panels: RMS error to the truth, and to the exact picture, over time as a ratio to exact. Settings on the panel's front
// are joined, and numbered in the order of front_of(); the numbers' names stand below.
Drawing to_chart(const Sweep& sweep, const std::string& title);

// "0.42", "inf"
std::string figure_text(double value, int decimals);

}  // namespace demo
