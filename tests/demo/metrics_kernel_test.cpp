// SPDX-License-Identifier: MIT
// M0 and M4: kernels whose figures are known.
#include "demo/metrics/kernel.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <span>

#include "demo/metrics/numerics.h"
#include "demo/metrics/studio.h"
#include "tests/demo/metrics_planes.h"

using namespace demo;

namespace {

std::vector<double> gaussian(double sigma, double shift = 0.0) {
    std::vector<double> row;
    double sum = 0.0;
    for (int i = -60; i <= 60; ++i) {
        row.push_back(std::exp(-0.5 * (i - shift) * (i - shift) / (sigma * sigma)));
        sum += row.back();
    }
    for (double& value : row) value /= sum;
    return row;
}

KernelFigures figures_of(const cloud::BlurPlan& plan) {
    const pipeline::Frame frame = blurred_picture(plan, noise_picture(64, 64));
    return kernel_figures(column_responses(frame, std::span(frame.passes).subspan(1), {0}, plan.levels));
}

}  // namespace

TEST_CASE("a kernel that is the same everywhere has no errors", "[metrics]") {
    const KernelFigures figures = kernel_figures({gaussian(5.0), gaussian(5.0), gaussian(5.0), gaussian(5.0)});
    CHECK(figures.sigma_px == Approx(5.0).epsilon(0.001));
    CHECK(figures.sigma_variation == Approx(0.0).margin(1e-9));
    CHECK(figures.anisotropy == Approx(1.0));
    CHECK(figures.energy_error == Approx(0.0).margin(1e-9));
    CHECK(figures.phase_error == Approx(0.0).margin(1e-9));
}

TEST_CASE("each figure of a kernel sees its own fault", "[metrics]") {
    const KernelFigures wide = kernel_figures({gaussian(4.0), gaussian(5.0)});
    CHECK(wide.anisotropy == Approx(25.0 / 16.0).epsilon(0.001));
    CHECK(wide.sigma_variation > 0.05);
    std::vector<double> bright = gaussian(5.0);
    for (double& value : bright) value *= 1.1;
    CHECK(kernel_figures({bright, bright}).energy_error == Approx(0.21));
    const KernelFigures shifted = kernel_figures({gaussian(5.0, -1.0), gaussian(5.0, 1.0)});
    CHECK(shifted.sigma_variation == Approx(0.0).margin(1e-9));
    CHECK(shifted.phase_error > 0.05);
}

TEST_CASE("the chains' kernels have the figures that their sums give", "[metrics]") {
    // Tents between all steps: sigma by the variances of boxes, steps and tents.
    const KernelFigures three = figures_of({3, true, 1});
    CHECK(three.sigma_px == Approx(cloud::sigma_px({3, true, 1})).epsilon(0.005));
    CHECK(three.sigma_variation < 0.01);
    CHECK(three.anisotropy < 1.05);
    CHECK(three.energy_error < 0.005);
    CHECK(three.phase_error < 0.06);
    const KernelFigures four = figures_of({4, true, 1});
    CHECK(four.phase_error < three.phase_error);
    // Boxes and steps alone: the lattice shows.
    CHECK(figures_of({3, false, 0}).phase_error > 2.0 * three.phase_error);
    CHECK(figures_of({3, false, 0}).sigma_px == Approx(cloud::sigma_px({3, false, 0})).epsilon(0.005));
}

TEST_CASE("blocks bend a plane at their borders", "[metrics]") {
    const Plane smooth = tests::plane_of(64, 64, [](int x, int y) { return std::sin(0.1 * x) * std::cos(0.13 * y); });
    CHECK(blockiness(smooth, 8) == Approx(1.0).margin(0.1));
    const Plane blocks =
        tests::plane_of(64, 64, [](int x, int y) { return 0.1 * (x / 8) + 0.07 * (y / 8) + 1e-4 * x * x; });
    CHECK(blockiness(blocks, 8) > 5.0);
    CHECK(blockiness(Plane(64, 64, 0.5f), 8) == 1.0);
}

TEST_CASE("blurs leave constants as they are, and each byte within half a step", "[metrics]") {
    const int value = GENERATE(0, 1, 127, 254, 255);
    for (int levels = 1; levels <= cloud::kMaxBlurLevels; ++levels)
        for (const bool tents : {false, true})
            CHECK(change_of_constant({levels, tents, tents ? 1 : 0}, 70, 40, value) == 0);
}

TEST_CASE("blits and blends stay close to double precision", "[metrics]") {
    const BlurErrors errors = blur_errors({2, true, 1}, noise_picture(96, 64));
    CHECK(errors.worst <= 0.5 + 1e-9);
    CHECK(errors.rms > 0.1);  // bytes are not double precision
    CHECK(errors.drift <= 0.5);
    CHECK(blend_drift(16) <= 0.5);
    CHECK(blend_drift(16) > 0.0);
}
