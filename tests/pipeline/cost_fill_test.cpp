// SPDX-License-Identifier: MIT
// Costs of filling and of memory against published figures: peaks and the costs of single layers that the sources of
// pipeline/cost/rates.cpp give.

#include "pipeline/cost/fill_cost.h"
#include "pipeline/cost/pass_work.h"
#include "tests/support/cost_frames.h"

using namespace pipeline;
using namespace test_support;

TEST_CASE("cost: the published peaks of filling", "[cost]") {
    const struct {
        const char* profile;
        double pixels_low, pixels_high, one_low, one_high, two_low, two_high;  // M/s; two: texels of two textures
    } rows[] = {
        {"ps2", 2359.296, 2359.296, 1179.648, 1179.648, 1179.648, 1179.648},
        {"dx7", 480, 800, 480, 800, 480, 1600},
        {"gamecube", 648, 648, 648, 648, 648, 648},
        {"xbox", 932, 932, 932, 932, 1864, 1864},
    };
    CHECK(std::size(rows) == chip_rates().size());
    const std::uint64_t pixels = area_of(64, 32);
    for (const auto& row : rows) {
        INFO(row.profile);
        const Frame plain         = frame_of_rectangle(64, 32);
        const PassCost untextured = first_cost(plain, replaced(pixels), row.profile);
        check_range(rate_of(2048, untextured.of(CostUnit::Fill)), row.pixels_low, row.pixels_high);
        for (const int stages : {1, 2}) {
            Frame frame = plain;
            bind_textures(frame, stages, TextureFormat::L8, 64, 32, TextureFilter::Linear);
            const PassCounts counts = textured(pixels, stages, TextureFormat::L8, 4);
            const Range fill        = first_cost(frame, counts, row.profile).of(CostUnit::Fill);
            if (stages == 1) check_range(rate_of(2048, fill), row.one_low, row.one_high);
            if (stages == 2) check_range(rate_of(2 * 2048, fill), row.two_low, row.two_high);
        }
    }
}

TEST_CASE("cost: linear filters of four bytes a texel keep the peaks", "[cost]") {
    // The ports were built for it: what a filter reads is no slower than the pixels.
    for (const char* profile : {"ps2", "gamecube"}) {
        INFO(profile);
        Frame frame = frame_of_rectangle(64, 32);
        bind_textures(frame, 1, TextureFormat::A8R8G8B8, 64, 32, TextureFilter::Linear);
        const PassCost cost = first_cost(frame, textured(2048, 1, TextureFormat::A8R8G8B8, 4), profile);
        CHECK(cost.of(CostUnit::TextureMemory).most <= cost.of(CostUnit::Fill).least);
        CHECK(cost.of(CostUnit::TextureMemory).most > 0.0);
    }
}

TEST_CASE("cost: ideal textured passes on the Graphics Synthesizer", "[cost]") {
    // ps2: 35,840 clocks or 243 us, 8,960 or 61 us, 2,240 or 15 us.
    const struct {
        int width, height;
        double clk, us;
    } rows[] = {{640, 448, 35840, 243}, {320, 224, 8960, 61}, {160, 112, 2240, 15}};
    for (const auto& row : rows) {
        Frame frame = frame_of_rectangle(row.width, row.height);
        bind_textures(frame, 1, TextureFormat::A8R8G8B8, row.width, row.height, TextureFilter::Linear);
        const std::uint64_t pixels = area_of(row.width, row.height);
        const PassCost cost        = first_cost(frame, textured(pixels, 1, TextureFormat::A8R8G8B8, 4), "ps2");
        CHECK(clocks(cost.of(CostUnit::Fill).least, rates_of("ps2")) == Approx(row.clk));
        CHECK(cost.of(CostUnit::Fill).least * 1e3 == Approx(row.us).epsilon(0.02));
    }
}

TEST_CASE("cost: pixels fill whole footprints", "[cost]") {
    const auto slots = [](const PixelRect& rect, Footprint footprint) {
        DrawWork draw{.is_rectangle = true, .covered = rect, .textures = {}};
        draw.fragments = static_cast<double>((rect.x1 - rect.x0) * (rect.y1 - rect.y0));
        return pixel_slots(draw, footprint);
    };
    CHECK(slots({0, 0, 8, 2}, {8, 2}) == Range{16, 16});
    CHECK(slots({0, 0, 1, 1}, {8, 2}) == Range{1, 16});
    CHECK(slots({7, 1, 9, 3}, {8, 2}) == Range{4, 64});
    CHECK(slots({7, 1, 9, 3}, {2, 2}) == Range{4, 16});
    CHECK(slots({7, 1, 9, 3}, {1, 1}) == Range{4, 4});
    const auto triangles = [](double fragments, double count, Footprint footprint) {
        return pixel_slots({.covered = {}, .fragments = fragments, .triangles = count, .textures = {}}, footprint);
    };
    // Textures halve the footprint of the Graphics Synthesizer: 4x2 at (4, 0) are a clock.
    Frame frame           = small_frame(64, 32);
    frame.passes[0].draws = {rectangle({4, 0, 8, 2}, 0xffffffff)};
    check_range(first_cost(frame, replaced(8), "ps2").of(CostUnit::Fill), 0.5 / 147456, 1.0 / 147456);
    bind_textures(frame, 1, TextureFormat::L8, 8, 8, TextureFilter::Point);
    const PassCounts with_texture = textured(8, 1, TextureFormat::L8, 1);
    check_range(first_cost(frame, with_texture, "ps2").of(CostUnit::Fill), 1.0 / 147456, 1.0 / 147456);
    // Ten of one fragment each: a footprint for each.
    CHECK(triangles(10, 10, {8, 2}) == Range{10, 160});
    // Half of a square of 32: 31 / 2 + 1 rows of 15 / 8 + 1 footprints.
    CHECK(triangles(512, 1, {8, 2}) == Range{512, 16.5 * 2.875 * 16});
    CHECK(triangles(512, 1, {1, 1}) == Range{512, 512});
}

TEST_CASE("cost: memory that is shared", "[cost]") {
    // dx7: a 32-bit blended pixel with depth tested moves 12 bytes, 16 if depth is written: 165 to 220 Mpixels/s at
    // 2.66 GB/s, 330 to 440 at 5.3. xbox: a layer of 640x480 takes 0.6 to 0.8 ms at 6.4 GB/s.
    const std::uint64_t pixels  = area_of(640, 480);
    Frame frame                 = frame_of_rectangle(640, 480, TargetFormat::D24);
    frame.passes[0].state.blend = kAlphaOver;
    for (const bool writes : {false, true}) {
        frame.passes[0].state.depth                             = {CompareFunc::LessEqual, writes};
        std::get<DrawRectangle>(frame.passes[0].draws[0]).color = {0x80ffffff};
        const std::vector<PassCounts> counts                    = execute(frame).counts;
        CHECK(counts[0].bytes == pixels * (writes ? 16 : 12));
        const PassCost on_card = cost(frame, counts, rates_of("dx7")).passes[0];
        check_range(rate_of(static_cast<double>(pixels), on_card.ms), writes ? 165 : 220, writes ? 330 : 440, 0.02);
        CHECK(slowest_unit(on_card) == CostUnit::MainMemory);
        const PassCost on_xbox = cost(frame, counts, rates_of("xbox")).passes[0];
        CHECK(on_xbox.ms.least == Approx(writes ? 0.8 : 0.6).epsilon(0.05));
        // The raw fill of it: 0.33 ms.
        CHECK(on_xbox.of(CostUnit::Fill).least == Approx(0.33).epsilon(0.01));
    }
}

TEST_CASE("cost: GameCube layers and copies", "[cost]") {
    // One layer of 640x480 takes 0.47 ms at the peak; a copy of it to RGBA8 writes 1.2 MB to memory of 2.6 GB/s.
    const std::uint64_t pixels = area_of(640, 480);
    const PassCost layer       = first_cost(frame_of_rectangle(640, 480), replaced(pixels), "gamecube");
    CHECK(layer.ms.least == Approx(0.47).epsilon(0.01));

    Frame frame = small_frame(640, 480);
    frame.targets.push_back({.name = "source", .format = TargetFormat::R6G6B6A6, .width = 640, .height = 480});
    frame.passes[0].draws = {CopyRectangle{.source = {1}, .from = {0, 0, 640, 480}}};
    const FrameCost copy  = cost(frame, execute(frame).counts, rates_of("gamecube"));
    const PassCost& one   = copy.passes[0];
    check_range(one.of(CostUnit::MainMemory), 1228800 / 2.6e6, 1228800 / 2.6e6);
    check_range(one.of(CostUnit::FrameMemory), 0.0, 640 * 480 * 3 / 7.6e6);
    CHECK(one.of(CostUnit::Copy) == Range{});
    CHECK(topics(copy) == std::vector<std::string_view>{"copies"});
    // Within the Graphics Synthesizer's memory it is read and written there.
    const Range local = cost(frame, execute(frame).counts, rates_of("ps2")).total.of(CostUnit::FrameMemory);
    check_range(local, 640 * 480 * 7 / 38.4e6, 640 * 480 * 7 / 37.75e6);
    // Within the memory that cards and the Xbox share, too.
    const Range shared = cost(frame, execute(frame).counts, rates_of("xbox")).total.of(CostUnit::MainMemory);
    check_range(shared, 640 * 480 * 7 / 6.4e6, 640 * 480 * 7 / 5.3e6);
    // Halved, it writes a quarter.
    std::get<CopyRectangle>(frame.passes[0].draws[0]).halve = true;
    const FrameCost halved                                  = cost(frame, execute(frame).counts, rates_of("gamecube"));
    check_range(halved.passes[0].of(CostUnit::MainMemory), 307200 / 2.6e6, 307200 / 2.6e6);
}

TEST_CASE("cost: textures that come from memory", "[cost]") {
    // 1 MB of texture fits the GameCube's cache, and is fetched once, however often it is read; one more does not.
    for (const int width : {512, 1024}) {
        INFO(width);
        Frame frame = frame_of_rectangle(512, 512);
        bind_textures(frame, 1, TextureFormat::A8R8G8B8, width, 512, TextureFilter::Linear);
        Draw draw                           = frame.passes[0].draws[0];
        std::get<DrawRectangle>(draw).uv[0] = {0.0f, 0.0f, 1.0f, 1.0f};
        for (int i = 0; i < 3; ++i) frame.passes[0].draws.push_back(draw);
        const double once = width * 512 * 4;
        PassCounts counts = textured(4 * area_of(512, 512), 1, TextureFormat::A8R8G8B8, 4);
        counts.rectangles = 4;
        const Range main  = first_cost(frame, counts, "gamecube").of(CostUnit::MainMemory);
        check_range(main, once / 2.6e6, (width == 512 ? 1 : 4) * once / 2.6e6);
        // No cache of the Xbox is known: each drawing may fetch it again.
        const Range shared   = first_cost(frame, counts, "xbox").of(CostUnit::MainMemory);
        const double targets = 4 * 512 * 512 * 4;
        check_range(shared, (targets + once) / 6.4e6, (targets + 4 * once) / 5.3e6);
    }
}

TEST_CASE("cost: texels that a rectangle reads anew", "[cost]") {
    const struct {
        const char* name;
        UvRect uv;
        TextureFilter filter;
        Range fresh;
    } rows[] = {
        {"one a pixel", {0, 0, 0.5f, 0.5f}, TextureFilter::Linear, {1, 1}},
        {"halved", {0, 0, 1, 1}, TextureFilter::Linear, {4, 4}},
        {"mirrored", {1, 0, 0, 1}, TextureFilter::Linear, {4, 4}},
        {"more than the filter takes", {0, 0, 4, 4}, TextureFilter::Linear, {4, 4}},
        {"point", {0, 0, 1, 1}, TextureFilter::Point, {1, 1}},
        {"magnified", {0, 0, 0.25f, 0.25f}, TextureFilter::Linear, {0.25, 1}},
    };
    for (const auto& row : rows) {
        INFO(row.name);
        Frame frame = frame_of_rectangle(64, 64);
        bind_textures(frame, 1, TextureFormat::L8, 128, 128, row.filter);
        std::get<DrawRectangle>(frame.passes[0].draws[0]).uv[0] = row.uv;
        const PassWork work = pass_work(frame, frame.passes[0], execute(frame).counts[0]);
        REQUIRE(work.draws.size() == 1);
        REQUIRE(work.draws[0].textures.size() == 1);
        CHECK(work.draws[0].textures[0].fresh == row.fresh);
        CHECK(work.texel_scale == 1.0);
        CHECK(work.frame_bytes == 64.0 * 64.0 * 4.0);
    }
}

TEST_CASE("cost: a second stage may cost the GameCube a second clock", "[cost]") {
    Frame frame = frame_of_rectangle(64, 32);
    for (std::size_t i = 0; i < 2; ++i)
        frame.passes[0].state.stages[i] = {.color_op = TextureOp::SelectArg2, .alpha_op = TextureOp::SelectArg2};
    check_range(first_cost(frame, replaced(2048), "gamecube").of(CostUnit::Fill), 2048 / 648e3, 2 * 2048 / 648e3);
    check_range(first_cost(frame, replaced(2048), "xbox").of(CostUnit::Fill), 2048 / 932e3, 2048 / 932e3);
}

TEST_CASE("cost: a sample with linear mips is two", "[cost]") {
    Frame frame = frame_of_rectangle(64, 32);
    bind_textures(frame, 1, TextureFormat::L8, 64, 32, TextureFilter::Linear);
    const Range one = first_cost(frame, textured(2048, 1, TextureFormat::L8, 4), "gamecube").of(CostUnit::Fill);
    frame.passes[0].state.stages[0].mip_filter = MipFilter::Linear;
    const Range two = first_cost(frame, textured(2048, 1, TextureFormat::L8, 8), "gamecube").of(CostUnit::Fill);
    CHECK(two.least == Approx(2.0 * one.least));
    CHECK(two.most == Approx(2.0 * one.most));
}
