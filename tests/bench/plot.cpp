// SPDX-License-Identifier: MIT
#include "tests/bench/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>

namespace bench {

namespace {

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

// Values low to high along a line of the picture, logarithmically.
struct Scale {
    double low, high, first_px, last_px;

    double px(double value) const {
        return first_px + std::log(value / low) / std::log(high / low) * (last_px - first_px);
    }

    // 1, 2 and 5 times powers of ten; if those were too many, the powers alone.
    std::vector<double> ticks() const {
        const bool few = high / low < 300.0;
        std::vector<double> ticks;
        for (double power = std::pow(10.0, std::floor(std::log10(low))); power <= high; power *= 10.0)
            for (const double step : {1.0, 2.0, 5.0})
                if ((few || step == 1.0) && power * step >= low * 0.999 && power * step <= high * 1.001)
                    ticks.push_back(power * step);
        return ticks;
    }
};

// With a margin at both ends.
Scale scale_over(double low, double high, double margin, double first_px, double last_px) {
    return {low / margin, high * margin, first_px, last_px};
}

template <class... Values>
std::string text(const char* format, Values... values) {
    char buffer[512];
    std::snprintf(buffer, sizeof buffer, format, values...);
    return buffer;
}

// Attributes, not a style sheet: every program that shows SVG knows those.
constexpr const char* kGrid  = "stroke=\"#e5e7eb\"";
constexpr const char* kEven  = "stroke=\"#9ca3af\" stroke-width=\"1.2\" stroke-dasharray=\"4 4\"";
constexpr const char* kCurve = "fill=\"none\" stroke=\"#2563eb\" stroke-width=\"2\" stroke-linejoin=\"round\"";
constexpr const char* kPoint = "fill=\"#2563eb\" stroke=\"#ffffff\" stroke-width=\"1.2\"";
constexpr const char* kTitle = "font-size=\"13\" font-weight=\"600\" fill=\"#111827\"";
constexpr const char* kTick  = "font-size=\"11\" fill=\"#4b5563\"";
constexpr const char* kValue = "font-size=\"10.5\" fill=\"#1d4ed8\"";

std::string line(double x0, double y0, double x1, double y1, const char* look) {
    return text("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" %s/>\n", x0, y0, x1, y1, look);
}

// anchor: which end of the words x is: start, middle or end.
std::string words(double x, double y, const char* anchor, const char* look, const std::string& what) {
    return text("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" %s>%s</text>\n", x, y, anchor, look, what.c_str());
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

std::string grid(const Scale& x, const Scale& y, bool has_times) {
    std::string out;
    for (const double tick : x.ticks()) {
        out += line(x.px(tick), y.first_px, x.px(tick), y.last_px, kGrid);
        out += words(x.px(tick), y.first_px + 17.0, "middle", kTick, size_text(tick));
    }
    for (const double tick : y.ticks()) {
        out += line(x.first_px, y.px(tick), x.last_px, y.px(tick), kGrid);
        if (has_times) out += words(x.first_px - 8.0, y.px(tick) + 4.0, "end", kTick, tick_time(tick));
    }
    return out;
}

// From the first point as far as the panel goes.
std::string in_proportion(const std::vector<Point>& points, double slope, const Scale& x, const Scale& y) {
    const Point first  = points.front();
    const double limit = slope > 0.0 ? y.high : y.low;
    const double size  = std::min(x.high, first.size * std::pow(limit / first.seconds, 1.0 / slope));
    return line(x.px(first.size), y.px(first.seconds), x.px(size),
                y.px(first.seconds * std::pow(size / first.size, slope)), kEven);
}

std::string panel(const Series& series, const std::vector<Point>& points, double left, const Scale& y, bool is_first) {
    const Scale x   = scale_over(points.front().size, points.back().size, 1.25, left, left + kPanelWidth);
    std::string out = words(left, kTop - 14.0, "start", kTitle, std::string(series.title));
    out += grid(x, y, is_first);
    out += in_proportion(points, series.slope, x, y);
    std::string path;
    for (const Point& point : points) path += text("%.1f,%.1f ", x.px(point.size), y.px(point.seconds));
    out += text("<polyline %s points=\"", kCurve) + path + "\"/>\n";
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double px = x.px(points[i].size), py = y.px(points[i].seconds);
        out += text("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3.5\" %s/>\n", px, py, kPoint);
        // On the side where the curve is not: right of each point, left of the last.
        const bool is_last  = i > 0 && i + 1 == points.size();
        const bool is_below = is_last == (series.slope < 0.0);
        out += words(px + (is_last ? -6.0 : 6.0), py + (is_below ? 14.0 : -6.0), is_last ? "end" : "start", kValue,
                     format_time(points[i].seconds));
    }
    return out;
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

    const Scale y      = scale_over(least, greatest, 1.6, kTop + kPanelHeight, kTop);
    const double width = kLeft + kPanelStep * static_cast<double>(drawn.size());
    std::string svg    = text(
           "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" "
              "font-family=\"system-ui, 'Segoe UI', 'DejaVu Sans', sans-serif\">\n",
           width, kHeight);
    svg += text("<rect width=\"%.0f\" height=\"%.0f\" rx=\"6\" fill=\"#ffffff\"/>\n", width, kHeight);
    for (std::size_t i = 0; i < drawn.size(); ++i)
        svg += panel(drawn[i].series, drawn[i].points, kLeft + kPanelStep * static_cast<double>(i), y, i == 0);
    return svg + "</svg>\n";
}

}  // namespace bench
