// SPDX-License-Identifier: MIT
// What is not known exactly: the least and the most that it may be. least <= most.
#pragma once

#include <algorithm>

namespace pipeline {

struct Range {
    double least = 0.0, most = 0.0;

    Range& operator+=(const Range& more) {
        least += more.least;
        most += more.most;
        return *this;
    }
    friend Range operator+(Range a, const Range& b) { return a += b; }
    friend Range operator*(const Range& a, double factor) { return {a.least * factor, a.most * factor}; }
    bool operator==(const Range&) const = default;
};

constexpr Range exactly(double value) {
    return {value, value};
}
// Of two that go on at the same time.
constexpr Range slower(const Range& a, const Range& b) {
    return {std::max(a.least, b.least), std::max(a.most, b.most)};
}

}  // namespace pipeline
