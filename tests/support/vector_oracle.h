// SPDX-License-Identifier: MIT
// What the arrays of `nimbus7 vectors` must hold, from the words of their rules in whole numbers and fractions: a third
// telling beside the kernels and raster/reference, and free of both.
#pragma once

#include <map>
#include <string>

namespace test_support {

// An entry's place: the value of each axis; names and numbers (a func, a format, a depth) stand in `text` and `real`.
struct VectorPlace {
    std::map<std::string, int> number;
    std::map<std::string, std::string> text;
    std::map<std::string, double> real;
};

// Of the array `name` (the file without .npy), whose manifest entry says `rule` and `what`. Throws std::runtime_error
// for one that it does not know.
int expected_entry(const std::string& name, const std::string& rule, const std::string& what, const VectorPlace& at);

}  // namespace test_support
