// SPDX-License-Identifier: MIT
// Light baked into the vertices of a cloud; it depends on the cloud and the daylight, not on the camera.
//   light = 0.85 sun * T (1/2 + 1/2 N.L)  +  0.15 S  +  sky * O (1/2 + 1/2 Ny)  +  bounce * O (1/2 - 1/2 Ny)
// T: what of the sun comes through the cloud: exp(-k c), c being the lengths of the chords that the ray to the sun cuts
// from all particles. S: light that was scattered many times and arrives everywhere, as bright as the sun and of the
// sky's hue. O: 0.15 + 0.85 times the mean of exp(-c k / 2) over 16 directions, by N.d; where a surface dives into
// another particle it falls to 3/4. All of it times 1 + 0.12 lump, the lump being the surface's own (particle_mesh.h). No
// channel exceeds 0.95, so that the top keeps its shape.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "cloud/cloud.h"
#include "cloud/for_each.h"

namespace cloud {

// light: to multiply with the particle's colour. occlusion: 0..1, the share of all the light that arrives; for those
// who light the particles by other means. sun: T, 0..1.
struct LitVertex {
    Vec3 position   = Vec3(0.0f);
    Vec3 normal     = Vec3(0.0f, 1.0f, 0.0f);
    Vec3 light      = Vec3(1.0f);
    float occlusion = 1.0f;
    float sun       = 1.0f;
};

// A list whose copies share its memory until one of them is changed, and so do lists put together from others: clouds are
// copied and merged for every frame, and most have not changed.
class LitVertices {
  public:
    LitVertices() = default;
    explicit LitVertices(std::vector<LitVertex> vertices);

    std::size_t size() const { return parts_.empty() ? 0 : parts_.back().first + parts_.back().vertices->size(); }
    bool empty() const { return size() == 0; }
    // Those of one particle lie one behind the other.
    const LitVertex& operator[](std::size_t i) const {
        const Part& part = parts_.size() == 1 ? parts_[0] : part_of(i);
        return (*part.vertices)[i - part.first];
    }
    std::vector<LitVertex> all() const;

    void append(const LitVertices& others);
    // To change this list alone.
    std::vector<LitVertex>& edit();

  private:
    struct Part {
        std::size_t first;
        std::shared_ptr<std::vector<LitVertex>> vertices;
    };
    const Part& part_of(std::size_t i) const;

    std::vector<Part> parts_;  // none is empty, but by an edit
};

// icosphere_vertices(kFinestLevel) vertices for each particle, in the cloud's order.
struct LitParticles {
    LitVertices vertices;
    Vec3 mean_color = Vec3(1.0f);              // light times colour, over all vertices
    Vec3 low = Vec3(0.0f), high = Vec3(0.0f);  // the box around all vertices
};
LitParticles light_particles(const Cloud& cloud, const Daylight& light, const ForEach& for_each = one_by_one);

}  // namespace cloud
