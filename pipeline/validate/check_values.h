// SPDX-License-Identifier: MIT
// The rules that hold for every value of a type, wherever it stands, by visit_fields: floats are finite, enumerators
// are among those that have a name, ids refer to an entry of their list or to nothing (-1).
#pragma once

#include <cmath>

#include "pipeline/frame/field_traits.h"
#include "pipeline/frame/text_values.h"
#include "pipeline/validate/findings.h"

namespace pipeline {

template <class T>
std::string got(const T& value) {
    std::string text = " (got ";
    append_value(text, value);
    return text + ')';
}

// The size and the field name of the frame's list of `Of`.
struct ListSize {
    std::string_view field;
    std::size_t size = 0;
};
template <class Of>
ListSize list_size(const Frame& frame) {
    ListSize found;
    visit_fields(frame, [&](std::string_view name, const auto& list) {
        if constexpr (std::same_as<std::remove_cvref_t<decltype(list)>, std::vector<Of>>) found = {name, list.size()};
    });
    return found;
}

template <class T>
bool is_finite(const T& value) {
    if constexpr (std::same_as<T, float>) {
        return std::isfinite(value);
    } else {
        bool finite = true;
        for (glm::length_t i = 0; i < value.length(); ++i) finite &= is_finite(value[i]);
        return finite;
    }
}

template <class T>
void check_values(const Frame& frame, const T& value, const Place& place, Findings& findings) {
    if constexpr (FieldStruct<T>) {
        visit_fields(value, [&](std::string_view name, const auto& field) {
            check_values(frame, field, place.field(name), findings);
        });
    } else if constexpr (kIsList<T> || kIsArray<T>) {
        if constexpr (!std::is_integral_v<typename T::value_type>) {
            for (std::size_t i = 0; i < value.size(); ++i) {
                check_values(frame, value[i], place.entry(i), findings);
            }
        }
    } else if constexpr (kIsOptional<T>) {
        if (value) check_values(frame, *value, place, findings);
    } else if constexpr (kIsVariant<T>) {
        std::visit([&](const auto& alternative) { check_values(frame, alternative, place, findings); }, value);
    } else if constexpr (std::same_as<T, Mat4>) {
        if (!is_finite(value)) report(findings, place, "must be finite");
    } else if constexpr (std::same_as<T, float> || kIsVec<T>) {
        if (!is_finite(value)) report(findings, place, "must be finite" + got(value));
    } else if constexpr (NamedEnum<T>) {
        const auto& names = EnumNames<T>::names;
        if (static_cast<std::size_t>(value) >= names.size()) {
            std::string what = "must be one of";
            for (const std::string_view name : names) {
                what += ' ';
                what += name;
            }
            report(findings, place, what + got(value));
        }
    } else if constexpr (kIsId<T>) {
        check_id(frame, value, place, findings);
    }
}

template <class Of>
bool is_in_range(const Frame& frame, Id<Of> id) {
    return id.index >= 0 && static_cast<std::size_t>(id.index) < list_size<Of>(frame).size;
}

template <class Of>
void check_id(const Frame& frame, Id<Of> id, const Place& place, Findings& findings) {
    if (id.index == -1 || is_in_range(frame, id)) return;
    const ListSize list = list_size<Of>(frame);
    report(findings, place,
           "must refer to one of the " + std::to_string(list.size) + ' ' + std::string(list.field) +
               ", or be nothing, -1" + got(id.index));
}

}  // namespace pipeline
