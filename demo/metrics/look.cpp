// SPDX-License-Identifier: MIT
#include "demo/metrics/look.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>
#include <variant>
#include <vector>

#include "demo/metrics/measures.h"
#include "demo/metrics/statistics.h"

namespace demo {
namespace {

// Boxes of the size, of a grid that starts at (-x, -y), that hold a marked pixel.
int boxes(const Mask& mask, int size, int x, int y) {
    Mask hit(mask.width / size + 2, mask.height / size + 2);
    for (int py = 0; py < mask.height; ++py)
        for (int px = 0; px < mask.width; ++px)
            if (mask.at(px, py) != 0) hit.at((px + x) / size, (py + y) / size) = 1;
    return static_cast<int>(std::count(hit.values.begin(), hit.values.end(), 1));
}

double saturation(Vec3 color) {
    const float most = std::max({color.x, color.y, color.z}), least = std::min({color.x, color.y, color.z});
    return most > 0.0f ? static_cast<double>((most - least) / most) : 0.0;
}

// Gives each sphere of a pass a colour of its own: 1, 2, 3, ... Spheres are what triangles connect.
void number_spheres(pipeline::Frame& frame, pipeline::Pass& pass) {
    std::vector<std::uint32_t> parent(frame.vertices.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::uint32_t vertex) {
        while (parent[vertex] != vertex) vertex = parent[vertex] = parent[parent[vertex]];
        return vertex;
    };
    const auto& triangles = std::get<pipeline::DrawTriangles>(pass.draws.front());
    for (std::uint32_t i = 0; i < triangles.index_count; i += 3)
        for (std::uint32_t corner : {1u, 2u})
            parent[root(frame.indices[triangles.first_index + i + corner])] =
                root(frame.indices[triangles.first_index + i]);
    std::vector<std::uint32_t> number(frame.vertices.size(), 0);
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < triangles.index_count; ++i) {
        const std::uint32_t vertex = frame.indices[triangles.first_index + i];
        std::uint32_t& own         = number[root(vertex)];
        if (own == 0) own = ++count;
        frame.vertices[vertex].diffuse = {0xff000000 | own};
    }
    pass.state.fog      = {};
    pass.state.lighting = {};
}

// Where two spheres of the nearest cloud intersect, as seen without the scene.
Mask seams_of(Studio& studio) {
    const Anatomy& anatomy = studio.anatomy();
    Mask seams(anatomy.shape.width, anatomy.shape.height);
    pipeline::Frame frame = studio.frame({});
    remove_scene(frame);
    std::optional<FoundBlur> last;
    while (const std::optional<FoundBlur> blur = find_blur(frame, last ? last->end : 0)) last = blur;
    if (!last) return seams;
    const std::size_t spheres = last->first - 1;
    cut(frame, spheres + 1, frame.passes[spheres].color);
    number_spheres(frame, frame.passes[spheres]);
    const pipeline::ColorImage numbers = studio.picture(frame);
    const float gap_m                  = studio.clouds().front().baked.cloud.blur_m;
    const auto number                  = [&](int x, int y) {
        const std::uint32_t argb = numbers.pixels[seams.index(x, y)];
        return argb >> 24 == 255 ? argb & 0xffffff : 0;
    };
    for (int y = 0; y < seams.height; ++y)
        for (int x = 0; x < seams.width; ++x)
            for (const auto& [nx, ny] : {std::pair{x + 1, y}, std::pair{x, y + 1}})
                if (seams.has(nx, ny) && number(x, y) != 0 && number(nx, ny) != 0 && number(x, y) != number(nx, ny) &&
                    std::abs(anatomy.shape_m.at(x, y) - anatomy.shape_m.at(nx, ny)) <= gap_m)
                    seams.at(x, y) = seams.at(nx, ny) = 1;
    return seams;
}

}  // namespace

Mask contour_of(const Plane& plane, float level) {
    Mask contour(plane.width, plane.height);
    for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x) {
            if (!(plane.at(x, y) >= level)) continue;
            for (const auto& [dx, dy] : {std::pair{1, 0}, std::pair{-1, 0}, std::pair{0, 1}, std::pair{0, -1}})
                if (plane.has(x + dx, y + dy) && plane.at(x + dx, y + dy) < level) contour.at(x, y) = 1;
        }
    return contour;
}

std::optional<double> box_dimension(const Mask& mask) {
    if (std::count(mask.values.begin(), mask.values.end(), 1) < 64) return std::nullopt;
    std::vector<double> log_size, log_count;
    for (const int size : {2, 4, 8, 16, 32}) {
        double sum = 0.0;
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x) sum += boxes(mask, size, x * size / 4, y * size / 4);
        log_size.push_back(std::log(static_cast<double>(size)));
        log_count.push_back(std::log(sum / 16.0));
    }
    const double mean_size = mean(log_size), mean_count = mean(log_count);
    double both = 0.0, square = 0.0;
    for (std::size_t i = 0; i < log_size.size(); ++i) {
        both += (log_size[i] - mean_size) * (log_count[i] - mean_count);
        square += (log_size[i] - mean_size) * (log_size[i] - mean_size);
    }
    return -both / square;
}

std::optional<Tones> tones_of(const ColorPlane& picture, const Mask& where) {
    std::vector<std::pair<double, double>> pixels;  // luminance, saturation
    for (std::size_t i = 0; i < picture.values.size(); ++i)
        if (where.values[i] != 0)
            pixels.emplace_back(static_cast<double>(luminance(picture.values[i])), saturation(picture.values[i]));
    if (pixels.size() < 64) return std::nullopt;
    std::sort(pixels.begin(), pixels.end());
    const auto at = [&](double share) {
        return pixels[static_cast<std::size_t>(share * static_cast<double>(pixels.size() - 1))];
    };
    std::vector<double> dark, light;
    for (std::size_t i = 0; i < pixels.size() / 4; ++i) {
        dark.push_back(pixels[i].second);
        light.push_back(pixels[pixels.size() - 1 - i].second);
    }
    return Tones{at(0.95).first / std::max(at(0.05).first, 1.0 / 255.0), mean(dark), mean(light)};
}

std::optional<double> crease_index(const Plane& luminance, const Mask& seams, const Mask& where) {
    std::vector<double> at_seams, elsewhere;
    for (int y = 0; y < luminance.height; ++y)
        for (int x = 0; x < luminance.width; ++x)
            if (where.at(x, y) != 0)
                (seams.at(x, y) != 0 ? at_seams : elsewhere)
                    .push_back(static_cast<double>(glm::length(gradient(luminance, x, y))));
    if (at_seams.size() < 64 || !(mean(elsewhere) > 0.0)) return std::nullopt;
    return mean(at_seams) / mean(elsewhere);
}

Metrics measure_look(Studio& studio) {
    Metric dimension{
        "M10.dimension", "box-counting dimension of the outline, without the scene", "", {}, Target{1.2, 1.4}};
    Metric tone{"M10.tone", "luminance within: 95th percentile over 5th", "", {}, Target{1.6, 3.0}};
    Metric colored{"M10.shadow_saturation",
                   "saturation of the darkest quarter over that of the lightest",
                   "",
                   {},
                   Target{.low = 1.0}};
    Metric crease{
        "M10.crease", "slope of the luminance at the seams of spheres over that elsewhere", "", {}, at_most(1.2)};
    if (!studio.has_cloud()) return {dimension, tone, colored, crease};
    dimension.value          = box_dimension(contour_of(studio.coverage(studio.shot(), remove_scene), 0.5f));
    const Plane& coverage    = studio.plain_coverage();
    const ColorPlane picture = colors_of(studio.picture(studio.frame()));
    Mask within(coverage.width, coverage.height);
    for (std::size_t i = 0; i < within.values.size(); ++i) within.values[i] = coverage.values[i] > 0.98f;
    if (const std::optional<Tones> tones = tones_of(picture, within)) {
        tone.value = tones->tone;
        if (tones->saturation_light > 0.0) colored.value = tones->saturation_dark / tones->saturation_light;
    }
    crease.value = crease_index(luminance_of(picture), seams_of(studio), within);
    return {dimension, tone, colored, crease};
}

}  // namespace demo
