// SPDX-License-Identifier: MIT
// The Graphics Synthesizer's pages, and what its memory has to be sent: by hand, and against clears that were timed on a
// PlayStation 2.

#include "pipeline/cost/page_breaks.h"

#include <algorithm>

#include "tests/support/cost_frames.h"

using namespace pipeline;
using namespace test_support;

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
