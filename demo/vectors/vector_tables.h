// SPDX-License-Identifier: MIT
// The golden vectors of a profile's rules: for each rule an array of bytes over all that goes into it. No value is
// computed here: each is drawn, by pipeline::execute on a frame made for it (vector_probe.h), so it is what the
// program does.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "pipeline/profile/profile.h"

namespace demo {

// Whole numbers, both ends included.
struct AxisRange {
    int first = 0, last = 255;
};
struct Axis {
    std::string name;
    std::variant<AxisRange, std::vector<int>, std::vector<double>, std::vector<std::string>> values;
};
std::size_t axis_size(const Axis& axis);

using Bytes = std::vector<std::uint8_t>;

struct VectorTable {
    std::string name;          // of the file, without .npy
    std::string topic;         // of the profile's evidence
    std::string rule;          // the enumerators at work
    std::string what;          // which states and targets were drawn with
    std::string expression;    // a value of the array, in the names of the axes
    std::string_view formula;  // of the rule, in words
    std::vector<Axis> axes;    // the last is the fastest
    std::function<Bytes()> draw;
};

class Prober;  // outlives the tables

std::vector<VectorTable> vector_tables(const pipeline::Profile& profile, Prober& prober);

// Its parts.
void add_blend_tables(const pipeline::Profile& profile, Prober& prober, std::vector<VectorTable>& tables);
void add_gs_blend_tables(const pipeline::Profile& profile, Prober& prober, std::vector<VectorTable>& tables);
void add_store_tables(const pipeline::Profile& profile, Prober& prober, std::vector<VectorTable>& tables);
void add_texture_tables(const pipeline::Profile& profile, Prober& prober, std::vector<VectorTable>& tables);
void add_fog_tables(const pipeline::Profile& profile, Prober& prober, std::vector<VectorTable>& tables);
void add_test_tables(const pipeline::Profile& profile, Prober& prober, std::vector<VectorTable>& tables);

std::string lower_case(std::string_view text);

}  // namespace demo
