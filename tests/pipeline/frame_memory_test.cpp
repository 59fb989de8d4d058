// SPDX-License-Identifier: MIT
// A frame takes memory for what its passes use, and for nothing else.
#include "pipeline/execute/frame_memory.h"

#include <catch2/catch.hpp>

#include "tests/support/small_frame.h"

using namespace pipeline;
using namespace test_support;

namespace {

std::size_t bytes_of(const Frame& frame) {
    FrameMemory memory;
    memory.prepare(frame, &raster::stored);
    return memory.bytes();
}

// Rows of whole blocks of pixels, not of a page.
std::size_t target_bytes(int width, int height) {
    return 4 * static_cast<std::size_t>(raster::Image(width, height).stride() * height);
}

struct TwoPasses {
    Frame frame = small_frame(100, 40, TargetFormat::D24);
    Pass& pass() { return frame.passes[0]; }
    TwoPasses() { pass().draws = {rectangle({0, 0, 100, 40}, 0xff102030)}; }
};

}  // namespace

TEST_CASE("targets have memory if a pass uses them", "[execute]") {
    const std::size_t one = target_bytes(100, 40);
    CHECK(one >= 4u * 100 * 40);
    CHECK(one < 2u * 4 * 100 * 40);
    TwoPasses two;
    Frame& frame = two.frame;
    CHECK(bytes_of(frame) == one);  // there is a depth target, which nothing tests

    frame.targets.push_back({.name = "other", .width = 300, .height = 7});
    CHECK(bytes_of(frame) == one);

    SECTION("a depth target that is tested, written or cleared") {
        two.pass().state.depth.func = CompareFunc::LessEqual;
        CHECK(bytes_of(frame) == 2 * one);
        two.pass().state.depth = {.func = CompareFunc::Always, .write = true};
        CHECK(bytes_of(frame) == 2 * one);
        two.pass().state.depth = {};
        two.pass().clear.depth = 1.0f;
        CHECK(bytes_of(frame) == 2 * one);
    }
    SECTION("a colour target that is drawn to, read, copied from or the picture") {
        Pass& pass = frame.passes.emplace_back();
        pass.color = {2};
        CHECK(bytes_of(frame) == one);
        pass.draws = {rectangle({0, 0, 9, 7}, 0xffffffff)};
        CHECK(bytes_of(frame) == one + target_bytes(300, 7));
        frame.passes.pop_back();
        frame.output = {2};
        CHECK(bytes_of(frame) == one + target_bytes(300, 7));
        frame.output                                                    = {0};
        std::get<DrawRectangle>(two.pass().draws[0]).textures[0].target = {2};
        CHECK(bytes_of(frame) == one);  // no stage reads it
        two.pass().state.stages[0] = {.color_op = TextureOp::SelectArg1, .alpha_op = TextureOp::SelectArg1};
        CHECK(bytes_of(frame) == one + target_bytes(300, 7));
        two.pass().state.stages[0] = {};
        two.pass().draws           = {CopyRectangle{.source = {2}, .from = {0, 0, 9, 7}}};
        CHECK(bytes_of(frame) == one + target_bytes(300, 7));
    }
    SECTION("another frame takes over what it can use and gives back the rest") {
        FrameMemory memory;
        two.pass().state.depth.func = CompareFunc::LessEqual;
        memory.prepare(frame, &raster::stored);
        CHECK(memory.bytes() == 2 * one);
        two.pass().state.depth.func = CompareFunc::Always;
        memory.prepare(frame, &raster::stored);
        CHECK(memory.bytes() == one);
    }
}

TEST_CASE("what is not there is drawn as if it were", "[execute]") {
    TwoPasses two;
    two.frame.targets.push_back({.name = "other", .format = TargetFormat::Psmct24, .width = 300, .height = 7});
    Pass& pass = two.frame.passes.emplace_back();
    pass.color = {2};  // does nothing
    std::vector<ColorImage> seen;
    execute(two.frame, {}, [&](const FinishedPass& finished) { seen.push_back(finished.read_color()); });
    REQUIRE(seen.size() == 2);
    CHECK(seen[0] == ColorImage{100, 40, std::vector<std::uint32_t>(100 * 40, 0xff102030)});
    CHECK(seen[1] == ColorImage{300, 7, std::vector<std::uint32_t>(300 * 7, 0x80000000)});

    // A pass whose only target is a depth buffer that it leaves alone.
    Frame frame           = small_frame(10, 10, TargetFormat::D24);
    frame.passes[0].color = {};
    frame.passes[0].draws = {rectangle({0, 0, 10, 10}, 0xff102030)};
    const Execution drawn = execute(frame);
    CHECK(drawn.counts[0].covered == 100);
    CHECK(drawn.output.pixels == std::vector<std::uint32_t>(100, 0));
}

TEST_CASE("textures have memory of their own if a pass reads them in another form", "[execute]") {
    TwoPasses two;
    Frame& frame             = two.frame;
    DrawRectangle& rectangle = std::get<DrawRectangle>(two.pass().draws[0]);
    const std::size_t target = target_bytes(100, 40);
    const TextureId colors   = add_texture(frame, TextureFormat::A8R8G8B8, 2, 2, std::vector<std::uint8_t>(16, 9)),
                    alphas   = add_texture(frame, TextureFormat::A8, 64, 32, std::vector<std::uint8_t>(64 * 32, 9));
    const std::size_t source = 64 * 32, expanded = source + 4 * 64 * 32, quads = source + 4 * 65 * 33;

    rectangle.textures[0].texture = alphas;
    CHECK(bytes_of(frame) == target);  // no stage reads it
    TextureStage& stage = two.pass().state.stages[0];
    stage               = {.color_op = TextureOp::SelectArg1, .alpha_op = TextureOp::SelectArg1};
    CHECK(bytes_of(frame) == target + expanded);
    stage.filter = TextureFilter::Linear;
    CHECK(bytes_of(frame) == target + expanded);
    stage.address_u = stage.address_v = TextureAddress::Clamp;
    CHECK(bytes_of(frame) == target + quads);
    Frame both = frame;
    both.passes.push_back(both.passes[0]);
    both.passes[1].state.stages[0].filter = TextureFilter::Point;
    CHECK(bytes_of(both) == target + expanded + quads - source);

    FrameMemory memory;
    memory.prepare(frame, &raster::stored);
    stage.filter = TextureFilter::Point;
    memory.prepare(frame, &raster::stored);
    CHECK(memory.bytes() == target + expanded);
    stage.filter = TextureFilter::Linear;
    memory.prepare(frame, &raster::stored);
    CHECK(memory.bytes() == target + quads);
    rectangle.textures[0].texture = colors;
    memory.prepare(frame, &raster::stored);
    CHECK(memory.bytes() == target);  // as the frame has it
}
