// SPDX-License-Identifier: MIT
// By hand: the colours that blending, stages, textures, light, fog and formats give in the frames of demo/frames, by
// exact arithmetic that is rounded once.
#include "tests/demo/frame_answers.h"

namespace demo {

TEST_CASE("frames by hand: blending and masks") {
    for (const FrameAnswer& answer : {
             // 255 * 128 / 255 and 255 * 127 / 255; alpha (128 * 128 + 255 * 127) / 255 = 191.25
             FrameAnswer{"blend_over", {{3, 0, {0xbf80007f, 0xff80007f}}}, {{0xbf80007f, 16}, {0xff80007f, 16}}},
             // 192 * 128 / 255 = 96.4; 128; 64 * 128 / 255 = 32.1; 0
             FrameAnswer{"blend_multiply", {{3, 0, {0x60802000, 0x60802000}}}, {{0x60802000, 24}, {0xc0804020, 8}}},
             // 128 * 64 / 255 = 32.1
             FrameAnswer{"blend_alpha_multiply", {}, {{0x20c08040, 36}, {0x80c08040, 12}}},
             FrameAnswer{"blend_additive", {{3, 0, {0x00306090, 0x0060c0ff}}, {7, 0, {0x0060c0ff, 0x0090ffff}}}, {}},
             // on the right alpha (128 * 255 + 64 * 127) / 255 = 159.9, blue 128 * 127 / 255 = 63.7
             FrameAnswer{"blend_premultiplied", {{3, 0, {0xff40007f, 0xa0400040}}}, {}},
             // alpha (255 * 64 + 64 * 191) / 255 = 111.9, (255 * 128 + 128 * 127) / 255 = 191.7
             FrameAnswer{"blend_dest_alpha",
                         {{1, 0, {0x00000000, 0x70404040, 0x70404040, 0xc0808080, 0xc0808080, 0xffffffff}},
                          {7, 0, {0xffffffff, 0xffffffff, 0xffffffff}}},
                         {}},
             FrameAnswer{"mask_channels",
                         {{1, 0, {0x40ff4040, 0x4040ff40}}, {5, 3, {0x404040ff, 0xff404040}}},
                         {{0x40ff4040, 8}, {0x4040ff40, 8}, {0x404040ff, 8}, {0xff404040, 8}}},
         }) {
        check_answer(answer);
    }
}

TEST_CASE("frames by hand: every blend factor") {
    // source 0x80c08040, target 0x604060a0; two rows each in the order of BlendFactor
    const std::vector<std::uint32_t> of_source{0x00000000, 0x80c08040, 0x40914010, 0x402f4030, 0x30303028,
                                               0x50905018, 0x40604020, 0x40604020, 0x30483018, 0x50785028};
    const std::vector<std::uint32_t> of_target{0x00000000, 0x604060a0, 0x30303028, 0x30103078, 0x24102464,
                                               0x3c303c3c, 0x30203050, 0x30203050, 0x2418243c, 0x3c283c64};
    REQUIRE(of_source.size() == pipeline::EnumNames<pipeline::BlendFactor>::names.size());
    for (int i = 0; i < 10; ++i) {
        check_answer({"blend_source_factors", {{0, 2 * i, {of_source[i]}}, {3, 2 * i + 1, {of_source[i]}}}, {}});
        check_answer({"blend_dest_factors", {{0, 2 * i, {of_target[i]}}, {3, 2 * i + 1, {of_target[i]}}}, {}});
    }
}

TEST_CASE("frames by hand: texture stages") {
    // texel 0x406020e0, colour 0x80c08040: products over 255 are 32.1, 72.3, 16.1, 56.2; sums 192, 288, 160, 288
    const std::vector<std::uint32_t> ops{0x406020e0, 0x80c08040, 0x20481038, 0x40912070, 0x81ff40e1,
                                         0xc0ffa0ff, 0x41a121a1, 0x81ff41ff, 0x000000a0};
    for (int i = 0; i < 9; ++i) check_answer({"combine_ops", {{0, 2 * i, {ops[i]}}, {3, 2 * i + 1, {ops[i]}}}, {}});
    for (const FrameAnswer& answer : {
             FrameAnswer{
                 "combine_blend_alphas", {{1, 0, {0x3f808080, 0x3f404040}}, {5, 3, {0x3fc0c0c0, 0x3f3f3f3f}}}, {}},
             FrameAnswer{"combine_modulate_color_add_alpha", {{3, 0, {0x60885078, 0xa0c890b8}}}, {}},
             FrameAnswer{"combine_complement_replicate",
                         {{1, 0, {0x406020e0, 0xbf9fdf1f}}, {5, 0, {0x40404040, 0xbfbfbfbf}}},
                         {}},
             FrameAnswer{"combine_two_stages", {{0, 2, greys({0x10, 0x10, 0x30, 0x30, 0x60, 0x60, 0xa0, 0xa0})}}, {}},
             FrameAnswer{"combine_specular", {{3, 0, {0xff401008, 0x40ff9048}}}, {{0xff401008, 16}}},
             // 192 * 255 / 255, 128 * 128 / 255 = 64.3, 64, 32 * 128 / 255 = 16.1
             FrameAnswer{
                 "combine_texture_factor", {{3, 0, {0xc0804020, 0xc0404010}}, {7, 0, {0xc0404010, 0xffffffff}}}, {}},
         }) {
        check_answer(answer);
    }
}

TEST_CASE("frames by hand: reading textures") {
    for (const FrameAnswer& answer : {
             FrameAnswer{"blit_1_to_1",
                         {{0, 0, greys({0x00, 0x10, 0x20, 0x30, 0x00, 0x10, 0x20, 0x30})},
                          {0, 3, greys({0xc0, 0xd0, 0xe0, 0xf0, 0xc0, 0xd0, 0xe0, 0xf0})}},
                         {}},
             FrameAnswer{"blit_half_pixel_shift",
                         {{0, 0, greys({0x50, 0x60, 0x70, 0x00, 0x28, 0x38, 0x48, 0x00})},
                          {0, 2, greys({0xd0, 0xe0, 0xf0, 0x00, 0xa8, 0xb8, 0xc8, 0x00})},
                          {0, 3, greys({0, 0, 0, 0, 0, 0, 0, 0})}},
                         {}},
             // means 0.25, 0.5, 0.75; 63.75, 127.5
             FrameAnswer{"downsample_2_to_1", {{0, 0, greys({0, 0, 1, 1})}, {0, 1, greys({1, 64, 128, 255})}}, {}},
             // 255 times 1, 3, 5, 7 eighths
             FrameAnswer{"upsample_linear",
                         {{0, 1, greys({0, 0, 32, 96, 159, 223, 255, 255})},
                          {0, 2, greys({96, 32, 32, 96, 159, 223, 223, 159})}},
                         {}},
             FrameAnswer{"texture_formats", {{3, 0, {0x60000000, 0xff606060}}, {7, 0, {0xff606060, 0x80c08040}}}, {}},
             FrameAnswer{"texture_address",
                         {{0, 0, greys({0, 0x50, 0xa0, 0xf0, 0, 0x50, 0xa0, 0xf0, 0, 0x50, 0xa0, 0xf0})},
                          {0, 2, greys({0, 0, 0, 0, 0, 0x50, 0xa0, 0xf0, 0xf0, 0xf0, 0xf0, 0xf0})},
                          {0, 4, greys({0xf0, 0xa0, 0x50, 0, 0, 0x50, 0xa0, 0xf0, 0xf0, 0xa0, 0x50, 0})}},
                         {}},
             // 255 times 1 or 3 quarters
             FrameAnswer{"texture_address_linear",
                         {{0, 0, greys({64, 64, 191, 191, 64, 64, 191, 191})},
                          {0, 2, greys({0, 64, 191, 255, 255, 255, 255, 255})},
                          {0, 4, greys({0, 64, 191, 255, 255, 191, 64, 0})}},
                         {}},
             FrameAnswer{
                 "texture_perspective",
                 {{7, 0, greys({0x00, 0x50})}, {11, 8, greys({0x50, 0xa0, 0xa0, 0xf0, 0xf0})}, {0, 15, greys({0x00})}},
                 {{0xff000000, 128}, {0xff505050, 64}, {0xffa0a0a0, 32}, {0xfff0f0f0, 32}}},
             FrameAnswer{"texture_projected",
                         {{3, 0, greys({0x00, 0x50})}, {7, 8, greys({0x50, 0xa0})}, {11, 15, greys({0xa0, 0xf0})}},
                         {{0xff000000, 64}, {0xff505050, 64}, {0xffa0a0a0, 64}, {0xfff0f0f0, 64}}},
             FrameAnswer{"texture_mips_point",
                         {{0, 0, greys({0x20})},
                          {7, 1, greys({0x60})},
                          {0, 2, greys({0xa0})},
                          {7, 3, greys({0xa0})},
                          {0, 4, greys({0xe0})}},
                         {{0xff202020, 8}, {0xff606060, 8}, {0xffa0a0a0, 16}, {0xffe0e0e0, 8}}},
             // (96 * 112 + 160 * 144) / 256 = 132, (160 * 112 + 224 * 144) / 256 = 196
             FrameAnswer{"texture_mips_linear",
                         {},
                         {{0xff202020, 8}, {0xff606060, 8}, {0xff848484, 8}, {0xffa0a0a0, 8}, {0xffc4c4c4, 8}}},
             // 0x82 * 0x80 / 255 = 65.3; seven texels of the cross, 4x4 pixels each
             FrameAnswer{"target_as_texture",
                         {{0, 0, {0x80844184}}, {4, 0, {0x80ff4184}}, {15, 7, {0x80ff4184}}},
                         {{0x80ff4184, 112}, {0x80844184, 144}}},
         }) {
        check_answer(answer);
    }
}

TEST_CASE("frames by hand: shading, fog and light") {
    for (const FrameAnswer& answer : {
             // at (0, 16): 255 times 15/16, 1/32, 1/32
             FrameAnswer{"shade_flat_and_gouraud",
                         {{0, 0, {0xffff0000}}, {15, 15, {0xff00ff00}}, {0, 16, {0xffef0808}}},
                         {{0xffff0000, 120}, {0xff00ff00, 136}}},
             FrameAnswer{"shade_gouraud_ramp",
                         {{0, 0, greys({8, 24, 40, 56, 72, 88, 104, 120, 135, 151, 167, 183, 199, 215, 231, 247})}},
                         {}},
             // (16 - d) / 16 * 255 = 255, 191.25, 63.75, 0
             FrameAnswer{"fog_linear", {{3, 0, {0xffff0000, 0xffbf0040}}, {11, 3, {0xff4000bf, 0xff0000ff}}}, {}},
             // 255 e^-0.4 = 170.9, 255 e^-0.8 = 114.6, 255 e^-1.2 = 76.8
             FrameAnswer{"fog_exp", {{3, 0, {0xffff0000, 0xffab0054}}, {11, 3, {0xff73008c, 0xff4d00b2}}}, {}},
             // 255 e^-0.16 = 217.3, 255 e^-0.64 = 134.5, 255 e^-1.44 = 60.4
             FrameAnswer{"fog_exp2", {{3, 0, {0xffff0000, 0xffd90026}}, {11, 3, {0xff860079, 0xff3c00c3}}}, {}},
             // 255 times 10, 9, 7 sixteenths
             FrameAnswer{"fog_range",
                         {{4, 0, greys({159, 143})}, {8, 3, greys({143, 112})}, {4, 4, greys({159, 159})}},
                         {{0xff9f9f9f, 84}, {0xff8f8f8f, 16}, {0xff707070, 28}}},
             FrameAnswer{"light_directional",
                         {{3, 0, greys({204, 173})}, {7, 3, greys({173, 51})}, {11, 0, greys({51, 51})}},
                         {}},
             // 255 / 3; 255 * 12/13 / 3.25 = 72.4; 255 * 0.8 / 3.75 = 54.4
             FrameAnswer{
                 "light_point",
                 {{4, 0, greys({85, 72})}, {8, 3, greys({72, 54})}, {4, 4, greys({85, 72})}, {8, 7, greys({72, 0})}},
                 {}},
             FrameAnswer{"light_negative", {{3, 0, greys({204, 204})}, {7, 0, greys({204, 0})}}, {}},
             // 255 times 0.4; 0.32, 0.256; 0.24, 0.144
             FrameAnswer{"light_specular", {{3, 0, {0xffcc6666, 0xff934141}}, {11, 0, {0xff622525, 0xff000000}}}, {}},
             FrameAnswer{
                 "light_material_sources", {{3, 0, {0x9900ff00, 0xffff0000}}, {11, 0, {0x400000ff, 0x99ff0000}}}, {}},
             FrameAnswer{"light_normal_lengths", {{3, 0, greys({102, 204})}}, {}},
         }) {
        check_answer(answer);
    }
}

TEST_CASE("frames by hand: formats of targets") {
    for (const FrameAnswer& answer : {
             FrameAnswer{"format_565",
                         {{1, 0, {0xff848284, 0xff000000, 0xff000000, 0xff080408}},
                          {5, 3, {0xff080408, 0xff7b7d7b, 0xff7b7d7b, 0xffffffff}}},
                         {}},
             FrameAnswer{"format_1555",
                         {{1, 0, {0xff848484, 0x00000000, 0x00000000, 0x00080808}},
                          {5, 3, {0x00080808, 0xff7b7b7b, 0xff7b7b7b, 0xffffffff}}},
                         {}},
             FrameAnswer{"format_6666",
                         {{1, 0, {0x82828282, 0x00000000, 0x00000000, 0x04040404}},
                          {5, 3, {0x04040404, 0x7d7d7d7d, 0x7d7d7d7d, 0xffffffff}}},
                         {}},
             FrameAnswer{"format_masked_write",
                         {{1, 0, {0xff848284, 0xff84ff84, 0xff84ff84, 0xffff82ff}}},
                         {{0xff848284, 8}, {0xff84ff84, 8}, {0xffff82ff, 8}}},
             FrameAnswer{"copy_rectangle", {{3, 0, {0xff102030, 0xff102031}}}, {{0xff102030, 16}, {0xff102031, 16}}},
         }) {
        check_answer(answer);
    }
}

}  // namespace demo
