// SPDX-License-Identifier: MIT
// The values of command line arguments. Errors are std::runtime_error and name the option: "--size 0x0: ...".
#pragma once

#include <string>

#include "demo/scene.h"

namespace demo {

inline constexpr int kMaxFrameNumber = 999999;
inline constexpr int kMaxThreads     = 1024;
inline constexpr int kMaxLimit       = 1000000;

// "1280x720"; each side 1 to pipeline::kMaxTargetSize.
Size parse_size(const std::string& text);

// Both ends belong to it.
struct FrameRange {
    int first = 0, last = 0;
    bool operator==(const FrameRange&) const = default;
};

// "3-7", or "5" for 5-5.
FrameRange parse_frames(const std::string& text);

// A whole number from `low` to `high`; `option` is the name for the error.
int parse_number(const std::string& option, const std::string& text, int low, int high);

// Does the file name have a run of '#', as in "f.####.png"?
bool has_frame_number(const std::string& pattern);

// The last such run replaced by the number, with zeros before it up to the length of the run: "f.0007.png".
std::string numbered_path(const std::string& pattern, int number);

}  // namespace demo
