// SPDX-License-Identifier: MIT
// Rows of text in columns, two blanks apart.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace demo {

using TextRow = std::vector<std::string>;

// Rows may be shorter than the first. columns: for each whether its text begins at its left edge ('l') or ends at
// its right ('r'); the last letter stands for the columns after it. Lines have no blanks at their end.
std::string text_table(const std::vector<TextRow>& rows, std::string_view columns);

// 1234567 as 1,234,567.
std::string with_separators(std::uint64_t value);

}  // namespace demo
