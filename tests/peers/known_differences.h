// SPDX-License-Identifier: MIT
// Differences that are a driver's own, from tests/known_differences.txt. One a line, blank lines and # comments
// aside:
//   <frame> <driver> <pixels> <units>  <reason>
// allows at most `pixels` pixels of the frame to fail, by at most `units` of 255. An entry whose frame passes without
// it is stale, and an error, so the list cannot outlive its reasons.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tests/peers/compare.h"

namespace peers {

struct KnownDifference {
    std::string frame, driver;
    std::uint64_t pixels = 0;
    int units            = 0;
    std::string reason;
};

// Throws std::runtime_error with the line for a file that is not there or a line that is not of this form.
std::vector<KnownDifference> read_known_differences(const std::string& path);
std::vector<KnownDifference> parse_known_differences(const std::string& text, const std::string& path);

enum class Verdict { Ok, Known, Stale, Failed };
Verdict judge(const Comparison& comparison, const KnownDifference* known);

}  // namespace peers
