// SPDX-License-Identifier: MIT
// How far the numbers go. Each theme measures one kind of extreme with a function that the theme's tests check against
// its bound, and of which the table (nimbus7_extremes) prints a row. What is measured is the same on every machine.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace extremes {

// A row of the table: what was tried, over which range, what the rules allow at worst, what was found, and where it ends.
struct Row {
    std::string what, range, bound, worst, end;
};

// One theme each.
std::vector<Row> position_rows();
std::vector<Row> coverage_rows();
std::vector<Row> coordinate_rows();
std::vector<Row> size_rows();
std::vector<Row> depth_rows();
std::vector<Row> blend_rows();
std::vector<Row> downsample_rows();
std::vector<Row> sphere_rows();

// All of them, in Markdown.
std::string table();

// Whole numbers with commas; others with so many decimals, rounded away from what is good.
std::string count_text(std::uint64_t count);
std::string ceil_text(double value, int decimals);

}  // namespace extremes
