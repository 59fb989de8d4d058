// SPDX-License-Identifier: MIT
#include "tests/extremes/extremes.h"

#include <cmath>

namespace extremes {

std::string count_text(std::uint64_t count) {
    std::string text = std::to_string(count);
    for (std::size_t end = text.size(); end > 3; end -= 3) text.insert(end - 3, ",");
    return text;
}

std::string ceil_text(double value, int decimals) {
    const double unit       = std::pow(10.0, decimals);
    const auto units        = static_cast<std::uint64_t>(std::ceil(value * unit));
    std::string text        = std::to_string(units);
    const auto least_digits = static_cast<std::size_t>(decimals) + 1;
    if (text.size() < least_digits) text.insert(0, least_digits - text.size(), '0');
    if (decimals > 0) text.insert(text.size() - static_cast<std::size_t>(decimals), ".");
    return text;
}

std::string table() {
    std::string text =
        "| case | range tried | bound | worst measured | where it ends |\n| --- | --- | --- | ---: | --- |\n";
    for (const auto rows : {&position_rows, &coverage_rows, &coordinate_rows, &size_rows, &depth_rows, &blend_rows,
                            &downsample_rows, &sphere_rows})
        for (const Row& row : rows())
            text +=
                "| " + row.what + " | " + row.range + " | " + row.bound + " | " + row.worst + " | " + row.end + " |\n";
    return text;
}

}  // namespace extremes
