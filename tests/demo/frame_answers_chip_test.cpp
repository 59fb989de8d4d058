// SPDX-License-Identifier: MIT
// By hand: the frames of demo/frames that are for one chip, from the formulas in pipeline/frame/arithmetic.h,
// blend_state.h and frame.h.
#include "tests/demo/frame_answers.h"

namespace demo {

TEST_CASE("frames by hand: Graphics Synthesizer, pixels") {
    for (const FrameAnswer& answer : {
             // 255 * 64 >> 7 = 127; (-255 * 64 >> 7) + 255 = 127; (255 * 192 >> 7) = 382; (-1 >> 7) + 1 = 0
             FrameAnswer{"ps2_blend_0x44",
                         {{3, 0, {0x407f007f, 0x80ff0000}}, {11, 0, {0xc0ff0000, 0x01000000}}},
                         {{0x407f007f, 16}, {0x80ff0000, 16}, {0xc0ff0000, 16}, {0x01000000, 16}}},
             // 192, 128, 65 times 64 >> 7 = 96, 64, 32; times 192 >> 7 = 288, 192, 97
             FrameAnswer{"ps2_blend_0x89", {{3, 0, {0x40604020, 0x80604020}}, {11, 0, {0xc0ffc061}}}, {}},
             FrameAnswer{"ps2_colclamp", {{3, 0, {0x80ff80a0, 0x804080a0}}, {11, 0, {0x80000000, 0x80c000a0}}}, {}},
             // 32, 48, 64 times 127 >> 7 = 31, 47, 63
             FrameAnswer{"ps2_pabe", {{3, 0, {0x80304050, 0x7f203040}}, {11, 0, {0x7f2f3f4f}}}, {}},
             FrameAnswer{"ps2_fba", {{3, 0, {0x01203040, 0x81203040}}, {11, 0, {0x80203040}}}, {}},
             FrameAnswer{"ps2_date",
                         {{1, 0, {0x7f0000ff, 0x80ff0000}},
                          {1, 2, {0x80ff0000, 0x800000ff}},
                          {5, 1, {0x000000f8, 0x80f80000}},
                          {5, 3, {0x80f80000, 0x800000f8}}},
                         {{0x80ff0000, 8}, {0x80f80000, 8}, {0x800000ff, 20}}},
             FrameAnswer{"ps2_alpha_fail",
                         {{3, 0, {0x800000ff, 0x40ff0000}},
                          {11, 3, {0x800000ff, 0x80ff0000}},
                          {3, 4, {0x8000ff00, 0x8000ff00}},
                          {11, 7, {0x800000ff, 0x8000ff00}}},
                         {{0x8000ff00, 48}, {0x800000ff, 48}}},
             FrameAnswer{"ps2_alpha_fail_16_bits", {{3, 0, {0x80ff0000, 0x00f80000}}}, {}},
             // 134 + 2 or 3 reaches 136; on the right 1 - 4, 3, 2 wrap to 253, 254, 255, which keep 0xf8
             FrameAnswer{"ps2_psmct16_dither",
                         {{3, 0, {0x80808080, 0x80808080, 0x80888888, 0x80808080, 0x80888888}},
                          {4, 1, {0x80808080, 0x80808080, 0x80808080, 0x80808080}},
                          {4, 2, {0x80808080, 0x80888888, 0x80808080, 0x80888888}},
                          {4, 3, {0x80808080, 0x80808080, 0x80808080, 0x80808080}},
                          {8, 0, {0x80f8f8f8, 0x80000000, 0x80f8f8f8, 0x80000000}},
                          {8, 1, {0x80000000, 0x80f8f8f8, 0x80000000, 0x80000000}},
                          {8, 2, {0x80f8f8f8, 0x80000000, 0x80f8f8f8, 0x80000000}},
                          {8, 3, {0x80000000, 0x80000000, 0x80000000, 0x80f8f8f8}}},
                         {}},
             FrameAnswer{"ps2_psmct16",
                         {{1, 0, {0x80808080, 0x00000000, 0x00000000, 0x00080808}},
                          {5, 0, {0x00080808, 0x80787878, 0x80787878, 0x80f8f8f8}}},
                         {}},
             // (128 * 64 >> 7) + 64, 128, (-128 * 64 >> 7) + 192
             FrameAnswer{"ps2_dest_alpha", {{3, 0, {0x10808080, 0x80c08040}}, {11, 0, {0x004080c0, 0x00c08040}}}, {}},
         }) {
        check_answer(answer);
    }
}

TEST_CASE("frames by hand: Graphics Synthesizer, coverage, textures and fog") {
    for (
        const FrameAnswer& answer : {
            FrameAnswer{"ps2_shared_diagonal",
                        {{1, 2, {0x80000000, 0x80404040}}, {11, 11, {0x80404040, 0x80000000}}},
                        {{0x80404040, 100}}},
            // 64 * 32, 96 * 128, 32 * 64, 224 * 192, each >> 7: 16, 96, 16, 336; and + 32
            FrameAnswer{
                "ps2_texture_functions", {{3, 0, {0x106010ff, 0x406020e0}}, {11, 0, {0x608030ff, 0x408030ff}}}, {}},
            // in the middle rows and columns lie half way between texels, clamped at the edge: 0, 8, 24, 40; down by 32
            FrameAnswer{"ps2_blit_half_texel",
                        {{0, 0, greys({0x00, 0x10, 0x20, 0x30, 0x00, 0x08, 0x18, 0x28, 0x00, 0x10, 0x20, 0x30})},
                         {0, 1, greys({0x40, 0x50, 0x60, 0x70, 0x20, 0x28, 0x38, 0x48, 0x40, 0x50, 0x60, 0x70})},
                         {8, 3, greys({0xc0, 0xd0, 0xe0, 0xf0})}},
                        {}},
            // 255: (255 + (-255 * 8 >> 4)) = 127, then 127 + (-127 * 8 >> 4) = 63
            FrameAnswer{"ps2_downsample", {{0, 0, greys({0, 0, 0, 0})}, {0, 1, greys({1, 63, 127, 255})}}, {}},
            FrameAnswer{"ps2_gouraud_floor",
                        {{0, 3, greys({0, 15, 31, 47, 63, 79, 95, 111, 127, 143, 159, 175, 191, 207, 223, 239})}},
                        {}},
            // 255 * 255 >> 8 = 254, 1 * 255 >> 8 = 0; 64 * 255 >> 8 = 63, 192 * 255 >> 8 = 191; 256 * 255 >> 8
            FrameAnswer{"ps2_fog",
                        {{3, 0, {0x80fe0000, 0x803f00bf}}, {7, 0, {0x803f00bf, 0x800000ff, 0x800000ff}}},
                        {{0x80fe0000, 16}, {0x803f00bf, 16}, {0x800000ff, 16}}},
        }) {
        check_answer(answer);
    }
}

TEST_CASE("frames by hand: Flipper") {
    for (const FrameAnswer& answer : {
             // 129 - 2 + {0, 2; 3, 1} = 127, 129, 130, 128: 31, 32, 32, 32; 131 likewise: 32, 32, 33, 32
             FrameAnswer{"gamecube_rgba6_dither",
                         {{3, 0, {0x82828282, 0x827d7d7d, 0x82828282, 0x827d7d7d}},
                          {4, 1, {0x82828282, 0x82828282, 0x82828282, 0x82828282}},
                          {4, 2, {0x82828282, 0x82828282, 0x82828282, 0x82828282}},
                          {4, 3, {0x82868686, 0x82828282, 0x82868686, 0x82828282}}},
                         {{0x827d7d7d, 2}, {0x82868686, 2}, {0x82828282, 28}}},
             // 130 * 256 >> 8, 130 * 129 >> 8 = 65, 130 * 64 >> 8 = 32
             FrameAnswer{"gamecube_alpha_multiply", {{3, 0, {0x82824120, 0x41824120}}, {11, 0, {0x20824120}}}, {}},
             // 255 * 129 >> 8 = 128, 255 * 127 >> 8 = 126; 255 * 1 >> 8 = 0; (100 * 129 + 100 * 127) >> 8
             FrameAnswer{"gamecube_blend_over", {{3, 0, {0xff80007e, 0xff000000}}, {11, 0, {0xff646464}}}, {}},
             FrameAnswer{"gamecube_tev",
                         {{0, 1, {0xff804001}}, {0, 3, {0xffff7f01}}, {0, 5, {0xffff7f01}}, {0, 7, {0xffbf8041}}},
                         {}},
             // 1; 252 + 3; 126 + 1; 129 + 2
             FrameAnswer{"gamecube_halving_copy_rgba6", {{0, 0, {0xff010101, 0xffffffff, 0xff7f7f7f, 0xff838383}}}, {}},
             // 3 >> 2; 1020 >> 2; 510 >> 2; 5 >> 2
             FrameAnswer{"gamecube_halving_copy_rgb8", {{0, 0, {0xff000000, 0xffffffff, 0xff7f7f7f, 0xff010101}}}, {}},
             FrameAnswer{
                 "gamecube_sample_point",
                 {{1, 0, greys({0, 255, 255, 0})}, {1, 1, greys({0, 255, 255, 0})}, {2, 2, greys({0, 255, 255, 0})}},
                 {{0xffffffff, 6}}},
             // 255 times 18, 50, 82, 114 of 128: 35.9, 99.6, 163.4, 227.1
             FrameAnswer{"gamecube_filter", {{0, 2, greys({0, 0, 35, 99, 163, 227, 255, 255})}}, {}},
         }) {
        check_answer(answer);
    }
}

TEST_CASE("frames by hand: NV2A and Direct3D 7") {
    for (const FrameAnswer& answer : {
             // 248 * 128 / 255 = 124.5 keeps 15 of 31, 252 * 128 / 255 = 126.5 keeps 31 of 63; 132 + 8 keeps 17
             FrameAnswer{"xbox_565_blend", {{3, 0, {0xff7b7d7b, 0xff848284}}, {11, 0, {0xff8c868c}}}, {}},
             // 1 0 / 0 0: (0 + 1 + 1) >> 1 = 1, then again; 255 0 / 0 0: 128, then 64
             FrameAnswer{"xbox_downsample", {{0, 0, greys({0, 1, 1, 1})}, {0, 1, greys({1, 64, 128, 255})}}, {}},
             FrameAnswer{
                 "xbox_snap", {{1, 3, greys({0, 255, 255, 0})}, {2, 4, greys({0, 255, 255, 0})}}, {{0xffffffff, 10}}},
             FrameAnswer{"dx7_triangle_top_left",
                         {{4, 4, {0xffff0000, 0xff000000}}, {0, 1, {0xff0000ff, 0xffff0000}}},
                         {{0xffff0000, 15}, {0xff0000ff, 10}, {0xff000000, 39}}},
             FrameAnswer{"dx7_blit",
                         {{0, 0, greys({0x00, 0x08, 0x18, 0x28, 0x00, 0x10, 0x20, 0x30})},
                          {0, 1, greys({0x20, 0x28, 0x38, 0x48, 0x40, 0x50, 0x60, 0x70})},
                          {4, 3, greys({0xc0, 0xd0, 0xe0, 0xf0})}},
                         {}},
             FrameAnswer{"dx7_downsample", {{0, 0, greys({0, 0, 1, 1})}, {0, 1, greys({1, 64, 128, 255})}}, {}},
         }) {
        check_answer(answer);
    }
}

}  // namespace demo
