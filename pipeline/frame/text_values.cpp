// SPDX-License-Identifier: MIT
#include "pipeline/frame/text_values.h"

namespace pipeline {

namespace {
constexpr char kHexDigits[] = "0123456789abcdef";
}

void append_hex(std::string& out, const std::uint8_t* bytes, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        out += kHexDigits[bytes[i] >> 4];
        out += kHexDigits[bytes[i] & 15];
    }
}

void append_value(std::string& out, Argb value) {
    out += "0x";
    for (int shift = 28; shift >= 0; shift -= 4) out += kHexDigits[value.value >> shift & 15];
}

void append_value(std::string& out, const std::string& value) {
    out += '"';
    for (const char c : value) {
        const auto byte = static_cast<std::uint8_t>(c);
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (c == '\n') {
            out += "\\n";
        } else if (c == '\t') {
            out += "\\t";
        } else if (c == '\r') {
            out += "\\r";
        } else if (byte < 0x20 || byte == 0x7f) {
            out += "\\x";
            append_hex(out, &byte, 1);
        } else {
            out += c;
        }
    }
    out += '"';
}

}  // namespace pipeline
