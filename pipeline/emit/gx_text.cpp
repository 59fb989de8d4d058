// SPDX-License-Identifier: MIT
#include "pipeline/emit/gx_text.h"

#include <array>
#include <charconv>

namespace pipeline {

namespace {

std::uint32_t byte_of(Argb color, int shift) {
    return (color.value >> shift) & 0xffu;
}

}  // namespace

std::string c_float(float value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    std::string text(digits.data(), end);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text + 'f';
}

std::string c_int(std::int64_t value) {
    return std::to_string(value);
}

std::string c_bytes(std::uint64_t size) {
    std::string text = std::to_string(size);
    for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
    return text;
}

std::string c_color(Argb color) {
    return "(GXColor){ " + c_int(byte_of(color, 16)) + ", " + c_int(byte_of(color, 8)) + ", " +
           c_int(byte_of(color, 0)) + ", " + c_int(byte_of(color, 24)) + " }";
}

std::string c_rgba(Argb color) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    const std::uint32_t rgba           = color.value << 8 | color.value >> 24;
    std::string text                   = "0x";
    for (int shift = 28; shift >= 0; shift -= 4) text += kDigits[(rgba >> shift) & 15u];
    return text + 'u';
}

// Names from a frame may hold anything: nothing of them may end the comment, or look like the start of another.
std::string c_comment(std::string_view text) {
    std::string out = "/* ";
    for (const char c : text) {
        const bool is_control = static_cast<unsigned char>(c) < 0x20;
        if (c == '/' && (out.back() == '*' || out.back() == '/')) out += ' ';
        if (c == '*' && out.back() == '/') out += ' ';
        out += is_control ? ' ' : c;
    }
    return out + " */";
}

std::string c_string(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + '"';
}

void CText::line(std::string_view text) {
    if (!text.empty()) {
        text_.append(4 * depth_, ' ');
        text_ += text;
    }
    text_ += '\n';
}

void CText::call(std::string_view function, std::initializer_list<std::string_view> arguments) {
    std::string text(function);
    text += '(';
    bool first = true;
    for (const std::string_view argument : arguments) {
        if (!first) text += ", ";
        first = false;
        text += argument;
    }
    line(text + ");");
}

void CText::open(std::string_view text) {
    line(text);
    ++depth_;
}

void CText::close(std::string_view text) {
    --depth_;
    line(text);
}

}  // namespace pipeline
