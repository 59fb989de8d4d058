// SPDX-License-Identifier: MIT
#include "cloud/baselines/slice_volume.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "cloud/baselines/surface_color.h"
#include "cloud/bounds.h"
#include "cloud/exp_of_minus.h"
#include "cloud/mega_particles/cloud_draw.h"
#include "cloud/noise.h"
#include "cloud/particle_mesh.h"

namespace cloud {
namespace {

constexpr float kNoiseAmplitude = 2.0f;  // over the rim's half width
constexpr float kBillowMean     = 0.56f;
constexpr int kLightLevel       = 2;  // of the icosphere: its vertices are close enough together

void check(const SliceOptions& options) {
    if (options.size < 4 || options.size > 256)
        throw std::invalid_argument("slices: size must be 4 to 256 (got " + std::to_string(options.size) + ")");
    if (!(options.coverage >= 0.1f && options.coverage <= 1000.0f))
        throw std::invalid_argument("slices: coverage must be 0.1 to 1000 (got " + std::to_string(options.coverage) +
                                    ")");
}

// The point that the flat base moved to `point`.
Vec3 unsquash(Vec3 point, float base_y) {
    if (point.y < base_y) point.y = base_y + (point.y - base_y) / 0.15f;
    return point;
}

// What is nearest to a cell. in_ball: the cell's centre in the particle's unit ball.
struct Nearest {
    float distance_m     = std::numeric_limits<float>::infinity();
    std::size_t particle = 0;
    Vec3 in_ball         = Vec3(0.0f);
};

class Cells {
  public:
    Cells(const BakedCloud& baked, const SliceOptions& options)
        : baked_(baked), size_(options.size), n_(static_cast<std::size_t>(size_)) {
        const Cloud& cloud = baked.cloud;
        float greatest     = 0.0f;
        for (const Particle& particle : cloud.particles) greatest = std::max(greatest, particle.radius);
        extinction_          = options.coverage / greatest;
        const Vec3 extent    = baked.lit.high - baked.lit.low;
        const float longest  = std::max({extent.x, extent.y, extent.z, greatest});
        rim_m_               = std::max(cloud.blur_m, longest / static_cast<float>(size_));
        const float room     = (1.0f + kNoiseAmplitude) * rim_m_;  // as far as the noise carries the rim
        low_                 = baked.lit.low - room;
        step_                = (extent + 2.0f * room) / static_cast<float>(size_);
        high_                = low_ + step_ * static_cast<float>(size_);
        cycles_per_metre_    = cloud.fractal.cycles / longest;
        const float coarsest = std::max({step_.x, step_.y, step_.z});
        for (float cells = 1.0f / (cycles_per_metre_ * coarsest); octaves_ < cloud.fractal.octaves && cells >= 2.0f;
             cells *= 0.5f)
            ++octaves_;
        find_nearest();
    }

    SliceVolume volume() const {
        SliceVolume volume{.cloud = baked_.cloud, .low = low_, .high = high_, .size = size_, .stacks = {}};
        for (std::vector<std::uint8_t>& stack : volume.stacks) stack.resize(4 * n_ * n_ * n_);
        for (int z = 0; z < size_; ++z)
            for (int y = 0; y < size_; ++y)
                for (int x = 0; x < size_; ++x) put(volume, x, y, z);
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (int slice = 0; slice < size_; ++slice)
                volume.visible[axis].push_back(visible_part(&volume.stacks[axis][4 * index(0, 0, slice)]));
        return volume;
    }

  private:
    std::size_t index(int x, int y, int z) const {
        return (static_cast<std::size_t>(z) * n_ + static_cast<std::size_t>(y)) * n_ + static_cast<std::size_t>(x);
    }
    Vec3 center(int x, int y, int z) const {
        return low_ + (Vec3(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)) + 0.5f) * step_;
    }

    // Distances are measured in a particle's unit ball and taken times its radius. A particle is tried where its rim
    // can be, and what filtering mixes with that.
    void find_nearest() {
        nearest_.resize(n_ * n_ * n_);
        const float base_y = baked_.cloud.base_y;
        for (std::size_t i = 0; i < baked_.cloud.particles.size(); ++i) {
            const Particle& particle = baked_.cloud.particles[i];
            const Mat3 to_ball       = glm::inverse(particle.shape) / particle.radius;
            const auto [first, last] = cells_around(particle);
            for (int z = first[2]; z <= last[2]; ++z)
                for (int y = first[1]; y <= last[1]; ++y)
                    for (int x = first[0]; x <= last[0]; ++x) {
                        const Vec3 in_ball   = to_ball * (unsquash(center(x, y, z), base_y) - particle.center);
                        const float distance = (glm::length(in_ball) - 1.0f) * particle.radius;
                        Nearest& nearest     = nearest_[index(x, y, z)];
                        if (distance < nearest.distance_m) nearest = {distance, i, in_ball};
                    }
        }
    }

    std::pair<std::array<int, 3>, std::array<int, 3>> cells_around(const Particle& particle) const {
        const Mat3 rows = glm::transpose(particle.shape);
        Vec3 reach      = Vec3(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2])) * particle.radius;
        reach += (1.0f + kNoiseAmplitude) * rim_m_ + step_;
        const Vec3 low  = (squash(particle.center - reach, baked_.cloud.base_y) - low_) / step_;
        const Vec3 high = (squash(particle.center + reach, baked_.cloud.base_y) - low_) / step_;
        std::array<int, 3> first{}, last{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int a = static_cast<int>(axis);
            first[axis] = static_cast<int>(std::clamp(low[a], 0.0f, static_cast<float>(size_ - 1)));
            last[axis]  = static_cast<int>(std::clamp(high[a], 0.0f, static_cast<float>(size_ - 1)));
        }
        return {first, last};
    }

    float density(const Nearest& nearest, Vec3 point) const {
        const Fractal& fractal = baked_.cloud.fractal;
        const float reach      = kNoiseAmplitude * rim_m_;
        if (nearest.distance_m > rim_m_ + reach) return 0.0f;
        float noise = 0.0f;
        if (octaves_ > 0 && nearest.distance_m > -rim_m_ - reach) {
            const Vec3 at = (point - low_) * cycles_per_metre_;  // moves with the cloud
            noise = fractal.noise == Noise::Billow ? billow(at, octaves_, fractal.gain, fractal.seed) - kBillowMean
                                                   : fbm(at, octaves_, fractal.gain, fractal.seed);
        }
        const float surface = nearest.distance_m - noise * reach;
        return std::clamp(0.5f - surface / (2.0f * rim_m_), 0.0f, 1.0f) *
               baked_.cloud.particles[nearest.particle].alpha;
    }

    Vec3 color(const Nearest& nearest) const {
        const Icosphere& sphere  = icosphere();
        const Particle& particle = baked_.cloud.particles[nearest.particle];
        std::uint32_t closest    = 0;
        float most               = -std::numeric_limits<float>::infinity();
        for (std::uint32_t v = 0; v < icosphere_vertices(kLightLevel); ++v) {
            const float along = glm::dot(sphere.directions[v], nearest.in_ball);
            if (along > most) most = along, closest = v;
        }
        const LitVertex& lit = baked_.lit.vertices[nearest.particle * icosphere_vertices(kFinestLevel) + closest];
        return surface_color(baked_.cloud, particle, lit.light);
    }

    // One cell, into its place in each stack.
    void put(SliceVolume& volume, int x, int y, int z) const {
        const std::array<int, 3> at{x, y, z};
        const Nearest& nearest = nearest_[index(x, y, z)];
        const float density_1  = density(nearest, center(x, y, z));
        const Vec3 rgb         = color(nearest);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int slice = at[axis], u = at[(axis + 1) % 3], v = at[(axis + 2) % 3];
            const bool is_border     = u == 0 || v == 0 || u == size_ - 1 || v == size_ - 1;
            const float metres       = step_[static_cast<int>(axis)];
            const float alpha        = is_border ? 0.0f : 1.0f - exp_of_minus(extinction_ * density_1 * metres);
            const std::uint32_t argb = to_argb(rgb, alpha).value;
            std::uint8_t* texel      = &volume.stacks[axis][4 * index(u, v, slice)];
            for (int byte = 0; byte < 4; ++byte) texel[byte] = static_cast<std::uint8_t>(argb >> (8 * byte));
        }
    }

    // A texel is seen up to the centres of its neighbours.
    pipeline::PixelRect visible_part(const std::uint8_t* texels) const {
        pipeline::PixelRect part{size_, size_, 0, 0};
        for (int v = 0; v < size_; ++v)
            for (int u = 0; u < size_; ++u)
                if (texels[4 * index(u, v, 0) + 3] > 0)
                    part = {std::min(part.x0, u), std::min(part.y0, v), std::max(part.x1, u + 1),
                            std::max(part.y1, v + 1)};
        if (part.x1 == 0) return {};
        return grow(part, 1, size_, size_);
    }

    const BakedCloud& baked_;
    int size_;
    std::size_t n_;
    float rim_m_ = 0.0f, cycles_per_metre_ = 0.0f, extinction_ = 0.0f;
    int octaves_ = 0;
    Vec3 low_ = Vec3(0.0f), high_ = Vec3(0.0f), step_ = Vec3(0.0f);
    std::vector<Nearest> nearest_;
};

}  // namespace

SliceVolume make_slices(const BakedCloud& baked, const SliceOptions& options) {
    check(options);
    if (baked.cloud.particles.empty()) return {.cloud = baked.cloud, .stacks = {}};
    return Cells(baked, options).volume();
}

}  // namespace cloud
