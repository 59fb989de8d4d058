// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include "demo/tradeoff/report.h"

namespace demo {
namespace {

using Anchor = DrawnWords::Anchor;

// In pixels of the picture.
constexpr double kPanelWidth = 300.0, kPanelHeight = 240.0, kPanelStep = 372.0, kLeft = 56.0, kTop = 66.0;
constexpr double kLineHeight = 17.0, kRight = 14.0, kBelow = 54.0;

struct Panel {
    std::string title;
    PictureError MeasuredSetting::*error;
    bool MeasuredSetting::*is_on_front;
};

class PanelDrawer {
  public:
    PanelDrawer(Drawing& drawing, const Sweep& sweep, const Panel& panel, double left)
        : drawing_(drawing), sweep_(sweep), panel_(panel), x_(time_scale(left)), y_(error_scale()) {}

    void draw(const std::vector<const MeasuredSetting*>& front) {
        words({x_.first_px, kTop - 12.0}, Anchor::Start, panel_.title, Ink::Title, 12.0, true);
        grid();
        for (const MeasuredSetting& setting : sweep_.settings)
            if (!(setting.*panel_.is_on_front)) drawing_.items.emplace_back(DrawnDot{at(setting), 3.0, Ink::Muted});
        DrawnLine line{{}, Ink::Accent, 1.5, false};
        for (const MeasuredSetting* setting : front) {
            if (!(setting->*panel_.is_on_front)) continue;
            // Stairs: what lies above and right of a step is beaten by its corner.
            if (!line.points.empty()) line.points.push_back({line.points.back().x, at(*setting).y});
            line.points.push_back(at(*setting));
        }
        if (line.points.size() > 1) drawing_.items.emplace_back(line);
        double last_x = 1e9, last_y = 1e9;
        for (std::size_t i = 0; i < front.size(); ++i) {
            if (!(front[i]->*panel_.is_on_front)) continue;
            const DrawingPoint point = at(*front[i]);
            drawing_.items.emplace_back(DrawnDot{point, 4.5, Ink::Accent});
            // Above and right, or below and left where the number before is close.
            const bool is_close = std::abs(point.x - last_x) < 16.0 && std::abs(point.y - last_y) < 14.0;
            words({point.x + (is_close ? -6.0 : 6.0), point.y + (is_close ? 14.0 : -6.0)},
                  is_close ? Anchor::End : Anchor::Start, std::to_string(i + 1), Ink::AccentLabel, 11.0, true);
            last_x = point.x, last_y = point.y;
        }
    }

  private:
    DrawingScale time_scale(double left) const {
        double low = 1.0, high = 1.0;
        for (const MeasuredSetting& setting : sweep_.settings)
            low = std::min(low, setting.ratio), high = std::max(high, setting.ratio);
        const double margin = std::max(0.02, 0.06 * (high - low));
        return {low - margin, high + margin, left, left + kPanelWidth, false};
    }
    DrawingScale error_scale() const {
        double low = 1e9, high = 0.0;
        for (const MeasuredSetting& setting : sweep_.settings)
            low = std::min(low, (setting.*panel_.error).rms), high = std::max(high, (setting.*panel_.error).rms);
        const double margin = std::max(0.005, 0.07 * (high - low));
        return {std::max(low - margin, low > 0.0 ? 0.0 : -margin), high + margin, kTop + kPanelHeight, kTop, false};
    }
    DrawingPoint at(const MeasuredSetting& setting) const {
        return {x_.px(setting.ratio), y_.px((setting.*panel_.error).rms)};
    }
    void words(DrawingPoint where, Anchor anchor, const std::string& text, Ink ink = Ink::Label, double size = 11.0,
               bool bold = false) {
        drawing_.items.emplace_back(DrawnWords{where, anchor, text, size, ink, bold});
    }
    void grid() {
        const auto tick_text = [](const std::vector<double>& ticks, double tick) {
            const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
            return figure_text(tick, step < 0.0099 ? 3 : step < 0.099 ? 2 : step < 0.99 ? 1 : 0);
        };
        const std::vector<double> xs = x_.ticks(), ys = y_.ticks();
        for (const double tick : xs) {
            drawing_.items.emplace_back(DrawnLine{{{x_.px(tick), y_.first_px}, {x_.px(tick), y_.last_px}}});
            words({x_.px(tick), y_.first_px + 17.0}, Anchor::Middle, tick_text(xs, tick));
        }
        for (const double tick : ys) {
            drawing_.items.emplace_back(DrawnLine{{{x_.first_px, y_.px(tick)}, {x_.last_px, y_.px(tick)}}});
            words({x_.first_px - 8.0, y_.px(tick) + 4.0}, Anchor::End, tick_text(ys, tick));
        }
        words({0.5 * (x_.first_px + x_.last_px), y_.first_px + 34.0}, Anchor::Middle, "time, of exact = 1");
    }

    Drawing& drawing_;
    const Sweep& sweep_;
    const Panel& panel_;
    DrawingScale x_, y_;
};

}  // namespace

Drawing to_chart(const Sweep& sweep, const std::string& title) {
    const std::vector<const MeasuredSetting*> front = front_of(sweep);
    const double legend                             = kTop + kPanelHeight + kBelow;
    const std::size_t rows                          = (front.size() + 1) / 2;
    Drawing drawing{
        kLeft + kPanelStep + kPanelWidth + kRight, legend + kLineHeight * static_cast<double>(rows) + 6.0, {}};
    drawing.items.emplace_back(DrawnWords{{kLeft, 24.0}, Anchor::Start, title, 15.0, Ink::Title, true});
    const std::array panels{
        Panel{"RMS error to the truth, of 255", &MeasuredSetting::to_truth, &MeasuredSetting::on_truth_front},
        Panel{"RMS error to the exact picture, of 255", &MeasuredSetting::to_exact, &MeasuredSetting::on_exact_front},
    };
    for (std::size_t i = 0; i < panels.size(); ++i)
        PanelDrawer(drawing, sweep, panels[i], kLeft + kPanelStep * static_cast<double>(i)).draw(front);
    for (std::size_t i = 0; i < front.size(); ++i)
        drawing.items.emplace_back(DrawnWords{{kLeft + kPanelStep * static_cast<double>(i / rows),
                                               legend + kLineHeight * (static_cast<double>(i % rows) + 0.5)},
                                              Anchor::Start,
                                              std::to_string(i + 1) + "  " + front[i]->name,
                                              11.0,
                                              Ink::Label});
    return drawing;
}

}  // namespace demo
