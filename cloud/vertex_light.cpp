// SPDX-License-Identifier: MIT
#include "cloud/vertex_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "cloud/particle_mesh.h"

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

// As much of the sun as the floor says, in the colour of the sky, which is all that shadows see: they go blue and not
// grey.
Vec3 scattered_light(const Daylight& light) {
    const float sun = light.sun.x + light.sun.y + light.sun.z, sky = light.sky.x + light.sky.y + light.sky.z;
    return sky > 0.0f ? light.sky * (kScatteredFloor * sun / sky) : light.sun * kScatteredFloor;
}

// What a ray meets: all particles, above the base.
class Shadows {
  public:
    explicit Shadows(const Cloud& cloud) : base_y_(cloud.base_y) {
        float core_radius = 0.0f;
        for (const Particle& particle : cloud.particles) {
            spheres_.push_back(Vec4(particle.center, particle.radius * particle.radius));
            core_radius = std::max(core_radius, particle.radius);
        }
        // Behind a core's diameter 0.15 + 0.85 exp(-2.14) = 1/4 is left.
        per_metre_ = core_radius > 0.0f ? 2.14f * std::max(cloud.absorption, 0.0f) / (2.0f * core_radius) : 0.0f;
    }

    // Of the light from afar that travels against `direction`, the share that reaches `point`.
    float transmittance(Vec3 point, Vec3 direction, float density) const {
        float base = 1e30f;  // where the ray leaves the cloud through its base
        if (direction.y < 0.0f) base = std::max(base_y_ - point.y, -1e30f) / direction.y;
        base         = std::max(base, 0.0f);
        float metres = 0.0f;
        for (const Vec4& sphere : spheres_) {
            const Vec3 to_center     = Vec3(sphere) - point;
            const float along        = glm::dot(to_center, direction);
            const float half_chord_2 = along * along - glm::dot(to_center, to_center) + sphere.w;
            if (half_chord_2 <= 0.0f) continue;
            const float half_chord = std::sqrt(half_chord_2);
            const float leaves     = std::min(along + half_chord, base);
            const float enters     = std::max(along - half_chord, 0.0f);
            if (leaves > enters) metres += leaves - enters;
        }
        return exp_of_minus(metres * per_metre_ * density);
    }

  private:
    std::vector<Vec4> spheres_;  // centre, radius squared
    float base_y_    = 0.0f;
    float per_metre_ = 0.0f;
};

float ambient_occlusion(const Shadows& shadows, Vec3 point, Vec3 normal) {
    static const std::array<Vec3, kDirections> directions = occlusion_directions();
    float sum = 0.0f, weights = 0.0f;
    for (const Vec3& direction : directions) {
        const float weight = glm::dot(direction, normal);
        if (weight <= 0.0f) continue;
        sum += weight * shadows.transmittance(point, direction, 0.5f);
        weights += weight;
    }
    return with_floor(weights > 0.0f ? sum / weights : 1.0f);
}

// 1, falling to 3/4 where the point is half a radius deep in another particle.
float buried_darkening(const Cloud& cloud, std::size_t own, Vec3 point) {
    float deepest = 0.0f;
    for (std::size_t j = 0; j < cloud.particles.size(); ++j) {
        if (j == own) continue;
        const Particle& other = cloud.particles[j];
        deepest               = std::max(deepest, other.radius - glm::length(point - other.center));
    }
    return 1.0f - 0.25f * std::min(deepest / (0.5f * cloud.particles[own].radius), 1.0f);
}

}  // namespace

float exp_of_minus(float x) {
    if (!(x < 40.0f)) return 0.0f;
    // exp(-x) = 1 / exp(x / 64)^64; the series of degree 9 misses exp(0.625) by less than 3e-9.
    const double a = static_cast<double>(x) / 64.0;
    double e       = 1.0 + a / 9.0;
    for (int n = 8; n >= 1; --n) e = 1.0 + a / n * e;
    for (int i = 0; i < 6; ++i) e *= e;
    return static_cast<float>(1.0 / e);
}

LitParticles light_particles(const Cloud& cloud, const Daylight& light) {
    const Vec3 scattered = scattered_light(light);
    const Shadows shadows(cloud);
    const Icosphere& sphere = icosphere();
    const std::size_t count = sphere.directions.size();
    LitParticles lit;
    lit.vertices.reserve(cloud.particles.size() * count);
    lit.low = Vec3(1e30f), lit.high = Vec3(-1e30f);
    glm::dvec3 color_sum(0.0);
    std::vector<float> open(count);
    for (std::size_t i = 0; i < cloud.particles.size(); ++i) {
        const Particle& particle = cloud.particles[i];
        const ParticleMesh mesh  = shape_particle(cloud, i);
        for (std::size_t v = 0; v < count; ++v) {
            // Shadows are those of the smooth spheres: from the bottom of a dent every ray would start inside its own.
            const Vec3 surface = squash(particle.center + sphere.directions[v] * particle.radius, cloud.base_y);
            const Vec3 normal  = mesh.normals[v];
            if (v < icosphere_vertices(kOcclusionLevel))
                open[v] = ambient_occlusion(shadows, surface, normal) * buried_darkening(cloud, i, surface);
            else
                open[v] = 0.5f * (open[sphere.parents[v][0]] + open[sphere.parents[v][1]]);
            const float direct = shadows.transmittance(surface, light.to_sun, 1.0f);
            const float wrap   = 0.5f + 0.5f * glm::dot(normal, light.to_sun);
            const float up     = 0.5f + 0.5f * normal.y;
            const float relief = 1.0f + kLumpContrast * mesh.lumps[v];
            Vec3 color         = scattered + light.sun * ((1.0f - kScatteredFloor) * direct * wrap) +
                         light.sky * (open[v] * up) + light.bounce * (open[v] * (1.0f - up));
            color *= relief;
            const float brightest = std::max({color.x, color.y, color.z});
            if (brightest > kBrightest) color *= kBrightest / brightest;
            color = glm::max(color, Vec3(0.0f));
            lit.vertices.push_back({mesh.positions[v], normal, color, 0.5f * (with_floor(direct) + open[v])});
            lit.low  = glm::min(lit.low, mesh.positions[v]);
            lit.high = glm::max(lit.high, mesh.positions[v]);
            color_sum += glm::dvec3(color * particle.color);
        }
    }
    if (!lit.vertices.empty()) lit.mean_color = Vec3(color_sum / static_cast<double>(lit.vertices.size()));
    return lit;
}

}  // namespace cloud
