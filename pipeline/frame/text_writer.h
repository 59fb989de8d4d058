// SPDX-License-Identifier: MIT
// Writes any part of a frame as text, from visit_fields alone. What decides the layout:
//   - a field at its default value is left out, and so are the elements at the end of an array;
//   - a struct that holds a list is indented, one field a line; any other stands on one line if that fits;
//   - a struct's name (its first field, if a string) comes before its brace;
//   - a long list of structs of plain values is a table: the fields that occur, then one row for each element.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pipeline/frame/field_traits.h"
#include "pipeline/frame/frame_names.h"
#include "pipeline/frame/text_values.h"

namespace pipeline {

class TextWriter {
  public:
    explicit TextWriter(const FrameNames& names) : names_(names) {}

    std::string take() { return std::move(out_); }
    void append(std::string_view text) { out_ += text; }

    // Each field that differs from its default on its own line; a blank line before each list.
    template <FieldStruct Struct>
    void write_top_level(const Struct& value) {
        visit_pairs(value, Struct{}, [&](std::string_view name, const auto& field, const auto& otherwise) {
            if (identical(field, otherwise)) return;
            if (kIsList<std::remove_cvref_t<decltype(field)>>) out_ += '\n';
            line_start_ = out_.size();
            write_field(name, field, otherwise);
            out_ += '\n';
        });
    }

    // On one line, whatever its length. Not for lists.
    template <class T>
    void write_inline(const T& value) {
        inline_ = true;
        write(value, T{});
        inline_ = false;
    }

  private:
    static constexpr std::size_t kMaxColumns     = 110;
    static constexpr std::size_t kTableThreshold = 16;  // elements; a longer list of plain structs is a table
    static constexpr std::size_t kBytesPerLine   = 48;

    template <class T>
    void write(const T& value, const T& defaults) {
        if constexpr (FieldStruct<T>) {
            write_struct(value, defaults);
        } else if constexpr (std::same_as<T, std::vector<std::uint8_t>>) {
            write_bytes(value);
        } else if constexpr (kIsList<T>) {
            write_list(value);
        } else if constexpr (kIsArray<T>) {
            write_array(value, defaults);
        } else if constexpr (kIsOptional<T>) {
            if (value) {
                write(*value, typename T::value_type{});
            } else {
                out_ += "none";
            }
        } else if constexpr (kIsVariant<T>) {
            std::visit(
                [&](const auto& alternative) {
                    using Alternative = std::remove_cvref_t<decltype(alternative)>;
                    write_field(kAlternativeName<Alternative>, alternative, Alternative{});
                },
                value);
        } else if constexpr (kIsId<T>) {
            write_id(value);
        } else if constexpr (std::same_as<T, Mat4>) {
            write_matrix(value);
        } else {
            append_value(out_, value);
        }
    }

    template <class T>
    void write_field(std::string_view name, const T& value, const T& defaults) {
        out_ += name;
        out_ += ' ';
        write(value, defaults);
    }

    template <FieldStruct Struct>
    void write_struct(const Struct& value, const Struct& defaults) {
        const std::string* own_name = leading_name(value);
        if (own_name != nullptr && !own_name->empty()) {
            append_value(out_, *own_name);
            out_ += ' ';
        }
        const auto for_each_written = [&](auto&& body) {
            visit_pairs(value, defaults, [&](std::string_view name, const auto& field, const auto& otherwise) {
                if (static_cast<const void*>(&field) != own_name && !identical(field, otherwise)) {
                    body(name, field, otherwise);
                }
            });
        };
        const auto one_line = [&] {
            out_ += '{';
            const std::size_t empty = out_.size();
            for_each_written([&](std::string_view name, const auto& field, const auto& otherwise) {
                out_ += ' ';
                write_field(name, field, otherwise);
            });
            out_ += out_.size() > empty ? " }" : "}";
        };
        if ((inline_ || !holds_list<Struct>()) && fits_on_line(one_line)) return;
        out_ += '{';
        ++depth_;
        for_each_written([&](std::string_view name, const auto& field, const auto& otherwise) {
            new_line();
            write_field(name, field, otherwise);
        });
        --depth_;
        new_line();
        out_ += '}';
    }

    template <class T>
    void write_list(const std::vector<T>& list) {
        if constexpr (FieldStruct<T>) {
            if (list.size() > kTableThreshold && is_plain_struct<T>()) {
                write_table(list);
                return;
            }
        }
        if constexpr (std::is_arithmetic_v<T>) {
            write_numbers(list);
            return;
        }
        out_ += '[';
        ++depth_;
        for (const T& element : list) {
            new_line();
            write(element, T{});
        }
        --depth_;
        if (!list.empty()) new_line();
        out_ += ']';
    }

    template <class T, std::size_t count>
    void write_array(const std::array<T, count>& array, const std::array<T, count>& defaults) {
        std::size_t written = count;
        while (written > 0 && identical(array[written - 1], defaults[written - 1])) --written;
        const auto one_line = [&] {
            out_ += '[';
            for (std::size_t i = 0; i < written; ++i) {
                if (i > 0) out_ += ' ';
                write(array[i], defaults[i]);
            }
            out_ += ']';
        };
        if (fits_on_line(one_line)) return;
        out_ += '[';
        ++depth_;
        for (std::size_t i = 0; i < written; ++i) {
            new_line();
            write(array[i], defaults[i]);
        }
        --depth_;
        new_line();
        out_ += ']';
    }

    template <FieldStruct Struct>
    void write_table(const std::vector<Struct>& rows) {
        const Struct defaults{};
        std::vector<char> written;  // for each field: does it occur?
        visit_fields(defaults, [&](std::string_view, const auto&) { written.push_back(false); });
        for (const Struct& row : rows) {
            std::size_t i = 0;
            visit_pairs(row, defaults, [&](std::string_view, const auto& field, const auto& otherwise) {
                if (!written[i] && !identical(field, otherwise)) written[i] = true;
                ++i;
            });
        }
        if (std::find(written.begin(), written.end(), true) == written.end()) written[0] = true;

        const auto for_each_written = [&](const Struct& row, auto&& body) {
            std::size_t i = 0;
            bool first    = true;
            visit_fields(row, [&](std::string_view name, const auto& field) {
                if (!written[i++]) return;
                if (!first) out_ += ' ';
                first = false;
                body(name, field);
            });
        };
        out_ += "columns (";
        for_each_written(defaults, [&](std::string_view name, const auto&) { out_ += name; });
        out_ += ") [";
        inline_ = true;
        ++depth_;
        for (const Struct& row : rows) {
            new_line();
            for_each_written(row, [&](std::string_view, const auto& field) { write(field, field); });
        }
        --depth_;
        inline_ = false;
        new_line();
        out_ += ']';
    }

    template <class Number>
    void write_numbers(const std::vector<Number>& numbers) {
        const auto one_line = [&] {
            out_ += '[';
            for (const Number number : numbers) {
                if (out_.back() != '[') out_ += ' ';
                append_value(out_, number);
                if (out_.size() - line_start_ > kMaxColumns) return;
            }
            out_ += ']';
        };
        if (fits_on_line(one_line)) return;
        out_ += '[';
        ++depth_;
        constexpr std::size_t kLongestNumber = 11;
        bool at_line_start                   = true;
        for (const Number number : numbers) {
            if (at_line_start || out_.size() - line_start_ + kLongestNumber > kMaxColumns) {
                new_line();
            } else {
                out_ += ' ';
            }
            at_line_start = false;
            append_value(out_, number);
        }
        --depth_;
        new_line();
        out_ += ']';
    }

    template <class Of>
    void write_id(Id<Of> id) {
        const std::string_view name = names_.list_of<Of>().unique_name(id.index);
        if (id.index == -1) {
            out_ += "none";
        } else if (name.empty()) {
            out_ += '#';
            append_value(out_, id.index);
        } else {
            append_value(out_, std::string(name));
        }
    }

    // Runs `one_line`, which writes without line breaks; takes it back, unless all of this is to be on one line, if the
    // line becomes too long.
    template <class OneLine>
    bool fits_on_line(OneLine&& one_line) {
        if (inline_) {
            one_line();
            return true;
        }
        const std::size_t before = out_.size();
        inline_                  = true;
        one_line();
        inline_ = false;
        if (out_.size() - line_start_ <= kMaxColumns) return true;
        out_.resize(before);
        return false;
    }

    void write_matrix(const Mat4& matrix);
    void write_bytes(const std::vector<std::uint8_t>& bytes);
    void new_line();

    const FrameNames& names_;
    std::string out_;
    std::size_t line_start_ = 0;  // of the line being written, in out_
    std::size_t depth_      = 0;
    bool inline_            = false;
};

}  // namespace pipeline
