// SPDX-License-Identifier: MIT
// What must hold of the cost of any frame. Published figures: cost_fill_test.cpp, cost_page_breaks_test.cpp.
#include "pipeline/cost/cost.h"

#include <algorithm>
#include <cmath>

#include "pipeline/cost/pass_work.h"
#include "tests/support/cost_frames.h"
#include "tests/support/random_frame.h"

using namespace pipeline;
using namespace test_support;

TEST_CASE("rates: every number has a unit and a source, or says what is not known", "[cost]") {
    CHECK(find_rates("ideal") == nullptr);
    CHECK(find_rates("voodoo") == nullptr);
    for (const Profile& profile : profiles()) CHECK((find_rates(profile.name) != nullptr) == (profile.name != "ideal"));
    for (const ChipRates& rates : chip_rates()) {
        CHECK(find_profile(rates.profile) != nullptr);
        CHECK(rates.page_breaks.has_value() == (rates.profile == "ps2"));
        visit_rates(rates, [&](std::string_view name, const Rate& rate) {
            INFO(rates.profile << " " << name);
            CHECK(rate.evidence.topic == name);
            CHECK(!rate.unit.empty());
            CHECK(!rate.evidence.source.empty());
            CHECK(rate.low <= rate.high);
            CHECK(rate.low >= 0.0);
            CHECK((rate.low > 0.0) == (rate.high > 0.0));
            const bool is_doubtful = !is_known(rate) || rate.evidence.grade == Grade::Chosen;
            if (is_doubtful) CHECK(!rate.evidence.open.empty());
            if (!rate.evidence.open.empty()) CHECK(rate.evidence.open.back() != '.');
        });
    }
}

TEST_CASE("cost: counts are shared out among the draws", "[cost]") {
    Frame frame           = small_frame(64, 64);
    DrawTriangles quad    = add_quad(frame, 0xffffffff);
    frame.passes[0].draws = {rectangle({0, 0, 16, 16}, 0xffffffff), quad};
    for (int i = 0; i < 2; ++i) add_quad(frame, 0xffffffff);
    quad.first_index = 0;
    quad.index_count = 18;
    frame.passes[0].draws.emplace_back(quad);
    const auto shares = [&](std::uint64_t covered) {
        const PassWork work =
            pass_work(frame, frame.passes[0], {.triangles_drawn = 8, .rectangles = 1, .covered = covered});
        REQUIRE(work.draws.size() == 3);
        CHECK(work.draws[0].triangles == 0.0);
        CHECK(work.draws[1].triangles == 2.0);
        CHECK(work.draws[2].triangles == 6.0);
        return std::array{work.draws[0].fragments, work.draws[1].fragments, work.draws[2].fragments};
    };
    CHECK(shares(256 + 1000) == std::array{256.0, 250.0, 750.0});
    CHECK(shares(256) == std::array{256.0, 0.0, 0.0});
    CHECK(shares(128) == std::array{128.0, 0.0, 0.0});
}

TEST_CASE("cost: texels are those that were counted", "[cost]") {
    Frame frame = frame_of_rectangle(64, 32);
    bind_textures(frame, 1, TextureFormat::L8, 64, 32, TextureFilter::Linear);
    PassCounts counts = textured(2048, 1, TextureFormat::L8, 4);
    counts.texels /= 2;
    counts.bytes -= counts.texels;
    const PassWork work = pass_work(frame, frame.passes[0], counts);
    CHECK(work.texel_scale == 0.5);
    CHECK(work.frame_bytes == 2048.0 * 4.0);
    // A stage reads its texture if an argument is it, or if it blends by its alpha.
    const auto is_read = [&](const TextureStage& stage) {
        frame.passes[0].state.stages[0] = stage;
        return !pass_work(frame, frame.passes[0], counts).draws[0].textures.empty();
    };
    constexpr TextureArg kDiffuse{.source = ArgSource::Diffuse};
    CHECK(is_read({.color_op = TextureOp::Modulate, .alpha_op = TextureOp::SelectArg2}));
    CHECK(is_read({.color_op = TextureOp::SelectArg2, .alpha_op = TextureOp::SelectArg1}));
    CHECK(
        is_read({.color_op = TextureOp::BlendTextureAlpha, .color_arg1 = kDiffuse, .alpha_op = TextureOp::SelectArg2}));
    CHECK(!is_read({.color_op = TextureOp::SelectArg2, .alpha_op = TextureOp::SelectArg2}));
    CHECK(!is_read({.color_op = TextureOp::Modulate, .color_arg1 = kDiffuse, .alpha_op = TextureOp::SelectArg2}));
    CHECK(!is_read({}));
}

TEST_CASE("cost: geometry", "[cost]") {
    Frame frame           = small_frame(64, 32);
    frame.passes[0].draws = {add_quad(frame, 0xffffffff)};
    // A mesh of a million triangles, half of them culled, of which no pixel is left.
    const PassCounts counts{.vertices = 500'000, .triangles_in = 1'000'000, .triangles_drawn = 500'000};
    const FrameCost on_ps2 = cost(frame, {counts}, rates_of("ps2"));
    check_range(on_ps2.total.of(CostUnit::Setup), 500 / 75.0, 500 / 20.0);
    check_range(on_ps2.total.of(CostUnit::Vertices), 500 / 75.0, 3000 / 20.0);
    check_range(on_ps2.total.of(CostUnit::VertexUpload), 500 * 32 / 1200.0, 3 * 500 * 32 / 1180.0);
    CHECK(on_ps2.total.ms.least == Approx(500 * 32 / 1200.0));  // side by side, not their sum
    CHECK(on_ps2.verdict == Verdict::Depends);
    CHECK(slowest_unit(on_ps2.total) == CostUnit::Vertices);
    check_range(cost(frame, {counts}, rates_of("dx7")).total.of(CostUnit::Vertices), 25, 150);
    // Not known for the others: named, and no time.
    for (const char* profile : {"gamecube", "xbox"}) {
        const FrameCost unknown = cost(frame, {counts}, rates_of(profile));
        CHECK(unknown.total.ms == Range{});
        CHECK(topics(unknown) == std::vector<std::string_view>{"setup", "vertices"});
    }
}

TEST_CASE("cost: fog on the Graphics Synthesizer is not known", "[cost]") {
    Frame frame           = small_frame(64, 32);
    frame.passes[0].draws = {add_quad(frame, 0xffffffff)};
    const PassCounts counts{.vertices = 4, .triangles_in = 2, .triangles_drawn = 2, .covered = 2048};
    CHECK(cost(frame, {counts}, rates_of("ps2")).unknown.empty());
    frame.passes[0].state.fog.mode = FogMode::Linear;
    const FrameCost fogged         = cost(frame, {counts}, rates_of("ps2"));
    CHECK(topics(fogged) == std::vector<std::string_view>{"fogged_pixels"});
    // Rectangles have no fog.
    Frame blit                    = frame_of_rectangle(64, 32);
    blit.passes[0].state.fog.mode = FogMode::Linear;
    CHECK(cost(blit, {replaced(2048)}, rates_of("ps2")).unknown.empty());
}

TEST_CASE("cost: a pass with nothing costs nothing", "[cost]") {
    Frame frame = frame_of_rectangle(640, 448, TargetFormat::D24);
    frame.passes[0].draws.emplace_back(add_quad(frame, 0xffffffff));
    bind_textures(frame, 2, TextureFormat::L8, 256, 256, TextureFilter::Linear);
    for (const ChipRates& rates : chip_rates()) {
        INFO(rates.profile);
        const FrameCost nothing = cost(frame, {PassCounts{}}, rates);
        CHECK(nothing.passes[0] == PassCost{});
        CHECK(nothing.total == PassCost{});
        CHECK(nothing.unknown.empty());
        CHECK(nothing.verdict == Verdict::Fits);
        CHECK(cost(Frame{}, {}, rates).total == PassCost{});
    }
}

TEST_CASE("cost: grows with each count", "[cost]") {
    Frame frame = frame_of_rectangle(64, 64, TargetFormat::D24);
    frame.passes[0].draws.emplace_back(add_quad(frame, 0xffffffff));
    frame.passes[0].clear = {.color = Argb{0}, .depth = 1.0f};
    bind_textures(frame, 2, TextureFormat::L8, 256, 256, TextureFilter::Linear);
    const PassCounts base{.vertices        = 400,
                          .triangles_in    = 200,
                          .triangles_drawn = 100,
                          .rectangles      = 1,
                          .covered         = 50'000,
                          .depth_tested    = 50'000,
                          .depth_passed    = 50'000,
                          .depth_written   = 50'000,
                          .color_written   = 50'000,
                          .blended         = 50'000,
                          .cleared         = 8192,
                          .texels          = 400'000,
                          .bytes           = 2'000'000};
    const struct {
        const char* name;
        std::uint64_t PassCounts::*count;
        CostUnit unit;  // of ps2 that it makes longer
    } rows[] = {
        {"vertices", &PassCounts::vertices, CostUnit::Vertices},
        {"triangles_drawn", &PassCounts::triangles_drawn, CostUnit::Setup},
        {"triangles_in", &PassCounts::triangles_in, CostUnit::Vertices},
        {"rectangles", &PassCounts::rectangles, CostUnit::VertexUpload},
        {"covered", &PassCounts::covered, CostUnit::Fill},
        {"cleared", &PassCounts::cleared, CostUnit::Fill},
        {"texels", &PassCounts::texels, CostUnit::TextureMemory},
        {"bytes", &PassCounts::bytes, CostUnit::FrameMemory},
    };
    for (const auto& row : rows) {
        INFO(row.name);
        PassCounts more = base;
        more.*row.count *= 10;
        const PassCost small = first_cost(frame, base, "ps2"), large = first_cost(frame, more, "ps2");
        const Range before = small.of(row.unit), after = large.of(row.unit);
        CHECK(after.least >= before.least);
        CHECK(after.most >= before.most);
        CHECK(after != before);
        for (const ChipRates& rates : chip_rates()) {
            INFO(rates.profile);
            const Range one = cost(frame, {base}, rates).total.ms, ten = cost(frame, {more}, rates).total.ms;
            CHECK(ten.least >= one.least);
            CHECK(ten.most >= one.most);
        }
    }
}

TEST_CASE("cost: ranges are ordered, and totals are sums", "[cost]") {
    std::size_t rectangles = 0;
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        const Frame frame                    = random_frame(seed);
        const std::vector<PassCounts> counts = execute(frame).counts;
        for (const ChipRates& rates : chip_rates()) {
            INFO(rates.profile << ", random frame " << seed);
            const FrameCost all = cost(frame, counts, rates);
            REQUIRE(all.passes.size() == frame.passes.size());
            PassCost sum;
            for (const PassCost& pass : all.passes) {
                sum += pass;
                for (const Range& range : pass.unit_ms) {
                    CHECK(range.least >= 0.0);
                    CHECK(range.least <= range.most);
                    CHECK(std::isfinite(range.most));
                }
                CHECK(pass.page_breaks.least <= pass.page_breaks.most);
                CHECK(pass.ms.least <= pass.ms.most);
                // No unit takes longer than its pass.
                for (const Range& range : pass.unit_ms) CHECK(range.most <= pass.ms.most * (1.0 + 1e-12));
            }
            CHECK(sum == all.total);
            CHECK(all.verdict == verdict_of(all.total.ms));
        }
        // What rectangles cover is known without drawing.
        for (std::size_t i = 0; i < counts.size(); ++i) {
            const std::vector<Draw>& draws = frame.passes[i].draws;
            const auto is_rectangle = [](const Draw& draw) { return std::holds_alternative<DrawRectangle>(draw); };
            if (draws.empty() || !std::all_of(draws.begin(), draws.end(), is_rectangle)) continue;
            const PassWork work = pass_work(frame, frame.passes[i], counts[i]);
            std::uint64_t area  = 0;
            for (const DrawWork& draw : work.draws)
                if (draw.covered.x0 < draw.covered.x1 && draw.covered.y0 < draw.covered.y1)
                    area += area_of(draw.covered.x1 - draw.covered.x0, draw.covered.y1 - draw.covered.y0);
            INFO("random frame " << seed << ", pass " << i);
            CHECK(area == counts[i].covered);
            rectangles += draws.size();
        }
    }
    CHECK(rectangles > 20);
}

TEST_CASE("cost: the verdict", "[cost]") {
    CHECK(kFrameBudgetMs == Approx(16.667).epsilon(1e-4));
    CHECK(verdict_of({0.0, 0.0}) == Verdict::Fits);
    CHECK(verdict_of({1.0, 16.6}) == Verdict::Fits);
    CHECK(verdict_of({16.6, 16.7}) == Verdict::Depends);
    CHECK(verdict_of({16.7, 90.0}) == Verdict::TooLong);
    // 60 layers of 640x448 without depth in strips of a page's width fit a PlayStation 2's frame; 200 do not.
    Frame frame             = small_frame(640, 448);
    frame.targets[0].format = TargetFormat::Psmct32;
    for (int x = 0; x < 640; x += 64) frame.passes[0].draws.emplace_back(rectangle({x, 0, x + 64, 448}, 0xffffffff));
    const std::vector<Draw> layer = frame.passes[0].draws;
    for (const auto& [layers, verdict] : {std::pair{60, Verdict::Fits}, {200, Verdict::TooLong}}) {
        frame.passes[0].draws.clear();
        for (int i = 0; i < layers; ++i)
            frame.passes[0].draws.insert(frame.passes[0].draws.end(), layer.begin(), layer.end());
        PassCounts counts = replaced(static_cast<std::uint64_t>(layers) * area_of(640, 448));
        counts.rectangles = frame.passes[0].draws.size();
        CHECK(cost(frame, {counts}, rates_of("ps2")).verdict == verdict);
    }
}

TEST_CASE("cost: counts must be those of the frame", "[cost]") {
    const Frame frame = small_frame(8, 8);
    CHECK_THROWS_AS(cost(frame, {}, rates_of("ps2")), std::invalid_argument);
    CHECK_THROWS_AS(cost(frame, {PassCounts{}, PassCounts{}}, rates_of("ps2")), std::invalid_argument);
    CHECK_NOTHROW(cost(frame, {PassCounts{}}, rates_of("ps2")));
}
