// SPDX-License-Identifier: MIT
#include "demo/metrics/kernel.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "demo/metrics/blits.h"
#include "demo/metrics/measures.h"
#include "demo/metrics/statistics.h"

namespace demo {
namespace {

double sum_of(const std::vector<double>& values) {
    double sum = 0.0;
    for (double value : values) sum += value;
    return sum;
}

// About the place of the bright column.
double variance_of(const std::vector<double>& response) {
    const auto middle = static_cast<double>(response.size() / 2);
    double square     = 0.0;
    for (std::size_t i = 0; i < response.size(); ++i) {
        const double away = static_cast<double>(i) - middle;
        square += away * away * response[i];
    }
    return square / sum_of(response);
}

// Half the sum of |kernel - mean kernel| over the plane, for kernels that are products.
double half_difference(const std::vector<double>& across, const std::vector<double>& down,
                       const std::vector<double>& mean_response) {
    double sum = 0.0;
    for (std::size_t y = 0; y < down.size(); ++y) {
        if (down[y] == 0.0 && mean_response[y] == 0.0) continue;
        for (std::size_t x = 0; x < across.size(); ++x)
            sum += std::abs(across[x] * down[y] - mean_response[x] * mean_response[y]);
    }
    return sum / 2.0;
}

std::vector<double> without_empty_ends(const std::vector<double>& row, std::size_t ends) {
    return {row.begin() + static_cast<std::ptrdiff_t>(ends), row.end() - static_cast<std::ptrdiff_t>(ends)};
}

}  // namespace

Responses column_responses(const pipeline::Frame& frame, std::span<const pipeline::Pass> blits,
                           pipeline::TargetId image, int levels) {
    // The widest chain of five levels reaches some 200 pixels.
    constexpr int kWidth = 1024, kMiddle = 512;
    Responses responses;
    for (int place = 0; place < 1 << levels; ++place) {
        std::vector<std::vector<double>> rows(frame.targets.size());
        std::vector<double>& start = rows[static_cast<std::size_t>(image.index)];
        start.assign(kWidth, 0.0);
        start[static_cast<std::size_t>(kMiddle + place)] = 1.0;
        for (const pipeline::Pass& pass : blits) {
            const auto& rectangle           = std::get<pipeline::DrawRectangle>(pass.draws.front());
            const std::vector<double>& from = rows[static_cast<std::size_t>(rectangle.textures[0].target.index)];
            const double scale              = scale_of(pass, frame);
            const auto width                = static_cast<int>(std::lround(static_cast<double>(from.size()) * scale));
            rows[static_cast<std::size_t>(pass.color.index)] = blit_columns(pass, from, scale, width);
        }
        const std::vector<double>& end = rows[static_cast<std::size_t>(image.index)];
        std::vector<double> centered(kWidth, 0.0);
        for (int x = place; x < kWidth; ++x)
            centered[static_cast<std::size_t>(x - place)] = end[static_cast<std::size_t>(x)];
        responses.push_back(std::move(centered));
    }
    std::size_t ends = kMiddle - 1;
    for (const std::vector<double>& response : responses)
        for (std::size_t i = 0; i < ends; ++i)
            if (response[i] != 0.0 || response[response.size() - 1 - i] != 0.0) ends = i;
    for (std::vector<double>& response : responses) response = without_empty_ends(response, ends);
    return responses;
}

KernelFigures kernel_figures(const Responses& responses) {
    if (responses.empty()) return {};
    std::vector<double> variances, mean_response(responses.front().size(), 0.0);
    double energy_error = 0.0;
    for (const std::vector<double>& response : responses) {
        variances.push_back(variance_of(response));
        for (std::size_t i = 0; i < response.size(); ++i)
            mean_response[i] += response[i] / static_cast<double>(responses.size());
    }
    std::vector<double> sigmas;
    KernelFigures figures;
    for (std::size_t x = 0; x < responses.size(); ++x)
        for (std::size_t y = 0; y < responses.size(); ++y) {
            sigmas.push_back(std::sqrt((variances[x] + variances[y]) / 2.0));
            figures.anisotropy = std::max(figures.anisotropy, variances[x] / variances[y]);
            energy_error       = std::max(energy_error, std::abs(sum_of(responses[x]) * sum_of(responses[y]) - 1.0));
            if (y >= x)  // the other half is the same, transposed
                figures.phase_error =
                    std::max(figures.phase_error, half_difference(responses[x], responses[y], mean_response));
        }
    figures.sigma_px        = mean(sigmas);
    figures.sigma_variation = variation(sigmas);
    figures.energy_error    = energy_error;
    return figures;
}

double blockiness(const Plane& plane, int cell) {
    std::vector<double> at_borders, elsewhere;
    const auto add = [&](int at, float before, float here, float after) {
        const double bend =
            std::abs(static_cast<double>(before) - 2.0 * static_cast<double>(here) + static_cast<double>(after));
        // A border is between two pixels; both see it.
        const int place = at % cell;
        (place == 0 || place == cell - 1 ? at_borders : elsewhere).push_back(bend);
    };
    for (int y = 0; y < plane.height; ++y)
        for (int x = 1; x + 1 < plane.width; ++x) add(x, plane.at(x - 1, y), plane.at(x, y), plane.at(x + 1, y));
    for (int y = 1; y + 1 < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x) add(y, plane.at(x, y - 1), plane.at(x, y), plane.at(x, y + 1));
    const double outside = mean(elsewhere);
    return outside > 0.0 ? mean(at_borders) / outside : 1.0;
}

Metrics measure_kernel(Studio& studio) {
    Metric sigma{"M4.sigma", "width of the blur, standard deviation", "px"};
    Metric variation_of_sigma{
        "M4.sigma_variation", "how much it varies with the place on the pixel grid", "%", {}, at_most(1.0)};
    Metric anisotropy{"M4.anisotropy", "greatest variance along an axis over the smallest", "", {}, at_most(1.05)};
    Metric energy{"M4.energy_error", "greatest change of the total brightness", "%", {}, at_most(0.5)};
    Metric phase{"M4.phase_error", "greatest difference of a kernel from the mean one", "%", {}, at_most(3.0)};
    Metric blocks{"M4.blockiness", "bends of the coverage on cell borders over those elsewhere", "", {}, at_most(1.15)};
    const pipeline::Frame frame = studio.frame();
    if (const std::optional<FoundBlur> blur = find_blur(frame)) {
        const std::span<const pipeline::Pass> blits(frame.passes.data() + blur->first, blur->end - blur->first);
        const KernelFigures figures = kernel_figures(column_responses(frame, blits, blur->image, blur->levels));
        sigma.value                 = figures.sigma_px;
        variation_of_sigma.value    = 100.0 * figures.sigma_variation;
        anisotropy.value            = figures.anisotropy;
        energy.value                = 100.0 * figures.energy_error;
        phase.value                 = 100.0 * figures.phase_error;
        if (blur->levels > 1) blocks.value = blockiness(studio.detailless_coverage(), 1 << blur->levels);
    }
    return {sigma, variation_of_sigma, anisotropy, energy, phase, blocks};
}

}  // namespace demo
