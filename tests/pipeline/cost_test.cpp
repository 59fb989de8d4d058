// SPDX-License-Identifier: MIT
// Costs against published figures: peaks, clear timings and the costs of single layers that the sources of
// pipeline/cost/rates.cpp give, and what must hold of any frame.
#include "pipeline/cost/cost.h"

#include <algorithm>
#include <cmath>

#include "pipeline/cost/fill_cost.h"
#include "pipeline/cost/page_breaks.h"
#include "pipeline/cost/pass_work.h"
#include "tests/support/count_rows.h"
#include "tests/support/random_frame.h"

using namespace pipeline;
using namespace test_support;

namespace {

const ChipRates& rates_of(std::string_view profile) {
    const ChipRates* rates = find_rates(profile);
    REQUIRE(rates != nullptr);
    return *rates;
}

PassCost first_cost(const Frame& frame, const PassCounts& counts, std::string_view profile) {
    return cost(frame, {counts}, rates_of(profile)).passes[0];
}

Frame frame_of_rectangle(int width, int height, std::optional<TargetFormat> depth = {}) {
    Frame frame           = small_frame(width, height, depth);
    frame.passes[0].draws = {rectangle({0, 0, width, height}, 0xffffffff)};
    return frame;
}

std::uint64_t area_of(int width, int height) {
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
}

// Opaque, without depth.
PassCounts replaced(std::uint64_t pixels) {
    return {.rectangles = 1, .covered = pixels, .depth_passed = pixels, .color_written = pixels, .bytes = pixels * 4};
}

// Binds one texture, size x size, to each of the first `stages`, one texel a pixel.
void bind_textures(Frame& frame, int stages, TextureFormat format, int width, int height, TextureFilter filter) {
    auto& draw = std::get<DrawRectangle>(frame.passes[0].draws[0]);
    for (int i = 0; i < stages; ++i) {
        const auto stage     = static_cast<std::size_t>(i);
        const auto bytes     = static_cast<std::size_t>(width * height * bytes_per_texel(format));
        draw.textures[stage] = bound(add_texture(frame, format, width, height, std::vector<std::uint8_t>(bytes)));
        frame.passes[0].state.stages[stage]        = kTextureOnly;
        frame.passes[0].state.stages[stage].filter = filter;
    }
}

PassCounts textured(std::uint64_t pixels, int stages, TextureFormat format, int taps) {
    PassCounts counts = replaced(pixels);
    counts.texels     = pixels * static_cast<std::uint64_t>(stages * taps);
    counts.bytes += counts.texels * static_cast<std::uint64_t>(bytes_per_texel(format));
    return counts;
}

std::vector<std::string_view> topics(const FrameCost& cost) {
    std::vector<std::string_view> names;
    for (const Evidence& evidence : cost.unknown) names.push_back(evidence.topic);
    return names;
}

// Millions of `amount` a second, from the most time to the least.
Range rate_of(double amount, const Range& ms) {
    return {amount / ms.most / 1e3, amount / ms.least / 1e3};
}

void check_range(const Range& range, double least, double most, double tolerance = 0.005) {
    CHECK(range.least == Approx(least).epsilon(tolerance));
    CHECK(range.most == Approx(most).epsilon(tolerance));
}

double clocks(double ms, const ChipRates& rates) {
    return ms * 1e3 * rates.clock.low;
}

}  // namespace

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

namespace {

// A clear of F0bes/clearbench: rectangles of width x height, at each page of the part of the screen that is drawn to.
struct ClearTiming {
    const char* name;
    int width, height;    // of a rectangle
    int screen_height;    // drawn to, of 640 pixels
    bool depth;           // written too, in pages of its own
    double measured_clk;  // half the main processor's cycles
    double breaks;
};

Frame clear_frame(const ClearTiming& row) {
    Frame frame             = small_frame(640, row.screen_height, TargetFormat::D32);
    frame.targets[0].format = TargetFormat::Psmct32;
    Pass& pass              = frame.passes[0];
    if (row.depth) pass.state.depth = {CompareFunc::Always, true};
    const int step_x = std::max(64, row.width), step_y = std::max(32, row.height);
    for (int x = 0; x < 640; x += step_x)
        for (int y = 0; y < row.screen_height; y += step_y)
            pass.draws.emplace_back(rectangle({x, y, x + row.width, y + row.height}, 0xff203040));
    return frame;
}

}  // namespace

TEST_CASE("cost: the clears measured on a PlayStation 2", "[cost]") {
    // Those that draw colour and depth in one page are drawn with colour alone here.
    const ClearTiming rows[] = {
        {"one sprite", 640, 448, 448, true, 39972, 2240},
        {"a sprite a page", 64, 32, 448, true, 20248, 140},
        {"half of each page, the other half as depth", 32, 32, 448, false, 9200, 140},
        {"one sprite, half the height", 640, 224, 224, true, 19600, 1120},
        {"a sprite a page, half the height", 64, 32, 224, true, 10233, 70},
    };
    const ChipRates& rates = rates_of("ps2");
    for (const ClearTiming& row : rows) {
        INFO(row.name);
        const Frame frame                    = clear_frame(row);
        const std::vector<PassCounts> counts = execute(frame).counts;
        const FrameCost frame_cost           = cost(frame, counts, rates);
        CHECK(frame_cost.total.page_breaks == exactly(row.breaks));
        CHECK(clocks(frame_cost.total.ms.least, rates) == Approx(row.measured_clk).epsilon(0.15));
        CHECK(clocks(frame_cost.total.ms.most, rates) == Approx(row.measured_clk).epsilon(0.15));
        // A clock of rounding.
        CHECK(clocks(frame_cost.total.ms.least, rates) <= row.measured_clk + 1.0);
        CHECK(clocks(frame_cost.total.ms.most, rates) >= row.measured_clk - 1.0);
    }
}

TEST_CASE("cost: a clear lies between its fastest and its slowest way", "[cost]") {
    Frame frame            = small_frame(640, 448, TargetFormat::D24);
    frame.passes[0].clear  = {.color = Argb{0}, .depth = 1.0f};
    const FrameCost on_ps2 = cost(frame, execute(frame).counts, rates_of("ps2"));
    CHECK(on_ps2.total.page_breaks == Range{140, 2240});
    CHECK(clocks(on_ps2.total.ms.least, rates_of("ps2")) == Approx(20248).epsilon(0.01));
    CHECK(clocks(on_ps2.total.ms.most, rates_of("ps2")) == Approx(39972).epsilon(0.01));
    // Colour alone opens one page at a time.
    Frame color                  = frame;
    color.passes[0].clear.depth  = {};
    const FrameCost color_on_ps2 = cost(color, execute(color).counts, rates_of("ps2"));
    CHECK(color_on_ps2.total.ms.least < on_ps2.total.ms.least);
    CHECK(color_on_ps2.total.of(CostUnit::Fill) == on_ps2.total.of(CostUnit::Fill));
    // Both together: no more pixels than one of them; twice the bytes.
    const FrameCost on_xbox = cost(frame, execute(frame).counts, rates_of("xbox"));
    check_range(on_xbox.total.of(CostUnit::Fill), 286720 / 932e3, 286720 / 932e3);
    check_range(on_xbox.total.of(CostUnit::MainMemory), 286720 * 8 / 6.4e6, 286720 * 8 / 5.3e6);
}

TEST_CASE("cost: colour alone changes its page faster than colour and depth", "[cost]") {
    const PassCost alone = first_cost(frame_of_rectangle(640, 448), replaced(area_of(640, 448)), "ps2");
    CHECK(clocks(alone.ms.least, rates_of("ps2")) == Approx(17920 + 2240 * 1.7));
    CHECK(clocks(alone.ms.most, rates_of("ps2")) == Approx(17920 + 2240 * 9.85));
    Frame tested                 = frame_of_rectangle(640, 448, TargetFormat::D24);
    tested.passes[0].state.depth = {CompareFunc::GreaterEqual, false};
    const PassCost both          = cost(tested, execute(tested).counts, rates_of("ps2")).passes[0];
    CHECK(clocks(both.of(CostUnit::PageBreaks).least, rates_of("ps2")) == Approx(2240 * 9.5));
}

TEST_CASE("cost: after triangles a rectangle enters its page again", "[cost]") {
    Frame frame           = small_frame(64, 32);
    const Draw corner     = rectangle({0, 0, 8, 8}, 0xffffffff);
    frame.passes[0].draws = {corner, corner};
    const PassCounts two{.rectangles = 2, .covered = 128};
    CHECK(first_cost(frame, two, "ps2").page_breaks == exactly(1));
    // With a triangle of one fragment between them.
    frame.passes[0].draws = {corner, add_quad(frame, 0xffffffff), corner};
    const PassCounts with_one{.triangles_in = 2, .triangles_drawn = 1, .rectangles = 2, .covered = 128 + 1};
    const PageBreaks one = triangle_breaks(1, 1, {64, 32});
    CHECK(first_cost(frame, with_one, "ps2").page_breaks.least == Approx(2 + one.spans + one.entries));
}

TEST_CASE("cost: page breaks of rectangles", "[cost]") {
    const struct {
        const char* name;
        PixelRect rect;
        PageShape shape;
        PageBreaks expected;
    } rows[] = {
        {"nothing", {3, 3, 3, 9}, {64, 32}, {0, 0}},
        {"a pixel", {70, 40, 71, 41}, {64, 32}, {0, 1}},
        {"a page", {64, 32, 128, 64}, {64, 32}, {0, 1}},
        {"a column of pages", {0, 0, 64, 512}, {64, 32}, {0, 16}},
        {"and a pixel more", {0, 0, 65, 512}, {64, 32}, {2 * 256, 0}},
        {"640x512, jbit.net", {0, 0, 640, 512}, {64, 32}, {2560, 0}},
        {"16 bits", {0, 0, 64, 512}, {64, 64}, {0, 8}},
        {"half a row pair at each end", {60, 31, 68, 33}, {64, 32}, {2 * 2, 0}},
        {"left of the texture", {-64, -32, 0, 0}, {64, 32}, {0, 1}},
        {"on both sides of its corner", {-1, -1, 1, 1}, {64, 32}, {2 * 2, 0}},
    };
    for (const auto& row : rows) {
        INFO(row.name);
        std::optional<Page> last;
        CHECK(rectangle_breaks(row.rect, row_pairs(row.rect), row.shape, last) == row.expected);
    }
    // The page that the last rectangle ended in is not entered again.
    std::optional<Page> last;
    CHECK(rectangle_breaks({0, 0, 32, 32}, 16, {64, 32}, last) == PageBreaks{0, 1});
    CHECK(rectangle_breaks({32, 0, 64, 32}, 16, {64, 32}, last) == PageBreaks{0, 0});
    CHECK(rectangle_breaks({0, 32, 32, 64}, 16, {64, 32}, last) == PageBreaks{0, 1});
    CHECK(page_shape(4) == PageShape{64, 32});
    CHECK(page_shape(2) == PageShape{64, 64});
    CHECK(page_shape(1) == PageShape{128, 64});
    // 640x448 in strips of a page's width: 14 pages each.
    double in_strips = 0.0;
    last.reset();
    for (int x = 0; x < 640; x += 64) in_strips += rectangle_breaks({x, 0, x + 64, 448}, 224, {64, 32}, last).entries;
    CHECK(in_strips == 140.0);
}

TEST_CASE("cost: page breaks of triangles", "[cost]") {
    CHECK(triangle_breaks(0, 10, {64, 32}) == PageBreaks{0, 0});
    CHECK(triangle_breaks(100, 0, {64, 32}) == PageBreaks{0, 0});
    // Half of a square of 64: 32 row pairs of 32 pixels on average, c = 1/2.
    CHECK(triangle_breaks(2048, 1, {64, 32}) == PageBreaks{32, 1});
    CHECK(triangle_breaks(3 * 2048, 3, {64, 32}) == PageBreaks{96, 3});
    // Of 256: 128 row pairs of 128 pixels, c = 2.
    CHECK(triangle_breaks(32768, 1, {64, 32}) == PageBreaks{128 * 3, 0});
    // Small ones cross a page's side, and come back, as often in all as their pixels are long.
    for (const double count : {64.0, 256.0})
        CHECK(triangle_breaks(32768, count, {64, 32}).spans == Approx(32768.0 / 64.0));
    // Each may enter a page, or none.
    Frame frame           = small_frame(64, 32);
    frame.passes[0].draws = {add_quad(frame, 0xffffffff)};
    const PassCounts counts{.vertices        = 4,
                            .triangles_in    = 2,
                            .triangles_drawn = 2,
                            .covered         = 2048,
                            .depth_passed    = 2048,
                            .color_written   = 2048,
                            .bytes           = 8192};
    const Range breaks = first_cost(frame, counts, "ps2").page_breaks;
    CHECK(breaks.most - breaks.least == Approx(2.0));
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

TEST_CASE("cost: on the Graphics Synthesizer a frame's textures may have to be uploaded", "[cost]") {
    // ps2: 64 KB of 8 bit texels take 8,192 clocks or 56 us.
    Frame frame = frame_of_rectangle(64, 32);
    bind_textures(frame, 1, TextureFormat::L8, 256, 256, TextureFilter::Point);
    frame.passes.push_back(frame.passes[0]);
    const PassCounts counts = textured(2048, 1, TextureFormat::L8, 1);
    const FrameCost on_ps2  = cost(frame, {counts, counts}, rates_of("ps2"));
    check_range(on_ps2.passes[0].of(CostUnit::Upload), 0.0, 0.0555, 0.01);
    CHECK(on_ps2.passes[0].uploaded_bytes == Range{0, 65536});
    CHECK(on_ps2.passes[1].of(CostUnit::Upload) == Range{});  // once a frame
    CHECK(on_ps2.passes[0].ms.most == Approx(on_ps2.passes[1].ms.most + on_ps2.passes[0].of(CostUnit::Upload).most));
    CHECK(on_ps2.passes[0].ms.least == on_ps2.passes[1].ms.least);
    // 48 bytes without texture; 80 with one, 10 clocks.
    const Range plain = first_cost(frame_of_rectangle(64, 32), replaced(2048), "ps2").of(CostUnit::VertexUpload);
    CHECK(clocks(plain.most, rates_of("ps2")) == Approx(6).epsilon(0.01));
    CHECK(clocks(on_ps2.passes[0].of(CostUnit::VertexUpload).most, rates_of("ps2")) == Approx(10).epsilon(0.01));
    // The consoles with one memory upload nothing; how fast a card does is not known.
    CHECK(cost(frame, {counts, counts}, rates_of("xbox")).total.of(CostUnit::Upload) == Range{});
    CHECK(topics(cost(frame, {counts, counts}, rates_of("xbox"))) == std::vector<std::string_view>{"setup"});
    CHECK(topics(cost(frame, {counts, counts}, rates_of("dx7"))) == std::vector<std::string_view>{"setup", "upload"});
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

TEST_CASE("cost: frame and texture may change their pages together or one after the other", "[cost]") {
    Frame frame = frame_of_rectangle(640, 448);
    bind_textures(frame, 1, TextureFormat::A8R8G8B8, 640, 448, TextureFilter::Point);
    const PassCounts counts = textured(area_of(640, 448), 1, TextureFormat::A8R8G8B8, 1);
    CHECK(first_cost(frame, counts, "ps2").page_breaks == Range{2240, 4480});
    CHECK(first_cost(frame, counts, "xbox").page_breaks == Range{});
    // A texture of 8 bits within a page of its own does not change.
    Frame small = frame_of_rectangle(640, 448);
    bind_textures(small, 1, TextureFormat::L8, 128, 64, TextureFilter::Point);
    CHECK(first_cost(small, textured(area_of(640, 448), 1, TextureFormat::L8, 1), "ps2").page_breaks == exactly(2240));
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
