// SPDX-License-Identifier: MIT
// Mega-particles from a glTF file, as an artist places them: each node of its default scene whose name starts with
// "particle", in any case ("particle", "Particle.001"), an empty or a mesh. Lengths in metres, y up. What the node
// is, its particle has:
//
//   center    where its origin stands
//   radius    the cube root of its volume's scale, times 1 for an empty or half the largest extent of its mesh
//   shape     what is left of its scale, rotation and shear, with determinant 1; a mirrored one is turned inside out
//   color     red, green and blue of the base colour of the mesh's first material; white without
//   alpha     that colour's alpha; 1 without
//   glow      that material's emissive factor; black without
//
// Numbers among the node's extras (custom properties in Blender) come before those: "alpha" from 0 to 1, "glow" one
// number or three, from 0 to 100. Parents and animations (gltf_animation.h) move particles; skins and morph targets
// do not.
#pragma once

#include <memory>
#include <vector>

#include "cloud/cloud.h"
#include "demo/scene_data.h"

namespace demo {

class ParticleFile {
  public:
    // SceneError for a file that cannot be used: also for one without particles or with more than
    // kMaxParticlesPerCloud.
    explicit ParticleFile(const FileReference& file);

    // In a fixed order, parents before their children. A particle is left out while its radius is below 0.1 mm or it
    // is squashed flat, with an axis of its shape beyond 1000. SceneError if one leaves the world: a coordinate or
    // radius beyond 1e5 m.
    std::vector<cloud::Particle> at(double seconds) const;

    // Seconds until the last key; 0 if nothing moves. At later times all stays as it is then.
    double duration() const;

  private:
    struct Contents;
    std::shared_ptr<const Contents> contents_;
};

}  // namespace demo
