// SPDX-License-Identifier: MIT
// `execute` and the truth of the same frames, with one sample a pixel and chains blit by blit: what is left between them is
// rounding, and the few pixels where rounding decides.
#include <catch2/catch.hpp>
#include <cmath>

#include "demo/scene.h"
#include "pipeline/execute/execute.h"
#include "pipeline/truth/truth.h"
#include "pipeline/validate/validate.h"
#include "tests/support/random.h"
#include "tests/support/random_frame.h"
#include "tests/support/small_frame.h"

namespace {

using namespace pipeline;
using namespace test_support;

// The greatest difference of a channel, in bytes, at each pixel.
std::vector<double> differences(const Frame& frame) {
    const ColorImage got     = execute(frame).output;
    const TruthPicture truth = draw_truth(frame, {.samples_per_axis = 1, .true_gaussian = false});
    std::vector<double> out;
    for (std::size_t i = 0; i < got.pixels.size(); ++i) {
        out.push_back(0.0);
        for (std::size_t c = 0; c < 4; ++c) {
            const std::uint32_t byte = (got.pixels[i] >> (c == 3 ? 24 : 16 - 8 * c)) & 255;
            out.back()               = std::max(out.back(), std::abs(byte - 255.0 * truth.pixels[i][c]));
        }
    }
    return out;
}

// Of pixels with a difference of more than `bytes`.
struct Share {
    std::size_t beyond = 0, pixels = 0;
    void add(const std::vector<double>& differences, double bytes) {
        pixels += differences.size();
        for (const double difference : differences) beyond += difference > bytes;
    }
    double value() const { return static_cast<double>(beyond) / static_cast<double>(pixels); }
};

// What is no rounding is left: ideal arithmetic, formats of 8 bits and the finest depth.
Frame without_roundings(Frame frame) {
    frame.arithmetic = {.pixel_center = frame.arithmetic.pixel_center};
    for (Target& target : frame.targets) {
        if (is_depth(target.format)) target.format = TargetFormat::D32;
        if (target.format == TargetFormat::A1R5G5B5 || target.format == TargetFormat::R6G6B6A6 ||
            target.format == TargetFormat::Psmct16)
            target.format = TargetFormat::A8R8G8B8;
        if (target.format == TargetFormat::R5G6B5) target.format = TargetFormat::X8R8G8B8;
    }
    for (Pass& pass : frame.passes) {
        pass.state.gs_blend = {};
        pass.state.dither   = {};
    }
    return frame;
}

}  // namespace

// One layer, corners on the subpixel grid, so that both cover the same pixels; texels that differ by 40 at most. In bytes:
//   texel     1.13: fractions cut to 1/256 and the coordinate's own floats, 2/256 * 40 along each axis; rounded, 0.5
//   diffuse   0.57: rounded, 0.5; a step of the plane rounded to 1/256, 15 times, and the block's start (raster/primitives.h)
//   modulate  1.95: of texels up to 140/255: 1.13 + 0.57 * 140/255 + 0.5
//   blend     3.6:  by an alpha up to 140/255: 1.95 * 140/255 + 1.95 * (source less destination, 1 at most) + 0.5
TEST_CASE("the truth of one layer lies as near to execute as its roundings allow", "[truth]") {
    double greatest = 0.0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        INFO("seed " << seed);
        Random random(seed);
        Frame frame                 = small_frame(40, 40);
        frame.passes[0].clear.color = Argb{random.bits()};
        frame.passes[0].state.blend = kAlphaOver;
        std::vector<std::uint8_t> texels(16 * 16 * 4);
        for (std::uint8_t& texel : texels) texel = static_cast<std::uint8_t>(random.from(100, 140));
        const TextureId texture         = add_texture(frame, TextureFormat::A8R8G8B8, 16, 16, texels);
        const TextureArg diffuse        = {.source = ArgSource::Diffuse};
        frame.passes[0].state.stages[0] = {.color_op   = TextureOp::Modulate,
                                           .color_arg2 = diffuse,
                                           .alpha_op   = TextureOp::Modulate,
                                           .alpha_arg2 = diffuse,
                                           .filter     = TextureFilter::Linear,
                                           .address_u  = random.any<TextureAddress>(),
                                           .address_v  = random.any<TextureAddress>()};
        if (random.chance(50)) {
            DrawRectangle draw;
            draw.x0 = draw.y0 = static_cast<float>(random.from(0, 160)) / 16.0f;
            draw.x1 = draw.y1 = static_cast<float>(random.from(300, 640)) / 16.0f;
            draw.color        = {random.bits()};
            draw.uv[0]        = {random.real(-1, 1), random.real(-1, 1), random.real(1, 2), random.real(1, 2)};
            draw.textures[0]  = bound(texture);
            frame.passes[0].draws.push_back(draw);
        } else {
            DrawWindowTriangles draw{.first_index = 0, .index_count = 3, .textures = {}};
            draw.textures[0] = bound(texture);
            for (std::uint32_t i = 0; i < 3; ++i) {
                const float x = static_cast<float>(random.from(-200, 800)) / 16.0f;
                const float y = static_cast<float>(random.from(-200, 800)) / 16.0f;
                frame.window_vertices.push_back({.x       = x,
                                                 .y       = y,
                                                 .rhw     = random.real(0.2f, 1.0f),
                                                 .diffuse = {random.bits()},
                                                 .uv0     = {random.real(-1, 1), random.real(-1, 1), 1.0f}});
                frame.indices.push_back(i);
            }
            frame.passes[0].draws.push_back(draw);
        }
        const std::vector<double> off = differences(frame);
        const double worst            = *std::max_element(off.begin(), off.end());
        CHECK(worst <= 3.6);
        greatest = std::max(greatest, worst);
    }
    CHECK(greatest > 0.5);  // they were drawn
}

// Up to six passes on one another, with tests for equality, factors of four and textures of noise. Corners of all kinds, so sides
// move by up to 1/32 pixel.
TEST_CASE("the truth of random frames differs little but where rounding decides", "[truth]") {
    Share share;
    int count = 0;
    for (std::uint32_t seed = 0; seed < 400; ++seed) {
        const Frame frame = without_roundings(random_frame(seed));
        if (!validate(frame).empty()) continue;
        ++count;
        share.add(differences(frame), 4.0);
    }
    CHECK(count > 100);
    CHECK(share.value() < 0.005);  // 0.19 %
}

TEST_CASE("the truth of scenes differs little but at edges", "[truth]") {
    for (const char* name : {"smoke", "canyon"}) {
        INFO(name);
        Share share;
        share.add(differences(demo::scene_frame(*demo::load_scene(name), {160, 90}, 0)), 4.0);
        CHECK(share.value() < 0.02);  // 0.14 % and 1.5 %
    }
}
