// SPDX-License-Identifier: MIT
// What generic code over visit_fields needs to know of a field's type: the shapes a frame is built from (structs,
// lists, arrays, optionals, variants, ids, vectors and matrices) and how to walk two structs of one type side by side.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "pipeline/frame/frame.h"

namespace pipeline {

template <class T>
concept FieldStruct = requires(const T& value) {
    visit_fields(value, [](std::string_view, const auto&) {});
};

template <class>
inline constexpr bool kIsList = false;
template <class T>
inline constexpr bool kIsList<std::vector<T>> = true;

template <class>
inline constexpr bool kIsArray = false;
template <class T, std::size_t count>
inline constexpr bool kIsArray<std::array<T, count>> = true;

template <class>
inline constexpr bool kIsOptional = false;
template <class T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

template <class>
inline constexpr bool kIsVariant = false;
template <class... Ts>
inline constexpr bool kIsVariant<std::variant<Ts...>> = true;

template <class>
inline constexpr bool kIsId = false;
template <class Of>
inline constexpr bool kIsId<Id<Of>> = true;

template <class>
inline constexpr bool kIsVec = false;
template <glm::length_t count>
inline constexpr bool kIsVec<glm::vec<count, float>> = true;

// A value of fixed size that is written in one piece and that no name stands in.
template <class T>
inline constexpr bool kIsPlain =
    std::is_arithmetic_v<T> || NamedEnum<T> || kIsVec<T> || kIsId<T> || std::same_as<T, Argb> || std::same_as<T, Mat4>;

// What the alternatives of a variant are called.
template <class>
inline constexpr std::string_view kAlternativeName{};
template <>
inline constexpr std::string_view kAlternativeName<DrawTriangles> = "triangles";
template <>
inline constexpr std::string_view kAlternativeName<DrawRectangle> = "rectangle";
template <>
inline constexpr std::string_view kAlternativeName<CopyRectangle> = "copy";
template <>
inline constexpr std::string_view kAlternativeName<DrawWindowTriangles> = "window_triangles";

// Field number `index` of `value`, which is known to be a `Field`.
template <class Field, FieldStruct Struct>
const Field& field_at(const Struct& value, int index) {
    const Field* found = nullptr;
    int i              = 0;
    visit_fields(value, [&](std::string_view, const auto& field) {
        if constexpr (std::same_as<std::remove_cvref_t<decltype(field)>, Field>) {
            if (i == index) found = &field;
        }
        ++i;
    });
    return *found;
}

// visit(name, field of a, the same field of b)
template <FieldStruct Struct, class Visit>
void visit_pairs(const Struct& a, const Struct& b, Visit&& visit) {
    int index = 0;
    visit_fields(a, [&](std::string_view name, const auto& field) {
        visit(name, field, field_at<std::remove_cvref_t<decltype(field)>>(b, index++));
    });
}

// The first field of a struct if it is a string, else null: the struct's name.
template <class Struct>
auto leading_name(Struct& value) {
    std::conditional_t<std::is_const_v<Struct>, const std::string*, std::string*> name = nullptr;
    int index                                                                          = 0;
    visit_fields(value, [&](std::string_view, auto& field) {
        if constexpr (std::same_as<std::remove_cvref_t<decltype(field)>, std::string>) {
            if (index == 0) name = &field;
        }
        ++index;
    });
    return name;
}

// Does `predicate` hold for some field of a default struct?
template <FieldStruct Struct, class Predicate>
bool any_field(Predicate&& predicate) {
    const Struct defaults{};
    bool any = false;
    visit_fields(defaults, [&](std::string_view, const auto& field) { any = any || predicate(field); });
    return any;
}

// Does a struct contain a list, itself or in a member?
template <FieldStruct Struct>
bool holds_list() {
    static const bool holds = any_field<Struct>([](const auto& field) {
        using Field = std::remove_cvref_t<decltype(field)>;
        if constexpr (FieldStruct<Field>) {
            return holds_list<Field>();
        } else {
            return kIsList<Field>;
        }
    });
    return holds;
}

// Are all fields plain values?
template <FieldStruct Struct>
bool is_plain_struct() {
    static const bool plain =
        !any_field<Struct>([](const auto& field) { return !kIsPlain<std::remove_cvref_t<decltype(field)>>; });
    return plain;
}

// Equal to the last bit: unlike ==, it tells 0 from -0, and finds a NaN equal to itself.
template <class T>
bool identical(const T& a, const T& b) {
    if constexpr (FieldStruct<T>) {
        bool same = true;
        visit_pairs(a, b, [&](std::string_view, const auto& x, const auto& y) { same = same && identical(x, y); });
        return same;
    } else if constexpr (std::same_as<T, float>) {
        return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
    } else if constexpr (kIsVec<T> || std::same_as<T, Mat4>) {
        bool same = true;
        for (glm::length_t i = 0; i < a.length(); ++i) same = same && identical(a[i], b[i]);
        return same;
    } else if constexpr (kIsArray<T>) {
        for (std::size_t i = 0; i < a.size(); ++i) {
            if (!identical(a[i], b[i])) return false;
        }
        return true;
    } else if constexpr (kIsList<T>) {
        if (a.size() != b.size()) return false;
        for (std::size_t i = 0; i < a.size(); ++i) {
            if (!identical(a[i], b[i])) return false;
        }
        return true;
    } else if constexpr (kIsOptional<T>) {
        return a.has_value() == b.has_value() && (!a.has_value() || identical(*a, *b));
    } else if constexpr (kIsVariant<T>) {
        return a.index() == b.index() && std::visit(
                                             [&](const auto& alternative) {
                                                 using Alternative = std::remove_cvref_t<decltype(alternative)>;
                                                 return identical(alternative, std::get<Alternative>(b));
                                             },
                                             a);
    } else {
        return a == b;
    }
}

}  // namespace pipeline
