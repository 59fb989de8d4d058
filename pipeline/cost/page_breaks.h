// SPDX-License-Identifier: MIT
// How often filling changes the page on the Graphics Synthesizer: estimated from rectangles exactly and from triangles
// by their mean size. A primitive is scanned from left to right in rows of pixel pairs, then down (jbit.net, "PS2
// Graphics Synthesizer Fill Performance").
//
//   A rectangle over k > 1 pages side by side    spans = k * row pairs: k - 1 from page to page and one back
//   within one column of pages                   entries = pages under each other; the first not, if the last
//                                                rectangle ended there
//   n triangles of f fragments in all            each as half of a square of side s = sqrt(2 f / n) at a random place,
//                                                whose row pairs are s / 2 pixels long on average. With c = (s / 2) /
//                                                page width, of s / 2 row pairs each has 2 c spans, or 1 + c from c = 1
//                                                on; entries = (1 - c) * s / page height
// Pages are 64x32 pixels of 24 and 32 bits, 64x64 of 16, 128x64 of 8 (parallel-gs, swizzle_utils.h); targets and
// textures begin on one.
#pragma once

#include <optional>

#include "pipeline/frame/frame.h"

namespace pipeline {

struct PageShape {
    int width = 64, height = 32;  // pixels
    bool operator==(const PageShape&) const = default;
};
PageShape page_shape(int bytes_per_pixel);

// What ChipRates::page_breaks tells apart.
struct PageBreaks {
    double spans = 0.0, entries = 0.0;
    bool operator==(const PageBreaks&) const = default;
};

struct Page {
    int column = 0, row = 0;
    bool operator==(const Page&) const = default;
};

// rect: pixels that are covered, or texels that are read. row_pairs: of the pixels that do so. last: the page where the
// drawing before ended, if that is known; becomes where this ends.
PageBreaks rectangle_breaks(const PixelRect& rect, int row_pairs, PageShape shape, std::optional<Page>& last);
int row_pairs(const PixelRect& rect);

// Without the page that each triangle may enter as it begins.
PageBreaks triangle_breaks(double fragments, double triangles, PageShape shape);

// In page-sized pieces: each page once. That is how a clear is done fast.
PageBreaks paged_breaks(const PixelRect& rect, PageShape shape);

}  // namespace pipeline
