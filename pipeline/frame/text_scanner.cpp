// SPDX-License-Identifier: MIT
#include "pipeline/frame/text_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/frame/frame_text.h"
#include "pipeline/frame/text_values.h"

namespace pipeline {

namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

bool is_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool ends_token(char c) {
    return is_blank(c) || c == '(' || c == ')' || c == '[' || c == ']' || c == '{' || c == '}' || c == '"';
}

constexpr std::array<std::int8_t, 256> kHexValue = [] {
    std::array<std::int8_t, 256> values{};
    values.fill(-1);
    for (int i = 0; i < 10; ++i) values['0' + i] = static_cast<std::int8_t>(i);
    for (int i = 0; i < 6; ++i) values['a' + i] = values['A' + i] = static_cast<std::int8_t>(10 + i);
    return values;
}();

int hex_value(char c) {
    return kHexValue[static_cast<std::uint8_t>(c)];
}

}  // namespace

void TextScanner::skip_blanks() {
    while (at_ < text_.size()) {
        if (is_blank(text_[at_])) {
            ++at_;
        } else if (text_.substr(at_, 2) == "//") {
            at_ = std::min(text_.find('\n', at_), text_.size());
        } else {
            return;
        }
    }
}

bool TextScanner::take(char c) {
    if (peek() != c || at_ == text_.size()) return false;
    ++at_;
    return true;
}

bool TextScanner::take_word(std::string_view expected) {
    const std::size_t start = position();
    if (word() == expected) return true;
    at_ = start;
    return false;
}

void TextScanner::expect(char c, std::string_view what) {
    if (!take(c)) fail("expected " + std::string(what) + ", got " + what_follows());
}

std::string_view TextScanner::word() {
    const std::size_t start = position();
    while (at_ < text_.size() && is_word(text_[at_])) ++at_;
    return text_.substr(start, at_ - start);
}

std::string_view TextScanner::number_token() {
    const std::size_t start = position();
    while (at_ < text_.size() && !ends_token(text_[at_])) ++at_;
    return text_.substr(start, at_ - start);
}

std::string TextScanner::quoted() {
    const std::size_t start = position();
    if (!take('"')) fail("expected a string in double quotes, got " + what_follows());
    std::string value;
    for (; at_ < text_.size() && text_[at_] != '\n'; ++at_) {
        if (text_[at_] == '"') return ++at_, value;
        if (text_[at_] != '\\') {
            value += text_[at_];
            continue;
        }
        const std::size_t escape = at_++;
        switch (at_ < text_.size() ? text_[at_] : '\0') {
            case '"':
                value += '"';
                break;
            case '\\':
                value += '\\';
                break;
            case 'n':
                value += '\n';
                break;
            case 't':
                value += '\t';
                break;
            case 'r':
                value += '\r';
                break;
            case 'x':
                if (at_ + 2 < text_.size() && hex_value(text_[at_ + 1]) >= 0 && hex_value(text_[at_ + 2]) >= 0) {
                    value += static_cast<char>(hex_value(text_[at_ + 1]) * 16 + hex_value(text_[at_ + 2]));
                    at_ += 2;
                    break;
                }
                [[fallthrough]];
            default:
                fail_at(escape, R"(unknown escape in a string: there are \" \\ \n \t \r \x7f)");
        }
    }
    fail_at(start, "the string is not closed on its line");
}

float TextScanner::real() {
    const std::size_t start      = position();
    const std::string_view token = number_token();
    float value                  = 0.0f;
    const auto [end, error]      = std::from_chars(token.data(), token.data() + token.size(), value);
    const bool whole             = !token.empty() && end == token.data() + token.size();
    at_                          = start;
    if (!whole || error == std::errc::invalid_argument) fail("expected a number, got " + what_follows());
    const bool spelled = token.find_first_of("iInN") != std::string_view::npos;  // inf, nan
    if (error != std::errc() || (!std::isfinite(value) && !spelled)) {
        fail("the number " + what_follows() + " is out of the range of single precision");
    }
    at_ = start + token.size();
    return value;
}

std::uint32_t TextScanner::color() {
    const std::size_t start      = position();
    const std::string_view token = number_token();
    std::uint32_t value          = 0;
    bool valid                   = token.size() == 10 && token.substr(0, 2) == "0x";
    for (std::size_t i = 2; valid && i < token.size(); ++i) {
        valid = hex_value(token[i]) >= 0;
        value = value << 4 | (hex_value(token[i]) & 15);
    }
    if (!valid) {
        at_ = start;
        fail("expected a colour, 0xAARRGGBB, got " + what_follows());
    }
    return value;
}

void TextScanner::hex_until_bracket(std::vector<std::uint8_t>& bytes) {
    while (!take(']')) {
        const int high = hex_value(peek());
        const int low  = at_ + 1 < text_.size() ? hex_value(text_[at_ + 1]) : -1;
        if (high < 0) fail("expected hexadecimal bytes or ']', got " + what_follows());
        if (low < 0) fail_at(at_ + 1, "half a byte: a byte has two hexadecimal digits");
        bytes.push_back(static_cast<std::uint8_t>(high * 16 + low));
        at_ += 2;
    }
}

std::string TextScanner::what_follows() {
    constexpr std::size_t kLongest = 40;
    if (at_end()) return "the end of the text";
    std::size_t end = at_;
    while (end < text_.size() && !ends_token(text_[end]) && end - at_ < kLongest) ++end;
    std::string shown = "'";
    for (const char c : text_.substr(at_, std::max<std::size_t>(end - at_, 1))) {
        const auto byte = static_cast<std::uint8_t>(c);
        if (byte >= 0x20 && byte < 0x7f) {
            shown += c;
        } else {
            shown += "\\x";
            append_hex(shown, &byte, 1);
        }
    }
    return shown + "'";
}

int TextScanner::line_of(std::size_t position) const {
    return 1 + static_cast<int>(std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(position), '\n'));
}

void TextScanner::fail_at(std::size_t position, const std::string& reason) const {
    const std::size_t newline = position == 0 ? std::string_view::npos : text_.rfind('\n', position - 1);
    const std::size_t start   = newline == std::string_view::npos ? 0 : newline + 1;
    throw ParseError(line_of(position), static_cast<int>(position - start) + 1, reason);
}

}  // namespace pipeline
