// SPDX-License-Identifier: MIT
// The comparison itself: what it allows, what it excuses, and that the rest fails. No OpenGL here; nimbus7_peers
// --mistakes shows the same of whole frames.
#include "tests/peers/compare.h"

#include <catch2/catch.hpp>

#include "tests/peers/known_differences.h"
#include "tests/peers/rounding.h"

namespace {

using namespace peers;
using pipeline::ColorImage;

ColorImage row(std::vector<std::uint32_t> pixels) {
    return {static_cast<int>(pixels.size()), 1, std::move(pixels)};
}

// The same units allowed everywhere, no edges, no slivers.
Limits limits(const ColorImage& ours, int allowed) {
    return {.by_rounding      = [=] { return std::vector(ours.pixels.size(), allowed); },
            .with_perspective = [=](int, int) { return allowed; },
            .envelope         = [=] { return Envelope(ours); },
            .of_nudged        = [=](int, int) { return allowed; },
            .at_edge          = [](int, int) { return 0; },
            .is_excused       = [](int, int) { return false; }};
}

pipeline::Pass triangles_pass() {
    pipeline::Pass pass;
    pass.draws = {pipeline::DrawTriangles{}};
    return pass;
}

pipeline::Pass blit_pass(pipeline::TextureFilter filter) {
    pipeline::Pass pass;
    pipeline::DrawRectangle blit;
    blit.textures[0].texture = {0};
    pass.draws               = {blit};
    auto& stage              = pass.state.stages[0];
    stage.color_op = stage.alpha_op = pipeline::TextureOp::SelectArg1;
    stage.filter                    = filter;
    return pass;
}

}  // namespace

TEST_CASE("equal pictures ask for no limits", "[peers]") {
    const ColorImage picture = row({0, 0xffffffff});
    const Comparison result  = compare(picture, picture, {});
    CHECK(result.pixels == 2);
    CHECK(result.differing == 0);
    CHECK(result.failed == 0);
}

TEST_CASE("a difference is allowed up to the limit and fails beyond, in any channel", "[peers]") {
    const int shift          = GENERATE(0, 8, 16, 24);
    const ColorImage ours    = row({0x80808080, 0x80808080, 0x80808080});
    const ColorImage theirs  = row({0x80808080, 0x80808080 + (2u << shift), 0x80808080 - (3u << shift)});
    const Comparison allowed = compare(ours, theirs, limits(ours, 3));
    CHECK(allowed.differing == 2);
    CHECK(allowed.failed == 0);
    CHECK(allowed.worst.units == 3);
    CHECK(allowed.worst.x == 2);
    CHECK(allowed.mean() == Approx(-1.0 / 12));
    const Comparison refused = compare(ours, theirs, limits(ours, 2));
    CHECK(refused.failed == 1);
    CHECK(refused.worst.peers == theirs.pixels[2]);
}

TEST_CASE("the worst is a failed pixel, if there is one, however small", "[peers]") {
    const ColorImage ours = row({0, 0}), theirs = row({9, 1});
    Limits both             = limits(ours, 9);
    both.by_rounding        = [] { return std::vector{9, 0}; };
    both.with_perspective   = [](int, int) { return 0; };
    const Comparison result = compare(ours, theirs, both);
    CHECK(result.failed == 1);
    CHECK(result.worst.x == 1);
}

TEST_CASE("an edge pixel lies within what nudges show, widened by what is allowed", "[peers]") {
    const ColorImage ours = row({0x10, 0x10, 0x10}), nudged = row({0x10, 0x40, 0x40});
    Limits with_edges   = limits(ours, 1);
    with_edges.envelope = [=] {
        Envelope envelope(ours);
        envelope.include(nudged);
        return envelope;
    };
    const Comparison result = compare(ours, row({0x13, 0x41, 0x42}), with_edges);
    CHECK(result.differing == 3);
    CHECK(result.edge == 1);
    CHECK(result.failed == 2);
    // Edge pixels do not count in the mean.
    CHECK(result.mean() == Approx((0x03 + 0x32) / 8.0));
}

TEST_CASE("what only a nudge shows has limits of its own, where nudges change the picture", "[peers]") {
    // No fragment of ours is near, so that nothing is allowed by rounding.
    const ColorImage ours = row({0x10, 0x10, 0x10, 0x10}), nudged = row({0x40, 0x40, 0x40, 0x10});
    Limits with_edges    = limits(ours, 0);
    with_edges.of_nudged = [](int x, int) { return x == 2 ? 5 : 1; };
    with_edges.envelope  = [=] {
        Envelope envelope(ours);
        envelope.include(nudged);
        return envelope;
    };
    CHECK(compare(ours, row({0x41, 0x0f, 0x45, 0x10}), with_edges).edge == 3);
    CHECK(compare(ours, row({0x42, 0x0e, 0x46, 0x11}), with_edges).failed == 4);
}

TEST_CASE("a sliver excuses any value, but only where it is", "[peers]") {
    const ColorImage ours   = row({0, 0});
    Limits with_sliver      = limits(ours, 0);
    with_sliver.is_excused  = [](int x, int) { return x == 1; };
    const Comparison result = compare(ours, row({0xff, 0xff}), with_sliver);
    CHECK(result.edge == 1);
    CHECK(result.failed == 1);
}

TEST_CASE("at an edge roundings are enough, elsewhere not", "[peers]") {
    const ColorImage ours = row({0x10, 0x10, 0x10});
    Limits at_edges       = limits(ours, 0);
    at_edges.at_edge      = [](int x, int) { return x == 1 ? 0 : 2; };

    const Comparison result = compare(ours, row({0x12, 0x12, 0x13}), at_edges);
    CHECK(result.edge == 1);
    CHECK(result.failed == 2);
}

TEST_CASE("sums of comparisons keep the worst that failed", "[peers]") {
    const ColorImage ours = row({0});
    Comparison sum;
    sum.add(compare(ours, row({5}), limits(ours, 5)));
    sum.add(compare(ours, row({2}), limits(ours, 1)));
    sum.add(compare(ours, row({4}), limits(ours, 4)));
    CHECK(sum.pixels == 3);
    CHECK(sum.failed == 1);
    CHECK(sum.worst.units == 2);
}

TEST_CASE("roundings are counted, not guessed", "[peers]") {
    const auto allowed = [](const pipeline::Pass& pass, int layers) {
        return allowed_difference(pass, fragment_error(pass), layers);
    };
    SECTION("a copy is exact") {
        CHECK(allowed(blit_pass(pipeline::TextureFilter::Point), 1) == 0);
    }
    SECTION("a filter rounds once") {
        CHECK(allowed(blit_pass(pipeline::TextureFilter::Linear), 1) == 1);
    }
    SECTION("nothing drawn, nothing allowed") {
        CHECK(allowed(blit_pass(pipeline::TextureFilter::Linear), 0) == 0);
    }
    SECTION("without a blend only the last layer counts") {
        CHECK(allowed(triangles_pass(), 1) == 1);
        CHECK(allowed(triangles_pass(), 100) == 1);
    }
    SECTION("each blend adds its own") {
        pipeline::Pass pass = blit_pass(pipeline::TextureFilter::Point);
        pass.state.blend    = {.source = pipeline::BlendFactor::One, .dest = pipeline::BlendFactor::One};
        CHECK(allowed(pass, 1) == 1);
        CHECK(allowed(pass, 7) == 7);
    }
    SECTION("a factor of four makes an error four times as large") {
        pipeline::Pass pass                    = blit_pass(pipeline::TextureFilter::Linear);
        pass.state.stages[0].color_op          = pipeline::TextureOp::Modulate4X;
        pass.state.stages[0].color_arg2.source = pipeline::ArgSource::TFactor;
        CHECK(allowed(pass, 1) == 3);
    }
}

TEST_CASE("known differences are read, and become stale", "[peers]") {
    const auto list =
        parse_known_differences("# a comment\n\ncanyon softpipe 40 30  its own level of detail\n", "x.txt");
    REQUIRE(list.size() == 1);
    CHECK(list[0].frame == "canyon");
    CHECK(list[0].driver == "softpipe");
    CHECK(list[0].pixels == 40);
    CHECK(list[0].units == 30);
    CHECK(list[0].reason == "its own level of detail");
    CHECK_THROWS_WITH(parse_known_differences("\ncanyon softpipe 40 30\n", "x.txt"), Catch::StartsWith("x.txt:2: "));
    CHECK_THROWS(parse_known_differences("canyon softpipe many 30 why\n", "x.txt"));

    Comparison within{.pixels = 100, .differing = 40, .failed = 40};
    within.worst.units = 30;
    Comparison more    = within;
    more.failed        = 41;
    Comparison worse   = within;
    worse.worst.units  = 31;
    CHECK(judge(within, &list[0]) == Verdict::Known);
    CHECK(judge(more, &list[0]) == Verdict::Failed);
    CHECK(judge(worse, &list[0]) == Verdict::Failed);
    CHECK(judge(within, nullptr) == Verdict::Failed);
    CHECK(judge({.pixels = 100}, &list[0]) == Verdict::Stale);
    CHECK(judge({.pixels = 100}, nullptr) == Verdict::Ok);
}

TEST_CASE("differences that lean to one side, or that are edges in number, are suspect", "[peers]") {
    CHECK_FALSE(is_suspect({.pixels = 10000, .sum = 2000.0}));  // 0.05 of 40000 channels
    CHECK(is_suspect({.pixels = 10000, .sum = 2001.0}));
    CHECK(is_suspect({.pixels = 10000, .sum = -2001.0}));
    CHECK_FALSE(is_suspect({.pixels = 9999, .sum = 39996.0}));  // too small to tell
    CHECK_FALSE(is_suspect({.pixels = 10000, .sum = -4000.0, .explained_mean = 0.05}));
    CHECK(is_suspect({.pixels = 10000, .sum = -4001.0, .explained_mean = 0.05}));
    CHECK_FALSE(is_suspect({.pixels = 10000, .edge = 33}));  // 20 + 3 * 4.47
    CHECK(is_suspect({.pixels = 10000, .edge = 34}));
    CHECK(is_suspect({.pixels = 1000000, .edge = 2135}));
}
