// SPDX-License-Identifier: MIT
#include "cloud/mega_particles/blur.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "pipeline/execute/execute.h"
#include "tests/cloud/cumulus.h"

using namespace cloud;
using namespace pipeline;

namespace {

// A frame whose picture is of 256 x 64: the particles' target, white and opaque from column `edge` on, then blurred. Of a
// smaller target those pixels are white whose centres lie there, and it is enlarged.
Frame blurred_edge(const BlurPlan& plan, int edge) {
    Frame frame;
    CloudTargets targets;
    const int first   = plan.first_level;
    targets.width     = 256;
    targets.height    = 64;
    targets.particles = frame.output = {0};
    frame.targets.push_back({.name = "particles", .width = 256 >> first, .height = 64 >> first});
    const auto unused = static_cast<std::size_t>(std::max(first, 1));
    targets.front.resize(unused), targets.back.resize(unused);
    for (int level = static_cast<int>(unused); level <= plan.levels; ++level)
        for (auto* chain : {&targets.front, &targets.back}) {
            chain->push_back({static_cast<std::int32_t>(frame.targets.size())});
            frame.targets.push_back({.name = "level", .width = 256 >> level, .height = 64 >> level});
        }
    Pass& pass = frame.passes.emplace_back();
    pass.color = targets.particles;
    DrawRectangle white;
    white.x0   = static_cast<float>(edge) / static_cast<float>(1 << first);
    white.x1   = 256.0f;
    white.y1   = 64.0f;
    pass.draws = {white};
    const SceneTargets scene;
    const View view = look(Vec3(0.0f), Vec3(1.0f, 0.0f, 0.0f), 256, 64);
    const BakedCloud baked;
    const PixelRect all{0, 0, 256, 64};
    const CloudDraw draw{frame, scene, view, baked, targets, plan, all, all};
    append_blur(draw);
    if (first == 0) return frame;
    frame.output = {static_cast<std::int32_t>(frame.targets.size())};
    frame.targets.push_back({.name = "enlarged", .width = 256, .height = 64});
    Pass& enlargement = append_pass(draw, "enlarge", frame.output, all);
    show_texture(enlargement.state, TextureFilter::Linear);
    enlargement.draws = {blit(targets.particles, 256 >> first, 64 >> first, static_cast<float>(1 << first), 0.0f)};
    return frame;
}

// Of the steps from column to column of all places an edge can have within a texel of the coarsest level, about that
// place.
double measured_sigma_px(const BlurPlan& plan) {
    double sum = 0.0, mean = 0.0, square = 0.0;
    for (int edge = 128; edge < 128 + (1 << plan.levels); ++edge) {
        const ColorImage image = execute(blurred_edge(plan, edge)).output;
        for (int x = 1; x < 256; ++x) {
            const std::uint32_t* column = image.pixels.data() + 32 * 256 + x;
            const double step           = static_cast<double>(column[0] >> 24) - static_cast<double>(column[-1] >> 24);
            sum += step, mean += step * (x - edge), square += step * (x - edge) * (x - edge);
        }
    }
    mean /= sum;
    return std::sqrt(square / sum - mean * mean);
}

}  // namespace

TEST_CASE("the blur has the width its plan says, at every phase, and leaves constants alone") {
    const BlurPlan plan =
        GENERATE(BlurPlan{1, true, 1}, BlurPlan{1, true, 4}, BlurPlan{2, true, 1}, BlurPlan{2, true, 3},
                 BlurPlan{3, true, 1}, BlurPlan{4, true, 2}, BlurPlan{2, false, 0}, BlurPlan{3, false, 0});
    INFO("levels " << plan.levels << ", bottom tents " << plan.bottom_tents);
    double width_sum = 0.0;
    const int phases = 1 << plan.levels;
    for (int phase = 0; phase < phases; ++phase) {
        const int edge         = 128 + phase;
        const ColorImage image = execute(blurred_edge(plan, edge)).output;
        const auto column      = [&](int x) { return image.pixels[static_cast<std::size_t>(32 * 256 + x)]; };
        CHECK(column(0) == 0u);
        CHECK(column(255) == 0xffffffffu);
        // Mean and variance of the steps from column to column. Bytes are rounded half up, each blit by an eighth on
        // average, so the mean moves a little to the black side.
        double sum = 0.0, mean = 0.0, square = 0.0;
        for (int x = 1; x < 256; ++x) {
            const double step =
                (static_cast<double>(column(x) >> 24) - static_cast<double>(column(x - 1) >> 24)) / 255.0;
            CHECK(step >= -0.003);
            CHECK(column(x) >> 24 == (column(x) & 255));
            sum += step, mean += step * (x - edge), square += step * (x - edge) * (x - edge);
        }
        CHECK(sum == Approx(1.0));
        CHECK(mean == Approx(0.0).margin(0.15 + 0.1 * phases));
        width_sum += std::sqrt(square - mean * mean);
    }
    CHECK(width_sum / phases == Approx(sigma_px(plan)).epsilon(0.05));
}

TEST_CASE("plans are chosen by width: about a fifth apart with tents, doubling without") {
    CHECK(sigma_px({1, true, 4}) == Approx(3.0));
    CHECK(sigma_px({2, true, 1}) == Approx(4.12).epsilon(0.01));
    CHECK(sigma_px({3, true, 1}) == Approx(8.54).epsilon(0.01));
    CHECK(sigma_px({4, true, 1}) == Approx(17.2).epsilon(0.01));
    float last = 0.0f;
    for (float wanted = 1.8f; wanted < 20.0f; wanted *= 1.01f) {
        const BlurPlan plan = plan_blur(Mode::Skirt, wanted);
        CHECK(sigma_px(plan) >= last);
        CHECK(sigma_px(plan) == Approx(wanted).epsilon(0.16));
        CHECK(plan.levels <= 4);
        last = sigma_px(plan);
        CHECK_FALSE(plan_blur(Mode::Article, wanted).inner_tents);
        CHECK(plan_blur(Mode::Article, wanted).bottom_tents == 0);
    }
    CHECK(plan_blur(Mode::Skirt, 0.0f) == BlurPlan{1, true, 1});
    CHECK(plan_blur(Mode::Skirt, 1e9f) == BlurPlan{4, true, 2});
    CHECK(plan_blur(Mode::Article, 4.6f) == BlurPlan{3, false, 0});
}

TEST_CASE("a blur of a smaller target has the width its plan says") {
    const BlurPlan plan =
        GENERATE(BlurPlan{.levels = 1, .bottom_tents = 2, .first_level = 1}, BlurPlan{.levels = 2, .first_level = 2},
                 BlurPlan{.levels = 3, .inner_tents = true, .bottom_tents = 1, .first_level = 1},
                 BlurPlan{.levels = 3, .first_level = 2, .extra_tents = {0, 0, 2}},
                 BlurPlan{.levels = 4, .bottom_tents = 1, .first_level = 1, .extra_tents = {0, 1, 1, 1}});
    INFO("levels " << plan.first_level << " to " << plan.levels << ", bottom tents " << plan.bottom_tents);
    CHECK(measured_sigma_px(plan) == Approx(sigma_px(plan)).epsilon(0.02));
}

// Every plan there is; half of a tent at the finest level is the most that tents cannot make up for.
TEST_CASE("a smaller target keeps the variance of the blur") {
    const auto variance = [](const BlurPlan& plan) { return sigma_px(plan) * sigma_px(plan); };
    for (float wanted = 1.0f; wanted < 24.0f; wanted *= 1.1f) {
        const BlurPlan plan = plan_blur(Mode::Skirt, wanted);
        CHECK(at_target_scale(Mode::Skirt, plan, 1) == plan);
        for (const int scale : {2, 4}) {
            const BlurPlan other = at_target_scale(Mode::Skirt, plan, scale);
            INFO("sigma " << wanted << ", scale " << scale);
            const int first = scale / 2;
            CHECK(other.first_level == first);
            CHECK(std::abs(variance(other) - variance(plan)) <= 0.25 * static_cast<double>(1 << (2 * first)) + 1e-3);
            CHECK(other.levels == std::max(plan.levels, first));
        }
    }
    CHECK(at_target_scale(Mode::Article, plan_blur(Mode::Article, 4.6f), 2) == BlurPlan{.levels = 3, .first_level = 1});
}
