// SPDX-License-Identifier: MIT
// A chip is a table: one that does not exist is planned for, drawn for and priced like the four that do, by its table alone.
#include <algorithm>
#include <catch2/catch.hpp>

#include "demo/scene.h"
#include "pipeline/check/check.h"
#include "pipeline/check/memory_map.h"
#include "pipeline/cost/cost.h"
#include "pipeline/execute/execute.h"
#include "pipeline/legalize/legalize.h"
#include "pipeline/validate/validate.h"
#include "tests/support/image_match.h"

using namespace pipeline;

namespace {

// Pixels are sampled a quarter in, products are the TEV's, depth is reversed and has 16 bits, a mask tells colour from alpha
// alone, and nothing limits drawing but the viewport.
Profile made_up() {
    Profile chip;
    chip.name               = "made up";
    chip.chip               = "a chip that was never built";
    chip.arithmetic         = {.snap         = SnapRule::Truncate,
                               .pixel_center = 4,
                               .filter       = FilterRule::FlipperFloor7,
                               .combine      = CombineRule::Tev,
                               .fog          = FogRule::FlipperFloor256,
                               .blend        = BlendRule::FlipperTrunc256};
    chip.formats            = {.draw         = {TargetFormat::A8R8G8B8, TargetFormat::X8R8G8B8},
                               .copy_targets = {TargetFormat::A8R8G8B8},
                               .depth        = {TargetFormat::D24}};
    chip.states.depth_funcs = {CompareFunc::Never, CompareFunc::Always, CompareFunc::GreaterEqual,
                               CompareFunc::Greater};
    chip.states.color_mask  = MaskKind::ColorAndAlpha;
    chip.states.scissor     = false;
    chip.limits = {.texture_width = 1024, .texture_height = 1024, .memory = 16u << 20, .pitch_alignment = 32};
    return chip;
}

Frame canyon() {
    return demo::scene_frame(*demo::load_scene("canyon"), {160, 90}, 0);
}

}  // namespace

TEST_CASE("a chip that is made up gets a scene that it can draw, by its table alone", "[legalize]") {
    const Frame ideal      = canyon();
    const LegalFrame legal = legalize(ideal, made_up());
    CHECK(validate(legal.frame).empty());
    CHECK(legal.left.empty());
    CHECK(legal.frame.arithmetic == made_up().arithmetic);
    const auto was_rewritten = [&](std::string_view rewrite) {
        return std::any_of(legal.notes.begin(), legal.notes.end(),
                           [&](const RewriteNote& note) { return note.rewrite == rewrite; });
    };
    for (const char* rewrite : {"reversed_depth", "scissor", "pixel_center", "arithmetic"}) {
        CAPTURE(rewrite);
        CHECK(was_rewritten(rewrite));
    }
    for (const char* rewrite : {"stages", "gs_alpha", "copies"}) CHECK_FALSE(was_rewritten(rewrite));
    // Its sums are cut where the ideal's are rounded.
    const ColorImage want = execute(ideal).output, got = execute(legal.frame).output;
    REQUIRE(got.pixels.size() == want.pixels.size());
    const double mean = test_support::mean_difference(want, got);
    CHECK(mean > 0.0);
    CHECK(mean < 2.5);
}

TEST_CASE("what a made up chip lacks is found, its memory laid out, and its time counted", "[legalize]") {
    Profile chip           = made_up();
    chip.limits.memory     = 1u << 20;
    const LegalFrame legal = legalize(canyon(), chip);
    REQUIRE(legal.left.size() == 1);
    CHECK(legal.left[0].rule == "memory");
    const MemoryMap memory = lay_out(legal.frame, chip);
    REQUIRE(memory.regions.size() == 1);
    CHECK(memory.regions[0].over > 0);

    chip.states.stages = 0;
    CHECK(check(legal.frame, chip).size() > 1);

    ChipRates rates      = *find_rates("dx7");
    const auto counts    = execute(legal.frame).counts;
    const Range as_it_is = cost(legal.frame, counts, rates).total.ms;
    rates.clock.low /= 2.0;
    rates.clock.high /= 2.0;
    const Range at_half = cost(legal.frame, counts, rates).total.ms;
    CHECK(as_it_is.least > 0.0);
    CHECK(at_half.least > as_it_is.least);
}
