// SPDX-License-Identifier: MIT
#include "demo/tradeoff/page.h"

#include <nettle/base64.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "demo/drawing.h"
#include "demo/embedded_texts.h"
#include "demo/image_file.h"
#include "demo/tradeoff/report.h"
#include "demo/version.h"

namespace demo {
namespace {

// The page's own, so that the chart follows its light and dark colours.
constexpr DrawingColors kPageColors{"var(--paper)", "var(--line)",   "var(--faint)",     "var(--label)",
                                    "var(--ink)",   "var(--accent)", "var(--accent-ink)"};

std::string data_uri(const pipeline::ColorImage& image) {
    const std::string png = encode_image("picture.png", image, Channels::Rgb);
    std::string text(BASE64_ENCODE_RAW_LENGTH(png.size()), '\0');
    base64_encode_raw(text.data(), png.size(), reinterpret_cast<const std::uint8_t*>(png.data()));
    return "data:image/png;base64," + text;
}

pipeline::ColorImage to_image(const RealPicture& picture) {
    pipeline::ColorImage image{.width = picture.width, .height = picture.height, .pixels = {}};
    image.pixels.reserve(picture.pixels.size());
    for (const auto& pixel : picture.pixels) {
        std::uint32_t color = 0xff;
        for (const double channel : pixel)
            color = color << 8 | static_cast<std::uint32_t>(std::lround(std::clamp(channel, 0.0, 255.0)));
        image.pixels.push_back(color);
    }
    return image;
}

std::string cell(const std::string& text) {
    return "<td>" + text + "</td>";
}

std::string table_rows(const Sweep& sweep) {
    const std::vector<const MeasuredSetting*> front = front_of(sweep);
    std::vector<const MeasuredSetting*> order;
    for (const MeasuredSetting& setting : sweep.settings) order.push_back(&setting);
    std::stable_sort(order.begin() + 1, order.end(), [](const auto* a, const auto* b) { return a->ratio < b->ratio; });
    std::string rows;
    for (const MeasuredSetting* setting : order) {
        const auto on_front      = std::find(front.begin(), front.end(), setting);
        const std::string number = on_front == front.end() ? "" : std::to_string(on_front - front.begin() + 1);
        rows += number.empty() ? "<tr>" : "<tr class=\"front\">";
        rows += cell(number) + "<th scope=\"row\">" + escaped(setting->name) + "</th>" +
                cell(figure_text(setting->milliseconds, 2)) + cell(figure_text(setting->ratio, 3)) +
                cell(figure_text(setting->ratio_low, 3) + "&ndash;" + figure_text(setting->ratio_high, 3));
        for (const PictureError* error : {&setting->to_truth, &setting->to_exact})
            rows += cell(figure_text(error->rms, 2)) + cell(figure_text(error->max, 0)) +
                    cell(std::isinf(error->psnr_db) ? "&infin;" : figure_text(error->psnr_db, 1)) +
                    cell(figure_text(error->ssim, 4));
        rows += "</tr>\n";
    }
    return rows;
}

// The pictures themselves stand once, in the gallery; the view takes them from there.
std::string figure(const std::string& id, const std::string& name, const std::string& says,
                   const pipeline::ColorImage& picture) {
    return "<figure><img id=\"" + id + "\" alt=\"" + escaped(name) + "\" width=\"" + std::to_string(picture.width) +
           "\" height=\"" + std::to_string(picture.height) + "\" src=\"" + data_uri(picture) + "\"><figcaption><b>" +
           escaped(name) + "</b> " + says + "</figcaption></figure>\n";
}

std::string filled(std::string_view page, const std::vector<std::pair<std::string_view, std::string>>& values) {
    std::string out;
    while (true) {
        const std::size_t open = page.find("{{"), close = page.find("}}", open);
        if (open == std::string_view::npos) return out + std::string(page);
        const std::string_view name = page.substr(open + 2, close - open - 2);
        const auto value = std::find_if(values.begin(), values.end(), [&](const auto& v) { return v.first == name; });
        if (value == values.end()) throw std::logic_error("page.html: no value for " + std::string(name));
        out += std::string(page.substr(0, open)) + value->second;
        page.remove_prefix(close + 2);
    }
}

}  // namespace

std::string to_page(const Sweep& sweep, const std::string& title) {
    const std::vector<const MeasuredSetting*> front = front_of(sweep);
    std::string figures =
        figure("picture-0", "truth", "drawn without rounding, 16 samples a pixel", to_image(sweep.truth));
    std::string choices = "<option value=\"picture-0\">truth</option>\n";
    for (std::size_t i = 0; i < front.size(); ++i) {
        const std::string number = std::to_string(i + 1), id = "picture-" + number;
        figures +=
            figure(id, number + " " + front[i]->name,
                   "time " + figure_text(front[i]->ratio, 2) + ", RMS " + figure_text(front[i]->to_truth.rms, 2) +
                       " to the truth, " + figure_text(front[i]->to_exact.rms, 2) + " to exact",
                   front[i]->picture);
        choices += "<option value=\"" + id + "\">" + number + " " + escaped(front[i]->name) + "</option>\n";
    }
    std::string idle;
    for (const std::string& name : sweep.without_effect) idle += (idle.empty() ? "" : ", ") + escaped(name);
    const int runs = sweep.options.runs, threads = sweep.options.threads;
    return filled(find_text(embedded_tradeoff(), "page")->text,
                  {{"title", escaped(title)},
                   {"version", std::string(kVersion)},
                   {"width", std::to_string(sweep.options.size.width)},
                   {"height", std::to_string(sweep.options.size.height)},
                   {"runs", std::to_string(runs)},
                   {"threads", threads == 0   ? "all cores"
                               : threads == 1 ? "one thread"
                                              : std::to_string(threads) + " threads"},
                   {"noise", figure_text(100.0 * sweep.noise, 1)},
                   {"idle", idle.empty() ? "" : "<p class=\"note\">Without effect on this scene: " + idle + ".</p>"},
                   {"chart", to_svg(to_chart(sweep, title), kPageColors)},
                   {"rows", table_rows(sweep)},
                   {"figures", figures},
                   {"choices", choices}});
}

}  // namespace demo
