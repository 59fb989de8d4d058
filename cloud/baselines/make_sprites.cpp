// SPDX-License-Identifier: MIT
// Where puffs stand, how large they are and what light they have.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <stdexcept>
#include <string>

#include "cloud/baselines/soft_disc.h"
#include "cloud/baselines/sprite_cloud.h"
#include "cloud/baselines/surface_color.h"
#include "cloud/particle_mesh.h"

namespace cloud {
namespace {

constexpr int kMostSprites      = 100'000;
constexpr float kFarthestOut    = 0.7f;   // of a puff's middle, over its particle's radius
constexpr float kSmallestCore   = 0.55f;  // over the particle's radius
constexpr float kLightSmoothing = 0.12f;  // over the greatest particle's radius
constexpr int kLightLevel       = 1;      // of the icosphere: its vertices are close enough together

void check(const SpriteOptions& options) {
    if (options.count < 1 || options.count > kMostSprites)
        throw std::invalid_argument("sprites: count must be 1 to " + std::to_string(kMostSprites) + " (got " +
                                    std::to_string(options.count) + ")");
    if (!(options.opacity >= 0.0f && options.opacity <= 1.0f))
        throw std::invalid_argument("sprites: opacity must be 0 to 1 (got " + std::to_string(options.opacity) + ")");
}

float fraction(double v) {
    return static_cast<float>(v - std::floor(v));
}

// A direction in the horizontal plane, turned by products alone: the C library's sin and cos differ between machines.
struct Azimuth {
    double cosine = 1.0, sine = 0.0;

    // On by the golden angle, 137.508 degrees.
    void turn() {
        const double turned = cosine * -0.7373688780783197 - sine * 0.6754902942615238;
        sine                = sine * -0.7373688780783197 + cosine * 0.6754902942615238;
        cosine              = turned;
    }
};

// Evenly spread over a unit ball. The multiples of 1/g, 1/g^2, 1/g^3 with g^4 = g + 1 fill a cube as the golden ratio's
// fill a line; the greatest of three even numbers is below r with a chance of r^3, as is a place in the ball.
Vec3 place_in_ball(int i, const Azimuth& azimuth) {
    const float r = std::max(
        {fraction(i * 0.8191725133961645), fraction(i * 0.6710436067037893), fraction(i * 0.5497004779019703)});
    const float y     = 2.0f * fraction((i + 0.5) * 0.7548776662466927) - 1.0f;
    const float level = std::sqrt(1.0f - y * y);
    return Vec3(static_cast<float>(azimuth.cosine) * level, y, static_cast<float>(azimuth.sine) * level) * r;
}

double surface(const Particle& particle) {
    const double r = particle.radius;
    return r * r;
}

// The light on the outside of the cloud, where vertices stand for it.
class OuterLight {
  public:
    explicit OuterLight(const BakedCloud& baked) {
        for (const Particle& particle : baked.cloud.particles)
            smoothing_m_ = std::max(smoothing_m_, kLightSmoothing * particle.radius);
        std::vector<Mat3> to_ball;
        for (const Particle& particle : baked.cloud.particles)
            to_ball.push_back(glm::inverse(particle.shape) / particle.radius);
        for (std::size_t i = 0; i < baked.cloud.particles.size(); ++i)
            for (std::uint32_t v = 0; v < icosphere_vertices(kLightLevel); ++v) {
                const LitVertex& vertex = baked.lit.vertices[i * icosphere_vertices(kFinestLevel) + v];
                if (!is_inside_another(baked.cloud, to_ball, i, vertex.position)) vertices_.push_back(vertex);
            }
        if (vertices_.empty()) vertices_ = baked.lit.vertices.all();  // particles that lie in each other all around
    }

    Vec3 mean_near(Vec3 point) const {
        Vec3 sum(0.0f);
        float weights = 0.0f;
        for (const LitVertex& vertex : vertices_) {
            const Vec3 to_vertex = vertex.position - point;
            const float distance = glm::dot(to_vertex, to_vertex) + smoothing_m_ * smoothing_m_;
            const float weight   = 1.0f / (distance * distance);
            sum += weight * vertex.light;
            weights += weight;
        }
        return sum / weights;
    }

  private:
    static bool is_inside_another(const Cloud& cloud, const std::vector<Mat3>& to_ball, std::size_t own, Vec3 point) {
        for (std::size_t i = 0; i < cloud.particles.size(); ++i) {
            const Vec3 in_ball = to_ball[i] * (point - cloud.particles[i].center);
            if (i != own && glm::dot(in_ball, in_ball) < 1.0f) return true;
        }
        return false;
    }

    float smoothing_m_ = 0.0f;
    std::vector<LitVertex> vertices_;
};

}  // namespace

SpriteCloud make_sprites(const BakedCloud& baked, const SpriteOptions& options) {
    check(options);
    const Cloud& cloud = baked.cloud;
    SpriteCloud made{.cloud = cloud, .sprites = {}};
    if (cloud.particles.empty()) return made;
    double total = 0.0;
    for (const Particle& particle : cloud.particles) total += surface(particle);

    const OuterLight light(baked);
    Azimuth azimuth;
    std::size_t current = 0;
    double reached      = surface(cloud.particles[0]);
    for (int i = 0; i < options.count; ++i, azimuth.turn()) {
        while (reached < total * (i + 0.5) / options.count && current + 1 < cloud.particles.size())
            reached += surface(cloud.particles[++current]);
        const Particle& particle = cloud.particles[current];
        const Vec3 offset        = place_in_ball(i, azimuth) * kFarthestOut;
        const float core         = std::max(1.0f - glm::length(offset), kSmallestCore) * particle.radius;
        Sprite sprite;
        sprite.center   = squash(particle.center + particle.shape * (offset * particle.radius), cloud.base_y);
        sprite.center.y = std::max(sprite.center.y, cloud.base_y + 0.95f * core);  // the base stays flat
        sprite.radius   = core / kSoftDiscCore;
        sprite.color    = surface_color(cloud, particle, light.mean_near(sprite.center));
        sprite.alpha    = options.opacity * particle.alpha;
        sprite.cosine   = static_cast<float>(azimuth.cosine);
        sprite.sine     = static_cast<float>(azimuth.sine);
        made.sprites.push_back(sprite);
    }
    return made;
}

}  // namespace cloud
