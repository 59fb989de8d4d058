// SPDX-License-Identifier: MIT
#include "pipeline/emit/dx7_text.h"

#include "pipeline/frame/text_values.h"

namespace pipeline::dx7 {

std::string literal(float value) {
    std::string text;
    append_value(text, value);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text + 'f';
}

std::string literal(Argb color) {
    std::string text;
    append_value(text, color);
    return text;
}

// Octal escapes end after three digits, whatever follows.
std::string literal(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (byte < 32 || byte == 127) {
            out += '\\';
            for (const int shift : {6, 3, 0}) out += static_cast<char>('0' + (byte >> shift & 7));
        } else {
            out += c;
        }
    }
    return out + '"';
}

std::string list_of(std::initializer_list<float> values) {
    std::string text;
    for (const float value : values) text += (text.empty() ? "" : ", ") + literal(value);
    return text;
}

// Direct3D multiplies row vectors, so that its rows are the frame's columns.
std::string list_of(const Mat4& matrix) {
    std::string text;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) text += (text.empty() ? "" : ", ") + literal(matrix[column][row]);
    return text;
}

std::string quoted(std::string_view name) {
    std::string text = "'";
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        text += byte < 32 || byte == 127 ? ' ' : c == '\\' ? '/' : c;
    }
    return text + "'";
}

}  // namespace pipeline::dx7
