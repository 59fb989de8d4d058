// SPDX-License-Identifier: MIT
#include "demo/contact_sheet.h"

#include <algorithm>
#include <array>

#include "demo/label_font.h"

namespace demo {
namespace {

using pipeline::ColorImage;

constexpr int kThumbWidth      = 208;
constexpr int kThumbHeight     = 156;
constexpr int kGap             = 8;
constexpr int kLabelHeight     = kGlyphHeight + 6;
constexpr int kCellWidth       = 2 * kThumbWidth + kGap / 2;  // two thumbnails
constexpr int kCellHeight      = kLabelHeight + kThumbHeight;
constexpr int kMaxColumns      = 8;
constexpr int kSheetMargin     = kGap;
constexpr int kMaxCharacters   = kCellWidth / kGlyphAdvance;
// Neither black nor white nor grey, so that the picture's edge is seen.
constexpr std::uint32_t kPaper = 0xff26303c, kInk = 0xffe8ecf0;

struct Extent {
    int width, height;
};

// The largest size of the same shape that fits a thumbnail, at least one pixel a side.
Extent thumbnail_extent(const ColorImage& image) {
    const int repeats = std::min(kThumbWidth / image.width, kThumbHeight / image.height);
    if (repeats >= 1) return {image.width * repeats, image.height * repeats};
    const bool is_wide = image.width * kThumbHeight >= image.height * kThumbWidth;
    if (is_wide) return {kThumbWidth, std::max(1, image.height * kThumbWidth / image.width)};
    return {std::max(1, image.width * kThumbHeight / image.height), kThumbHeight};
}

// Source pixels [first, end) of target pixel i, of `from` pixels shown as `to`: at least one.
struct Span {
    int first, end;
};
Span source_span(int i, int from, int to) {
    const int first = static_cast<int>(static_cast<std::int64_t>(i) * from / to);
    const int end   = static_cast<int>(static_cast<std::int64_t>(i + 1) * from / to);
    return {first, std::max(first + 1, end)};
}

std::uint32_t average(const ColorImage& image, Span xs, Span ys) {
    std::array<std::uint64_t, 3> sums{};
    for (int y = ys.first; y < ys.end; ++y) {
        for (int x = xs.first; x < xs.end; ++x) {
            const std::uint32_t pixel = image.pixels[static_cast<std::size_t>(y) * image.width + x];
            for (int c = 0; c < 3; ++c) sums[c] += pixel >> (8 * c) & 255;
        }
    }
    const auto count    = static_cast<std::uint64_t>(xs.end - xs.first) * static_cast<std::uint64_t>(ys.end - ys.first);
    std::uint32_t pixel = 0xff000000;
    for (int c = 0; c < 3; ++c) pixel |= static_cast<std::uint32_t>((sums[c] + count / 2) / count) << (8 * c);
    return pixel;
}

ColorImage thumbnail(const ColorImage& image) {
    if (image.width == 0) return {};
    const auto [width, height] = thumbnail_extent(image);
    ColorImage small{.width = width, .height = height, .pixels = {}};
    small.pixels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            small.pixels.push_back(
                average(image, source_span(x, image.width, width), source_span(y, image.height, height)));
        }
    }
    return small;
}

void place(ColorImage& sheet, const ColorImage& image, int left, int top) {
    for (int y = 0; y < image.height; ++y) {
        const auto row = image.pixels.begin() + static_cast<std::ptrdiff_t>(y) * image.width;
        std::copy(row, row + image.width,
                  sheet.pixels.begin() + static_cast<std::ptrdiff_t>(top + y) * sheet.width + left);
    }
}

// As many columns as rows, up to a limit.
int column_count(int cells) {
    int columns = 1;
    while (columns < kMaxColumns && columns * columns < cells) ++columns;
    return columns;
}

}  // namespace

void ContactSheet::add(const std::string& label, const ColorImage& left, const ColorImage& right) {
    if (cells_.size() == kMaxCells) {
        ++left_out_;
    } else {
        cells_.push_back({label, thumbnail(left), thumbnail(right)});
    }
}

ColorImage ContactSheet::draw() const {
    const int cells   = static_cast<int>(cells_.size());
    const int columns = column_count(cells);
    const int rows    = (cells + columns - 1) / columns;
    ColorImage sheet{.width  = kSheetMargin + columns * (kCellWidth + kGap),
                     .height = kSheetMargin + rows * (kCellHeight + kGap) + (left_out_ > 0 ? kLabelHeight : 0),
                     .pixels = {}};
    sheet.pixels.assign(static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height), kPaper);
    for (int i = 0; i < cells; ++i) {
        const Cell& cell = cells_[static_cast<std::size_t>(i)];
        const int x      = kSheetMargin + i % columns * (kCellWidth + kGap);
        const int y      = kSheetMargin + i / columns * (kCellHeight + kGap);
        draw_label(sheet, cell.label.substr(0, kMaxCharacters), x, y, kInk);
        if (cell.left.width == 0) draw_label(sheet, "depth only", x, y + kLabelHeight, kInk);
        place(sheet, cell.left, x, y + kLabelHeight);
        place(sheet, cell.right, x + kCellWidth - kThumbWidth, y + kLabelHeight);
    }
    if (left_out_ > 0) {
        draw_label(sheet, "and " + std::to_string(left_out_) + " more passes", kSheetMargin,
                   sheet.height - kLabelHeight, kInk);
    }
    return sheet;
}

}  // namespace demo
