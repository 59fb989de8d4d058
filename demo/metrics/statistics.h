// SPDX-License-Identifier: MIT
// Sums over measured values, in double and in the order given. All are 0 without values.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace demo {

inline double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (double value : values) sum += value;
    return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

// The root of the mean square.
inline double rms(const std::vector<double>& values) {
    double sum = 0.0;
    for (double value : values) sum += value * value;
    return values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values.size()));
}

// Standard deviation over mean.
inline double variation(const std::vector<double>& values) {
    const double middle = mean(values);
    double sum          = 0.0;
    for (double value : values) sum += (value - middle) * (value - middle);
    return middle != 0.0 ? std::sqrt(sum / static_cast<double>(values.size())) / std::abs(middle) : 0.0;
}

// share: 0 for the least, 0.5 for the median, 1 for the greatest.
inline double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

// Pearson's, of equally many values; 0 where one side does not vary.
inline double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    const double mean_a = mean(a), mean_b = mean(b);
    double ab = 0.0, aa = 0.0, bb = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ab += (a[i] - mean_a) * (b[i] - mean_b);
        aa += (a[i] - mean_a) * (a[i] - mean_a);
        bb += (b[i] - mean_b) * (b[i] - mean_b);
    }
    return aa > 0.0 && bb > 0.0 ? ab / std::sqrt(aa * bb) : 0.0;
}

}  // namespace demo
