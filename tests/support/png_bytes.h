// SPDX-License-Identifier: MIT
// A PNG file made by hand from the specification (ISO/IEC 15948), uncompressed: for kinds that the program itself
// never writes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tests {

// Colour types of PNG: 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA.
struct PngKind {
    int color_type = 6;
    int bits       = 8;  // of a sample; 16-bit samples are two bytes, high first
};

// rows: the bytes of each row. palette: R, G, B each. palette_alpha: the tRNS chunk, if not empty.
std::string png_bytes(int width, int height, PngKind kind, const std::vector<std::string>& rows,
                      const std::string& palette = "", const std::string& palette_alpha = "");

}  // namespace tests
