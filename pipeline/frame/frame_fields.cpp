// SPDX-License-Identifier: MIT
#include "pipeline/frame/frame_fields.h"

#include <algorithm>

#include "pipeline/frame/field_traits.h"
#include "pipeline/frame/text_values.h"

namespace pipeline {
namespace {

constexpr std::size_t kIndent = 4, kValueColumn = 32, kKindColumn = 48, kLineWidth = 118;

class FieldsText {
  public:
    template <FieldStruct Struct>
    void add(const Struct& defaults) {
        visit_fields(defaults, [&](std::string_view name, const auto& field) { add_field(std::string(name), field); });
    }

    std::string take() { return std::move(text_); }

  private:
    template <class T>
    void add_field(const std::string& name, const T& field) {
        if constexpr (FieldStruct<T>) {
            add_struct(name, field);
        } else if constexpr (kIsVariant<T>) {
            add_alternatives(field);
        } else if constexpr (kIsOptional<T>) {
            add_line(name, "none", kind_of<typename T::value_type>());
        } else if constexpr (kIsList<T>) {
            add_entries(name + "[]", typename T::value_type{}, "");
        } else if constexpr (kIsArray<T>) {
            add_entries(name + '[' + std::to_string(field.size()) + ']', field[0], text_of(field[0]));
        } else {
            add_line(name, text_of(field), kind_of<T>());
        }
    }

    template <class T>
    void add_entries(const std::string& name, const T& entry, const std::string& value) {
        if constexpr (FieldStruct<T>) {
            add_struct(name, entry);
        } else if constexpr (kIsVariant<T>) {
            begin(name);
            add_alternatives(entry);
            --depth_;
        } else {
            add_line(name, value, kind_of<T>());
        }
    }

    template <FieldStruct Struct>
    void add_struct(const std::string& name, const Struct& defaults) {
        begin(name);
        add(defaults);
        --depth_;
    }

    template <class... Alternatives>
    void add_alternatives(const std::variant<Alternatives...>&) {
        (add_struct(std::string(kAlternativeName<Alternatives>), Alternatives{}), ...);
    }

    void begin(const std::string& name) {
        text_ += std::string(kIndent * depth_, ' ') + name + '\n';
        ++depth_;
    }

    // The names of an enum, or what a value is.
    template <class T>
    static std::string kind_of() {
        if constexpr (NamedEnum<T>) {
            std::string names;
            for (const std::string_view name : EnumNames<T>::names) {
                if (!names.empty()) names += ' ';
                names += name;
            }
            return names;
        } else if constexpr (std::same_as<T, bool>) {
            return "true false";
        } else if constexpr (std::same_as<T, float>) {
            return "a number";
        } else if constexpr (std::is_integral_v<T>) {
            return std::same_as<T, std::uint8_t> ? "0 to 255" : "an integer";
        } else if constexpr (std::same_as<T, std::string>) {
            return "a name";
        } else if constexpr (std::same_as<T, Argb>) {
            return "0xAARRGGBB";
        } else if constexpr (std::same_as<T, Mat4>) {
            return "4x4, rows as on paper";
        } else if constexpr (kIsVec<T>) {
            return std::to_string(T::length()) + " numbers";
        } else {
            static_assert(kIsId<T>);
            return "\"name\", #number or none";
        }
    }

    template <class T>
    static std::string text_of(const T& value) {
        std::string text;
        if constexpr (std::same_as<T, Mat4>) {
            text = "identity";
        } else if constexpr (kIsId<T>) {
            text = "none";
        } else if constexpr (!FieldStruct<T>) {
            append_value(text, value);
        }
        return text;
    }

    void add_line(const std::string& name, const std::string& value, std::string_view kind) {
        std::string line(kIndent * depth_, ' ');
        line += name;
        fill_to(line, kValueColumn);
        line += value;
        fill_to(line, kKindColumn);
        bool starts = true;
        while (!kind.empty()) {
            const std::size_t length = std::min(kind.find(' '), kind.size());
            if (!starts && line.size() + 1 + length > kLineWidth) {
                text_ += line + '\n';
                line.assign(kKindColumn, ' ');
                starts = true;
            }
            if (!starts) line += ' ';
            line += kind.substr(0, length);
            starts = false;
            kind.remove_prefix(std::min(length + 1, kind.size()));
        }
        text_ += line + '\n';
    }

    static void fill_to(std::string& line, std::size_t column) { line.resize(std::max(line.size() + 1, column), ' '); }

    std::size_t depth_ = 0;
    std::string text_;
};

}  // namespace

std::string describe_fields() {
    FieldsText fields;
    fields.add(Frame{});
    return fields.take();
}

}  // namespace pipeline
