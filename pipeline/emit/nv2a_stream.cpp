// SPDX-License-Identifier: MIT
#include "pipeline/emit/nv2a_stream.h"

#include <algorithm>
#include <bit>
#include <vector>

#include "pipeline/frame/text_values.h"

namespace pipeline {
namespace {

constexpr std::size_t kMeaningColumn = 64, kMostColumns = 118, kWordsOfLine = 8;

void append_digits(std::string& out, std::uint64_t value, int digits) {
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) out += "0123456789abcdef"[value >> shift & 15];
}

void append_shown(std::string& out, std::string_view text) {
    for (const char c : text) out += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
}

}  // namespace

std::string numbers(std::span<const float> values) {
    std::string text;
    for (const float value : values) {
        if (!text.empty()) text += ' ';
        append_value(text, value);
    }
    return text;
}

std::string hex(std::uint64_t value, int digits) {
    std::string text = "0x";
    append_digits(text, value, digits);
    return text;
}

void Nv2aStream::section(std::string_view title) {
    text_ += "\n# ";
    append_shown(text_, title);
    text_ += "\n\n";
}

void Nv2aStream::note(std::string_view text) {
    std::string line = "#";
    const auto flush = [&] {
        append_shown(text_, line);
        text_ += '\n';
        line = "#";
    };
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        if (line.size() > 1 && line.size() + 1 + word.size() > kMostColumns) flush();
        line += ' ';
        line += word;
        text.remove_prefix(std::min(word.size() + 1, text.size()));
    }
    flush();
}

void Nv2aStream::note_once(std::string_view text) {
    if (notes_.emplace(text).second) note(text);
}

void Nv2aStream::line(std::string_view text) {
    append_shown(text_, text);
    text_ += '\n';
}

void Nv2aStream::set(const Nv2aMethod& method, std::size_t entry, std::initializer_list<std::uint32_t> values,
                     std::string_view meaning) {
    const std::size_t offset = method.offset + entry * method.stride;
    bool is_new              = false;
    std::size_t at           = offset;
    for (const std::uint32_t value : values) {
        const auto [place, is_first] = words_.try_emplace(at, value);
        is_new                       = is_new || is_first || place->second != value;
        place->second                = value;
        at += 4;
    }
    if (is_new) write(method, entry, false, std::span(values.begin(), values.size()), meaning);
}

void Nv2aStream::set_floats(const Nv2aMethod& method, std::size_t entry, std::span<const float> values,
                            std::string_view meaning) {
    const auto word        = [&](std::size_t i) { return std::bit_cast<std::uint32_t>(values[i]); };
    const std::string text = (meaning.empty() ? "" : std::string(meaning) + ": ") + numbers(values);
    if (values.size() == 1) set(method, entry, {word(0)}, text);
    if (values.size() == 3) set(method, entry, {word(0), word(1), word(2)}, text);
    if (values.size() == 4) set(method, entry, {word(0), word(1), word(2), word(3)}, text);
}

void Nv2aStream::act(const Nv2aMethod& method, std::uint32_t value, std::string_view meaning) {
    write(method, 0, false, {&value, 1}, meaning);
}

void Nv2aStream::feed(const Nv2aMethod& method, std::span<const std::uint32_t> values, std::string_view meaning) {
    for (std::size_t i = 0; i < values.size(); i += kWordsOfLine)
        write(method, 0, true, values.subspan(i, std::min(kWordsOfLine, values.size() - i)), i == 0 ? meaning : "");
}

void Nv2aStream::write(const Nv2aMethod& method, std::size_t entry, bool same_offset,
                       std::span<const std::uint32_t> values, std::string_view meaning) {
    const std::size_t start = text_.size();
    append_digits(text_, method.offset + entry * method.stride, 4);
    text_ += same_offset ? "* " : "  ";
    text_ += method.name;
    if (method.entries > 1) {
        text_ += '[';
        append_value(text_, entry);
        text_ += ']';
    }
    for (const std::uint32_t value : values) {
        text_ += " 0x";
        append_digits(text_, value, 8);
    }
    if (!meaning.empty()) {
        const std::size_t columns = text_.size() - start;
        text_.append(columns < kMeaningColumn ? kMeaningColumn - columns : 1, ' ');
        text_ += "; ";
        append_shown(text_, meaning);
    }
    text_ += '\n';
}

}  // namespace pipeline
