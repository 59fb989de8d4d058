// SPDX-License-Identifier: MIT
#include "demo/tradeoff/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace demo {
namespace {

std::string csv_word(const std::string& word) {
    if (word.find_first_of(",\"\n") == std::string::npos) return word;
    std::string quoted = "\"";
    for (const char c : word) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::string csv_error(const PictureError& error) {
    return "," + figure_text(error.max, 2) + "," + figure_text(error.rms, 4) + "," + figure_text(error.psnr_db, 2) +
           "," + figure_text(error.ssim, 6);
}

}  // namespace

std::string figure_text(double value, int decimals) {
    if (std::isinf(value)) return "inf";
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

std::string to_csv(const Sweep& sweep) {
    std::string csv =
        "setting,milliseconds,ratio,ratio_low,ratio_high,truth_max,truth_rms,truth_psnr_db,truth_ssim,exact_max,"
        "exact_rms,exact_psnr_db,exact_ssim,on_truth_front,on_exact_front\n";
    for (const MeasuredSetting& setting : sweep.settings) {
        csv += csv_word(setting.name) + "," + figure_text(setting.milliseconds, 3) + "," +
               figure_text(setting.ratio, 4) + "," + figure_text(setting.ratio_low, 4) + "," +
               figure_text(setting.ratio_high, 4) + csv_error(setting.to_truth) + csv_error(setting.to_exact) + "," +
               (setting.on_truth_front ? "1" : "0") + "," + (setting.on_exact_front ? "1" : "0") + "\n";
    }
    return csv;
}

std::vector<const MeasuredSetting*> front_of(const Sweep& sweep) {
    std::vector<const MeasuredSetting*> front;
    for (const MeasuredSetting& setting : sweep.settings)
        if (setting.on_a_front() || &setting == &sweep.settings.front()) front.push_back(&setting);
    std::stable_sort(front.begin() + 1, front.end(),
                     [](const MeasuredSetting* a, const MeasuredSetting* b) { return a->ratio > b->ratio; });
    return front;
}

std::string to_markdown(const Sweep& sweep, const std::string& scene) {
    std::string table =
        "| scene | setting | time | RMS to truth | PSNR | SSIM | RMS to exact | greatest | SSIM |\n"
        "| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
    for (const MeasuredSetting* setting : front_of(sweep)) {
        const PictureError &truth = setting->to_truth, &exact = setting->to_exact;
        table += "| " + scene + " | " + setting->name + " | " + figure_text(setting->ratio, 2) + " | " +
                 figure_text(truth.rms, 2) + " | " + figure_text(truth.psnr_db, 2) + " dB | " +
                 figure_text(truth.ssim, 4) + " | " + figure_text(exact.rms, 2) + " | " + figure_text(exact.max, 0) +
                 " | " + figure_text(exact.ssim, 4) + " |\n";
    }
    return table;
}

}  // namespace demo
