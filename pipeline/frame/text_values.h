// SPDX-License-Identifier: MIT
// Single values as text, appended to a string. Numbers take their shortest form that reads back to the same bits.
#pragma once

#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>

#include "pipeline/frame/field_traits.h"

namespace pipeline {

template <class Number>
requires std::is_arithmetic_v<Number>
void append_value(std::string& out, Number value) {
    if constexpr (std::same_as<Number, bool>) {
        out += value ? "true" : "false";
    } else {
        char digits[32];
        out.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
    }
}

// "quoted", with \" \\ \n \t \r and \x7f for what would not show.
void append_value(std::string& out, const std::string& value);

// 0xAARRGGBB
void append_value(std::string& out, Argb value);

// By name; a value that no name belongs to as #200, so that even a broken frame can be shown.
template <NamedEnum Enum>
void append_value(std::string& out, Enum value) {
    const auto number = static_cast<std::size_t>(value);
    if (number < EnumNames<Enum>::names.size()) {
        out += enum_name(value);
    } else {
        out += '#';
        append_value(out, number);
    }
}

// (x y z)
template <glm::length_t count>
void append_value(std::string& out, const glm::vec<count, float>& value) {
    for (glm::length_t i = 0; i < count; ++i) {
        out += i == 0 ? '(' : ' ';
        append_value(out, value[i]);
    }
    out += ')';
}

// Two digits a byte.
void append_hex(std::string& out, const std::uint8_t* bytes, std::size_t count);

// Row `row` of a matrix as it is written on paper.
inline Vec4 matrix_row(const Mat4& matrix, int row) {
    return {matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row]};
}

}  // namespace pipeline
