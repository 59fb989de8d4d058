// SPDX-License-Identifier: MIT
// nimbus7 requires: what a scene's frames need of a chip or of a program that draws them, and nothing else.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "demo/arguments.h"
#include "pipeline/profile/profile.h"

namespace demo {

enum class RequiresFormat : std::uint8_t { Text, Json };

// profiles: one report for each, of the frames rewritten for its chip.
struct RequiresOptions {
    std::string scene;  // as FrameSource takes it
    std::optional<Size> size;
    FrameRange frames;
    std::vector<const pipeline::Profile*> profiles;
    RequiresFormat format = RequiresFormat::Text;
};

// Prints the reports; then throws ChipCannot if a chip lacks something for a frame.
void report_requirements(const RequiresOptions& options);

}  // namespace demo
