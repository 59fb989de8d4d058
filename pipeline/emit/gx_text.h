// SPDX-License-Identifier: MIT
// C source as text: indented lines, calls, and literals that read back exactly, whatever the locale.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include "pipeline/frame/math_types.h"

namespace pipeline {

std::string c_float(float value);         // "0.5f"; finite
std::string c_int(std::int64_t value);    // "-3"
std::string c_bytes(std::uint64_t size);  // "1,024"; of comments
std::string c_color(Argb color);          // "(GXColor){ 255, 0, 0, 128 }": red, green, blue, alpha
std::string c_rgba(Argb color);           // "0xff000080u": the same as a word, red in its top byte
std::string c_comment(std::string_view text);
std::string c_string(std::string_view text);

class CText {
  public:
    void line(std::string_view text = {});
    void comment(std::string_view text) { line(c_comment(text)); }
    void call(std::string_view function, std::initializer_list<std::string_view> arguments);
    void open(std::string_view text);  // a line, and what follows it goes further in
    void close(std::string_view text = "}");
    std::string take() { return std::move(text_); }

  private:
    std::string text_;
    std::size_t depth_ = 0;
};

}  // namespace pipeline
