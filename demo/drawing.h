// SPDX-License-Identifier: MIT
// A diagram as plain data, lines, dots and words, and the two ways it is shown: as SVG, which every program that shows SVG
// understands (attributes, no style sheet), and as pixels. Lengths in pixels at scale 1, y down.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "pipeline/execute/execute.h"

namespace demo {

enum class Ink : std::uint8_t { Paper, Grid, Muted, Label, Title, Accent, AccentLabel };

struct DrawingPoint {
    double x = 0.0, y = 0.0;
};

// Through two points or more.
struct DrawnLine {
    std::vector<DrawingPoint> points;
    Ink ink      = Ink::Grid;
    double width = 1.0;
    bool dashed  = false;
};

// With a rim of paper.
struct DrawnDot {
    DrawingPoint center;
    double radius = 3.5;
    Ink ink       = Ink::Accent;
};

// at: on the line that the letters stand on; `anchor` says which end of the words.
struct DrawnWords {
    enum class Anchor : std::uint8_t { Start, Middle, End };
    DrawingPoint at;
    Anchor anchor = Anchor::Start;
    std::string text;
    double size = 11.0;
    Ink ink     = Ink::Label;
    bool bold   = false;
};

struct Drawing {
    double width = 0.0, height = 0.0;
    std::vector<std::variant<DrawnLine, DrawnDot, DrawnWords>> items;  // later ones lie over earlier ones
};

// Values low to high along a line of the picture.
struct DrawingScale {
    double low, high, first_px, last_px;
    bool logarithmic = false;

    double px(double value) const;
    // Round values: 1, 2 and 5 times powers of ten; on a long logarithmic scale the powers alone.
    std::vector<double> ticks() const;
};

// Colours as SVG writes them, in the order of Ink.
using DrawingColors = std::array<std::string_view, 7>;
inline constexpr DrawingColors kPaperColors{"#ffffff", "#e5e7eb", "#9ca3af", "#4b5563",
                                            "#111827", "#2563eb", "#1d4ed8"};

std::string to_svg(const Drawing& drawing, const DrawingColors& colors = kPaperColors);

// In kPaperColors. Letters are label_font's, `scale` pixels for each of theirs.
pipeline::ColorImage to_image(const Drawing& drawing, int scale);

// & < > " as entities.
std::string escaped(std::string_view text);

}  // namespace demo
