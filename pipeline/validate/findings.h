// SPDX-License-Identifier: MIT
// Where a rule looks, and what it found. A Place is a path kept as links on the stack; its text is made only when there
// is a finding, so a frame without one costs no string.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pipeline/validate/validate.h"

namespace pipeline {

class Place {
  public:
    // The start of a path: "frame", or entry `index` of a list, "pass 3 'composite'".
    explicit Place(std::string_view kind) : text_(kind) {}
    Place(std::string_view kind, std::size_t index, std::string_view name)
        : text_(kind), name_(name), index_(static_cast<std::ptrdiff_t>(index)) {}

    // A field, or an entry of a field, of the place.
    Place field(std::string_view name) const { return Place(this, name, -1); }
    Place entry(std::size_t index) const { return Place(this, {}, static_cast<std::ptrdiff_t>(index)); }
    Place entry(std::string_view list, std::size_t index) const {
        return Place(this, list, static_cast<std::ptrdiff_t>(index));
    }

    std::string text() const {
        if (parent_ == nullptr) {
            std::string text(text_);
            if (index_ >= 0) text += ' ' + std::to_string(index_);
            if (!name_.empty()) text += " '" + std::string(name_) + "'";
            return text;
        }
        std::string text = parent_->text();
        if (!text_.empty()) text += (parent_->parent_ == nullptr ? ": " : ".") + std::string(text_);
        if (index_ >= 0) text += '[' + std::to_string(index_) + ']';
        return text;
    }

  private:
    Place(const Place* parent, std::string_view text, std::ptrdiff_t index)
        : parent_(parent), text_(text), index_(index) {}

    const Place* parent_ = nullptr;
    std::string_view text_, name_;
    std::ptrdiff_t index_ = -1;
};

using Findings = std::vector<Finding>;

inline void report(Findings& findings, const Place& place, std::string what) {
    findings.push_back({place.text(), std::move(what)});
}

}  // namespace pipeline
