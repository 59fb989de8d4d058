// SPDX-License-Identifier: MIT
// Reads any part of a frame from text, by visit_fields alone: the inverse of text_writer.h. The text follows the types,
// so it nests no deeper than they do, and grows no list but by what stands in it.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/frame/field_traits.h"
#include "pipeline/frame/frame_names.h"
#include "pipeline/frame/text_scanner.h"

namespace pipeline {

class TextReader {
  public:
    // most_list_bytes: what the entries of one list may take. Empty braces stand for structs of up to a kilobyte.
    explicit TextReader(std::string_view text, std::size_t most_list_bytes = std::size_t{1} << 30)
        : scan_(text), most_list_bytes_(most_list_bytes) {}

    void read_first_line();
    // Fields up to the end of the text; then gives every id in `frame` what it refers to.
    void read_top_level(Frame& frame);

  private:
    // An id as written; until all lists are read, Id::index is a number into references_.
    struct Reference {
        std::size_t position;
        std::string name;
        std::int32_t index;  // if name is empty
    };
    struct Step {
        std::string_view name;
        std::ptrdiff_t index = -1;
    };

    template <class T>
    void read(T& value) {
        if constexpr (FieldStruct<T>) {
            read_struct(value);
        } else if constexpr (std::same_as<T, std::vector<std::uint8_t>>) {
            scan_.expect('[', "'[' before hexadecimal bytes");
            value.clear();
            scan_.hex_until_bracket(value);
        } else if constexpr (kIsList<T>) {
            read_list(value);
        } else if constexpr (kIsArray<T>) {
            read_array(value);
        } else if constexpr (kIsOptional<T>) {
            if (scan_.take_word("none")) {
                value.reset();
            } else {
                read(value.emplace());
            }
        } else if constexpr (kIsVariant<T>) {
            read_variant(value);
        } else {
            read_value(value);
        }
    }

    template <FieldStruct Struct>
    void read_struct(Struct& value) {
        std::uint32_t given = 0;  // a bit for each field
        if (scan_.peek() == '"') {
            if (std::string* name = leading_name(value)) {
                *name = scan_.quoted();
                given = 1;
            }
        }
        const std::size_t opened = scan_.position();
        scan_.expect('{', "'{'");
        while (!scan_.take('}')) {
            if (scan_.at_end()) {
                scan_.fail("missing '}': " + path() + " is still open, since line " +
                           std::to_string(scan_.line_of(opened)));
            }
            read_field(value, given);
        }
    }

    template <FieldStruct Struct>
    void read_field(Struct& value, std::uint32_t& given) {
        const std::size_t start    = scan_.position();
        const std::uint32_t chosen = read_field_name(value);
        std::uint32_t bit          = 1;
        visit_fields(value, [&](std::string_view name, auto& field) {
            if (bit == chosen) {
                if (given & bit) {
                    scan_.fail_at(start, "field '" + std::string(name) + "' of " + path() + " is given twice");
                }
                given |= bit;
                path_.push_back({name});
                read(field);
                path_.pop_back();
            }
            bit <<= 1;
        });
    }

    // The bit of the field whose name follows.
    template <FieldStruct Struct>
    std::uint32_t read_field_name(const Struct& value) {
        const std::size_t start     = scan_.position();
        const std::string_view word = scan_.word();
        if (word.empty()) scan_.fail("expected a field of " + path() + ", got " + scan_.what_follows());
        std::uint32_t bit = 1, chosen = 0;
        visit_fields(value, [&](std::string_view name, const auto&) {
            if (name == word) chosen = bit;
            bit <<= 1;
        });
        if (chosen == 0) {
            std::string reason = "unknown field '" + shorten(word) + "' in " + path() + "; there are ";
            bool first         = true;
            visit_fields(value, [&](std::string_view name, const auto&) {
                if (!first) reason += ", ";
                first = false;
                reason += name;
            });
            scan_.fail_at(start, reason);
        }
        return chosen;
    }

    template <class T>
    void read_list(std::vector<T>& list) {
        list.clear();
        if constexpr (FieldStruct<T>) {
            if (scan_.peek() == 'c') {
                read_table(list);
                return;
            }
        }
        const std::size_t opened = scan_.position();
        scan_.expect('[', "'['");
        while (!end_of_list(opened)) {
            path_.back().index = static_cast<std::ptrdiff_t>(list.size());
            require_room(list);
            read(list.emplace_back());
        }
        path_.back().index = -1;
    }

    template <class T, std::size_t count>
    void read_array(std::array<T, count>& array) {
        const std::size_t opened = scan_.position();
        scan_.expect('[', "'['");
        for (std::size_t i = 0; !end_of_list(opened); ++i) {
            if (i == count) scan_.fail("too many: " + path() + " has " + std::to_string(count) + " entries");
            path_.back().index = static_cast<std::ptrdiff_t>(i);
            read(array[i]);
            path_.back().index = -1;
        }
    }

    // columns (position uv0) [ (0 0 0) (0 0)   (1 0 0) (1 0) ]
    template <FieldStruct Struct>
    void read_table(std::vector<Struct>& rows) {
        const std::size_t start = scan_.position();
        if (scan_.word() != "columns") scan_.fail_at(start, "expected '[' or 'columns ('");
        scan_.expect('(', "'(' before the names of the columns");
        std::vector<std::uint32_t> columns;
        std::uint32_t given = 0;
        while (!scan_.take(')')) {
            const std::size_t name = scan_.position();
            columns.push_back(read_field_name(Struct{}));
            if (given & columns.back()) scan_.fail_at(name, "the column is given twice");
            given |= columns.back();
        }
        if (columns.empty()) scan_.fail_at(start, "a table has at least one column");
        const std::size_t opened = scan_.position();
        scan_.expect('[', "'[' before the rows");
        while (!end_of_list(opened)) {
            path_.back().index = static_cast<std::ptrdiff_t>(rows.size());
            require_room(rows);
            Struct& row = rows.emplace_back();
            for (const std::uint32_t column : columns) {
                std::uint32_t bit = 1;
                visit_fields(row, [&](std::string_view, auto& field) {
                    if (bit == column) read(field);
                    bit <<= 1;
                });
            }
        }
        path_.back().index = -1;
    }

    template <class T>
    void require_room(const std::vector<T>& list) {
        if (list.size() < most_list_bytes_ / sizeof(T)) return;
        path_.back().index = -1;
        scan_.fail("too many: " + path() + " may have " + std::to_string(list.size()) + " entries");
    }

    template <class... Alternatives>
    void read_variant(std::variant<Alternatives...>& value) {
        const std::size_t start     = scan_.position();
        const std::string_view word = scan_.word();
        const bool known = ((word == kAlternativeName<Alternatives> && (value = Alternatives{}, true)) || ...);
        if (!known) {
            std::string reason = "expected one of";
            ((reason += ' ', reason += kAlternativeName<Alternatives>), ...);
            scan_.fail_at(start, reason);
        }
        std::visit([&](auto& alternative) { read_struct(alternative); }, value);
    }

    template <class Number>
    requires std::is_arithmetic_v<Number>
    void read_value(Number& value) {
        if constexpr (std::same_as<Number, float>) {
            value = scan_.real();
        } else if constexpr (std::same_as<Number, bool>) {
            value = read_bool();
        } else {
            value = scan_.integer(std::numeric_limits<Number>::min(), std::numeric_limits<Number>::max());
        }
    }
    void read_value(std::string& value) { value = scan_.quoted(); }
    void read_value(Argb& value) { value.value = scan_.color(); }

    template <NamedEnum Enum>
    void read_value(Enum& value) {
        using Underlying = std::underlying_type_t<Enum>;
        if (scan_.take('#')) {
            value = static_cast<Enum>(scan_.integer<Underlying>(0, std::numeric_limits<Underlying>::max()));
            return;
        }
        const std::size_t start     = scan_.position();
        const std::string_view word = scan_.word();
        const auto& names           = EnumNames<Enum>::names;
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (names[i] == word) {
                value = static_cast<Enum>(i);
                return;
            }
        }
        std::string reason = word.empty() ? "expected" : "unknown value '" + shorten(word) + "' for " + path() + ";";
        for (std::size_t i = 0; i < names.size(); ++i) {
            reason += i == 0 ? " one of " : ", ";
            reason += names[i];
        }
        if (word.empty()) reason += ", got " + scan_.what_follows();
        scan_.fail_at(start, reason);
    }

    template <glm::length_t count>
    void read_value(glm::vec<count, float>& value) {
        scan_.expect('(', "'(' before " + std::to_string(count) + " numbers");
        for (glm::length_t i = 0; i < count; ++i) value[i] = scan_.real();
        scan_.expect(')', "')' after " + std::to_string(count) + " numbers");
    }
    void read_value(Mat4& value);

    template <class Of>
    void read_value(Id<Of>& value) {
        value = {};
        if (scan_.take_word("none")) return;
        value.index = static_cast<std::int32_t>(references_.size());
        read_reference();
    }

    // Follows the ids in `value`, wherever they are.
    template <class T>
    void resolve(T& value, const FrameNames& names) {
        if constexpr (FieldStruct<T>) {
            visit_fields(value, [&](std::string_view, auto& field) { resolve(field, names); });
        } else if constexpr (kIsList<T> || kIsArray<T>) {
            if constexpr (!std::is_arithmetic_v<typename T::value_type>) {
                for (auto& element : value) resolve(element, names);
            }
        } else if constexpr (kIsOptional<T>) {
            if (value) resolve(*value, names);
        } else if constexpr (kIsVariant<T>) {
            std::visit([&](auto& alternative) { resolve(alternative, names); }, value);
        } else if constexpr (kIsId<T>) {
            if (value) value.index = referred_index(references_[static_cast<std::size_t>(value.index)], value, names);
        }
    }
    template <class Of>
    std::int32_t referred_index(const Reference& reference, Id<Of>, const FrameNames& names) const {
        return reference.name.empty() ? reference.index : index_by_name(reference, names.list_of<Of>());
    }
    std::int32_t index_by_name(const Reference& reference, const NamedList& list) const;

    void read_reference();
    bool read_bool();
    bool end_of_list(std::size_t opened);
    std::string path() const;  // of what is being read: "passes[3].state"
    static std::string shorten(std::string_view word);

    TextScanner scan_;
    std::size_t most_list_bytes_;
    std::vector<Step> path_;
    std::vector<Reference> references_;
};

}  // namespace pipeline
