// SPDX-License-Identifier: MIT
// Pieces of C++ text. Numbers take their shortest form that reads back to the same bits.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "pipeline/frame/frame.h"

namespace pipeline::dx7 {

std::string literal(float value);            // 0.5f
std::string literal(Argb color);             // 0x80ffffff
std::string literal(std::string_view text);  // "with \" and \\ escaped"

// 1.0f, 0.5f, 0.0f
std::string list_of(std::initializer_list<float> values);
std::string list_of(const Mat4& matrix);  // sixteen, as D3DMATRIX has them

// A name between quotes, for a comment: in one line, and not joined to the next by a backslash.
std::string quoted(std::string_view name);

// The API's constants end in the names that the frame has: D3DCMP_LESSEQUAL.
template <NamedEnum Enum>
std::string constant(std::string_view prefix, Enum value) {
    return std::string(prefix) + std::string(enum_name(value));
}

}  // namespace pipeline::dx7
