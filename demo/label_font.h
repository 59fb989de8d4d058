// SPDX-License-Identifier: MIT
// Small text on a picture: glyphs of 5x7 pixels for the printable ASCII characters, drawn in label_font.cpp as they
// look.
#pragma once

#include <string_view>

#include "pipeline/execute/execute.h"

namespace demo {

inline constexpr int kGlyphWidth   = 5;
inline constexpr int kGlyphHeight  = 7;
inline constexpr int kGlyphAdvance = kGlyphWidth + 1;

// The top left corner of the first glyph at (left, top); what lies outside the image is left out. Other characters
// show as '?'.
void draw_label(pipeline::ColorImage& image, std::string_view text, int left, int top, std::uint32_t color);

}  // namespace demo
