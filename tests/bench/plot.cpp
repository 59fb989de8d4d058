// SPDX-License-Identifier: MIT
#include "tests/bench/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>

#include "demo/drawing.h"

namespace bench {

namespace {

using demo::Drawing;
using demo::DrawingScale;
using demo::DrawnDot;
using demo::DrawnLine;
using demo::DrawnWords;
using demo::Ink;
using Anchor = DrawnWords::Anchor;

struct Series {
    std::string_view prefix, title;
    double slope;  // in proportion, or inversely
};
constexpr std::array kSeries{
    Series{"growth/canyon/", "canyon: pixels", 1.0},
    Series{"growth/spheres/", "one cloud: spheres", 1.0},
    Series{"growth/clouds/", "clouds of 24 spheres", 1.0},
    Series{"growth/threads/", "canyon, 1080p: threads", -1.0},
};

struct Point {
    double size, seconds;
};

std::vector<Point> points_of(const Series& series, const std::vector<Figure>& figures) {
    std::vector<Point> points;
    for (const Figure& figure : figures)
        if (figure.name.starts_with(series.prefix) && figure.size > 0.0)
            points.push_back({figure.size, figure.seconds});
    std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.size < b.size; });
    return points;
}

// In pixels of the picture.
constexpr double kPanelWidth = 200.0, kPanelHeight = 190.0, kPanelStep = 232.0, kTop = 46.0, kLeft = 66.0;
constexpr double kHeight = kTop + kPanelHeight + 36.0;

// Logarithmic, with a margin at both ends.
DrawingScale scale_over(double low, double high, double margin, double first_px, double last_px) {
    return {low / margin, high * margin, first_px, last_px, true};
}

template <class... Values>
std::string text(const char* format, Values... values) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, format, values...);
    return buffer;
}

// "500k", "2M"
std::string size_text(double size) {
    if (size >= 1e6) return text("%.3gM", size / 1e6);
    if (size >= 1e3) return text("%.3gk", size / 1e3);
    return text("%.3g", size);
}

std::string tick_time(double seconds) {
    return seconds >= 1.0 ? text("%.3g s", seconds) : text("%.3g ms", seconds * 1e3);
}

void add_grid(Drawing& drawing, const DrawingScale& x, const DrawingScale& y, bool has_times) {
    for (const double tick : x.ticks()) {
        drawing.items.emplace_back(DrawnLine{{{x.px(tick), y.first_px}, {x.px(tick), y.last_px}}});
        drawing.items.emplace_back(DrawnWords{{x.px(tick), y.first_px + 17.0}, Anchor::Middle, size_text(tick)});
    }
    for (const double tick : y.ticks()) {
        drawing.items.emplace_back(DrawnLine{{{x.first_px, y.px(tick)}, {x.last_px, y.px(tick)}}});
        if (has_times)
            drawing.items.emplace_back(DrawnWords{{x.first_px - 8.0, y.px(tick) + 4.0}, Anchor::End, tick_time(tick)});
    }
}

// From the first point as far as the panel goes.
DrawnLine in_proportion(const std::vector<Point>& points, double slope, const DrawingScale& x, const DrawingScale& y) {
    const Point first  = points.front();
    const double limit = slope > 0.0 ? y.high : y.low;
    const double size  = std::min(x.high, first.size * std::pow(limit / first.seconds, 1.0 / slope));
    return {{{x.px(first.size), y.px(first.seconds)},
             {x.px(size), y.px(first.seconds * std::pow(size / first.size, slope))}},
            Ink::Muted,
            1.2,
            true};
}

void add_panel(Drawing& drawing, const Series& series, const std::vector<Point>& points, double left,
               const DrawingScale& y, bool is_first) {
    const DrawingScale x = scale_over(points.front().size, points.back().size, 1.25, left, left + kPanelWidth);
    drawing.items.emplace_back(
        DrawnWords{{left, kTop - 14.0}, Anchor::Start, std::string(series.title), 13.0, Ink::Title, true});
    add_grid(drawing, x, y, is_first);
    drawing.items.emplace_back(in_proportion(points, series.slope, x, y));
    DrawnLine curve{{}, Ink::Accent, 2.0};
    for (const Point& point : points) curve.points.push_back({x.px(point.size), y.px(point.seconds)});
    drawing.items.emplace_back(curve);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double px = x.px(points[i].size), py = y.px(points[i].seconds);
        drawing.items.emplace_back(DrawnDot{{px, py}});
        // On the side where the curve is not: right of each point, left of the last.
        const bool is_last  = i > 0 && i + 1 == points.size();
        const bool is_below = is_last == (series.slope < 0.0);
        drawing.items.emplace_back(DrawnWords{{px + (is_last ? -6.0 : 6.0), py + (is_below ? 14.0 : -6.0)},
                                              is_last ? Anchor::End : Anchor::Start,
                                              format_time(points[i].seconds),
                                              10.5,
                                              Ink::AccentLabel});
    }
}

}  // namespace

std::string to_plot(const std::vector<Figure>& figures) {
    struct Drawn {
        Series series;
        std::vector<Point> points;
    };
    std::vector<Drawn> drawn;
    double least = 1e30, greatest = 0.0;
    for (const Series& series : kSeries) {
        std::vector<Point> points = points_of(series, figures);
        if (points.empty()) continue;
        for (const Point& point : points) {
            least    = std::min(least, point.seconds);
            greatest = std::max(greatest, point.seconds);
        }
        drawn.push_back({series, std::move(points)});
    }
    if (drawn.empty()) throw std::runtime_error("no figures of growth/* to plot");

    const DrawingScale y = scale_over(least, greatest, 1.6, kTop + kPanelHeight, kTop);
    Drawing drawing{kLeft + kPanelStep * static_cast<double>(drawn.size()), kHeight, {}};
    for (std::size_t i = 0; i < drawn.size(); ++i)
        add_panel(drawing, drawn[i].series, drawn[i].points, kLeft + kPanelStep * static_cast<double>(i), y, i == 0);
    return demo::to_svg(drawing);
}

}  // namespace bench
