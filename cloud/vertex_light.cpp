// SPDX-License-Identifier: MIT
#include "cloud/vertex_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <span>

#include "cloud/bounds.h"
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

// Rays that leave a particle's surface in one direction. Coordinate by coordinate, so that several are computed at once.
struct Rays {
    static constexpr std::size_t kMost = icosphere_vertices(kFinestLevel);
    using Values                       = std::array<float, kMost>;
    std::size_t count                  = 0;
    Values x, y, z;  // where they start
    Values base;     // metres to where they leave the cloud through its base
    Values metres;   // inside particles
    Values share;    // of light from afar that arrives against their direction

    void add(Vec3 start) {
        x[count] = start.x, y[count] = start.y, z[count] = start.z;
        ++count;
    }
};

// A particle in a ray's way. to_ball: from its own axes to those of a ball of its radius; null if it is one.
struct Obstacle {
    Vec4 sphere;  // centre, radius squared
    const Mat3* to_ball;
};

// All that a particle's rays can meet: all particles, above the base.
class Shadows {
  public:
    explicit Shadows(const Cloud& cloud) : base_y_(cloud.base_y) {
        float core_radius = 0.0f;
        for (const Particle& particle : cloud.particles) {
            to_ball_.push_back(glm::inverse(particle.shape));
            if (particle.alpha > 0.0f) core_radius = std::max(core_radius, particle.radius);
        }
        for (std::size_t i = 0; i < cloud.particles.size(); ++i) {
            const Particle& particle = cloud.particles[i];
            const float radius       = particle.alpha > 0.0f ? particle.radius : 0.0f;  // else it is not there
            obstacles_.push_back(
                {Vec4(particle.center, radius * radius), particle.shape == Mat3(1.0f) ? nullptr : &to_ball_[i]});
        }
        // Behind a core's diameter 0.15 + 0.85 exp(-2.14) = 1/4 is left.
        per_metre_ = core_radius > 0.0f ? 2.14f * std::max(cloud.absorption, 0.0f) / (2.0f * core_radius) : 0.0f;
    }

    const std::vector<Obstacle>& obstacles() const { return obstacles_; }

    // How deep the point lies in a particle, in metres about; negative outside.
    float depth(std::size_t particle, Vec3 point) const {
        const Obstacle& obstacle = obstacles_[particle];
        const Vec3 offset        = point - Vec3(obstacle.sphere);
        return std::sqrt(obstacle.sphere.w) - glm::length(obstacle.to_ball ? *obstacle.to_ball * offset : offset);
    }

    // Sets the rays' shares. in_reach: what any of them may meet.
    void trace(Rays& rays, Vec3 direction, float density, std::span<const Obstacle> in_reach) const {
        for (std::size_t i = 0; i < rays.count; ++i) {
            const float base = direction.y < 0.0f ? std::max(base_y_ - rays.y[i], -1e30f) / direction.y : 1e30f;
            rays.base[i]     = std::max(base, 0.0f);
            rays.metres[i]   = 0.0f;
        }
        for (const Obstacle& obstacle : in_reach)
            if (obstacle.to_ball)
                add_chords(rays, direction, obstacle.sphere, *obstacle.to_ball);
            else
                add_chords(rays, direction, obstacle.sphere);
        for (std::size_t i = 0; i < rays.count; ++i)
            rays.share[i] = exp_of_minus(rays.metres[i] * per_metre_ * density);
    }

  private:
    // A ray that misses the sphere, or leaves it before it starts, adds 0.
    static void add_chords(Rays& rays, Vec3 direction, const Vec4& sphere) {
        for (std::size_t i = 0; i < rays.count; ++i) {
            const Vec3 to_center     = Vec3(sphere) - Vec3(rays.x[i], rays.y[i], rays.z[i]);
            const float along        = glm::dot(to_center, direction);
            const float half_chord_2 = along * along - glm::dot(to_center, to_center) + sphere.w;
            const float half_chord   = std::sqrt(std::max(half_chord_2, 0.0f));
            const float leaves       = std::min(along + half_chord, rays.base[i]);
            const float enters       = std::max(along - half_chord, 0.0f);
            rays.metres[i] += std::max(leaves - enters, 0.0f);
        }
    }

    // The same where the ray is a ray through a ball, at another speed.
    static void add_chords(Rays& rays, Vec3 direction, const Vec4& sphere, const Mat3& to_ball) {
        const Vec3 step   = to_ball * direction;
        const float speed = glm::length(step);
        const Vec3 unit   = step / speed;
        for (std::size_t i = 0; i < rays.count; ++i) {
            const Vec3 to_center     = to_ball * (Vec3(sphere) - Vec3(rays.x[i], rays.y[i], rays.z[i]));
            const float along        = glm::dot(to_center, unit);
            const float half_chord_2 = along * along - glm::dot(to_center, to_center) + sphere.w;
            const float half_chord   = std::sqrt(std::max(half_chord_2, 0.0f));
            const float leaves       = std::min((along + half_chord) / speed, rays.base[i]);
            const float enters       = std::max((along - half_chord) / speed, 0.0f);
            rays.metres[i] += std::max(leaves - enters, 0.0f);
        }
    }

    std::vector<Mat3> to_ball_;
    std::vector<Obstacle> obstacles_;
    float base_y_    = 0.0f;
    float per_metre_ = 0.0f;
};

// What stands around one particle, to leave out what its rays cannot meet. All margins are far wider than any rounding.
class Vicinity {
  public:
    Vicinity(const Cloud& cloud, const std::vector<Obstacle>& obstacles, std::size_t own, std::span<const Vec3> surface)
        : obstacles_(obstacles) {
        const glm::dvec3 center(cloud.particles[own].center);
        for (const Vec3& point : surface) radius_ = std::max(radius_, glm::length(glm::dvec3(point) - center));
        for (std::size_t j = 0; j < obstacles.size(); ++j) {
            const glm::dvec3 offset = glm::dvec3(Vec3(obstacles[j].sphere)) - center;
            const double distance = glm::length(offset), radius = greatest_radius(cloud.particles[j]);
            others_.push_back({offset, distance, radius});
            if (j != own && distance < (radius_ + radius) * (1.0 + kMargin) + kMargin * distance)
                touching_.push_back(j);
        }
    }

    // Particles that may hold a point of the surface.
    const std::vector<std::size_t>& touching() const { return touching_; }

    // What rays from the surface may meet, in the cloud's order. A ray passes the centre of another sphere, d
    // away from ours, at a distance of at least sqrt(d^2 - (d.u)^2) - R, u being its direction.
    void find_in_reach(Vec3 direction, std::vector<Obstacle>& found) const {
        const glm::dvec3 u  = glm::normalize(glm::dvec3(direction));
        // A direction that is a little too long lengthens `along`, which counts like a larger sphere.
        const double excess = std::max(glm::length(glm::dvec3(direction)) - 1.0, 0.0);
        const double margin = std::sqrt(2.0 * excess * (1.0 + excess)) + kMargin;
        found.clear();
        for (std::size_t j = 0; j < others_.size(); ++j) {
            const Other& other = others_[j];
            const double reach = radius_ + other.radius + margin * (other.distance + radius_ + other.radius);
            const double along = glm::dot(other.offset, u);
            const bool misses  = other.distance * other.distance - along * along > reach * reach;
            if (!misses && along + reach >= 0.0) found.push_back(obstacles_[j]);
        }
    }

  private:
    static constexpr double kMargin = 2e-3;  // the square root of some roundings

    struct Other {
        glm::dvec3 offset;
        double distance, radius;
    };
    const std::vector<Obstacle>& obstacles_;
    double radius_ = 0.0;  // of the surface
    std::vector<Other> others_;
    std::vector<std::size_t> touching_;
};

// Of the coarser vertices.
using Openness = std::array<float, icosphere_vertices(kOcclusionLevel)>;

Openness ambient_occlusion(const Shadows& shadows, const Vicinity& vicinity, std::span<const Vec3> surface,
                           std::span<const Vec3> normals) {
    static const std::array<Vec3, kDirections> directions = occlusion_directions();
    Openness sums{}, weights{}, open;
    std::array<std::size_t, open.size()> vertex_of;
    std::vector<Obstacle> in_reach;
    for (const Vec3& direction : directions) {
        Rays rays;
        for (std::size_t v = 0; v < open.size(); ++v)
            if (glm::dot(direction, normals[v]) > 0.0f) {
                vertex_of[rays.count] = v;
                rays.add(surface[v]);
            }
        vicinity.find_in_reach(direction, in_reach);
        shadows.trace(rays, direction, 0.5f, in_reach);
        for (std::size_t i = 0; i < rays.count; ++i) {
            const std::size_t v = vertex_of[i];
            const float weight  = glm::dot(direction, normals[v]);
            sums[v] += weight * rays.share[i];
            weights[v] += weight;
        }
    }
    for (std::size_t v = 0; v < open.size(); ++v) open[v] = with_floor(weights[v] > 0.0f ? sums[v] / weights[v] : 1.0f);
    return open;
}

// 1, falling to 3/4 where the point is half a radius deep in another particle.
float buried_darkening(const Shadows& shadows, float own_radius, const Vicinity& vicinity, Vec3 point) {
    float deepest = 0.0f;
    for (const std::size_t j : vicinity.touching()) deepest = std::max(deepest, shadows.depth(j, point));
    return 1.0f - 0.25f * std::min(deepest / (0.5f * own_radius), 1.0f);
}

// All vertices of one particle.
void light_particle(const Cloud& cloud, const Daylight& light, const Shadows& shadows, std::size_t own,
                    std::span<LitVertex> vertices) {
    const Vec3 scattered     = scattered_light(light);
    const Icosphere& sphere  = icosphere();
    const Particle& particle = cloud.particles[own];
    const ParticleMesh mesh  = shape_particle(cloud, own);
    // Shadows are those of the smooth spheres: from the bottom of a dent every ray would start inside its own.
    std::vector<Vec3> surface;
    Rays to_sun;
    for (const Vec3& direction : sphere.directions) {
        surface.push_back(squash(particle.center + particle.shape * (direction * particle.radius), cloud.base_y));
        to_sun.add(surface.back());
    }
    const Vicinity vicinity(cloud, shadows.obstacles(), own, surface);
    std::vector<Obstacle> in_reach;
    vicinity.find_in_reach(light.to_sun, in_reach);
    shadows.trace(to_sun, light.to_sun, 1.0f, in_reach);
    const Openness coarse_open = ambient_occlusion(shadows, vicinity, surface, mesh.normals);
    std::vector<float> open(surface.size());
    for (std::size_t v = 0; v < surface.size(); ++v) {
        const Vec3 normal = mesh.normals[v];
        if (v < coarse_open.size())
            open[v] = coarse_open[v] * buried_darkening(shadows, particle.radius, vicinity, surface[v]);
        else
            open[v] = 0.5f * (open[sphere.parents[v][0]] + open[sphere.parents[v][1]]);
        const float direct = to_sun.share[v];
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

float exp_of_minus(float x) {
    // exp(-x) = 1 / exp(x / 64)^64; the series of degree 9 misses exp(0.625) by less than 3e-9.
    const bool leaves_some = x < 40.0f;
    const double a         = static_cast<double>(leaves_some ? x : 0.0f) / 64.0;
    double e               = 1.0 + a / 9.0;
    for (int n = 8; n >= 1; --n) e = 1.0 + a / n * e;
    for (int i = 0; i < 6; ++i) e *= e;
    return leaves_some ? static_cast<float>(1.0 / e) : 0.0f;
}

LitParticles light_particles(const Cloud& cloud, const Daylight& light, const ForEach& for_each) {
    const Shadows shadows(cloud);
    const std::size_t count = icosphere().directions.size();
    LitParticles lit;
    lit.vertices.resize(cloud.particles.size() * count);
    for_each(cloud.particles.size(), [&](std::size_t i) {
        light_particle(cloud, light, shadows, i, std::span(lit.vertices).subspan(i * count, count));
    });
    // Sums in the vertices' order, whatever order they were made in.
    lit.low = Vec3(1e30f), lit.high = Vec3(-1e30f);
    glm::dvec3 color_sum(0.0);
    for (std::size_t i = 0; i < lit.vertices.size(); ++i) {
        const LitVertex& vertex  = lit.vertices[i];
        lit.low                  = glm::min(lit.low, vertex.position);
        lit.high                 = glm::max(lit.high, vertex.position);
        const Particle& particle = cloud.particles[i / count];
        color_sum += glm::dvec3(vertex.light * particle.color + particle.glow);
    }
    if (!lit.vertices.empty()) lit.mean_color = Vec3(color_sum / static_cast<double>(lit.vertices.size()));
    return lit;
}

}  // namespace cloud
