// SPDX-License-Identifier: MIT
#include "cloud/generate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "cloud/particle_mesh.h"
#include "cloud/wide_loops.h"

namespace cloud {
namespace {

// A direction in the horizontal plane, turned by products alone: the C library's sin and cos differ between machines.
struct Azimuth {
    double cosine = 1.0, sine = 0.0;

    Azimuth turned_by(const Azimuth& other) const {
        return {cosine * other.cosine - sine * other.sine, sine * other.cosine + cosine * other.sine};
    }
};

// 137.508 degrees, the golden angle.
constexpr Azimuth kGoldenAngle{-0.7373688780783197, 0.6754902942615238};

// Within a tenth of a turn or so: sin and cos by their series, error below 1e-6 up to a quarter of a turn.
Azimuth small_turn(double turns) {
    const double a = turns * 6.283185307179586, a2 = a * a;
    const double sine = a * (1.0 - a2 / 6.0 * (1.0 - a2 / 20.0 * (1.0 - a2 / 42.0 * (1.0 - a2 / 72.0))));
    const double cosine =
        1.0 - a2 / 2.0 * (1.0 - a2 / 12.0 * (1.0 - a2 / 30.0 * (1.0 - a2 / 56.0 * (1.0 - a2 / 90.0))));
    return {cosine, sine};
}

// -1..1, another value for each step of `state`.
double next_signed(std::uint32_t& state) {
    state           = state * 1664525u + 1013904223u;
    std::uint32_t h = state;
    h               = (h ^ (h >> 16)) * 0x7feb352du;
    h               = (h ^ (h >> 15)) * 0x846ca68bu;
    h ^= h >> 16;
    return static_cast<double>(h) / 2147483648.0 - 1.0;
}

Vec3 direction(const Azimuth& azimuth, float sine_of_elevation) {
    const float e     = std::clamp(sine_of_elevation, -1.0f, 1.0f);
    const float level = std::sqrt(1.0f - e * e);
    return Vec3(level * static_cast<float>(azimuth.cosine), e, level * static_cast<float>(azimuth.sine));
}

// Points spread over a unit sphere, by which the buried share of a particle is measured; the last once more, up to a whole
// number of vectors.
constexpr std::uint32_t kSurfacePoints = icosphere_vertices(1);
struct SurfacePoints {
    static constexpr std::size_t kSize = (kSurfacePoints + 7) / 8 * 8;
    std::array<float, kSize> x, y, z;
};

const SurfacePoints& surface_points() {
    static const SurfacePoints points = [] {
        SurfacePoints made;
        for (std::size_t i = 0; i < SurfacePoints::kSize; ++i) {
            const Vec3 d = icosphere().directions[std::min<std::size_t>(i, kSurfacePoints - 1)];
            made.x[i] = d.x, made.y[i] = d.y, made.z[i] = d.z;
        }
        return made;
    }();
    return points;
}

// Particles, coordinate by coordinate.
class Crowd {
  public:
    void add(const Particle& particle) {
        x_.push_back(particle.center.x), y_.push_back(particle.center.y), z_.push_back(particle.center.z);
        radius_.push_back(particle.radius);
    }

    // How many of the particle's surface points lie inside any of these; with more than `enough` it need not go on.
    int buried_points(const Particle& particle, float enough) const {
        int buried = 0;
        with_wide_loops([&] { buried = count_buried(particle.center, particle.radius, enough); });
        return buried;
    }

  private:
    // The search goes by blocks, so that the first ones, which are the largest, can decide.
    static constexpr std::size_t kBlock = 64;

    int count_buried(Vec3 center, float radius, float enough) const {
        constexpr std::size_t kSize = SurfacePoints::kSize;
        const SurfacePoints& unit   = surface_points();
        float px[kSize], py[kSize], pz[kSize];
        std::uint32_t is_buried[kSize];
        for (std::size_t i = 0; i < kSize; ++i) {
            px[i] = center.x + unit.x[i] * radius, py[i] = center.y + unit.y[i] * radius;
            pz[i] = center.z + unit.z[i] * radius, is_buried[i] = 0;
        }
        int buried = 0;
        for (std::size_t first = 0; first < radius_.size(); first += kBlock) {
            const std::size_t count = std::min(radius_.size() - first, kBlock);
            const float *x = &x_[first], *y = &y_[first], *z = &z_[first], *r = &radius_[first];
            std::uint32_t near[kBlock];
            for (std::size_t j = 0; j < count; ++j) {
                const float dx = center.x - x[j], dy = center.y - y[j], dz = center.z - z[j];
                // The margin is wider than any rounding.
                const float reach =
                    (radius + r[j]) * 1.001f + 1e-6f * (std::abs(x[j]) + std::abs(y[j]) + std::abs(z[j]));
                near[j] = dx * dx + dy * dy + dz * dz < reach * reach ? 1u : 0u;
            }
            std::size_t near_count = 0;
            for (std::uint32_t j = 0; j < count; ++j) {
                const std::uint32_t is_near = near[j];
                near[near_count]            = j;
                near_count += is_near;
            }
            if (near_count == 0) continue;
            for (std::size_t n = 0; n < near_count; ++n) {
                const std::size_t j = near[n];
                const float cx = x[j], cy = y[j], cz = z[j], r2 = r[j] * r[j];
                for (std::size_t i = 0; i < kSize; ++i) {
                    const float dx = px[i] - cx, dy = py[i] - cy, dz = pz[i] - cz;
                    is_buried[i] |= dx * dx + dy * dy + dz * dz < r2 ? 1u : 0u;
                }
            }
            std::uint32_t sum = 0;
            for (std::size_t i = 0; i < kSurfacePoints; ++i) sum += is_buried[i];
            buried = static_cast<int>(sum);
            if (static_cast<float>(buried) > enough) break;
        }
        return buried;
    }

    std::vector<float> x_, y_, z_, radius_;
};

float share_of(int surface_points) {
    return static_cast<float>(surface_points) / static_cast<float>(kSurfacePoints);
}

class Grower {
  public:
    Grower(std::span<const Particle> cores, const Growth& growth)
        : particles_(cores.begin(), cores.end()), jitter_(growth.jitter), random_(growth.seed) {
        for (Particle& core : particles_) {
            core.generation = 0;
            core_radius_.push_back(core.radius);
            crowd_.add(core);
        }
    }

    // One more generation, on all there are. Each parent's children are a golden angle apart, and neighbouring parents
    // begin a golden angle apart.
    void add(const Generation& rule, int generation) {
        const std::size_t parent_count = particles_.size();
        std::vector<Azimuth> next(parent_count);
        std::vector<int> asked(parent_count);
        for (std::size_t i = 1; i < parent_count; ++i) next[i] = next[i - 1].turned_by(kGoldenAngle);
        for (int i = 0; i < rule.count && parent_count > 0; ++i) {
            const float t      = (static_cast<float>(i) + 0.5f) / static_cast<float>(rule.count);
            const Azimuth turn = small_turn(jitter_ * next_signed(random_));
            const float swell  = 1.0f + jitter_ * static_cast<float>(next_signed(random_));
            for (int parents = 0; parents < kParentsTried; ++parents) {
                const std::size_t which = emptiest(asked);
                ++asked[which];
                if (seat(rule, generation, t, swell, turn, which, next[which])) break;
            }
        }
    }

    std::vector<Particle> particles() && { return std::move(particles_); }

  private:
    static constexpr int kParentsTried = 4, kAzimuthsTried = 6;
    static constexpr float kMostOfParent = 0.6f;

    // One child on parent `which`, at the first of its next azimuths where it is not buried; false if there is none.
    bool seat(const Generation& rule, int generation, float t, float swell, const Azimuth& turn, std::size_t which,
              Azimuth& next) {
        const Particle parent = particles_[which];
        Particle child        = parent;
        child.generation      = generation;
        const float share     = rule.first_radius + (rule.last_radius - rule.first_radius) * t;
        child.radius          = std::min(core_radius_[which] * share, parent.radius * kMostOfParent) * swell;
        for (int tried = 0; tried < kAzimuthsTried; ++tried) {
            const Azimuth azimuth = next.turned_by(turn);
            next                  = next.turned_by(kGoldenAngle);
            child.center =
                parent.center + direction(azimuth, rule.lowest + rule.rise * t) * (parent.radius * rule.seat);
            // Any more than a point over the limit is too many, however the share rounds.
            const float enough = rule.greatest_burial * static_cast<float>(kSurfacePoints) + 1.0f;
            if (share_of(crowd_.buried_points(child, enough)) > rule.greatest_burial) continue;
            particles_.push_back(child);
            crowd_.add(child);
            core_radius_.push_back(core_radius_[which]);
            return true;
        }
        return false;
    }

    // The parent with the most surface for each child it was asked to seat, the next one included.
    std::size_t emptiest(const std::vector<int>& asked) const {
        std::size_t best = 0;
        float most       = -1.0f;
        for (std::size_t i = 0; i < asked.size(); ++i) {
            const float surface = particles_[i].radius * particles_[i].radius / static_cast<float>(asked[i] + 1);
            if (surface > most) most = surface, best = i;
        }
        return best;
    }

    std::vector<Particle> particles_;
    Crowd crowd_;                     // the same
    std::vector<float> core_radius_;  // of the core that each descends from
    float jitter_;
    std::uint32_t random_;
};

}  // namespace

float buried_share(const Particle& particle, std::span<const Particle> others) {
    Crowd crowd;
    for (const Particle& other : others) crowd.add(other);
    return share_of(crowd.buried_points(particle, static_cast<float>(kSurfacePoints)));
}

std::vector<Particle> grow(std::span<const Particle> cores, const Growth& growth) {
    Grower grower(cores, growth);
    grower.add(growth.crown, 1);
    grower.add(growth.rim, 2);
    return std::move(grower).particles();
}

}  // namespace cloud
