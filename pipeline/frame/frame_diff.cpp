// SPDX-License-Identifier: MIT
// diff: two frames walked side by side. Lists are compared entry by entry, as far as the shorter one goes.
#include "pipeline/frame/field_traits.h"
#include "pipeline/frame/frame_names.h"
#include "pipeline/frame/frame_text.h"
#include "pipeline/frame/text_writer.h"

namespace pipeline {

namespace {

class Differ {
  public:
    Differ(const Frame& before, const Frame& after) : names_before_(before), names_after_(after) {}

    std::vector<std::string> take() { return std::move(lines_); }

    template <class T>
    void compare(const T& before, const T& after) {
        if (before == after) return;
        if constexpr (FieldStruct<T>) {
            visit_pairs(before, after, [&](std::string_view name, const auto& x, const auto& y) {
                const std::size_t length = path_.size();
                if (!path_.empty()) path_ += '.';
                path_ += name;
                compare(x, y);
                path_.resize(length);
            });
        } else if constexpr (kIsList<T> || kIsArray<T>) {
            if constexpr (kIsList<T> && std::is_arithmetic_v<typename T::value_type>) {
                compare_numbers(before, after);
            } else {
                compare_entries(before, after);
            }
        } else if constexpr (kIsVariant<T>) {
            if (before.index() != after.index()) {
                lines_.push_back(path_ + ": " + text_of(before, names_before_) + " -> " + text_of(after, names_after_));
                return;
            }
            std::visit(
                [&](const auto& alternative) {
                    compare(alternative, std::get<std::remove_cvref_t<decltype(alternative)>>(after));
                },
                before);
        } else {
            lines_.push_back(path_ + ": " + text_of(before, names_before_) + " -> " + text_of(after, names_after_));
        }
    }

  private:
    static constexpr std::size_t kMostRows = 8;  // of a list of plain structs (vertices) shown one by one

    template <class List>
    void compare_entries(const List& before, const List& after) {
        compare_sizes(before.size(), after.size());
        const std::size_t count = std::min(before.size(), after.size());
        std::size_t differing   = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (before[i] == after[i]) continue;
            ++differing;
            if constexpr (FieldStruct<typename List::value_type>) {
                if (is_plain_struct<typename List::value_type>() && differing > kMostRows) continue;
            }
            const std::size_t length = path_.size();
            path_ += '[' + std::to_string(i) + ']';
            compare(before[i], after[i]);
            path_.resize(length);
        }
        if constexpr (FieldStruct<typename List::value_type>) {
            if (is_plain_struct<typename List::value_type>() && differing > kMostRows) {
                lines_.push_back(path_ + ": " + std::to_string(differing - kMostRows) + " more differ");
            }
        }
    }

    // Bulk: the first difference stands for all.
    template <class Number>
    void compare_numbers(const std::vector<Number>& before, const std::vector<Number>& after) {
        compare_sizes(before.size(), after.size());
        const std::size_t count = std::min(before.size(), after.size());
        std::size_t differing = 0, first = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (before[i] != after[i] && differing++ == 0) first = i;
        }
        if (differing == 0) return;
        std::string line = path_ + '[' + std::to_string(first) + "]: " + std::to_string(before[first]) + " -> " +
                           std::to_string(after[first]);
        if (differing > 1) line += "; " + std::to_string(differing - 1) + " more differ";
        lines_.push_back(std::move(line));
    }

    void compare_sizes(std::size_t before, std::size_t after) {
        if (before == after) return;
        lines_.push_back(path_ + ": " + std::to_string(before) + " -> " + std::to_string(after) + " entries");
    }

    template <class T>
    static std::string text_of(const T& value, const FrameNames& names) {
        TextWriter writer(names);
        writer.write_inline(value);
        return writer.take();
    }

    FrameNames names_before_, names_after_;
    std::string path_;
    std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> diff(const Frame& before, const Frame& after) {
    Differ differ(before, after);
    differ.compare(before, after);
    return differ.take();
}

}  // namespace pipeline
