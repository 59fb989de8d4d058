// SPDX-License-Identifier: MIT
#include "pipeline/cost/page_breaks.h"

#include <algorithm>
#include <cmath>

namespace pipeline {

namespace {

bool is_empty(const PixelRect& rect) {
    return rect.x0 >= rect.x1 || rect.y0 >= rect.y1;
}

// Toward minus infinity: texels can lie left of their texture.
int floor_div(int a, int b) {
    return a >= 0 ? a / b : -((b - 1 - a) / b);
}

struct PageSpan {
    Page first, last;
    int columns() const { return last.column - first.column + 1; }
    int rows() const { return last.row - first.row + 1; }
};
PageSpan pages_of(const PixelRect& rect, PageShape shape) {
    return {{floor_div(rect.x0, shape.width), floor_div(rect.y0, shape.height)},
            {floor_div(rect.x1 - 1, shape.width), floor_div(rect.y1 - 1, shape.height)}};
}

}  // namespace

PageShape page_shape(int bytes_per_pixel) {
    if (bytes_per_pixel == 1) return {128, 64};
    if (bytes_per_pixel == 2) return {64, 64};
    return {64, 32};
}

int row_pairs(const PixelRect& rect) {
    return is_empty(rect) ? 0 : floor_div(rect.y1 - 1, 2) - floor_div(rect.y0, 2) + 1;
}

PageBreaks rectangle_breaks(const PixelRect& rect, int row_pairs, PageShape shape, std::optional<Page>& last) {
    if (is_empty(rect)) return {};
    const PageSpan pages = pages_of(rect, shape);
    const bool goes_on   = pages.first == last;
    last                 = pages.last;
    if (pages.columns() > 1) return {.spans = static_cast<double>(pages.columns()) * row_pairs};
    return {.entries = static_cast<double>(pages.rows() - (goes_on ? 1 : 0))};
}

PageBreaks triangle_breaks(double fragments, double triangles, PageShape shape) {
    if (fragments <= 0.0 || triangles <= 0.0) return {};
    const double side   = std::sqrt(2.0 * fragments / triangles);
    const double across = side / 2.0 / shape.width;  // pages that a row pair crosses on average
    const double spans  = across < 1.0 ? 2.0 * across : 1.0 + across;
    return {.spans   = triangles * side / 2.0 * spans,
            .entries = triangles * std::max(0.0, 1.0 - across) * side / shape.height};
}

PageBreaks paged_breaks(const PixelRect& rect, PageShape shape) {
    if (is_empty(rect)) return {};
    const PageSpan pages = pages_of(rect, shape);
    return {.entries = static_cast<double>(pages.columns()) * pages.rows()};
}

}  // namespace pipeline
