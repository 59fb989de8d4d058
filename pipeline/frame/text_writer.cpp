// SPDX-License-Identifier: MIT
#include "pipeline/frame/text_writer.h"

#include <algorithm>

namespace pipeline {

void TextWriter::new_line() {
    out_ += '\n';
    line_start_ = out_.size();
    out_.append(4 * depth_, ' ');
}

void TextWriter::write_matrix(const Mat4& matrix) {
    const auto one_line = [&] {
        for (int row = 0; row < 4; ++row) {
            out_ += row == 0 ? '(' : ' ';
            append_value(out_, matrix_row(matrix, row));
        }
        out_ += ')';
    };
    if (fits_on_line(one_line)) return;
    out_ += '(';
    ++depth_;
    for (int row = 0; row < 4; ++row) {
        new_line();
        append_value(out_, matrix_row(matrix, row));
    }
    --depth_;
    new_line();
    out_ += ')';
}

void TextWriter::write_bytes(const std::vector<std::uint8_t>& bytes) {
    out_ += '[';
    if (bytes.size() <= kBytesPerLine) {
        append_hex(out_, bytes.data(), bytes.size());
    } else {
        ++depth_;
        for (std::size_t i = 0; i < bytes.size(); i += kBytesPerLine) {
            new_line();
            append_hex(out_, bytes.data() + i, std::min(kBytesPerLine, bytes.size() - i));
        }
        --depth_;
        new_line();
    }
    out_ += ']';
}

}  // namespace pipeline
