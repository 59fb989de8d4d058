// SPDX-License-Identifier: MIT
#include "demo/metrics/interference.h"

#include <algorithm>

#include "cloud/bounds.h"
#include "cloud/merge.h"
#include "demo/metrics/measures.h"
#include "demo/metrics/statistics.h"

#include <glm/geometric.hpp>

namespace demo {
namespace {

// Farthest first, by the nearest particle.
std::vector<std::size_t> drawing_order(const Studio& studio) {
    std::vector<float> nearest;
    for (const SceneCloud& cloud : studio.clouds()) {
        float least = 1e30f;
        for (const cloud::Particle& particle : cloud.baked.cloud.particles)
            least = std::min(least, glm::length(particle.center - studio.eye()) - cloud::greatest_radius(particle));
        nearest.push_back(least);
    }
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < nearest.size(); ++i) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return nearest[a] > nearest[b]; });
    return order;
}

// Those that reach into each other are drawn as one cloud, or as layers that share the depth buffer: there is no picture
// of one by itself to compare with.
bool are_apart(const std::vector<SceneCloud>& clouds) {
    for (std::size_t i = 0; i < clouds.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (cloud::touch(clouds[i].baked, clouds[j].baked)) return false;
    return true;
}

}  // namespace

void lay_over(ColorPlane& picture, const Layer& layer) {
    for (std::size_t i = 0; i < picture.values.size(); ++i)
        picture.values[i] = layer.over_black.values[i] + (1.0f - layer.coverage.values[i]) * picture.values[i];
}

Mask overlaps_of(const std::vector<Layer>& layers) {
    Mask overlaps = layers.empty() ? Mask() : Mask(layers[0].coverage.width, layers[0].coverage.height);
    for (std::size_t i = 0; i < overlaps.values.size(); ++i)
        overlaps.values[i] = std::count_if(layers.begin(), layers.end(),
                                           [&](const Layer& layer) { return layer.coverage.values[i] > 0.02f; }) >= 2;
    return overlaps;
}

double color_rms(const ColorPlane& a, const ColorPlane& b, const Mask& where) {
    std::vector<double> differences;
    for (std::size_t i = 0; i < a.values.size(); ++i)
        for (int channel = 0; channel < 3 && where.values[i] != 0; ++channel)
            differences.push_back(static_cast<double>(a.values[i][channel] - b.values[i][channel]));
    return rms(differences);
}

Metrics measure_interference(Studio& studio) {
    Metric error{
        "M9.error", "picture against clouds drawn one by one, where they overlap (RMS)", "/255", {}, at_most(3.0)};
    Metric shuffled{
        "M9.shuffled", "pixels that change when the clouds are listed in another order", "", {}, at_most(0.0)};
    if (studio.clouds().size() < 2) return {error, shuffled};
    const bool apart     = are_apart(studio.clouds());
    FrameOptions options = studio.shot();
    options.has_clouds   = false;
    ColorPlane composite = colors_of(studio.picture(studio.frame(options)));
    std::vector<Layer> layers;
    for (const std::size_t cloud : drawing_order(studio)) {
        options                          = studio.shot();
        options.only_cloud               = cloud;
        options.flat_scene               = Vec3(0.0f);
        const pipeline::ColorImage black = studio.picture(studio.frame(options));
        options.flat_scene               = Vec3(1.0f);
        layers.push_back({colors_of(black), coverage_of(studio.picture(studio.frame(options)), black)});
        lay_over(composite, layers.back());
    }
    const pipeline::ColorImage picture = studio.picture(studio.frame());
    const Mask overlaps                = overlaps_of(layers);
    if (apart && std::find(overlaps.values.begin(), overlaps.values.end(), 1) != overlaps.values.end())
        error.value = 255.0 * color_rms(colors_of(picture), composite, overlaps);

    std::reverse(studio.edit().clouds.begin(), studio.edit().clouds.end());
    const pipeline::ColorImage again = studio.picture(studio.frame());
    studio.restore();
    int changed = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) changed += picture.pixels[i] != again.pixels[i];
    shuffled.value = changed;
    return {error, shuffled};
}

}  // namespace demo
