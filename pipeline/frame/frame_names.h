// SPDX-License-Identifier: MIT
// The names that ids are written by: what stands in the lists of a frame, by name and by index. Views into the frame:
// it must outlive this and stay where it is.
#pragma once

#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "pipeline/frame/field_traits.h"

namespace pipeline {

struct NamedList {
    std::string_view field;  // of the frame: "targets"
    std::vector<std::string_view> names;
    std::unordered_map<std::string_view, std::vector<std::int32_t>> indices;  // by name; empty names are left out

    // The name of entry `index`, or nothing if it has none or is not the only one of that name.
    std::string_view unique_name(std::int32_t index) const {
        if (index < 0 || static_cast<std::size_t>(index) >= names.size()) return {};
        const std::string_view name = names[static_cast<std::size_t>(index)];
        const auto found            = indices.find(name);
        return found != indices.end() && found->second.size() == 1 ? name : std::string_view{};
    }
};

class FrameNames {
  public:
    explicit FrameNames(const Frame& frame) {
        visit_fields(frame, [&](std::string_view field, const auto& list) {
            NamedList entry{.field = field, .names = {}, .indices = {}};
            if constexpr (kIsList<std::remove_cvref_t<decltype(list)>>) {
                if constexpr (FieldStruct<typename std::remove_cvref_t<decltype(list)>::value_type>) {
                    for (const auto& element : list) {
                        const std::string* name = leading_name(element);
                        if (name == nullptr) break;
                        if (!name->empty()) {
                            entry.indices[*name].push_back(static_cast<std::int32_t>(entry.names.size()));
                        }
                        entry.names.push_back(*name);
                    }
                }
            }
            lists_.push_back(std::move(entry));
        });
    }

    // The frame's list of `Of`, to which Id<Of> refers.
    template <class Of>
    const NamedList& list_of() const {
        static const std::size_t field = [] {
            const Frame frame;
            std::size_t found = 0, i = 0;
            visit_fields(frame, [&](std::string_view, const auto& list) {
                if constexpr (std::same_as<std::remove_cvref_t<decltype(list)>, std::vector<Of>>) found = i;
                ++i;
            });
            return found;
        }();
        return lists_[field];
    }

  private:
    std::vector<NamedList> lists_;  // one for each field of the frame
};

}  // namespace pipeline
