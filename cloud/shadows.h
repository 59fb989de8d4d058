// SPDX-License-Identifier: MIT
// How much light comes through a cloud along rays that leave one of its particles: exp(-k c), c being the lengths of the
// chords that a ray cuts from all particles, added in the cloud's order. Smooth spheres and ellipsoids, without lumps.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cloud/cloud.h"
#include "cloud/particle_mesh.h"

namespace cloud {

// Particles in the way of rays. radius: the greatest; margin: of rounding, over the distance.
struct Obstacles {
    std::vector<std::uint32_t> particle;
    std::vector<float> x, y, z, radius, margin;

    std::size_t size() const { return particle.size(); }
    void resize(std::size_t size);
};

// Rays in one direction. Coordinate by coordinate, so that several are computed at once; those that start near each other
// should be added one after the other, for what none of a few neighbours can meet is left out.
class Rays {
  public:
    void clear() { count_ = 0; }
    void add(Vec3 start) {
        x_[count_] = start.x, y_[count_] = start.y, z_[count_] = start.z;
        ++count_;
    }
    std::size_t count() const { return count_; }
    float share(std::size_t ray) const { return share_[ray]; }  // of light from afar that arrives against the direction

    static constexpr std::size_t kTogether = 8;

  private:
    friend class Shadows;
    static constexpr std::size_t kMost = (icosphere_vertices(kFinestLevel) + kTogether - 1) / kTogether * kTogether;
    using Values                       = std::array<float, kMost>;
    std::size_t count_                 = 0;
    Values x_, y_, z_;  // where they start
    Values base_;       // metres to where they leave the cloud through its base
    Values metres_;     // inside particles
    Values share_;
    Obstacles near_;  // what any of them may meet
    std::vector<std::uint32_t> found_;
};

// All that the rays can meet: all particles, above the base.
class Shadows {
  public:
    explicit Shadows(const Cloud& cloud);

    // Particles that one of the points, all within `radius` of `center`, may lie in.
    std::vector<std::uint32_t> touching(Vec3 center, float radius) const;

    // How deep each of `points` lies in the deepest of `particles`, in metres about; 0 outside.
    void depths(std::span<const Vec3> points, std::span<const std::uint32_t> particles, std::span<float> deepest) const;

    // Sets the rays' shares. They start within `radius` of `center`. density: of the particles, over the cloud's.
    void trace(Rays& rays, Vec3 direction, float density, Vec3 center, float radius) const;

  private:
    // A bundle of rays. margin: what a direction that is a little too long adds, as if by larger particles, over the
    // distance.
    struct Bundle {
        Vec3 center;
        float radius;
        Vec3 direction;
        float margin;
    };
    // Sets `found`, as large as `among`, to what the bundle may meet, in their order; returns how many.
    static std::size_t find_in_reach(const Obstacles& among, std::size_t count, const Bundle& bundle,
                                     std::uint32_t* found);
    void add_chords(Rays& rays, std::size_t first, Vec3 direction, std::uint32_t particle) const;

    std::vector<Vec4> spheres_;  // centre, radius squared
    std::vector<Mat3> to_ball_;  // from its own axes to those of a ball of its radius
    std::vector<std::uint8_t> is_ball_;
    Obstacles all_;
    float base_y_    = 0.0f;
    float per_metre_ = 0.0f;
};

}  // namespace cloud
