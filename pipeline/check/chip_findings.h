// SPDX-License-Identifier: MIT
// What the rules of check are written with: a list that findings go to, and the frame's spelling of values.
#pragma once

#include <algorithm>

#include "pipeline/check/check.h"
#include "pipeline/frame/field_traits.h"
#include "pipeline/frame/text_values.h"
#include "pipeline/validate/findings.h"

namespace pipeline {

template <class T>
bool is_among(const T& value, const std::vector<T>& values) {
    return std::find(values.begin(), values.end(), value) != values.end();
}

template <class T>
std::string text_of(const T& value) {
    std::string text;
    append_value(text, value);
    return text;
}

template <NamedEnum Enum>
std::string names_of(const std::vector<Enum>& values) {
    std::string names;
    for (const Enum value : values) {
        if (!names.empty()) names += ' ';
        names += enum_name(value);
    }
    return names.empty() ? "none" : names;
}

// "source SRCALPHA dest INVSRCALPHA": the fields of a plain struct in which it differs from `other`.
template <FieldStruct Struct>
std::string differing_fields(const Struct& value, const Struct& other) {
    std::string text;
    visit_pairs(value, other, [&](std::string_view name, const auto& field, const auto& other_field) {
        if (field == other_field) return;
        if (!text.empty()) text += ' ';
        text += name;
        text += ' ';
        append_value(text, field);
    });
    return text;
}

class ChipFindings {
  public:
    explicit ChipFindings(const Profile& profile) : profile_(profile) {}

    void add(const Place& place, std::string_view rule, std::string uses, std::string has) {
        found_.push_back({place.text(), rule, std::move(uses), std::move(has)});
    }
    // For a rule that chips have of their own, or else under another topic.
    std::string_view topic_or(std::string_view topic, std::string_view other) const {
        return find_evidence(profile_, topic) != nullptr ? topic : other;
    }
    const Profile& profile() const { return profile_; }
    std::vector<ChipFinding> take() { return std::move(found_); }

  private:
    const Profile& profile_;
    std::vector<ChipFinding> found_;
};

// The rules, each file's.
void check_targets_and_textures(const Frame& frame, ChipFindings& findings);
void check_pass_formats(const Frame& frame, const Pass& pass, const Place& place, ChipFindings& findings);
void check_states(const Frame& frame, const Pass& pass, const Place& place, ChipFindings& findings);
void check_stages(const Frame& frame, const Pass& pass, const Place& place, ChipFindings& findings);
void check_memory(const Frame& frame, ChipFindings& findings);

}  // namespace pipeline
