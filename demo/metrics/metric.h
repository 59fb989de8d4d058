// SPDX-License-Identifier: MIT
// A figure about a picture, and what it should be. Figures are reports: a missed target is no error.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace demo {

// Both ends belong to it.
struct Target {
    double low  = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
};
constexpr Target at_most(double high) {
    return {.high = high};
}

enum class Verdict { Ok, Missed, NoTarget, NotApplicable };

// key: "M1.cut_share", the name in JSON. value: none where the picture has nothing to measure it at. unit: "" for a
// ratio, "%" for a value that is a share times 100, "/255" for steps of a byte, and so on.
struct Metric {
    std::string key, what, unit;
    std::optional<double> value;
    std::optional<Target> target;

    Verdict verdict() const {
        if (!value) return Verdict::NotApplicable;
        if (!target) return Verdict::NoTarget;
        return *value >= target->low && *value <= target->high ? Verdict::Ok : Verdict::Missed;
    }
};
using Metrics = std::vector<Metric>;

}  // namespace demo
