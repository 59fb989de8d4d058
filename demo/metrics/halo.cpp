// SPDX-License-Identifier: MIT
#include "demo/metrics/halo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <string>
#include <vector>

#include "demo/metrics/blits.h"
#include "demo/metrics/measures.h"
#include "demo/metrics/statistics.h"

namespace demo {
namespace {

// The blurred cloud's colour, not mixed with any other: the spheres' colour and alpha, blurred as the frame does but
// in double, and divided.
ColorPlane cloud_colors(Studio& studio, const pipeline::Frame& frame, const FoundBlur& blur) {
    pipeline::ColorImage spheres;
    studio.run(frame, [&](const pipeline::FinishedPass& pass) {
        if (pass.index + 1 == blur.first) spheres = pass.read_color();
    });
    const std::span<const pipeline::Pass> blits(frame.passes.data() + blur.first, blur.end - blur.first);
    const pipeline::PixelRect area = frame.passes[blur.first - 1].state.scissor;
    const auto image               = static_cast<std::size_t>(blur.image.index);
    const auto blurred             = [&](auto&& value_of) {
        std::vector<DeepPlane> images = empty_images(frame);
        for (int y = area.y0; y < std::min(area.y1, spheres.height); ++y)
            for (int x = area.x0; x < std::min(area.x1, spheres.width); ++x)
                images[image].at(x, y) = value_of(spheres.pixels[images[image].index(x, y)]);
        blit_all(frame, blits, images);
        return images[image];
    };
    const DeepPlane alpha = blurred([](std::uint32_t argb) { return (argb >> 24) / 255.0; });
    ColorPlane colors(spheres.width, spheres.height);
    for (int channel = 0; channel < 3; ++channel) {
        const DeepPlane weighted = blurred(
            [&](std::uint32_t argb) { return (argb >> 24) / 255.0 * ((argb >> (16 - 8 * channel) & 255) / 255.0); });
        for (std::size_t i = 0; i < colors.values.size(); ++i)
            colors.values[i][channel] = static_cast<float>(weighted.values[i] / std::max(alpha.values[i], 1e-6));
    }
    return colors;
}

struct NamedMode {
    const char* name;
    cloud::Mode mode;
};
constexpr std::array kModes{NamedMode{"skirt", cloud::Mode::Skirt}, NamedMode{"article", cloud::Mode::Article},
                            NamedMode{"premultiplied", cloud::Mode::Premultiplied},
                            NamedMode{"black", cloud::Mode::Black}};

}  // namespace

Halo halo(const ColorPlane& picture, const ColorPlane& scene, const ColorPlane& cloud, const Plane& coverage,
          const Mask& where) {
    std::vector<double> distances, errors;
    for (std::size_t i = 0; i < picture.values.size(); ++i) {
        if (where.values[i] == 0) continue;
        const Vec3 from = scene.values[i], along = cloud.values[i] - from, here = picture.values[i] - from;
        const float length2 = glm::dot(along, along);
        const float place   = length2 > 0.0f ? std::clamp(glm::dot(here, along) / length2, 0.0f, 1.0f) : 0.0f;
        distances.push_back(static_cast<double>(glm::length(here - along * place)));
        errors.push_back(static_cast<double>(luminance(here - along * coverage.values[i])));
    }
    return {mean(distances), mean(errors)};
}

Metrics measure_halo(Studio& studio) {
    Metrics metrics;
    for (const NamedMode& mode : kModes) {
        const std::string name = mode.name;
        const bool is_exact    = mode.mode == cloud::Mode::Skirt || mode.mode == cloud::Mode::Premultiplied;
        metrics.push_back({"M7." + name,
                           "the rim's distance from a mix of cloud and scene, " + name + " mode",
                           "/255",
                           {},
                           is_exact ? std::optional(at_most(2.0)) : std::nullopt});
        metrics.push_back({"M7." + name + "_light", "how much lighter than the mix", "/255", {}, {}});
    }
    // With more of them, one cloud would be the other's scene.
    if (!studio.is_mega() || studio.clouds().size() != 1) return metrics;
    FrameOptions options   = studio.shot();
    options.has_clouds     = false;
    const ColorPlane scene = colors_of(studio.picture(studio.frame(options)));
    options                = studio.shot();
    options.has_detail     = false;
    for (std::size_t i = 0; i < kModes.size(); ++i) {
        // Without the fractal, which each mode stores differently, nothing has to be made anew for another mode.
        studio.edit().clouds.front().baked.cloud.mode = kModes[i].mode;
        const pipeline::Frame frame                   = studio.frame(options);
        const std::optional<FoundBlur> blur           = find_blur(frame);
        const cloud::Cloud& cloud                     = studio.clouds().front().baked.cloud;
        if (!blur || cloud.tint) break;
        const Plane coverage = studio.coverage(options);
        const Halo found = halo(colors_of(studio.picture(frame)), scene, cloud_colors(studio, frame, *blur), coverage,
                                rim_of(coverage));
        metrics[2 * i].value     = 255.0 * found.distance;
        metrics[2 * i + 1].value = 255.0 * found.luminance_error;
    }
    studio.restore();
    return metrics;
}

}  // namespace demo
