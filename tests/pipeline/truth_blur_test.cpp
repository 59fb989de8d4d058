// SPDX-License-Identifier: MIT
// How the truth reads targets, and its Gaussian in place of chains of blits: which passes make a chain, of what variance.
#include <catch2/catch.hpp>
#include <cmath>

#include "cloud/mega_particles/blur_plan.h"
#include "pipeline/truth/blur_chain.h"
#include "pipeline/truth/truth.h"
#include "tests/support/random.h"
#include "tests/support/small_frame.h"

namespace {

using namespace pipeline;
using namespace test_support;
using truth::BlurChain;
using truth::find_blur_chains;

// Targets `level` (front) and `level + kBack` of 2^-level the size; 0 is the output, and what is blurred.
constexpr int kLevels = 4, kBack = kLevels;
Frame pyramid(int size) {
    Frame frame = small_frame(size, size);
    for (int i = 1; i < 2 * kLevels; ++i)
        frame.targets.push_back(
            {.name = std::to_string(i), .width = size >> i % kLevels, .height = size >> i % kLevels});
    return frame;
}

void append_blit(Frame& frame, int from, int to, double scale, double shift) {
    Pass& pass          = frame.passes.emplace_back();
    pass.color          = {to};
    TextureStage& stage = pass.state.stages[0];
    stage               = kTextureOnly;
    stage.filter        = TextureFilter::Linear;
    stage.address_u = stage.address_v = TextureAddress::Clamp;
    const double size                 = frame.targets[static_cast<std::size_t>(from)].width;
    DrawRectangle blit;
    blit.x0 = blit.y0 = static_cast<float>(shift);
    blit.x1 = blit.y1 = static_cast<float>(shift + 2 * scale * size);
    blit.uv[0]        = {.u0 = 0, .v0 = 0, .u1 = 2, .v1 = 2};
    blit.textures[0]  = {.texture = {}, .target = {from}};
    pass.draws.push_back(blit);
}

void append_tent(Frame& frame, int level) {
    append_blit(frame, level, level + kBack, 1, -0.5);
    append_blit(frame, level + kBack, level, 1, 0.5);
}

// As cloud/mega_particles/blur.cpp has it.
void append_blur(Frame& frame, const cloud::BlurPlan& plan) {
    for (int level = 1; level <= plan.levels; ++level) {
        append_blit(frame, level - 1, level, 0.5, 0);
        if (plan.inner_tents && level < plan.levels) append_tent(frame, level);
    }
    for (int i = 0; i < plan.bottom_tents; ++i) append_tent(frame, plan.levels);
    for (int level = plan.levels - 1; level >= 0; --level) {
        append_blit(frame, level + 1, level, 2, 0);
        if (plan.inner_tents && level > 0) append_tent(frame, level);
    }
}

struct Moments {
    double sum = 0.0, mean_x = 0.0, variance_x = 0.0, variance_y = 0.0;
};
Moments moments(const TruthPicture& picture) {
    Moments m;
    double xx = 0.0, y = 0.0, yy = 0.0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const double value = picture.pixels[i][0];
        const double px    = static_cast<double>(i % static_cast<std::size_t>(picture.width));
        const double py    = static_cast<double>(i / static_cast<std::size_t>(picture.width));
        m.sum += value;
        m.mean_x += value * px, xx += value * px * px;
        y += value * py, yy += value * py * py;
    }
    m.mean_x /= m.sum, y /= m.sum;
    m.variance_x = xx / m.sum - m.mean_x * m.mean_x;
    m.variance_y = yy / m.sum - y * y;
    return m;
}

}  // namespace

TEST_CASE("a chain's variance is that of its plan, of its blits and of the truth's Gaussian", "[truth]") {
    const cloud::BlurPlan plan = GENERATE(cloud::BlurPlan{1, false, 0}, cloud::BlurPlan{1, false, 2},
                                          cloud::BlurPlan{2, true, 1}, cloud::BlurPlan{3, true, 1});
    const int size             = 128;
    Frame frame                = pyramid(size);
    frame.passes[0].draws.push_back(rectangle({61, 62, 62, 63}, 0xffffffff));
    append_blur(frame, plan);
    const std::vector<BlurChain> chains = find_blur_chains(frame);
    REQUIRE(chains.size() == 1);
    CHECK(chains[0].first == 1);
    CHECK(chains[0].last == frame.passes.size() - 1);
    const double sigma = cloud::sigma_px(plan);
    CHECK(chains[0].variance[0] == Approx(sigma * sigma).epsilon(1e-6));
    CHECK(chains[0].variance[1] == Approx(sigma * sigma).epsilon(1e-6));
    CHECK(std::abs(chains[0].shift[0]) < 1e-6);

    const Moments gaussian = moments(draw_truth(frame, {.samples_per_axis = 1}));
    CHECK(gaussian.sum == Approx(1.0).epsilon(1e-9));
    CHECK(gaussian.mean_x == Approx(61.0));
    // What is cut off beyond 6 sigma has 7e-8 of the variance, and sampling a Gaussian of sigma 1 changes it by 2e-7.
    CHECK(gaussian.variance_x == Approx(sigma * sigma).epsilon(1e-6));
    CHECK(gaussian.variance_y == Approx(sigma * sigma).epsilon(1e-6));
    // A pixel's samples are spread by 15/192 square pixels, and averaging them adds as much.
    const Moments fine = moments(draw_truth(frame, {.samples_per_axis = 4}));
    CHECK(fine.variance_x == Approx(sigma * sigma + 2 * 15.0 / 192.0).epsilon(1e-4));

    // The blits' kernels differ from pixel to pixel; it is the mean of all phases of the coarsest level that has this variance.
    double second = 0.0, sum = 0.0;
    const int phases = 1 << plan.levels;
    for (int x = 48; x < 48 + phases; ++x) {
        std::get<DrawRectangle>(frame.passes[0].draws[0]).x0 = static_cast<float>(x);
        std::get<DrawRectangle>(frame.passes[0].draws[0]).x1 = static_cast<float>(x + 1);
        const Moments m = moments(draw_truth(frame, {.samples_per_axis = 1, .true_gaussian = false}));
        second += m.sum * (m.variance_x + (m.mean_x - x) * (m.mean_x - x));
        sum += m.sum;
    }
    CHECK(second / sum == Approx(sigma * sigma).epsilon(1e-5));
}

TEST_CASE("the truth's Gaussian falls off as a Gaussian", "[truth]") {
    Frame frame = pyramid(64);
    frame.passes[0].draws.push_back(rectangle({32, 32, 33, 33}, 0xffffffff));
    append_blur(frame, {2, false, 1});
    const TruthPicture picture = draw_truth(frame, {.samples_per_axis = 1});
    const double variance      = 5.0 + 8.0;
    const double peak          = picture.pixels[32 * 64 + 32][3];
    for (const auto& [x, y] : {std::pair{3, 0}, {0, 5}, {-4, 4}, {9, -7}, {0, 18}})
        CHECK(picture.pixels[static_cast<std::size_t>((32 + y) * 64 + 32 + x)][3] / peak ==
              Approx(std::exp(-(x * x + y * y) / 2.0 / variance)).epsilon(1e-9));
    CHECK(picture.pixels[32 * 64 + 32 + 23][3] == 0.0);  // beyond 6 sigma, 21.6
}

TEST_CASE("a blur keeps constants, and clamps at the edge of what its first pass reads", "[truth]") {
    Frame frame                 = pyramid(64);
    frame.passes[0].clear.color = Argb{0xff336699};
    append_blur(frame, {2, true, 1});
    for (const bool gaussian : {false, true})
        for (const int samples : {1, 4})
            for (const auto& color : draw_truth(frame, {samples, gaussian}).pixels) {
                CHECK(std::abs(color[0] - 0x33 / 255.0) < 1e-12);
                CHECK(std::abs(color[2] - 0x99 / 255.0) < 1e-12);
            }
    // What lies beyond the first pass's scissor is not read, what lies beyond the last's is not written.
    frame.passes[0].draws.push_back(rectangle({40, 0, 64, 64}, 0xffffffff));
    frame.passes[1].state.scissor     = {0, 0, 20, 32};
    frame.passes.back().state.scissor = {10, 0, 40, 50};
    const TruthPicture picture        = draw_truth(frame, {.samples_per_axis = 2});
    CHECK(std::abs(picture.pixels[39][0] - 0x33 / 255.0) < 1e-12);
    CHECK(picture.pixels[40][0] == 1.0);
}

TEST_CASE("what is no chain of blits is drawn as it is", "[truth]") {
    Frame frame = pyramid(64);
    append_blur(frame, {1, false, 1});
    REQUIRE(find_blur_chains(frame).size() == 1);
    const auto check_not_found = [&](const char* what, auto change) {
        INFO(what);
        Frame changed = frame;
        change(changed);
        CHECK(find_blur_chains(changed).empty());
    };
    const auto first = [](Frame& f) -> DrawRectangle& { return std::get<DrawRectangle>(f.passes[1].draws[0]); };
    check_not_found("blended", [](Frame& f) { f.passes[2].state.blend = kAlphaOver; });
    check_not_found("masked", [](Frame& f) { f.passes[2].state.color_mask.alpha = false; });
    check_not_found("alpha test", [](Frame& f) { f.passes[2].state.alpha_test.func = CompareFunc::Less; });
    check_not_found("destination alpha test", [](Frame& f) { f.passes[2].state.dest_alpha_test = DestAlphaTest::One; });
    check_not_found("points", [](Frame& f) { f.passes[2].state.stages[0].filter = TextureFilter::Point; });
    check_not_found("wrapped", [](Frame& f) { f.passes[2].state.stages[0].address_u = TextureAddress::Wrap; });
    check_not_found("modulated", [](Frame& f) { f.passes[2].state.stages[0].color_op = TextureOp::Modulate; });
    check_not_found("complement", [](Frame& f) { f.passes[2].state.stages[0].color_arg1.complement = true; });
    check_not_found("cleared", [](Frame& f) { f.passes[2].clear.color = Argb{0}; });
    // Where all of the run does not come back, or not to its place, the tent in it still does.
    const auto check_tent_alone = [&](const char* what, auto change) {
        INFO(what);
        Frame changed = frame;
        change(changed);
        const std::vector<BlurChain> chains = find_blur_chains(changed);
        REQUIRE(chains.size() == 1);
        CHECK((chains[0].first == 2 && chains[0].last == 3));
        CHECK(chains[0].variance[0] == Approx(0.5));
    };
    check_tent_alone("another target before",
                     [&](Frame& f) { first(f).textures[0].target = {2}, f.passes[1].color = {0}; });
    check_tent_alone("ends small", [](Frame& f) { f.passes.pop_back(); });
    check_tent_alone("shifted", [&](Frame& f) { first(f).x0 += 1, first(f).x1 += 1; });
    // Without the tent between it is still one.
    frame.passes.erase(frame.passes.begin() + 2, frame.passes.begin() + 4);
    CHECK(find_blur_chains(frame).size() == 1);
}

TEST_CASE("areas that are apart are blurred apart", "[truth]") {
    Frame frame = pyramid(64);
    frame.passes[0].draws.push_back(rectangle({0, 0, 32, 64}, 0xff400000));
    frame.passes[0].draws.push_back(rectangle({32, 0, 64, 64}, 0xff004000));
    append_blur(frame, {1, false, 0});
    for (std::size_t i : {1, 2}) {
        DrawRectangle left = std::get<DrawRectangle>(frame.passes[i].draws[0]), right = left;
        const float width = i == 1 ? 16.0f : 32.0f;
        left              = rectangle({0, 0, static_cast<int>(width), static_cast<int>(2 * width)}, 0);
        left.textures     = right.textures;
        left.uv[0]        = {.u0 = 0, .v0 = 0, .u1 = 0.5f, .v1 = 1};
        right             = left;
        right.x0 += width, right.x1 += width;
        right.uv[0]           = {.u0 = 0.5f, .v0 = 0, .u1 = 1, .v1 = 1};
        frame.passes[i].draws = {left, right};
    }
    const std::vector<BlurChain> chains = find_blur_chains(frame);
    REQUIRE(chains.size() == 1);
    REQUIRE(chains[0].areas.size() == 2);
    CHECK(chains[0].areas[1].read == PixelRect{32, 0, 64, 64});
    CHECK(chains[0].areas[1].written == PixelRect{32, 0, 64, 64});
    const TruthPicture picture = draw_truth(frame, {.samples_per_axis = 2});
    CHECK(picture.pixels[31][1] == 0.0);
    CHECK(std::abs(picture.pixels[31][0] - 64.0 / 255.0) < 1e-12);
}

// A tent of the samples is the tent of the pixels' means: their taps lie a pixel apart, not a sample.
TEST_CASE("a blit of a target means the same with any number of samples", "[truth]") {
    Random random(3);
    Frame frame = pyramid(32);
    for (int i = 0; i < 12; ++i) {
        const int x = random.from(0, 27), y = random.from(0, 27);
        DrawRectangle draw = rectangle({x, y, x + 5, y + 4}, random.bits());
        draw.x0 += random.real(0, 1), draw.y1 += random.real(0, 1);
        frame.passes[0].draws.push_back(draw);
    }
    frame.passes[0].color      = {kBack};
    frame.targets[kBack].width = frame.targets[kBack].height = 32;
    const auto drawn                                         = [&](double scale, double shift, int samples) {
        Frame blit = frame;
        append_blit(blit, kBack, 0, scale, shift);
        return draw_truth(blit, {samples, false}).pixels;
    };
    Frame direct           = frame;
    direct.passes[0].color = {0};
    for (const int samples : {1, 4}) {
        const auto want = draw_truth(direct, {.samples_per_axis = samples}).pixels;
        const auto same = drawn(1, 0, samples), tent = drawn(1, -0.5, samples);
        for (std::size_t y = 0; y < 31; ++y)
            for (std::size_t x = 0; x < 31; ++x) {
                const std::size_t i = y * 32 + x;
                CHECK(std::abs(same[i][1] - want[i][1]) < 1e-9);
                const double mean = (want[i][1] + want[i + 1][1] + want[i + 32][1] + want[i + 33][1]) / 4.0;
                CHECK(std::abs(tent[i][1] - mean) < 1e-9);
            }
    }
}

TEST_CASE("the truth refuses numbers of samples that it cannot draw", "[truth]") {
    for (const int samples : {0, -1, 17})
        CHECK_THROWS_WITH(draw_truth(small_frame(1, 1), {.samples_per_axis = samples}),
                          "samples_per_axis must lie within 1..16 (got " + std::to_string(samples) + ')');
}
