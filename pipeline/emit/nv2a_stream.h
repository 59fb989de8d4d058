// SPDX-License-Identifier: MIT
// Methods as text, in the form that emit_nv2a.h describes.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "pipeline/emit/nv2a_methods.h"

namespace pipeline {

// Texts of the frame (labels, names) may hold anything; what would end a line is shown as '?'.
class Nv2aStream {
  public:
    // A title between empty lines.
    void section(std::string_view title);
    // "# ...", cut into lines between words.
    void note(std::string_view text);
    // The same once, since `forget`.
    void note_once(std::string_view text);
    // As it is.
    void line(std::string_view text);

    // A state: nothing is written if the words were the same before, since `forget`.
    void set(const Nv2aMethod& method, std::size_t entry, std::initializer_list<std::uint32_t> values,
             std::string_view meaning);
    void set(const Nv2aMethod& method, std::initializer_list<std::uint32_t> values, std::string_view meaning) {
        set(method, 0, values, meaning);
    }
    void set(const Nv2aMethod& method, const Nv2aValue& value) { set(method, 0, {value.value}, value.name); }
    void set_flag(const Nv2aMethod& method, bool on) { set(method, 0, {on ? 1u : 0u}, on ? "on" : "off"); }
    void set_floats(const Nv2aMethod& method, std::size_t entry, std::span<const float> values,
                    std::string_view meaning);

    // An action: always written.
    void act(const Nv2aMethod& method, std::uint32_t value, std::string_view meaning);
    // All words to one method.
    void feed(const Nv2aMethod& method, std::span<const std::uint32_t> values, std::string_view meaning);

    // The next states are written whatever was before.
    void forget() {
        words_.clear();
        notes_.clear();
    }

    std::string take() { return std::move(text_); }

  private:
    void write(const Nv2aMethod& method, std::size_t entry, bool same_offset, std::span<const std::uint32_t> values,
               std::string_view meaning);

    std::string text_;
    std::map<std::size_t, std::uint32_t> words_;  // by offset, of NV097 alone
    std::set<std::string, std::less<>> notes_;
};

// "1 0.5 -2": the numbers in the shortest form that reads back to the same bits.
std::string numbers(std::span<const float> values);
// "0x0123abcd"
std::string hex(std::uint64_t value, int digits = 8);

}  // namespace pipeline
