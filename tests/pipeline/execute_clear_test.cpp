// SPDX-License-Identifier: MIT
// What a pass starts from: clears, which nothing limits but viewport and scissor, and depth as each format holds it.
#include "tests/support/random.h"
#include "tests/support/small_frame.h"

using namespace pipeline;
using namespace test_support;

namespace {

// The output as letters: one for each pixel, '.' for black, '#' for the colour asked for.
std::vector<std::string> picture(const ColorImage& image, std::uint32_t color) {
    std::vector<std::string> rows;
    for (int y = 0; y < image.height; ++y) {
        std::string& row = rows.emplace_back();
        for (int x = 0; x < image.width; ++x) {
            const std::uint32_t pixel = image.pixels[static_cast<std::size_t>(y * image.width + x)];
            row += pixel == color ? '#' : pixel == 0 ? '.' : '?';
        }
    }
    return rows;
}

using Rows = std::vector<std::string>;

const PixelRect kViewport{1, 1, 6, 5}, kScissor{3, 0, 8, 4};
const Rows kBoth     = {"........", "...###..", "...###..", "...###..", "........", "........"};
const Rows kViewed   = {"........", ".#####..", ".#####..", ".#####..", ".#####..", "........"};
const Rows kScissors = {"...#####", "...#####", "...#####", "...#####", "........", "........"};
const Rows kAll      = Rows(6, "########");
const Rows kNothing  = Rows(6, "........");

const struct Limits {
    const char* name;
    PixelRect viewport, scissor;
    Rows expected;
} kLimits[] = {
    {"no limits", {}, {}, kAll},
    {"viewport", kViewport, {}, kViewed},
    {"scissor", {}, kScissor, kScissors},
    {"both", kViewport, kScissor, kBoth},
    {"apart", {0, 0, 3, 6}, {3, 0, 8, 6}, kNothing},
};

// Everything that could hold a fragment back.
PipelineState adverse_state(bool has_depth) {
    PipelineState state;
    state.blend      = {BlendFactor::Zero, BlendFactor::One};
    state.color_mask = {false, false, false, false};
    state.alpha_test = {CompareFunc::Greater, 255};
    if (has_depth) state.depth.func = CompareFunc::Greater;
    return state;
}

// Draws with depth EQUAL over the whole target, as a rectangle or as triangles, in a pass of its own.
void add_equal_pass(Frame& frame, float depth, bool as_triangles, std::uint32_t color) {
    Pass pass             = frame.passes[0];
    pass.clear            = {};
    pass.state            = {};
    pass.state.depth.func = CompareFunc::Equal;
    const Target& target  = frame.targets[0];
    if (as_triangles)
        pass.draws = {add_quad(frame, color, depth)};
    else
        pass.draws = {rectangle({0, 0, target.width, target.height}, color, depth)};
    frame.passes.push_back(pass);
}

}  // namespace

TEST_CASE("a colour clear is limited by viewport and scissor, and by nothing else", "[execute]") {
    for (const Limits& limits : kLimits) {
        INFO(limits.name);
        Frame frame         = small_frame(8, 6, TargetFormat::D24);
        Pass& pass          = frame.passes[0];
        pass.clear.color    = Argb{0x12345678};
        pass.state          = adverse_state(true);
        pass.state.viewport = limits.viewport;
        pass.state.scissor  = limits.scissor;
        CHECK(picture(draw_on_both(frame).execution.output, 0x12345678) == limits.expected);
    }
}

TEST_CASE("a depth clear has the same limits", "[execute]") {
    for (const Limits& limits : kLimits)
        for (const bool is_depth_only : {false, true}) {
            INFO(limits.name << (is_depth_only ? ", depth only" : ""));
            Frame frame      = small_frame(8, 6, TargetFormat::D24);
            Pass& pass       = frame.passes[0];
            pass.clear.depth = 0.75f;
            pass.state       = adverse_state(true);
            add_equal_pass(frame, 0.75f, false, 0x12345678);
            frame.passes[0].state.viewport = limits.viewport;
            frame.passes[0].state.scissor  = limits.scissor;
            if (is_depth_only) frame.passes[0].color = {};
            CHECK(picture(draw_on_both(frame).execution.output, 0x12345678) == limits.expected);
        }
}

TEST_CASE("draws have the same limits", "[execute]") {
    for (const Limits& limits : kLimits) {
        INFO(limits.name);
        Frame frame         = small_frame(8, 6);
        Pass& pass          = frame.passes[0];
        pass.state.viewport = limits.viewport;
        pass.state.scissor  = limits.scissor;
        pass.draws          = {rectangle({-3, -3, 20, 20}, 0x12345678)};
        CHECK(picture(draw_on_both(frame).execution.output, 0x12345678) == limits.expected);
        pass.draws = {add_quad(frame, 0x12345678)};
        CHECK(picture(draw_on_both(frame).execution.output, 0x12345678) == limits.expected);
    }
}

TEST_CASE("a clear comes before the draws of its pass, and each value is set by itself", "[execute]") {
    Frame frame = small_frame(2, 1, TargetFormat::D24);
    Pass& pass  = frame.passes[0];
    pass.clear  = {.color = Argb{0x00ff00ff}, .depth = 0.5f};
    pass.draws  = {rectangle({1, 0, 2, 1}, 0x80808080)};
    CHECK(pixels_on_both(frame) == std::vector<std::uint32_t>{0x00ff00ff, 0x80808080});

    // The colour stays while depth is cleared, and the other way around.
    Pass other   = pass;
    other.draws  = {};
    other.clear  = {.color = {}, .depth = 0.25f};
    frame.passes = {pass, other};
    CHECK(pixels_on_both(frame) == std::vector<std::uint32_t>{0x00ff00ff, 0x80808080});
    frame.passes[1].clear = {.color = Argb{0}, .depth = {}};
    add_equal_pass(frame, 0.5f, false, 0xffffffff);
    CHECK(color_on_both(frame) == 0xffffffff);
}

TEST_CASE("what is drawn at the depth of the clear is equal to it, in each format", "[execute]") {
    std::vector<float> depths = {0.0f, 1.0f, 0.1f, 0.7f, 0.5f, 0.25f, 0x1p-30f, 0x1p-20f, 1.0f - 0x1p-24f, 1.0f / 3.0f};
    Random random(7);
    for (int i = 0; i < 100; ++i) depths.push_back(random.real(0.0f, 1.0f));
    for (const TargetFormat format : {TargetFormat::D16, TargetFormat::D24, TargetFormat::D32})
        for (const float depth : depths)
            for (const bool as_triangles : {false, true}) {
                INFO(enum_name(format) << ' ' << depth << (as_triangles ? ", triangles" : ", rectangle"));
                Frame frame                 = small_frame(3, 2, format);
                frame.passes[0].clear.depth = depth;
                add_equal_pass(frame, depth, as_triangles, 0xffffffff);
                CHECK(color_on_both(frame) == 0xffffffff);
            }
}

TEST_CASE("each depth format tells apart what its bits can, cleared or drawn", "[execute]") {
    // 0.25 is 2^(n-2) units of a format of n bits, so the second depth is that many units further on.
    const struct {
        TargetFormat format;
        float units_apart[3];
        bool equal[3];
    } rows[] = {
        {TargetFormat::D16, {0x1.8p-16f, 0x1p-17f, 0x1p-25f}, {false, true, true}},
        {TargetFormat::D24, {0x1p-17f, 0x1.8p-24f, 0x1p-25f}, {false, false, true}},
        {TargetFormat::D32, {0x1p-17f, 0x1.8p-24f, 0x1p-25f}, {false, false, false}},
    };
    for (const auto& row : rows)
        for (const int i : {0, 1, 2})
            for (const bool is_cleared : {true, false}) {
                INFO(enum_name(row.format) << ' ' << row.units_apart[i] << (is_cleared ? ", cleared" : ", drawn"));
                Frame frame = small_frame(3, 2, row.format);
                Pass& pass  = frame.passes[0];
                if (is_cleared) {
                    pass.clear.depth = 0.25f;
                } else {
                    pass.state.depth.write = true;
                    pass.draws             = {rectangle({0, 0, 3, 2}, 0, 0.25f)};
                }
                add_equal_pass(frame, 0.25f + row.units_apart[i], false, 0xffffffff);
                CHECK(color_on_both(frame) == (row.equal[i] ? 0xffffffff : 0));
            }
}

TEST_CASE("targets are all zeros at first, also for an executor that has drawn before", "[execute]") {
    Frame used                  = small_frame(5, 3, TargetFormat::D32);
    used.passes[0].clear        = {.color = Argb{0xffffffff}, .depth = 1.0f};
    Frame fresh                 = small_frame(5, 3, TargetFormat::D32);
    fresh.passes[0].state.depth = {CompareFunc::Equal, true};
    fresh.passes[0].draws       = {rectangle({0, 0, 2, 3}, 0x11111111, 0.0f)};
    const Rows expected         = Rows(3, "##...");
    for (const Backend backend : {Backend::Kernels, Backend::Reference}) {
        Executor executor;
        CHECK(picture(executor.execute(fresh, {.backend = backend}).output, 0x11111111) == expected);
        executor.execute(used, {.backend = backend});
        CHECK(picture(executor.execute(fresh, {.backend = backend}).output, 0x11111111) == expected);
    }
}
