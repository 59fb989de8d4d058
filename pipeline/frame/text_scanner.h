// SPDX-License-Identifier: MIT
// Text as a row of tokens: words, numbers, quoted strings, brackets. Everything that looks at single characters, and
// the one place that knows where an error is. Never allocates but for the text of a string or an error.
#pragma once

#include <charconv>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pipeline {

class TextScanner {
  public:
    explicit TextScanner(std::string_view text) : text_(text) {}

    // Past blanks and comments, which run from // to the end of the line.
    void skip_blanks();

    // What follows; each skips blanks first.
    std::size_t position() { return skip_blanks(), at_; }
    bool at_end() { return position() == text_.size(); }
    char peek() { return at_end() ? '\0' : text_[at_]; }
    bool take(char c);
    bool take_word(std::string_view expected);
    void expect(char c, std::string_view what);  // what: "'{' of blend"
    std::string_view word();                     // letters, digits and _; empty if something else follows
    std::string_view number_token();             // all up to a blank or bracket
    std::string quoted();                        // at a '"'

    template <std::integral Number>
    Number integer(Number least, Number greatest);
    float real();
    std::uint32_t color();  // 0xAARRGGBB
    // Pairs of hexadecimal digits up to the closing bracket, which is taken as well.
    void hex_until_bracket(std::vector<std::uint8_t>& bytes);

    // "'word'" or "the end of the text".
    std::string what_follows();
    [[noreturn]] void fail(const std::string& reason) { fail_at(position(), reason); }
    [[noreturn]] void fail_at(std::size_t position, const std::string& reason) const;
    int line_of(std::size_t position) const;

  private:
    std::string_view text_;
    std::size_t at_ = 0;
};

template <std::integral Number>
Number TextScanner::integer(Number least, Number greatest) {
    const std::size_t start      = position();
    const std::string_view token = number_token();
    Number value{};
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (token.empty() || error != std::errc() || end != token.data() + token.size() || value < least ||
        value > greatest) {
        at_ = start;
        fail("expected an integer from " + std::to_string(least) + " to " + std::to_string(greatest) + ", got " +
             what_follows());
    }
    return value;
}

}  // namespace pipeline
