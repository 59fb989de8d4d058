// SPDX-License-Identifier: MIT
// What the passes of the cloud technique lose on each chip: the multiplication of alpha alone by a fractal, the composite by
// alpha, and one halving. Errors are in units of a byte, against real numbers, over all inputs or a stated sample; means
// are the bias that a pass brings. The figures are derived from the chips' formulas by hand or by counting, apart from
// this program.
#include <cmath>

#include "pipeline/profile/profile.h"
#include "tests/support/random.h"
#include "tests/support/small_frame.h"

using namespace pipeline;
using namespace test_support;

namespace {

class Errors {
  public:
    void add(double got, double exact) {
        const double error = got - exact;
        sum_ += error;
        squares_ += error * error;
        least_ = count_ == 0 ? error : std::min(least_, error);
        most_  = count_ == 0 ? error : std::max(most_, error);
        ++count_;
    }
    double mean() const { return sum_ / count_; }
    double rms() const { return std::sqrt(squares_ / count_); }
    double least() const { return least_; }
    double most() const { return most_; }

  private:
    double sum_ = 0, squares_ = 0, least_ = 0, most_ = 0;
    int count_ = 0;
};

// mean, least, most, as they are printed: to the digits given.
void check(const Errors& errors, double mean, double least, double most, double within = 0.005) {
    CHECK(errors.mean() == Approx(mean).margin(within));
    CHECK(errors.least() == Approx(least).margin(within));
    CHECK(errors.most() == Approx(most).margin(within));
}

Arithmetic arithmetic_of(const char* profile) {
    const Profile* found = find_profile(profile);
    REQUIRE(found != nullptr);
    return found->arithmetic;
}

TextureId texture_of(Frame& frame, int width, int height, const std::function<std::uint32_t(int, int)>& argb) {
    std::vector<std::uint8_t> texels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int shift = 0; shift < 32; shift += 8)
                texels.push_back(static_cast<std::uint8_t>(argb(x, y) >> shift));
    return add_texture(frame, TextureFormat::A8R8G8B8, width, height, std::move(texels));
}

// A texture over the whole target, a texel a pixel.
DrawRectangle blit(const Frame& frame, const TextureBinding& from) {
    const Target& target = frame.targets[0];
    DrawRectangle draw   = rectangle({0, 0, target.width, target.height}, 0x80808080);
    draw.textures[0]     = from;
    // Texels are read at their centres, wherever a pixel is sampled.
    const float shift    = (8.0f - static_cast<float>(frame.arithmetic.pixel_center)) / 16.0f;
    draw.uv[0]           = {shift / static_cast<float>(target.width), shift / static_cast<float>(target.height),
                            1.0f + shift / static_cast<float>(target.width), 1.0f + shift / static_cast<float>(target.height)};
    return draw;
}

// Passes over one colour target of this format.
Frame chip_frame(const char* profile, TargetFormat format, int width, int height) {
    Frame frame             = small_frame(width, height);
    frame.arithmetic        = arithmetic_of(profile);
    frame.targets[0].format = format;
    frame.passes.clear();
    return frame;
}

Pass& add_pass(Frame& frame, const TextureBinding& from) {
    Pass& pass                     = frame.passes.emplace_back();
    pass.color                     = {0};
    pass.state.stages[0]           = kTextureOnly;
    pass.state.stages[0].address_u = pass.state.stages[0].address_v = TextureAddress::Clamp;
    pass.draws                                                      = {blit(frame, from)};
    return pass;
}

std::uint32_t channel(std::uint32_t pixel, int shift) {
    return pixel >> shift & 255;
}

// Stored alpha x, or what the format makes of it, times y.
template <class Set>
Errors alpha_multiply(const char* profile, TargetFormat format, Set&& set) {
    Frame frame = chip_frame(profile, format, 256, 256);
    const TextureId stored =
        texture_of(frame, 256, 256, [](int x, int) { return static_cast<std::uint32_t>(x) << 24 | 0x336699; });
    const TextureId fractal =
        texture_of(frame, 256, 256, [](int, int y) { return static_cast<std::uint32_t>(y) << 24 | 0xffffff; });
    add_pass(frame, bound(stored));
    const std::vector<std::uint32_t> before = pixels_on_both(frame);
    set(add_pass(frame, bound(fractal)).state);
    const std::vector<std::uint32_t> after = pixels_on_both(frame);
    Errors errors;
    for (std::size_t i = 0; i < after.size(); ++i) {
        errors.add(channel(after[i], 24), channel(before[i], 24) * static_cast<double>(i / 256) / 255.0);
        REQUIRE((after[i] & 0x00ffffff) == (before[i] & 0x00ffffff));
    }
    return errors;
}

void multiply_alpha_under_mask(PipelineState& state) {
    state.blend      = {BlendFactor::Zero, BlendFactor::SourceAlpha};
    state.color_mask = {.red = false, .green = false, .blue = false, .alpha = true};
}

// Source x over destination y, for every alpha up to `most`, of which `one` is one.
template <class Set>
Errors composite(const char* profile, TargetFormat format, std::uint32_t most, double one, Set&& set) {
    Errors errors;
    for (std::uint32_t alpha = 0; alpha <= most; ++alpha) {
        Frame frame = chip_frame(profile, format, 256, 256);
        const TextureId dest =
            texture_of(frame, 256, 256, [](int, int y) { return static_cast<std::uint32_t>(y) * 0x010101; });
        const TextureId source = texture_of(
            frame, 256, 256, [&](int x, int) { return static_cast<std::uint32_t>(x) * 0x010101 | alpha << 24; });
        add_pass(frame, bound(dest));
        set(add_pass(frame, bound(source)).state);
        const std::vector<std::uint32_t> pixels = execute(frame).output.pixels;
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256; ++x)
                errors.add(channel(pixels[static_cast<std::size_t>(256 * y + x)], 8),
                           y + (x - y) * static_cast<double>(alpha) / one);
    }
    return errors;
}

// Random quads, halved by reading between their texels, in the middle.
Errors halved_by_filter(const char* profile) {
    Random random(3);
    Frame frame                 = chip_frame(profile, TargetFormat::A8R8G8B8, 512, 256);
    const TextureId quads       = texture_of(frame, 1024, 512, [&](int, int) { return random.bits(); });
    Pass& pass                  = add_pass(frame, bound(quads));
    DrawRectangle& draw         = std::get<DrawRectangle>(pass.draws[0]);
    const float shift           = (8.0f - static_cast<float>(frame.arithmetic.pixel_center)) / 16.0f;
    draw.uv[0]                  = {shift / 512.0f, shift / 256.0f, 1.0f + shift / 512.0f, 1.0f + shift / 256.0f};
    pass.state.stages[0].filter = TextureFilter::Linear;
    const std::vector<std::uint32_t> pixels = pixels_on_both(frame);
    const std::vector<std::uint8_t>& texels = frame.textures[0].texels;
    Errors errors;
    for (std::size_t y = 0; y < 256; ++y)
        for (std::size_t x = 0; x < 512; ++x)
            for (std::size_t c = 0; c < 4; ++c) {
                const std::size_t at = 4 * (2 * y * 1024 + 2 * x) + c;
                const int sum        = texels[at] + texels[at + 4] + texels[at + 4096] + texels[at + 4100];
                errors.add(channel(pixels[512 * y + x], static_cast<int>(8 * c)), sum / 4.0);
            }
    return errors;
}

// Random quads, halved by a copy.
Errors halved_by_copy(TargetFormat format) {
    Random random(4);
    Frame frame = chip_frame("gamecube", TargetFormat::A8R8G8B8, 512, 256);
    frame.targets.push_back({.name = "efb", .format = format, .width = 1024, .height = 512});
    const TextureId quads = texture_of(frame, 1024, 512, [&](int, int) { return random.bits(); });
    Pass& fill            = add_pass(frame, bound(quads));
    fill.color            = {1};
    DrawRectangle& draw   = std::get<DrawRectangle>(fill.draws[0]);
    draw.x1               = 1024.0f;
    draw.y1               = 512.0f;
    Pass& copy            = frame.passes.emplace_back();
    copy.color            = {0};
    copy.draws            = {CopyRectangle{.source = {1}, .from = {0, 0, 1024, 512}, .halve = true}};
    ColorImage before;
    const std::vector<std::uint32_t> pixels = execute(frame, {}, [&](const FinishedPass& pass) {
                                                  if (pass.index == 0) before = pass.read_color();
                                              }).output.pixels;
    Errors errors;
    for (std::size_t y = 0; y < 256; ++y)
        for (std::size_t x = 0; x < 512; ++x)
            for (int shift = 0; shift < 24; shift += 8) {
                std::uint32_t sum = 0;
                for (const std::size_t at : {0, 1, 1024, 1025})
                    sum += channel(before.pixels[2 * y * 1024 + 2 * x + at], shift);
                errors.add(channel(pixels[512 * y + x], shift), sum / 4.0);
            }
    return errors;
}

}  // namespace

TEST_CASE("alpha times a fractal: the Xbox and Direct3D 7 lose nothing on average", "[chip]") {
    check(alpha_multiply("xbox", TargetFormat::A8R8G8B8, multiply_alpha_under_mask), 0.0, -127.0 / 255, 127.0 / 255);
    // No mask: the fractal is white, and all channels are multiplied.
    check(alpha_multiply("dx7", TargetFormat::A8R8G8B8, [](PipelineState& state) { state.blend = kMultiply; }), 0.0,
          -127.0 / 255, 127.0 / 255);
}

TEST_CASE("alpha times a fractal: the GameCube's six bits darken by 1.37 a pass", "[chip]") {
    check(alpha_multiply("gamecube", TargetFormat::R6G6B6A6, multiply_alpha_under_mask), -1.37, -4.24, 3.21);
}

TEST_CASE("alpha times a fractal: the Graphics Synthesizer floors once", "[chip]") {
    // Alpha is never blended: it is in green, say, and 0x80 is one: ALPHA = Cd * As.
    Frame frame = chip_frame("ps2", TargetFormat::Psmct32, 256, 129);
    const TextureId stored =
        texture_of(frame, 256, 129, [](int x, int) { return static_cast<std::uint32_t>(x) * 0x010101; });
    const TextureId fractal =
        texture_of(frame, 256, 129, [](int, int y) { return static_cast<std::uint32_t>(y) << 24; });
    add_pass(frame, bound(stored));
    add_pass(frame, bound(fractal)).state.gs_blend = {
        .a = GsColor::Cd, .b = GsColor::Zero, .c = GsAlpha::As, .d = GsColor::Zero};
    const std::vector<std::uint32_t> pixels = pixels_on_both(frame);
    Errors errors;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        errors.add(channel(pixels[i], 8), static_cast<double>(i % 256) * static_cast<double>(i / 256) / 128.0);
    check(errors, -0.479, -127.0 / 128, 0.0, 0.0005);
}

TEST_CASE("the composite by alpha, on each chip", "[chip]") {
    const auto over = [](PipelineState& state) { state.blend = kAlphaOver; };
    for (const char* name : {"ideal", "dx7", "xbox"}) {
        INFO(name);
        check(composite(name, TargetFormat::A8R8G8B8, 255, 255.0, over), 0.0, -127.0 / 255, 127.0 / 255);
    }
    check(composite("gamecube", TargetFormat::X8R8G8B8, 255, 255.0, over), -0.489, -1.43, 0.43);
    const auto gs_over = [](PipelineState& state) {
        state.gs_blend = {.a = GsColor::Cs, .b = GsColor::Cd, .c = GsAlpha::As, .d = GsColor::Cd};
    };
    check(composite("ps2", TargetFormat::Psmct32, 128, 128.0, gs_over), -0.479, -127.0 / 128, 0.0);
}

TEST_CASE("one halving, on each chip", "[chip]") {
    check(halved_by_filter("ideal"), 0.125, -0.25, 0.5);  // half up, once
    check(halved_by_filter("dx7"), 0.125, -0.25, 0.5);
    check(halved_by_filter("xbox"), 0.5, 0.0, 1.0);           // half up, three times
    check(halved_by_filter("ps2"), -0.5, -1.0, 0.0);          // floored three times
    check(halved_by_filter("gamecube"), -0.375, -0.75, 0.0);  // floored once
    check(halved_by_copy(TargetFormat::X8R8G8B8), -0.375, -0.75, 0.0);
    check(halved_by_copy(TargetFormat::R6G6B6A6), -0.0235, -0.75, 0.75);  // gains the bits back
}

TEST_CASE("two ways to composite with alpha times a fractal on the Graphics Synthesizer", "[chip]") {
    constexpr int kWidth = 512, kHeight = 400;
    Random random(5);
    struct Sample {
        int background, color, alpha, fractal;
    };
    std::vector<Sample> samples;
    for (int i = 0; i < kWidth * kHeight; ++i)
        samples.push_back({random.from(0, 255), random.from(0, 255), random.from(0, 128), random.from(0, 128)});
    const auto at   = [&](int x, int y) { return samples[static_cast<std::size_t>(kWidth * y + x)]; };
    const auto argb = [](int alpha, int color) { return static_cast<std::uint32_t>(alpha << 24 | color * 0x010101); };
    const ColorMask no_alpha{.alpha = false}, alpha_only{.red = false, .green = false, .blue = false};
    const GsBlend over{.a = GsColor::Cs, .b = GsColor::Cd, .c = GsAlpha::As, .d = GsColor::Cd};

    const auto start = [&](Frame& frame) {
        const TextureId background =
            texture_of(frame, kWidth, kHeight, [&](int x, int y) { return argb(0, at(x, y).background); });
        add_pass(frame, bound(background));
    };
    const auto errors_of = [&](const Frame& frame) {
        const std::vector<std::uint32_t> pixels = execute(frame).output.pixels;
        Errors errors;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const auto& [background, color, alpha, fractal] = samples[i];
            errors.add(channel(pixels[i], 0), background + (color - background) * alpha * fractal / 16384.0);
        }
        return errors;
    };

    // The fractal into the frame's alpha; the cloud over it by its own alpha; then back toward the old frame by the fractal.
    Frame nested = chip_frame("ps2", TargetFormat::Psmct32, kWidth, kHeight);
    nested.targets.push_back({.name = "copy", .format = TargetFormat::Psmct32, .width = kWidth, .height = kHeight});
    start(nested);
    const TextureId fractal =
        texture_of(nested, kWidth, kHeight, [&](int x, int y) { return argb(at(x, y).fractal, 0); });
    const TextureId cloud =
        texture_of(nested, kWidth, kHeight, [&](int x, int y) { return argb(at(x, y).alpha, at(x, y).color); });
    add_pass(nested, bound(fractal)).state.color_mask      = alpha_only;
    add_pass(nested, {.texture = {}, .target = {0}}).color = {1};
    Pass& draw_cloud                                       = add_pass(nested, bound(cloud));
    draw_cloud.state.gs_blend                              = over;
    draw_cloud.state.color_mask                            = no_alpha;
    Pass& back                                             = add_pass(nested, {.texture = {}, .target = {1}});
    back.state.gs_blend        = {.a = GsColor::Cd, .b = GsColor::Cs, .c = GsAlpha::Ad, .d = GsColor::Cs};
    back.state.color_mask      = no_alpha;
    const Errors nested_errors = errors_of(nested);
    check(nested_errors, -0.71, -1.98, 0.0, 0.025);
    CHECK(nested_errors.rms() == Approx(0.80).margin(0.005));

    // The product of the two alphas, floored, as one alpha.
    Frame direct = chip_frame("ps2", TargetFormat::Psmct32, kWidth, kHeight);
    start(direct);
    const TextureId product                         = texture_of(direct, kWidth, kHeight, [&](int x, int y) {
        return argb(at(x, y).alpha * at(x, y).fractal >> 7, at(x, y).color);
    });
    add_pass(direct, bound(product)).state.gs_blend = over;
    const Errors direct_errors                      = errors_of(direct);
    check(direct_errors, -0.46, -2.8, 1.9, 0.06);
    CHECK(direct_errors.rms() == Approx(0.715).margin(0.005));
}
