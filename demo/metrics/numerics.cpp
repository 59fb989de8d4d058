// SPDX-License-Identifier: MIT
#include "demo/metrics/numerics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <variant>

#include "cloud/mega_particles/blur.h"
#include "demo/metrics/blits.h"
#include "demo/metrics/measures.h"
#include "demo/metrics/statistics.h"

namespace demo {
namespace {

using pipeline::ColorImage;
using pipeline::Frame;

// Numerical Recipes' generator: for patterns, not for chance.
std::uint32_t next(std::uint32_t& state) {
    state = state * 1664525u + 1013904223u;
    return state >> 8;
}

DeepPlane channel_plane(const ColorImage& image, int channel) {
    DeepPlane plane(image.width, image.height);
    for (std::size_t i = 0; i < plane.values.size(); ++i) plane.values[i] = channel_of(image.pixels[i], channel);
    return plane;
}

std::size_t source_of(const pipeline::Pass& pass) {
    return static_cast<std::size_t>(std::get<pipeline::DrawRectangle>(pass.draws.front()).textures[0].target.index);
}

ColorImage one_color(int width, int height, std::uint32_t argb) {
    ColorImage image{.width = width, .height = height, .pixels = {}};
    image.pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), argb);
    return image;
}

}  // namespace

int channel_of(std::uint32_t argb, int channel) {
    return static_cast<int>(argb >> (8 * channel) & 255);
}

ColorImage noise_picture(int width, int height) {
    ColorImage image    = one_color(width, height, 0);
    std::uint32_t state = 1;
    for (std::uint32_t& pixel : image.pixels) pixel = next(state) << 16 ^ next(state);
    return image;
}

Frame blurred_picture(const cloud::BlurPlan& plan, const ColorImage& picture) {
    Frame frame;
    frame.output = {0};
    cloud::CloudTargets targets;
    targets.width     = cloud::round_up(picture.width, 1 << cloud::kMaxBlurLevels);
    targets.height    = cloud::round_up(picture.height, 1 << cloud::kMaxBlurLevels);
    targets.particles = {0};
    frame.targets.push_back({.name = "picture", .width = picture.width, .height = picture.height});
    targets.front.resize(1), targets.back.resize(1);
    for (int level = 1; level <= plan.levels; ++level)
        for (auto* chain : {&targets.front, &targets.back}) {
            chain->push_back({static_cast<std::int32_t>(frame.targets.size())});
            frame.targets.push_back(
                {.name = "level", .width = targets.width >> level, .height = targets.height >> level});
        }
    pipeline::Texture texture{.name = "picture", .width = picture.width, .height = picture.height, .texels = {}};
    for (const std::uint32_t pixel : picture.pixels)
        for (int channel = 0; channel < 4; ++channel)
            texture.texels.push_back(static_cast<std::uint8_t>(channel_of(pixel, channel)));
    frame.textures.push_back(std::move(texture));
    pipeline::Pass& pass = frame.passes.emplace_back();
    pass.label           = "picture";
    pass.color           = {0};
    cloud::show_texture(pass.state, pipeline::TextureFilter::Point);
    pipeline::DrawRectangle all;
    all.x1                  = static_cast<float>(picture.width);
    all.y1                  = static_cast<float>(picture.height);
    all.textures[0].texture = {0};
    pass.draws              = {all};

    const cloud::SceneTargets scene;
    const cloud::View view{.width = picture.width, .height = picture.height};
    const cloud::BakedCloud baked;
    const pipeline::PixelRect area{0, 0, targets.width, targets.height};
    cloud::append_blur({frame, scene, view, baked, targets, plan, area, area, {}});
    return frame;
}

int change_of_constant(const cloud::BlurPlan& plan, int width, int height, int value) {
    const auto byte = static_cast<std::uint32_t>(value);
    const ColorImage blurred =
        pipeline::execute(blurred_picture(plan, one_color(width, height, byte * 0x01010101u))).output;
    int worst = 0;
    for (const std::uint32_t pixel : blurred.pixels)
        for (int channel = 0; channel < 4; ++channel)
            worst = std::max(worst, std::abs(channel_of(pixel, channel) - value));
    return worst;
}

BlurErrors blur_errors(const cloud::BlurPlan& plan, const ColorImage& picture) {
    const Frame frame            = blurred_picture(plan, picture);
    // What each target holds, and what it would hold without rounding; of one channel, they are all alike.
    constexpr int kChannel       = 1;
    std::vector<DeepPlane> bytes = empty_images(frame), exact = bytes;
    BlurErrors errors;
    std::vector<double> all;
    std::size_t blits = 0;
    pipeline::execute(frame, {}, [&](const pipeline::FinishedPass& finished) {
        const auto to         = static_cast<std::size_t>(finished.pass.color.index);
        const DeepPlane drawn = channel_plane(finished.read_color(), kChannel);
        if (finished.index == 0) {
            exact[to] = drawn;
        } else {
            ++blits;
            DeepPlane expected = bytes[to];
            blit(finished.pass, bytes[source_of(finished.pass)], expected);
            blit(finished.pass, exact[source_of(finished.pass)], exact[to]);
            for (std::size_t i = 0; i < drawn.values.size(); ++i) {
                all.push_back(drawn.values[i] - expected.values[i]);
                errors.worst = std::max(errors.worst, std::abs(all.back()));
            }
        }
        bytes[to] = drawn;
    });
    std::vector<double> differences;
    for (std::size_t i = 0; i < bytes[0].values.size(); ++i)
        differences.push_back(bytes[0].values[i] - exact[0].values[i]);
    errors.rms   = rms(all);
    errors.drift = std::abs(mean(differences)) / static_cast<double>(blits);
    return errors;
}

double blend_drift(int count) {
    constexpr int kColumns = 256;
    Frame frame;
    frame.output = {0};
    frame.targets.push_back({.name = "picture", .width = kColumns, .height = 1});
    pipeline::Pass& pass = frame.passes.emplace_back();
    pass.color           = {0};
    pass.clear.color     = pipeline::Argb{0xff000000};
    pass.state.blend     = pipeline::kAlphaOver;
    std::vector<std::array<double, 3>> exact(kColumns);
    std::uint32_t state = 7;
    for (int layer = 0; layer < count; ++layer)
        for (int x = 0; x < kColumns; ++x) {
            pipeline::DrawRectangle rectangle;
            rectangle.x0 = static_cast<float>(x), rectangle.x1 = static_cast<float>(x + 1), rectangle.y1 = 1.0f;
            rectangle.color    = {next(state) << 16 ^ next(state)};
            const double alpha = channel_of(rectangle.color.value, 3) / 255.0;
            for (int channel = 0; channel < 3; ++channel) {
                double& under = exact[static_cast<std::size_t>(x)][static_cast<std::size_t>(channel)];
                under         = channel_of(rectangle.color.value, channel) * alpha + under * (1.0 - alpha);
            }
            pass.draws.emplace_back(rectangle);
        }
    const ColorImage image = pipeline::execute(frame).output;
    double worst           = 0.0;
    for (std::size_t x = 0; x < exact.size(); ++x)
        for (int channel = 0; channel < 3; ++channel)
            worst = std::max(
                worst, std::abs(channel_of(image.pixels[x], channel) - exact[x][static_cast<std::size_t>(channel)]));
    return worst / count;
}

Metrics measure_numerics(Studio& studio) {
    Metric constants{
        "M0.constants", "change of 0, 1, 127, 254, 255 by blurs of 1 to 5 levels", "/255", {}, at_most(0.0)};
    Metric extremes{
        "M0.extreme_blurs", "the same for blurs below a pixel and wider than the picture", "/255", {}, at_most(0.0)};
    Metric worst{"M0.pass_error", "a blit's byte against double precision (worst)", "/255", {}, at_most(0.5 + 1e-3)};
    Metric error{"M0.pass_rms", "the same (RMS)", "/255"};
    Metric drift{"M0.blur_drift", "mean drift of the whole blur, for each blit", "/255", {}, at_most(0.5)};
    Metric blends{"M0.blend_drift", "drift of 16 blends over each other, for each (worst)", "/255", {}, at_most(0.5)};
    Metric inside{"M0.inside", "scene that shows with the eye at a sphere's centre (mean)", "/255", {}, at_most(1.0)};
    Metric range{"M0.depth_range",
                 "change of the coverage with near:far at 1:10^6 (RMS over the rim)",
                 "/255",
                 {},
                 at_most(1.0)};

    int changed = 0, changed_extremes = 0;
    for (const int value : {0, 1, 127, 254, 255}) {
        for (int levels = 1; levels <= cloud::kMaxBlurLevels; ++levels)
            for (const bool tents : {false, true}) {
                const cloud::BlurPlan plan{.levels = levels, .inner_tents = tents, .bottom_tents = tents ? 1 : 0};
                changed = std::max(changed, change_of_constant(plan, 96, 64, value));
            }
        for (const float sigma : {0.0f, 0.2f, 1e6f})
            changed_extremes = std::max(changed_extremes,
                                        change_of_constant(cloud::plan_blur(cloud::Mode::Skirt, sigma), 17, 9, value));
    }
    constants.value = changed;
    extremes.value  = changed_extremes;
    const BlurErrors errors =
        blur_errors({.levels = 3, .inner_tents = true, .bottom_tents = 1}, noise_picture(160, 96));
    worst.value  = errors.worst;
    error.value  = errors.rms;
    drift.value  = errors.drift;
    blends.value = blend_drift(16);

    if (studio.has_cloud()) {
        const Vec3 eye = studio.eye(), target = studio.target();
        const Vec3 center = studio.greatest_particle().center;
        studio.look_from(center, center + (target - eye));
        std::vector<double> through;
        for (const float covered : studio.coverage().values) through.push_back(1.0 - static_cast<double>(covered));
        inside.value = 255.0 * mean(through);
        studio.look_from(eye, target);

        CameraPath& camera = studio.edit().description.camera;
        const double far_m = camera.far_m;
        camera.far_m       = 1e6 * camera.near_m;
        const Plane far    = studio.coverage();
        camera.far_m       = far_m;
        std::vector<double> differences;
        const Plane& near = studio.plain_coverage();
        const Mask rim    = rim_of(near);
        for (std::size_t i = 0; i < near.values.size(); ++i)
            if (rim.values[i] != 0) differences.push_back(static_cast<double>(far.values[i] - near.values[i]));
        range.value = 255.0 * rms(differences);
    }
    return {constants, extremes, worst, error, drift, blends, inside, range};
}

}  // namespace demo
