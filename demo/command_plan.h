// SPDX-License-Identifier: MIT
// nimbus7 plan: a scene's frame rewritten for a chip, what the chip still lacks, where all lies in its memory, what it costs.
#pragma once

#include <cstdint>
#include <exception>
#include <optional>
#include <string>
#include <utility>

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
