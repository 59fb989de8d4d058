// SPDX-License-Identifier: MIT
// Copies from one channel to another in frames.
#include "pipeline/frame/frame_text.h"
#include "pipeline/validate/validate.h"
#include "tests/support/random.h"
#include "tests/support/random_frame.h"
#include "tests/support/small_frame.h"

using namespace pipeline;
using namespace test_support;

namespace {

// Target 1 is 0x12345678 at pixel (1, 0) of 2x1 and zeros else; it is copied to the picture.
Frame copied_frame(CopyChannels channels, std::optional<std::uint32_t> clear,
                   TargetFormat format = TargetFormat::A8R8G8B8) {
    Frame frame             = small_frame(2, 1);
    frame.targets[0].format = format;
    frame.targets.push_back({.name = "from", .width = 2, .height = 1});
    frame.passes[0].color = {1};
    frame.passes[0].draws = {rectangle({1, 0, 2, 1}, 0x12345678)};
    Pass& pass            = frame.passes.emplace_back();
    pass.color            = {0};
    if (clear) pass.clear.color = Argb{*clear};
    pass.draws = {CopyRectangle{.source = {1}, .from = {0, 0, 2, 1}, .channels = channels}};
    return frame;
}
using Pixels = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("each kind of copy moves its channels and leaves the others", "[execute]") {
    CHECK(pixels_on_both(copied_frame(CopyChannels::All, 0x9abcdef0)) == Pixels{0, 0x12345678});
    CHECK(pixels_on_both(copied_frame(CopyChannels::AlphaToColor, 0x9abcdef0)) == Pixels{0x9a000000, 0x9a121212});
    CHECK(pixels_on_both(copied_frame(CopyChannels::GreenToAlpha, 0x9abcdef0)) == Pixels{0x00bcdef0, 0x56bcdef0});
}

TEST_CASE("a copy of some channels leaves the zeros that a target starts with in the others", "[execute]") {
    CHECK(pixels_on_both(copied_frame(CopyChannels::AlphaToColor, {})) == Pixels{0, 0x00121212});
    CHECK(pixels_on_both(copied_frame(CopyChannels::GreenToAlpha, {})) == Pixels{0, 0x56000000});
    CHECK(pixels_on_both(copied_frame(CopyChannels::AlphaToColor, {}, TargetFormat::X8R8G8B8)) ==
          Pixels{0xff000000, 0xff121212});
    // An executor that has drawn before leaves nothing of that.
    Executor executor;
    draw(executor, copied_frame(CopyChannels::All, 0xffffffff));
    CHECK(draw(executor, copied_frame(CopyChannels::GreenToAlpha, {})).execution.output.pixels ==
          Pixels{0, 0x56000000});
}

TEST_CASE("a copy from a target that nothing has drawn to is of zeros", "[execute]") {
    Frame frame = copied_frame(CopyChannels::AlphaToColor, 0x9abcdef0);
    frame.passes.erase(frame.passes.begin());
    CHECK(pixels_on_both(frame) == Pixels{0x9a000000, 0x9a000000});
}

TEST_CASE("copies of one channel after another", "[execute]") {
    Frame frame                                            = copied_frame(CopyChannels::AlphaToColor, 0x9abcdef0);
    std::get<CopyRectangle>(frame.passes[1].draws[0]).from = {1, 0, 2, 1};
    frame.passes[1].draws.push_back(
        CopyRectangle{.source = {1}, .from = {1, 0, 2, 1}, .channels = CopyChannels::GreenToAlpha});
    const Drawn drawn = draw_on_both(frame);
    CHECK(drawn.execution.output.pixels == Pixels{0x56121212, 0x9abcdef0});
    CHECK(drawn.execution.counts[1].copies == 2);
    CHECK(drawn.execution.counts[1].color_written == 2);
}

TEST_CASE("copies between channels are not halved", "[validate]") {
    Frame frame             = copied_frame(CopyChannels::GreenToAlpha, {});
    frame.targets[1].height = 2;
    auto& copy              = std::get<CopyRectangle>(frame.passes[1].draws[0]);
    copy.from               = {0, 0, 2, 2};
    copy.halve              = true;
    CHECK(validate(frame).size() == 1);
    copy.channels = CopyChannels::All;
    CHECK(validate(frame).empty());
}

TEST_CASE("kernels and reference agree on random copies between channels", "[agreement]") {
    Random random(11);
    int copies = 0;
    for (std::uint32_t seed = 0; copies < 60; ++seed) {
        Frame frame  = random_frame(seed);
        bool changes = false;
        for (Pass& pass : frame.passes)
            for (Draw& draw : pass.draws)
                if (auto* copy = std::get_if<CopyRectangle>(&draw); copy != nullptr && !copy->halve) {
                    copy->channels = random.one_of({CopyChannels::AlphaToColor, CopyChannels::GreenToAlpha});
                    changes        = true;
                    ++copies;
                }
        if (!changes) continue;
        INFO("seed " << seed);
        CHECK(validate(frame).empty());
        CHECK(parse_frame(to_text(frame)) == frame);
        check_kernels(frame, draw_reference(frame), seed, 1);
    }
}
