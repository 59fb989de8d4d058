// SPDX-License-Identifier: MIT
// The conventions by which plain structs of the frame can be walked: every struct has one visit_fields(), which
// names each of its fields once, and every enum has one EnumNames table. The text form, the parser, the diff and
// the random-frame generator are all written against these two and know no field by name.
#pragma once

#include <array>
#include <concepts>
#include <string_view>
#include <type_traits>

namespace pipeline {

// Specialise with `static constexpr std::array<std::string_view, N> names`, one name per enumerator from 0 up.
template <class Enum>
struct EnumNames;

template <class Enum>
concept NamedEnum = std::is_enum_v<Enum> && requires {
    EnumNames<Enum>::names.size();
};

template <NamedEnum Enum>
constexpr std::string_view enum_name(Enum value) {
    const auto index = static_cast<std::size_t>(value);
    return index < EnumNames<Enum>::names.size() ? EnumNames<Enum>::names[index] : "?";
}

// True for `Struct` and `const Struct`: visit_fields is written once and serves readers and writers.
template <class Maybe, class Struct>
concept SameStruct = std::same_as<std::remove_const_t<Maybe>, Struct>;

}  // namespace pipeline
