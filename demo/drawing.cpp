// SPDX-License-Identifier: MIT
#include "demo/drawing.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "demo/label_font.h"

namespace demo {
namespace {

template <class... Values>
std::string text(const char* format, Values... values) {
    char buffer[512];
    std::snprintf(buffer, sizeof buffer, format, values...);
    return buffer;
}

class SvgWriter {
  public:
    SvgWriter(const Drawing& drawing, const DrawingColors& colors) : colors_(colors) {
        out_ = text(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" "
            "font-family=\"system-ui, 'Segoe UI', 'DejaVu Sans', sans-serif\">\n",
            drawing.width, drawing.height);
        out_ += text("<rect width=\"%.0f\" height=\"%.0f\" rx=\"6\" fill=\"", drawing.width, drawing.height) +
                color(Ink::Paper) + "\"/>\n";
        for (const auto& item : drawing.items) std::visit([this](const auto& what) { add(what); }, item);
        out_ += "</svg>\n";
    }
    std::string take() && { return std::move(out_); }

  private:
    std::string color(Ink ink) const { return std::string(colors_[static_cast<std::size_t>(ink)]); }

    std::string stroke(const DrawnLine& line) const {
        std::string look = "stroke=\"" + color(line.ink) + "\"";
        if (line.width != 1.0) look += text(" stroke-width=\"%.3g\"", line.width);
        return look + (line.dashed ? " stroke-dasharray=\"4 4\"" : "");
    }
    void add(const DrawnLine& line) {
        if (line.points.size() == 2) {
            const auto& [from, to] = std::pair(line.points[0], line.points[1]);
            out_ += text("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" ", from.x, from.y, to.x, to.y) +
                    stroke(line) + "/>\n";
            return;
        }
        out_ += "<polyline fill=\"none\" " + stroke(line) + " stroke-linejoin=\"round\" points=\"";
        for (const DrawingPoint& point : line.points) out_ += text("%.1f,%.1f ", point.x, point.y);
        out_ += "\"/>\n";
    }
    void add(const DrawnDot& dot) {
        out_ += text("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.3g\" ", dot.center.x, dot.center.y, dot.radius) +
                "fill=\"" + color(dot.ink) + "\" stroke=\"" + color(Ink::Paper) + "\" stroke-width=\"1.2\"/>\n";
    }
    void add(const DrawnWords& words) {
        constexpr std::array kAnchors{"start", "middle", "end"};
        out_ += text("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" font-size=\"%.3g\"%s ", words.at.x, words.at.y,
                     kAnchors[static_cast<std::size_t>(words.anchor)], words.size,
                     words.bold ? " font-weight=\"600\"" : "") +
                "fill=\"" + color(words.ink) + "\">" + escaped(words.text) + "</text>\n";
    }

    const DrawingColors& colors_;
    std::string out_;
};

std::uint32_t pixel_of(Ink ink) {
    const std::string_view digits = kPaperColors[static_cast<std::size_t>(ink)].substr(1);
    std::uint32_t color           = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), color, 16);
    return 0xff000000u | color;
}

// Edges are soft over one pixel.
class PixelPainter {
  public:
    PixelPainter(const Drawing& drawing, int scale)
        : scale_(scale),
          image_{.width  = static_cast<int>(std::lround(drawing.width * scale)),
                 .height = static_cast<int>(std::lround(drawing.height * scale)),
                 .pixels = {}} {
        image_.pixels.assign(static_cast<std::size_t>(image_.width) * static_cast<std::size_t>(image_.height),
                             pixel_of(Ink::Paper));
        for (const auto& item : drawing.items) std::visit([this](const auto& what) { add(what); }, item);
    }
    pipeline::ColorImage take() && { return std::move(image_); }

  private:
    // distance: of a pixel's centre, in pixels, from what is drawn; at most `reach` away it shows.
    template <class Distance>
    void paint(double x0, double y0, double x1, double y1, double reach, Ink ink, Distance&& distance) {
        const std::uint32_t color = pixel_of(ink);
        const auto from           = [](double low) { return std::max(0, static_cast<int>(std::floor(low))); };
        const int end_x           = std::min(image_.width, static_cast<int>(std::ceil(x1 + reach + 1.0)));
        const int end_y           = std::min(image_.height, static_cast<int>(std::ceil(y1 + reach + 1.0)));
        for (int y = from(y0 - reach - 1.0); y < end_y; ++y)
            for (int x = from(x0 - reach - 1.0); x < end_x; ++x) {
                const double cover = std::clamp(reach + 0.5 - distance(x + 0.5, y + 0.5), 0.0, 1.0);
                std::uint32_t& pixel =
                    image_.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) +
                                  static_cast<std::size_t>(x)];
                std::uint32_t mixed = 0xff000000u;
                for (int shift = 0; shift < 24; shift += 8) {
                    const double below = pixel >> shift & 255, above = color >> shift & 255;
                    mixed |= static_cast<std::uint32_t>(std::lround(below + (above - below) * cover)) << shift;
                }
                pixel = mixed;
            }
    }

    void segment(DrawingPoint a, DrawingPoint b, double width, Ink ink) {
        const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
        paint(std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y), 0.5 * width, ink,
              [&](double x, double y) {
                  const double along =
                      square > 0.0 ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
                  return std::hypot(x - a.x - along * dx, y - a.y - along * dy);
              });
    }
    void add(const DrawnLine& line) {
        const auto scaled = [&](DrawingPoint point) { return DrawingPoint{point.x * scale_, point.y * scale_}; };
        for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
            const DrawingPoint a = scaled(line.points[i]), b = scaled(line.points[i + 1]);
            const double length = std::hypot(b.x - a.x, b.y - a.y), dash = line.dashed ? 4.0 * scale_ : length;
            for (double at = 0.0; at < length; at += 2.0 * dash) {
                const auto point = [&](double along) {
                    return DrawingPoint{a.x + (b.x - a.x) * along / length, a.y + (b.y - a.y) * along / length};
                };
                segment(point(at), point(std::min(at + dash, length)), line.width * scale_, line.ink);
            }
        }
    }
    void add(const DrawnDot& dot) {
        const double x = dot.center.x * scale_, y = dot.center.y * scale_, radius = dot.radius * scale_;
        const auto distance = [&](double px, double py) { return std::hypot(px - x, py - y); };
        paint(x, y, x, y, radius + 0.6 * scale_, Ink::Paper, distance);
        paint(x, y, x, y, radius - 0.6 * scale_, dot.ink, distance);
    }
    void add(const DrawnWords& words) {
        const int width  = static_cast<int>(words.text.size()) * kGlyphAdvance - 1;
        const double end = words.anchor == DrawnWords::Anchor::Start    ? 0.0
                           : words.anchor == DrawnWords::Anchor::Middle ? 0.5
                                                                        : 1.0;
        pipeline::ColorImage letters{.width = width, .height = kGlyphHeight, .pixels = {}};
        if (words.text.empty()) return;
        letters.pixels.assign(static_cast<std::size_t>(width) * kGlyphHeight, 0);
        draw_label(letters, words.text, 0, 0, 1);
        const int left = static_cast<int>(std::lround((words.at.x - end * width) * scale_));
        const int top  = static_cast<int>(std::lround((words.at.y - kGlyphHeight) * scale_));
        for (int y = 0; y < kGlyphHeight * scale_; ++y)
            for (int x = 0; x < width * scale_; ++x) {
                const bool is_set = letters.pixels[static_cast<std::size_t>(y / scale_ * width + x / scale_)] != 0;
                const int to_x = left + x, to_y = top + y;
                if (!is_set || to_x < 0 || to_y < 0 || to_x >= image_.width || to_y >= image_.height) continue;
                image_.pixels[static_cast<std::size_t>(to_y) * static_cast<std::size_t>(image_.width) +
                              static_cast<std::size_t>(to_x)] = pixel_of(words.ink);
            }
    }

    int scale_;
    pipeline::ColorImage image_;
};

}  // namespace

double DrawingScale::px(double value) const {
    const double part = logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
    return first_px + part * (last_px - first_px);
}

std::vector<double> DrawingScale::ticks() const {
    std::vector<double> ticks;
    if (!logarithmic) {
        double step        = std::pow(10.0, std::floor(std::log10(high - low)));
        const double count = (high - low) / step;
        step *= count < 2.0 ? 0.2 : count < 4.0 ? 0.5 : 1.0;
        for (double i = std::ceil(low / step - 0.001); i * step <= high + 0.001 * step; i += 1.0)
            ticks.push_back(i * step + 0.0);  // no -0
        return ticks;
    }
    const bool few = high / low < 300.0;
    for (double power = std::pow(10.0, std::floor(std::log10(low))); power <= high; power *= 10.0)
        for (const double step : {1.0, 2.0, 5.0})
            if ((few || step == 1.0) && power * step >= low * 0.999 && power * step <= high * 1.001)
                ticks.push_back(power * step);
    return ticks;
}

std::string to_svg(const Drawing& drawing, const DrawingColors& colors) {
    return SvgWriter(drawing, colors).take();
}

pipeline::ColorImage to_image(const Drawing& drawing, int scale) {
    return PixelPainter(drawing, scale).take();
}

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

}  // namespace demo
