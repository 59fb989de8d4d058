// SPDX-License-Identifier: MIT
// The figures of a trade-off against known answers.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <regex>

#include "demo/tradeoff/pareto.h"
#include "demo/tradeoff/picture_error.h"
#include "demo/tradeoff/report.h"
#include "demo/tradeoff/sweep.h"
#include "pipeline/frame/frame_text.h"

namespace {

using demo::Choice;
using demo::Cost;
using demo::PictureError;
using demo::RealPicture;
using Indices = std::vector<std::size_t>;

// value(x, y, channel)
RealPicture picture_of(int width, int height, const std::function<double(int, int, int)>& value) {
    RealPicture picture{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) picture.pixels.push_back({value(x, y, 0), value(x, y, 1), value(x, y, 2)});
    return picture;
}
RealPicture grey(int width, int height, double value) {
    return picture_of(width, height, [&](int, int, int) { return value; });
}

demo::Knob knob_of(std::string_view name, const std::vector<std::string_view>& settings) {
    demo::Knob knob{name, {}};
    for (const std::string_view setting : settings) knob.settings.push_back({setting, [](demo::FrameOptions&) {}});
    return knob;
}

demo::MeasuredSetting measured(const Choice& choice, double ratio, double truth_rms, double exact_rms) {
    demo::MeasuredSetting setting{.choice = choice};
    setting.ratio        = ratio;
    setting.to_truth.rms = truth_rms;
    setting.to_exact.rms = exact_rms;
    return setting;
}

}  // namespace

TEST_CASE("the Pareto front is what no other beats, the fastest first", "[tradeoff]") {
    CHECK(demo::pareto_front({}).empty());
    CHECK(demo::pareto_front(std::vector<Cost>{{1.0, 0.0}}) == Indices{0});
    //                                     exact       beaten      cheap       best trade  slower and worse
    CHECK(demo::pareto_front(std::vector<Cost>{{1.0, 0.0}, {0.6, 3.0}, {0.3, 5.0}, {0.5, 2.0}, {1.1, 0.1}}) ==
          Indices{2, 3, 0});
    // As fast but worse; as good but slower; a second one that is equal.
    CHECK(demo::pareto_front(std::vector<Cost>{{0.5, 2.0}, {0.5, 1.0}, {0.7, 1.0}, {0.5, 1.0}}) == Indices{1});
}

TEST_CASE("greatest difference, RMS and PSNR are as defined", "[tradeoff]") {
    const PictureError none = demo::error_between(grey(16, 12, 77.0), grey(16, 12, 77.0));
    CHECK(none.max == 0.0);
    CHECK(none.rms == 0.0);
    CHECK(std::isinf(none.psnr_db));
    CHECK(none.ssim == 1.0);

    const PictureError one = demo::error_between(grey(16, 12, 77.0), grey(16, 12, 78.0));
    CHECK(one.max == 1.0);
    CHECK(one.rms == Approx(1.0));
    CHECK(one.psnr_db == Approx(20.0 * std::log10(255.0)));

    // One channel of one pixel: 30^2 over 3 * 300 samples.
    RealPicture spot = grey(20, 15, 100.0);
    spot.pixels[47][1] += 30.0;
    const PictureError of_spot = demo::error_between(grey(20, 15, 100.0), spot);
    CHECK(of_spot.max == 30.0);
    CHECK(of_spot.rms == Approx(1.0));
}

TEST_CASE("SSIM is that of Wang et al. 2004", "[tradeoff]") {
    const double c1 = 2.55 * 2.55;
    // Without structure only the luminances are compared.
    CHECK(demo::error_between(grey(30, 20, 100.0), grey(30, 20, 120.0)).ssim ==
          Approx((2.0 * 100.0 * 120.0 + c1) / (100.0 * 100.0 + 120.0 * 120.0 + c1)).epsilon(1e-12));
    // Luma is what is compared: of red alone 0.299 times as much.
    const auto red = [](double value) {
        return picture_of(30, 20, [&](int, int, int channel) { return channel == 0 ? value : 0.0; });
    };
    const double a = 0.299 * 100.0, b = 0.299 * 200.0;
    CHECK(demo::error_between(red(100.0), red(200.0)).ssim == Approx((2.0 * a * b + c1) / (a * a + b * b + c1)));

    // By the definition, window by window with weights in two dimensions, as another program has it.
    const auto ramp = [](int x, int y, int) { return static_cast<double>((x * 7 + y * 13) % 256); };
    const auto worn = [](int x, int y, int) { return static_cast<double>((x * 7 + y * 13 + x * y % 5 * 3) % 256); };
    CHECK(demo::error_between(picture_of(32, 24, ramp), picture_of(32, 24, worn)).ssim ==
          Approx(0.8771173565354758).epsilon(1e-10));

    // Upside down contrast about one mean is less than no likeness.
    const auto wave = [](double sign) {
        return [=](int x, int, int) { return 128.0 + sign * (x % 2 ? 60.0 : -60.0); };
    };
    const double against = demo::error_between(picture_of(24, 24, wave(1.0)), picture_of(24, 24, wave(-1.0))).ssim;
    CHECK(against < -0.9);
}

TEST_CASE("what is not faster than exact by more than the noise is on no front", "[tradeoff]") {
    demo::Sweep sweep;
    sweep.noise    = 0.05;
    sweep.settings = {measured({0, 0}, 1.0, 3.0, 0.0), measured({1, 0}, 0.96, 2.0, 1.0),
                      measured({2, 0}, 0.9, 4.0, 0.5), measured({0, 1}, 0.8, 2.5, 2.0)};
    demo::mark_fronts(sweep);
    const auto on = [&](bool demo::MeasuredSetting::*front) {
        std::vector<bool> marks;
        for (const demo::MeasuredSetting& setting : sweep.settings) marks.push_back(setting.*front);
        return marks;
    };
    // The last is nearer to the truth than the exact picture.
    CHECK(on(&demo::MeasuredSetting::on_truth_front) == std::vector<bool>{false, false, false, true});
    CHECK(on(&demo::MeasuredSetting::on_exact_front) == std::vector<bool>{true, false, true, true});
    const auto front = demo::front_of(sweep);
    REQUIRE(front.size() == 3);
    CHECK(front[0]->choice == Choice{0, 0});
    CHECK(front[1]->choice == Choice{2, 0});
    CHECK(front[2]->choice == Choice{0, 1});
}

TEST_CASE("settings that pay are combined, all of them where they are few", "[tradeoff]") {
    const std::vector<demo::Knob> knobs{knob_of("a", {"a1", "a2"}), knob_of("b", {"b1"}), knob_of("c", {"c1"})};
    demo::Sweep sweep;
    sweep.noise    = 0.02;
    sweep.settings = {measured({0, 0, 0}, 1.0, 1.0, 0.0), measured({1, 0, 0}, 0.9, 2.0, 1.0),
                      measured({2, 0, 0}, 0.7, 5.0, 4.0), measured({0, 1, 0}, 0.8, 9.0, 9.0),
                      measured({0, 0, 1}, 0.99, 1.0, 0.1)};
    demo::mark_fronts(sweep);
    // c1 does not pay.
    CHECK(demo::next_combinations(sweep, knobs) == std::vector<Choice>{{2, 1, 0}, {1, 1, 0}});
    sweep.settings.push_back(measured({1, 1, 0}, 0.7, 9.0, 9.0));
    CHECK(demo::next_combinations(sweep, knobs) == std::vector<Choice>{{2, 1, 0}});
}

TEST_CASE("of many settings that pay, those on a front get one more", "[tradeoff]") {
    const std::vector<demo::Knob> knobs(6, knob_of("k", {"k1"}));  // 64 combinations
    demo::Sweep sweep;
    sweep.settings.push_back(measured(Choice(6, 0), 1.0, 1.0, 0.0));
    for (std::size_t i = 0; i < 6; ++i) {
        sweep.settings.push_back(measured(Choice(6, 0), 0.9, 9.0, 9.0));
        sweep.settings.back().choice[i] = 1;
    }
    sweep.settings[2].ratio = 0.5;  // which beats the others
    demo::mark_fronts(sweep);
    const std::vector<Choice> next = demo::next_combinations(sweep, knobs);
    CHECK(next ==
          std::vector<Choice>{
              {1, 1, 0, 0, 0, 0}, {0, 1, 1, 0, 0, 0}, {0, 1, 0, 1, 0, 0}, {0, 1, 0, 0, 1, 0}, {0, 1, 0, 0, 0, 1}});
}

TEST_CASE("a choice of settings is named, and does what each of them does", "[tradeoff]") {
    const auto no_clouds = [](demo::FrameOptions& options) { options.has_clouds = false; };
    const auto shift     = [](demo::FrameOptions& options) { options.shift_px.x = 7.0f; };
    const std::vector<demo::Knob> knobs{{"clouds", {{"none", no_clouds}}},
                                        {"shift", {{"all", no_clouds}, {"x", shift}}}};
    CHECK(demo::name_of({0, 0}, knobs) == "exact");
    CHECK(demo::name_of({1, 2}, knobs) == "none + x");
    CHECK(demo::options_of({0, 2}, knobs).has_clouds);
    CHECK(demo::options_of({0, 2}, knobs).shift_px.x == 7.0f);
    CHECK_FALSE(demo::options_of({1, 2}, knobs).has_clouds);
    CHECK(demo::options_of({1, 0}, knobs).shift_px.x == 0.0f);
}

TEST_CASE("each knob changes its own option, and in a frame what that is about", "[tradeoff]") {
    using Options = cloud::MegaParticleOptions;
    struct Expected {
        std::string name;
        Options options;
        std::string fields;  // that may differ
    };
    const std::string geometry = R"(vertices|indices|passes\[\d+\]\.draws)";
    const std::string skirt    = R"(|passes\[5\])";  // whose draws are all gone
    const std::vector<Expected> expected{
        {"scale 1/2", {.target_scale = 2}, "targets|passes|vertices|indices|cameras"},
        {"scale 1/4", {.target_scale = 4}, "targets|passes|vertices|indices|cameras"},
        {"spheres -1", {.fewer_sphere_levels = 1}, geometry},
        {"spheres -2", {.fewer_sphere_levels = 2}, geometry},
        {"no skirt", {.skirt = false}, geometry + skirt},
    };
    const demo::ScenePtr scene = demo::load_scene("canyon");
    const auto frame_with      = [&](const demo::FrameOptions& options) {
        return demo::scene_frame(*scene, {320, 180}, 0, options);
    };
    const pipeline::Frame exact             = frame_with({});
    std::size_t found                       = 0;
    const std::span<const demo::Knob> knobs = demo::knobs();
    for (std::size_t knob = 0; knob < knobs.size(); ++knob)
        for (std::size_t setting = 1; setting <= knobs[knob].settings.size(); ++setting) {
            Choice choice = demo::exact_choice(knobs);
            choice[knob]  = setting;
            REQUIRE(found < expected.size());
            const Expected& wanted = expected[found++];
            INFO(wanted.name);
            CHECK(demo::name_of(choice, knobs) == wanted.name);
            const demo::FrameOptions options = demo::options_of(choice, knobs);
            CHECK(options.mega_particles == wanted.options);
            const std::vector<std::string> lines = pipeline::diff(exact, frame_with(options));
            CHECK_FALSE(lines.empty());
            const std::regex allowed("(" + wanted.fields + ")[^a-z_].*");
            for (const std::string& line : lines) {
                INFO(line);
                CHECK(std::regex_match(line, allowed));
            }
        }
    CHECK(found == expected.size());
    CHECK(frame_with({.precision = demo::Precision::Fast}) == frame_with({.mega_particles = {.skirt = false}}));
}

TEST_CASE("a sweep is written as CSV and as Markdown", "[tradeoff]") {
    demo::Sweep sweep;
    sweep.settings                     = {measured({0}, 1.0, 3.0, 0.0), measured({1}, 0.5, 3.25, 1.5)};
    sweep.settings[0].name             = "exact";
    sweep.settings[0].to_exact.psnr_db = std::numeric_limits<double>::infinity();
    demo::MeasuredSetting& half        = sweep.settings[1];
    half.name                          = "half, \"soft\"";
    half.milliseconds                  = 12.3456;
    half.ratio_low = 0.49, half.ratio_high = 0.51;
    half.to_truth = {40.0, 3.25, 37.9, 0.98};
    half.to_exact = {20.0, 1.5, 44.6, 0.9912345};
    demo::mark_fronts(sweep);
    CHECK(demo::to_csv(sweep) ==
          "setting,milliseconds,ratio,ratio_low,ratio_high,truth_max,truth_rms,truth_psnr_db,truth_ssim,exact_max,"
          "exact_rms,exact_psnr_db,exact_ssim,on_truth_front,on_exact_front\n"
          "exact,0.000,1.0000,1.0000,1.0000,0.00,3.0000,0.00,1.000000,0.00,0.0000,inf,1.000000,1,1\n"
          "\"half, \"\"soft\"\"\",12.346,0.5000,0.4900,0.5100,40.00,3.2500,37.90,0.980000,20.00,1.5000,44.60,0.991235,"
          "1,1\n");
    CHECK(demo::to_markdown(sweep, "puff") ==
          "| scene | setting | time | RMS to truth | PSNR | SSIM | RMS to exact | greatest | SSIM |\n"
          "| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n"
          "| puff | exact | 1.00 | 3.00 | 0.00 dB | 1.0000 | 0.00 | 0 | 1.0000 |\n"
          "| puff | half, \"soft\" | 0.50 | 3.25 | 37.90 dB | 0.9800 | 1.50 | 20 | 0.9912 |\n");
}
