// SPDX-License-Identifier: MIT
#include "cloud/vertex_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>
#include <numeric>
#include <span>

#include "cloud/particle_mesh.h"
#include "cloud/shadows.h"

namespace cloud {
namespace {

constexpr float kScatteredFloor = 0.15f;  // light that was scattered many times arrives everywhere
constexpr float kBrightest      = 0.95f;
constexpr float kLumpContrast   = 0.12f;
constexpr int kOcclusionLevel   = 2;  // finer vertices take the mean of the ends of their edge: occlusion is smooth
constexpr int kDirections       = 16;

// Rows of a spiral from pole to pole, each a golden angle on.
std::array<Vec3, kDirections> occlusion_directions() {
    std::array<Vec3, kDirections> directions;
    float x = 1.0f, z = 0.0f;
    for (int i = 0; i < kDirections; ++i) {
        const float y                           = 1.0f - (2.0f * static_cast<float>(i) + 1.0f) / kDirections;
        const float level                       = std::sqrt(1.0f - y * y);
        directions[static_cast<std::size_t>(i)] = Vec3(x * level, y, z * level);
        const float turned                      = x * -0.73736888f - z * 0.67549029f;
        z                                       = z * -0.73736888f + x * 0.67549029f;
        x                                       = turned;
    }
    return directions;
}

float with_floor(float share) {
    return kScatteredFloor + (1.0f - kScatteredFloor) * share;
}

// 1, falling to 3/4 where the point is half a radius deep in another particle.
float buried_darkening(float deep, float own_radius) {
    return 1.0f - 0.25f * std::min(deep / (0.5f * own_radius), 1.0f);
}

// As much of the sun as the floor says, in the colour of the sky, which is all that shadows see: they go blue and not
// grey.
Vec3 scattered_light(const Daylight& light) {
    const float sun = light.sun.x + light.sun.y + light.sun.z, sky = light.sky.x + light.sky.y + light.sky.z;
    return sky > 0.0f ? light.sky * (kScatteredFloor * sun / sky) : light.sun * kScatteredFloor;
}

// Of the coarser vertices.
using Openness = std::array<float, icosphere_vertices(kOcclusionLevel)>;

// Such an order that few in a row lie close together: halves of halves, each cut across its longest side.
std::vector<std::uint32_t> neighbors_in_a_row(std::size_t vertices) {
    std::vector<std::uint32_t> order(vertices);
    std::iota(order.begin(), order.end(), 0u);
    const std::vector<Vec3>& directions = icosphere().directions;
    const auto cut                      = [&](auto&& self, std::span<std::uint32_t> part) -> void {
        if (part.size() <= Rays::kTogether) return;
        Vec3 low(1.0f), high(-1.0f);
        for (const std::uint32_t v : part) low = glm::min(low, directions[v]), high = glm::max(high, directions[v]);
        const Vec3 size        = high - low;
        const int axis         = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::size_t half = (part.size() / 2 + Rays::kTogether - 1) / Rays::kTogether * Rays::kTogether;
        std::nth_element(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(half), part.end(),
                                              [&](std::uint32_t a, std::uint32_t b) { return directions[a][axis] < directions[b][axis]; });
        self(self, part.first(half));
        self(self, part.subspan(half));
    };
    cut(cut, order);
    return order;
}

// A particle's surface, whose points are within `radius` of `center`.
struct Surface {
    std::vector<Vec3> points;
    Vec3 center;
    float radius = 0.0f;
};

Openness ambient_occlusion(const Shadows& shadows, const Surface& surface, std::span<const Vec3> normals, Rays& rays) {
    static const std::array<Vec3, kDirections> directions = occlusion_directions();
    static const std::vector<std::uint32_t> order         = neighbors_in_a_row(icosphere_vertices(kOcclusionLevel));
    // In that order.
    Openness x, y, z, facing, sums{}, weights{}, open;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Vec3& normal = normals[order[i]];
        x[i] = normal.x, y[i] = normal.y, z[i] = normal.z;
    }
    std::array<std::size_t, open.size()> places;
    for (const Vec3& d : directions) {
        for (std::size_t i = 0; i < open.size(); ++i) facing[i] = d.x * x[i] + d.y * y[i] + d.z * z[i];
        rays.clear();
        for (std::size_t i = 0; i < open.size(); ++i)
            if (facing[i] > 0.0f) {
                places[rays.count()] = i;
                rays.add(surface.points[order[i]]);
            }
        shadows.trace(rays, d, 0.5f, surface.center, surface.radius);
        for (std::size_t ray = 0; ray < rays.count(); ++ray) {
            const std::size_t i = places[ray];
            sums[i] += facing[i] * rays.share(ray);
            weights[i] += facing[i];
        }
    }
    for (std::size_t i = 0; i < open.size(); ++i)
        open[order[i]] = with_floor(weights[i] > 0.0f ? sums[i] / weights[i] : 1.0f);
    return open;
}

// All vertices of one particle.
void light_particle(const Cloud& cloud, const Daylight& light, const Shadows& shadows, std::size_t own,
                    std::span<LitVertex> vertices) {
    const Vec3 scattered     = scattered_light(light);
    const Icosphere& sphere  = icosphere();
    const Particle& particle = cloud.particles[own];
    const ParticleMesh mesh  = shape_particle(cloud, own);
    // Shadows are those of the smooth spheres: from the bottom of a dent every ray would start inside its own.
    Surface surface{.points = {}, .center = particle.center};
    surface.points.reserve(sphere.directions.size());
    for (const Vec3& direction : sphere.directions) {
        const Vec3 point = squash(particle.center + particle.shape * (direction * particle.radius), cloud.base_y);
        surface.points.push_back(point);
        surface.radius = std::max(surface.radius, 1.001f * glm::length(point - particle.center));
    }
    static const std::vector<std::uint32_t> order = neighbors_in_a_row(sphere.directions.size());
    Rays rays;
    for (const std::uint32_t v : order) rays.add(surface.points[v]);
    shadows.trace(rays, light.to_sun, 1.0f, surface.center, surface.radius);
    std::vector<float> sun(surface.points.size());
    for (std::size_t i = 0; i < order.size(); ++i) sun[order[i]] = rays.share(i);
    const Openness coarse_open = ambient_occlusion(shadows, surface, mesh.normals, rays);
    Openness deepest;
    std::vector<std::uint32_t> touching = shadows.touching(surface.center, surface.radius);
    std::erase(touching, static_cast<std::uint32_t>(own));
    shadows.depths(std::span(surface.points).first(deepest.size()), touching, deepest);
    std::vector<float> open(surface.points.size());
    for (std::size_t v = 0; v < surface.points.size(); ++v) {
        const Vec3 normal = mesh.normals[v];
        if (v < coarse_open.size())
            open[v] = coarse_open[v] * buried_darkening(deepest[v], particle.radius);
        else
            open[v] = 0.5f * (open[sphere.parents[v][0]] + open[sphere.parents[v][1]]);
        const float direct = sun[v];
        const float wrap   = 0.5f + 0.5f * glm::dot(normal, light.to_sun);
        const float up     = 0.5f + 0.5f * normal.y;
        const float relief = 1.0f + kLumpContrast * mesh.lumps[v];
        Vec3 color = scattered + light.sun * ((1.0f - kScatteredFloor) * direct * wrap) + light.sky * (open[v] * up) +
                     light.bounce * (open[v] * (1.0f - up));
        color *= relief;
        const float brightest = std::max({color.x, color.y, color.z});
        if (brightest > kBrightest) color *= kBrightest / brightest;
        color       = glm::max(color, Vec3(0.0f));
        vertices[v] = {mesh.positions[v], normal, color, 0.5f * (with_floor(direct) + open[v]), direct};
    }
}

}  // namespace

LitVertices::LitVertices(std::vector<LitVertex> vertices) {
    if (!vertices.empty()) parts_ = {{0, std::make_shared<std::vector<LitVertex>>(std::move(vertices))}};
}

const LitVertices::Part& LitVertices::part_of(std::size_t i) const {
    return *std::prev(std::upper_bound(parts_.begin(), parts_.end(), i,
                                       [](std::size_t at, const Part& part) { return at < part.first; }));
}

std::vector<LitVertex> LitVertices::all() const {
    std::vector<LitVertex> vertices;
    vertices.reserve(size());
    for (const Part& part : parts_) vertices.insert(vertices.end(), part.vertices->begin(), part.vertices->end());
    return vertices;
}

void LitVertices::append(const LitVertices& others) {
    const std::size_t before = size();
    for (const Part& part : std::vector<Part>(others.parts_)) parts_.push_back({before + part.first, part.vertices});
}

std::vector<LitVertex>& LitVertices::edit() {
    if (parts_.size() != 1 || parts_[0].vertices.use_count() > 1)
        parts_ = {{0, std::make_shared<std::vector<LitVertex>>(all())}};
    return *parts_[0].vertices;
}

LitParticles light_particles(const Cloud& cloud, const Daylight& light, const ForEach& for_each) {
    const Shadows shadows(cloud);
    const std::size_t count = icosphere().directions.size();
    std::vector<LitVertex> vertices(cloud.particles.size() * count);
    for_each(cloud.particles.size(), [&](std::size_t i) {
        light_particle(cloud, light, shadows, i, std::span(vertices).subspan(i * count, count));
    });
    LitParticles lit;
    // Sums in the vertices' order, whatever order they were made in.
    lit.low = Vec3(1e30f), lit.high = Vec3(-1e30f);
    glm::dvec3 color_sum(0.0);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const LitVertex& vertex  = vertices[i];
        lit.low                  = glm::min(lit.low, vertex.position);
        lit.high                 = glm::max(lit.high, vertex.position);
        const Particle& particle = cloud.particles[i / count];
        color_sum += glm::dvec3(vertex.light * particle.color + particle.glow);
    }
    if (!vertices.empty()) lit.mean_color = Vec3(color_sum / static_cast<double>(vertices.size()));
    lit.vertices = LitVertices(std::move(vertices));
    return lit;
}

}  // namespace cloud
