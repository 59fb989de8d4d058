// SPDX-License-Identifier: MIT
// What validate says of states that the frame's arithmetic has no rule for, and of copies.
#include "tests/support/small_frame.h"
#include "tests/support/validate_rules.h"

using namespace pipeline;
using test_support::check_rules, test_support::text_of;

namespace {

// Targets: 0 drawn to by pass 0, and copied from 1 by pass 1; 2 has 16 bits.
Frame ideal_frame() {
    Frame frame = test_support::small_frame(8, 8, TargetFormat::D16);
    frame.targets.push_back({.name = "large", .format = TargetFormat::R6G6B6A6, .width = 16, .height = 12});
    frame.targets.push_back({.name = "narrow", .format = TargetFormat::R5G6B5, .width = 8, .height = 8});
    frame.passes[0].draws = {test_support::rectangle({0, 0, 8, 8}, 0xffffffff)};
    Pass& copy            = frame.passes.emplace_back();
    copy.color            = {0};
    copy.draws            = {CopyRectangle{.source = {2}, .from = {0, 0, 12, 8}, .x = 2, .y = 4, .halve = true}};
    return frame;
}

Frame gs_frame() {
    Frame frame              = ideal_frame();
    frame.targets[0].format  = TargetFormat::Psmct16;
    frame.arithmetic.blend   = BlendRule::GsShift7;
    frame.arithmetic.combine = CombineRule::GsShift7;
    PipelineState& state     = frame.passes[0].state;
    state.gs_blend           = {.a = GsColor::Cs, .b = GsColor::Cd, .c = GsAlpha::As, .d = GsColor::Cd};
    state.dither             = {.mode = DitherMode::GsDimx, .matrix = {-4, 3}};
    state.stages[0]          = {.color_op = TextureOp::Modulate, .alpha_op = TextureOp::Add};
    state.alpha_test.fail    = AlphaFail::RgbOnly;
    state.dest_alpha_test    = DestAlphaTest::One;
    return frame;
}

CopyRectangle& copy(Frame& frame) {
    return std::get<CopyRectangle>(frame.passes[1].draws[0]);
}
PipelineState& state(Frame& frame) {
    return frame.passes[0].state;
}

}  // namespace

TEST_CASE("the frames that the rules of arithmetic are tried on are valid") {
    CHECK(text_of(validate(ideal_frame())).empty());
    CHECK(text_of(validate(gs_frame())).empty());
}

TEST_CASE("validate: states that the arithmetic has no rule for") {
    check_rules(
        &ideal_frame,
        {
            {"centre before the pixel",
             [](Frame& f) { f.arithmetic.pixel_center = -1; },
             {{"arithmetic: pixel_center", "must lie within 0..15 (got -1)"}}},
            {"centre in the next pixel",
             [](Frame& f) { f.arithmetic.pixel_center = 16; },
             {{"arithmetic: pixel_center", "must lie within 0..15 (got 16)"}}},
            {"no such rule",
             [](Frame& f) { f.arithmetic.fog = static_cast<FogRule>(4); },
             {{"arithmetic: fog", "must be one of NEAREST255 GS_FLOOR256 GS_TWO_FLOORS FLIPPER_FLOOR256 (got #4)"}}},
            {"the other blend",
             [](Frame& f) { state(f).gs_blend.fix = 1; },
             {{"pass 0: state.gs_blend", "must be left out unless arithmetic.blend is GS_SHIFT7 (got NEAREST255)"}}},
            {"the other dither",
             [](Frame& f) { state(f).dither.mode = DitherMode::GsDimx, f.targets[0].format = TargetFormat::R5G6B5; },
             {{"pass 0: state.dither.mode", "must fit arithmetic.blend NEAREST255 (got GS_DIMX)"}}},
            {"dither for no such rule",
             [](Frame& f) {
                 state(f).dither.mode = DitherMode::GsDimx;
                 f.targets[0].format  = TargetFormat::R5G6B5;
                 f.arithmetic.blend   = static_cast<BlendRule>(99);
             },
             {{"arithmetic: blend", "must be one of NEAREST255 GS_SHIFT7 FLIPPER_TRUNC256 (got #99)"},
              {"pass 0: state.dither.mode", "must fit arithmetic.blend ? (got GS_DIMX)"}}},
            {"dither of whole bytes",
             [](Frame& f) { state(f).dither.mode = DitherMode::Flipper2x2; },
             {{"pass 0: state.dither.mode", "must be NONE: the target keeps whole bytes (got FLIPPER_2X2)"}}},
            {"dither of no target",
             [](Frame& f) { f.passes[0].color = {}, state(f).dither.mode = DitherMode::Flipper2x2; },
             {{"pass 0: state.dither.mode", "must be NONE: the pass has no colour target (got FLIPPER_2X2)"}}},
            {"alpha of no target",
             [](Frame& f) { f.passes[0].color = {}, state(f).dest_alpha_test = DestAlphaTest::Zero; },
             {{"pass 0: state.dest_alpha_test", "must be OFF: the pass has no colour target (got ZERO)"}}},
        });
    check_rules(&gs_frame,
                {
                    {"the other blend",
                     [](Frame& f) { state(f).blend = kAlphaOver; },
                     {{"pass 0: state.blend", "must be left out with arithmetic.blend GS_SHIFT7: gs_blend says it"}}},
                    {"the other dither",
                     [](Frame& f) { state(f).dither.mode = DitherMode::Flipper2x2; },
                     {{"pass 0: state.dither.mode", "must fit arithmetic.blend GS_SHIFT7 (got FLIPPER_2X2)"}}},
                    {"offsets too large",
                     [](Frame& f) { state(f).dither.matrix[0] = -5, state(f).dither.matrix[15] = 4; },
                     {{"pass 0: state.dither.matrix[0]", "must lie within -4..3 (got -5)"},
                      {"pass 0: state.dither.matrix[15]", "must lie within -4..3 (got 4)"}}},
                    {"an op that it lacks, in colour",
                     [](Frame& f) { state(f).stages[0].color_op = TextureOp::Modulate2X; },
                     {{"pass 0: state.stages[0].color_op",
                       "must be an op that arithmetic.combine GS_SHIFT7 has (got MODULATE2X)"}}},
                    {"an op that it lacks, in alpha",
                     [](Frame& f) { state(f).stages[0].alpha_op = TextureOp::Subtract; },
                     {{"pass 0: state.stages[0].alpha_op",
                       "must be an op that arithmetic.combine GS_SHIFT7 has (got SUBTRACT)"}}},
                    {"a complement",
                     [](Frame& f) { state(f).stages[0].alpha_arg2.complement = true; },
                     {{"pass 0: state.stages[0].alpha_arg2.complement",
                       "must be false: arithmetic.combine GS_SHIFT7 has no complement"}}},
                    {"a second stage",
                     [](Frame& f) { state(f).stages[1] = state(f).stages[0]; },
                     {{"pass 0: state.stages[1].color_op",
                       "must be DISABLE: arithmetic.combine GS_SHIFT7 has one stage (got MODULATE)"}}},
                });
}

TEST_CASE("validate: copies") {
    const std::string draw = "pass 1: draws[0]";
    check_rules(&ideal_frame,
                {
                    {"nothing to copy from",
                     [](Frame& f) { copy(f).source = {}; },
                     {{draw + ".source", "must refer to a colour target"}}},
                    {"depth",
                     [](Frame& f) {
                         copy(f).source = {1}, copy(f).halve = false, copy(f).from = {0, 0, 2, 2};
                     },
                     {{draw + ".source", "must be a colour target (got D16)"}}},
                    {"itself",
                     [](Frame& f) {
                         copy(f).source = {0}, copy(f).from = {0, 0, 2, 2};
                     },
                     {{draw + ".source", "must not be the target that the pass draws to"}}},
                    {"nothing to copy to",
                     [](Frame& f) { f.passes[1].color = {}, f.passes[1].depth = {1}; },
                     {{draw, "must have a colour target to copy to: the pass names none"}}},
                    {"16 bits halved",
                     [](Frame& f) {
                         copy(f).source = {3}, copy(f).from = {0, 0, 4, 4};
                     },
                     {{draw + ".halve", "must be false for a source of this format (got R5G6B5)"}}},
                    {"odd corner",
                     [](Frame& f) { copy(f).from.x0 = 1; },
                     {{draw + ".from", "must have even corners to be halved"}}},
                    {"empty",
                     [](Frame& f) { copy(f).from.y1 = 0; },
                     {{draw + ".from", "must be a part of the source, and not empty"}}},
                    {"beyond the source",
                     [](Frame& f) { copy(f).from.x1 = 18; },
                     {{draw + ".from", "must be a part of the source, and not empty"}}},
                    {"beyond the target",
                     [](Frame& f) { copy(f).x = 3; },
                     {{draw, "must lie within the target that the pass draws to"}}},
                    {"before the target",
                     [](Frame& f) { copy(f).y = -1; },
                     {{draw, "must lie within the target that the pass draws to"}}},
                    {"a place that overflows",
                     [](Frame& f) { copy(f).x = 2147483647; },
                     {{draw, "must lie within the target that the pass draws to"}}},
                    {"a state",
                     [](Frame& f) { f.passes[1].state.depth.write = true; },
                     {{"pass 1: state.depth.write", "must be false: the pass has no depth target"},
                      {"pass 1: state", "must be left out but for viewport and scissor: copies know no state"}}},
                    {"draws besides",
                     [](Frame& f) { f.passes[1].draws.push_back(f.passes[0].draws[0]); },
                     {{"pass 1: draws", "must be copies all, or none of them"}}},
                });
}
