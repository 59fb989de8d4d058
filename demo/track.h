// SPDX-License-Identifier: MIT
// A value that changes over time, given at some times: rising seconds, at least one. Before the first and after the
// last it stands still.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace demo {

// T: added, and multiplied by a float.
template <class T>
class Track {
  public:
    void add(double seconds, const T& value) {
        seconds_.push_back(seconds);
        values_.push_back(value);
    }
    bool empty() const { return values_.empty(); }
    double last_seconds() const { return seconds_.empty() ? 0.0 : seconds_.back(); }

    // Straight from key to key.
    T linear(double seconds) const {
        const Place at = place(seconds);
        return value(at.key) * (1.0f - at.share) + value(at.key + 1) * at.share;
    }

    // Through the keys without a corner: cubic Hermite, with the slope at a key that of the straight line between its
    // neighbours (Catmull-Rom, for times that need not be even).
    T smooth(double seconds) const {
        const Place at = place(seconds);
        const float t = at.share, t2 = t * t, t3 = t2 * t;
        const auto span = static_cast<float>(time(at.key + 1) - time(at.key));
        return value(at.key) * (2.0f * t3 - 3.0f * t2 + 1.0f) + slope(at.key) * (span * (t3 - 2.0f * t2 + t)) +
               value(at.key + 1) * (3.0f * t2 - 2.0f * t3) + slope(at.key + 1) * (span * (t3 - t2));
    }

  private:
    struct Place {
        std::size_t key;  // the last at or before the time
        float share;      // of the way to the next
    };
    Place place(double seconds) const {
        const auto after = std::upper_bound(seconds_.begin(), seconds_.end(), seconds) - seconds_.begin();
        if (after == 0) return {0, 0.0f};
        const auto key = static_cast<std::size_t>(after) - 1;
        if (key + 1 == seconds_.size()) return {key, 0.0f};
        return {key, static_cast<float>((seconds - seconds_[key]) / (seconds_[key + 1] - seconds_[key]))};
    }
    std::size_t clamped(std::size_t key) const { return std::min(key, values_.size() - 1); }
    const T& value(std::size_t key) const { return values_[clamped(key)]; }
    double time(std::size_t key) const { return seconds_[clamped(key)]; }
    T slope(std::size_t key) const {
        const std::size_t before = key == 0 ? 0 : key - 1, after = clamped(key + 1);
        const double span = time(after) - time(before);
        return span > 0.0 ? (value(after) - value(before)) * static_cast<float>(1.0 / span) : value(key) * 0.0f;
    }

    std::vector<double> seconds_;
    std::vector<T> values_;
};

}  // namespace demo
