// SPDX-License-Identifier: MIT
// The executor as its callers see it: passes in order on their targets, observers, the output, what it refuses; and the
// memory behind a target.
#include "pipeline/execute/execute.h"

#include <algorithm>
#include <cstdint>

#include "pipeline/frame/frame_text.h"
#include "raster/image.h"
#include "tests/support/small_frame.h"

using namespace pipeline;
using namespace test_support;

namespace {

using Pixels = std::vector<std::uint32_t>;

constexpr Backend kBackends[] = {Backend::Kernels, Backend::Reference};

// Three targets of different sizes; the depth-only pass lets the pass after it through on the left.
Frame frame_of_passes() {
    return parse_frame(R"(nimbus7 frame 1
        output "middle"
        targets [
            "left" { width 2 height 1 }
            "middle" { width 3 height 1 }
            "depth" { format D16 width 3 height 1 }
            "unused" { width 1 height 1 }
        ]
        passes [
            "clear" { color "middle" clear { color 0x11111111 } }
            "depth only" {
                depth "depth"
                clear { depth 0.5 }
                state { depth { write true } }
                draws [rectangle { x1 1 y1 1 depth 1 }]
            }
            "colour only" { color "left" clear { color 0x22222222 } draws [rectangle { x1 1 y1 1 color 0x33333333 }] }
            "both" {
                color "middle"
                depth "depth"
                state { depth { func LESS } }
                draws [rectangle { x1 3 y1 1 depth 0.75 color 0x44444444 }]
            }
            "last" { color "left" draws [rectangle { x0 1 x1 2 y1 1 color 0x55555555 }] }
        ])");
}

}  // namespace

TEST_CASE("an observer sees each pass in order, with the pass's own target as it is then", "[execute]") {
    const Frame frame = frame_of_passes();
    const struct {
        const char* label;
        int width, height;
        Pixels pixels;
    } expected[] = {
        {"clear", 3, 1, {0x11111111, 0x11111111, 0x11111111}},
        {"depth only", 0, 0, {}},
        {"colour only", 2, 1, {0x33333333, 0x22222222}},
        {"both", 3, 1, {0x44444444, 0x11111111, 0x11111111}},
        {"last", 2, 1, {0x33333333, 0x55555555}},
    };
    for (const Backend backend : kBackends) {
        std::size_t calls = 0;
        std::vector<PassCounts> counts;
        const Execution execution = execute(frame, {.backend = backend}, [&](const FinishedPass& finished) {
            REQUIRE(calls < std::size(expected));
            const auto& want = expected[calls];
            INFO(want.label);
            CHECK(finished.index == calls++);
            CHECK(&finished.pass == &frame.passes[finished.index]);
            CHECK(finished.pass.label == want.label);
            const ColorImage color = finished.read_color();
            CHECK(color.width == want.width);
            CHECK(color.height == want.height);
            CHECK(color.pixels == want.pixels);
            CHECK(finished.read_color() == color);
            counts.push_back(finished.counts);
        });
        CHECK(calls == std::size(expected));
        CHECK(execution.counts == counts);
        CHECK(execution.output == ColorImage{3, 1, {0x44444444, 0x11111111, 0x11111111}});
    }
}

TEST_CASE("the output is the target that the frame names, drawn to last or never", "[execute]") {
    Frame frame = frame_of_passes();
    const struct {
        std::int32_t output;
        ColorImage expected;
    } rows[] = {
        {0, {2, 1, {0x33333333, 0x55555555}}},
        {1, {3, 1, {0x44444444, 0x11111111, 0x11111111}}},
        {3, {1, 1, {0}}},
    };
    for (const auto& row : rows) {
        INFO(row.output);
        frame.output = {row.output};
        CHECK(draw_on_both(frame).execution.output == row.expected);
    }
}

TEST_CASE("a frame without passes is its output, all zeros", "[execute]") {
    Frame frame = small_frame(3, 2);
    frame.passes.clear();
    for (const Backend backend : kBackends) {
        const Execution execution = execute(frame, {.backend = backend});
        CHECK(execution.output == ColorImage{3, 2, Pixels(6, 0)});
        CHECK(execution.counts.empty());
    }
}

TEST_CASE("a pass of depth alone takes its size from there", "[execute]") {
    Frame frame                       = small_frame(5, 3, TargetFormat::D32);
    frame.passes[0].color             = {};
    frame.passes[0].state.depth.write = true;
    frame.passes[0].draws             = {add_quad(frame, 0, 0.5f)};
    Pass shown                        = frame.passes[0];
    shown.color                       = {0};
    shown.state.depth                 = {CompareFunc::Equal, false};
    shown.draws                       = {rectangle({0, 0, 5, 3}, 0x77777777, 0.5f)};
    frame.passes.push_back(shown);
    CHECK(color_on_both(frame) == 0x77777777);
}

TEST_CASE("an invalid frame is refused with its first finding, before anything is drawn", "[execute]") {
    const struct {
        const char* name;
        void (*spoil)(Frame&);
        const char* what;
    } rows[] = {
        {"output", [](Frame& f) { f.output = {}; }, "frame: output must refer to a colour target"},
        {"target", [](Frame& f) { f.targets[3].width = 0; },
         "target 3 'unused': width must lie within 1..8192 (got 0)"},
        {"pass", [](Frame& f) { f.passes[4].state.depth.write = true; },
         "pass 4 'last': state.depth.write must be false: the pass has no depth target"},
        {"two findings",
         [](Frame& f) {
             f.passes[4].state.depth.write = true;
             f.passes[1].clear.depth       = 2.0f;
         },
         "pass 1 'depth only': clear.depth must lie within 0..1 (got 2)"},
        {"draw", [](Frame& f) { std::get<DrawRectangle>(f.passes[2].draws[0]).x0 = 3.0f; },
         "pass 2 'colour only': draws[0].x1 must be >= x0 (got 1)"},
    };
    for (const auto& row : rows)
        for (const Backend backend : kBackends) {
            INFO(row.name);
            Frame frame = frame_of_passes();
            row.spoil(frame);
            Executor executor;
            bool observed = false;
            std::string what;
            try {
                executor.execute(frame, {.backend = backend}, [&](const FinishedPass&) { observed = true; });
            } catch (const std::invalid_argument& error) {
                what = error.what();
            }
            CHECK(what == row.what);
            CHECK_FALSE(observed);
            // The executor is as good as new.
            CHECK(executor.execute(frame_of_passes(), {.backend = backend}).output ==
                  execute(frame_of_passes()).output);
        }
}

TEST_CASE("an instruction set that does not exist is refused", "[execute]") {
    const std::vector<std::string> targets = simd_targets();
    REQUIRE_FALSE(targets.empty());
    CHECK_THROWS_WITH(force_simd_target("MMX"),
                      Catch::StartsWith("unknown instruction set 'MMX' (this machine has " + targets[0]));
}

TEST_CASE("rows of an image start on a cache line and are never whole pages apart", "[execute]") {
    for (const int width : {1,    2,    15,   16,   17,   100,  640,  1008, 1009, 1023, 1024,
                            1025, 1040, 1920, 2040, 2048, 3072, 4096, 7168, 8191, 8192}) {
        INFO(width);
        constexpr int kHeight = 3;
        raster::Image image(width, kHeight);
        CHECK(image.width() == width);
        CHECK(image.height() == kHeight);
        CHECK(image.bounds() == raster::Rect{0, 0, width, kHeight});
        CHECK(image.stride() >= width);
        CHECK(image.stride() % raster::kBlockWidth == 0);
        CHECK(image.stride() * 4 % 4096 != 0);
        bool all_zero = true, aligned = true;
        for (int y = 0; y < kHeight; ++y) {
            aligned = aligned && reinterpret_cast<std::uintptr_t>(image.row(y)) % 64 == 0;
            CHECK(image.row(y) - image.row(0) == y * image.stride());
            for (int x = 0; x < width; ++x) all_zero = all_zero && image.row(y)[x] == 0;
        }
        CHECK(aligned);
        CHECK(all_zero);
        for (int y = 0; y < kHeight; ++y)  // the padding as well
            CHECK(std::count(image.row(y), image.row(y) + image.stride(), 0u) == image.stride());
    }
}
