// SPDX-License-Identifier: MIT
// By hand: which pixels the frames of demo/frames cover, and which fragments pass their tests.
#include "tests/demo/frame_answers.h"

namespace demo {
namespace {

constexpr std::uint32_t kBlack = 0xff000000, kWhite = 0xffffffff, kRed = 0xffff0000, kGreen = 0xff00ff00,
                        kBlue = 0xff0000ff;

}  // namespace

TEST_CASE("frames by hand: rules of coverage") {
    for (const FrameAnswer& answer : {
             FrameAnswer{"triangle_top_left",
                         {{0, 0, {kRed, kRed, kRed, kRed, kRed, kBlack}},
                          {0, 2, {kBlue, kBlue, kRed, kRed, kRed, kBlack}},
                          {0, 4, {kBlue, kBlue, kBlue, kBlue, kRed, kBlack}},
                          {0, 5, {kBlack, kBlack, kBlack, kBlack, kBlack, kBlack}}},
                         {{kRed, 15}, {kBlue, 10}, {kBlack, 39}}},
             FrameAnswer{"shared_diagonal",
                         {{1, 2, {kBlack, 0xff404040}}, {11, 11, {0xff404040, kBlack}}},
                         {{0xff404040, 100}, {kBlack, 156}}},
             FrameAnswer{"shared_fan", {{0, 1, {kBlack}}, {15, 14, {kBlack}}}, {{kBlack, 60}}},
             FrameAnswer{"shared_strip",
                         {{1, 3, {kBlack, 0xff404040}}, {13, 12, {0xff404040, kBlack}}},
                         {{0xff404040, 120}, {kBlack, 136}}},
             FrameAnswer{"sliver_triangles",
                         {{0, 1, {kRed, kRed}}, {15, 1, {kRed}}, {6, 5, {kBlack, kBlue, kBlack}}},
                         {{kRed, 16}, {kGreen, 0}, {kBlue, 1}, {kBlack, 111}}},
             FrameAnswer{"corners_on_pixel_centers",
                         {{0, 0, {kRed, kRed, kBlack}},
                          {0, 1, {kRed, kBlack}},
                          {4, 0, {kGreen, kGreen, kBlack}},
                          {4, 1, {kBlack, kGreen}},
                          {0, 5, {kBlue, kBlack}},
                          {4, 5, {kBlack, kWhite, kBlack}}},
                         {{kRed, 3}, {kGreen, 3}, {kBlue, 1}, {kWhite, 1}, {kBlack, 56}}},
             FrameAnswer{
                 "degenerate_triangles", {{4, 4, {kWhite, kWhite, kBlack}}, {4, 5, {kWhite, kBlack}}}, {{kBlack, 61}}},
             FrameAnswer{"cull_modes", {}, {{kRed, 12}, {kBlue, 12}, {kBlack, 104}}},
             FrameAnswer{"rectangle_fractions",
                         {{5, 1, {kBlue, kBlack}}, {2, 4, {kGreen, kWhite, kWhite, kBlack}}},
                         {{kRed, 9}, {kBlue, 1}, {kGreen, 6}, {kWhite, 4}, {kBlack, 44}}},
             FrameAnswer{"subpixel_steps",
                         {{1, 8, {kBlack, kWhite, kWhite, kBlack}},
                          {9, 8, {kBlack, kWhite, kWhite, kBlack}},
                          {2, 9, {kBlack, kWhite, kWhite, kBlack}},
                          {10, 9, {kBlack, kWhite, kWhite, kBlack}}},
                         {{kWhite, 64}}},
             FrameAnswer{"subpixel_rounding",
                         {{1, 2, {kBlack, kWhite, kWhite, kBlack}}, {2, 3, {kBlack, kWhite, kWhite, kBlack}}},
                         {{kWhite, 10}}},
         }) {
        check_answer(answer);
    }
}

TEST_CASE("frames by hand: clipping, viewport and scissor") {
    for (const FrameAnswer& answer : {
             FrameAnswer{"clip_near_plane", {{7, 0, {kBlack, 0xffff8000}}}, {{0xffff8000, 128}, {kBlack, 128}}},
             FrameAnswer{"clip_far_plane",
                         {{0, 0, {0xfff70000, 0xffe70000, 0xffd70000, 0xffc70000, kBlack}},
                          {0, 15, {0xfff70000, 0xffe70000, 0xffd70000, 0xffc70000, kBlack}}},
                         {{kBlack, 192}}},
             FrameAnswer{
                 "clip_guard_band", {{4, 3, {kBlack}}, {0, 7, {0xff00c0ff}}, {7, 7, {0xff00c0ff}}}, {{0xff00c0ff, 36}}},
             FrameAnswer{"clip_behind_eye", {{0, 8, {kBlack}}, {0, 9, {kGreen}}}, {{kGreen, 112}, {kRed, 0}}},
             FrameAnswer{"scissor",
                         {{2, 5, {kBlack, kWhite}}, {8, 6, {kWhite, kBlue, kBlue, kBlack}}},
                         {{kWhite, 22}, {kBlue, 10}, {kBlack, 224}}},
             FrameAnswer{"viewport_part",
                         {{3, 4, {kBlack, kRed}}, {9, 5, {kRed, kBlue}}},
                         {{kRed, 28}, {kBlue, 36}, {kBlack, 192}}},
             FrameAnswer{"clear_ignores_state",
                         {{3, 3, {0, 0x80ff0000, 0x80ff0000, 0}}, {4, 4, {0}}},
                         {{0x80ff0000, 8}, {0, 56}}},
         }) {
        check_answer(answer);
    }
}

TEST_CASE("frames by hand: depth and alpha tests") {
    for (const FrameAnswer& answer : {
             FrameAnswer{"depth_ties", {{3, 0, {kBlue, kRed}}}, {{kBlue, 32}, {kRed, 32}}},
             FrameAnswer{"depth_functions",
                         {{0, 0, {kGreen, kGreen, kGreen, kGreen, kGreen, kGreen, kBlack, kBlack}},
                          {0, 1, {kGreen, kGreen, kGreen, kGreen, kBlack, kBlack}},
                          {0, 2, {kGreen, kGreen, kBlack, kBlack, kBlack, kBlack}},
                          {0, 3, {kBlack, kBlack, kGreen, kGreen, kGreen, kGreen}},
                          {0, 4, {kBlack, kBlack, kBlack, kBlack, kGreen, kGreen}},
                          {0, 5, {kBlack, kBlack, kGreen, kGreen, kBlack, kBlack}},
                          {0, 6, {kGreen, kGreen, kBlack, kBlack, kGreen, kGreen}}},
                         {{kGreen, 24}}},
             FrameAnswer{"depth_equal_same_triangle", {{2, 2, {kGreen}}}, {{kGreen, 196}, {kRed, 0}, {kBlack, 828}}},
             FrameAnswer{"depth_formats",
                         {{3, 0, {kBlack, kGreen}},
                          {7, 0, {kGreen, kGreen}},
                          {3, 2, {kBlack, kBlack}},
                          {7, 2, {kBlack, kGreen}}},
                         {{kGreen, 24}}},
             FrameAnswer{"depth_write_off", {{3, 7, {kBlue, kRed}}}, {{kBlue, 32}, {kRed, 32}}},
             FrameAnswer{"depth_clear_values", {{1, 0, {kBlack, kWhite}}}, {{kWhite, 24}, {kBlack, 8}}},
             FrameAnswer{"depth_reversed", {{0, 0, {kRed, kRed, kRed, kGreen, kGreen, kBlue, kBlue, kBlue}}}, {}},
             FrameAnswer{"depth_intersection", {{7, 0, {kWhite, kBlue}}, {7, 15, {kWhite, kBlue}}}, {{kWhite, 128}}},
             FrameAnswer{"mask_depth_only", {{1, 0, {kWhite, 0xff203040}}}, {{kWhite, 8}, {0xff203040, 24}}},
             FrameAnswer{"alpha_test_before_depth", {{3, 0, {kBlue, 0x80ff0000}}}, {{kBlue, 16}, {0x80ff0000, 16}}},
             FrameAnswer{"alpha_test_functions",
                         {{0, 0, {0x3f00ff00, 0x3f00ff00, 0x4000ff00, 0x4000ff00, 0x4100ff00, 0x4100ff00, kBlack}},
                          {1, 6, {0x3f00ff00, kBlack, kBlack, 0x4100ff00}}},
                         {{0x3f00ff00, 8}, {0x4000ff00, 8}, {0x4100ff00, 8}, {kBlack, 40}}},
         }) {
        check_answer(answer);
    }
}

}  // namespace demo
