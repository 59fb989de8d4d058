// SPDX-License-Identifier: MIT
// nimbus7 plan: may a chip draw a scene's frame as it is, where would it lie in the chip's memory, what would it cost?
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "demo/scene.h"
#include "pipeline/profile/profile.h"

namespace demo {

enum class PlanFormat : std::uint8_t { Text, Json };

struct PlanOptions {
    std::string scene;
    const pipeline::Profile* profile = nullptr;
    std::optional<Size> size;
    int frame         = 0;
    PlanFormat format = PlanFormat::Text;
};

// What a chip cannot do; the whole list is printed already.
struct ChipCannot : std::exception {
    explicit ChipCannot(std::string text) : text_(std::move(text)) {}
    const char* what() const noexcept override { return text_.c_str(); }

  private:
    std::string text_;
};

// Prints the plan; then throws ChipCannot if the chip lacks something.
void report_plan(const PlanOptions& options);

}  // namespace demo
