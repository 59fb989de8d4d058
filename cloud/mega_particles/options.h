// SPDX-License-Identifier: MIT
// What the technique can be drawn with for less time. By default all is as the cloud's size in the picture asks for; every
// other choice costs accuracy and changes nothing else.
#pragma once

#include <cstdint>

namespace cloud {

// Shared: clouds that are apart in the picture have passes in common (share_passes.h); the picture is the same. OneByOne:
// each has its own, for those who look at a cloud's passes.
enum class Passes : std::uint8_t { Shared, OneByOne };

// target_scale: 1, 2 or 4. Particles are drawn, and the blur ends, in a target of 1/target_scale of the picture in both
// axes, against a depth buffer of that size that the scene is drawn into once more, without colour; the last draw
// enlarges bilinearly. The particles are then in no depth buffer of the scene's: what comes after the clouds is hidden
// by all but them.
// fewer_sphere_levels: of subdivision, than choose_level() asks for, from 0 to 3; the levels that there are limit it.
// skirt: of clouds in skirt mode. Without it the blur mixes the cloud's mean colour into its rim.
struct MegaParticleOptions {
    Passes passes                                     = Passes::Shared;
    int target_scale                                  = 1;
    int fewer_sphere_levels                           = 0;
    bool skirt                                        = true;
    bool operator==(const MegaParticleOptions&) const = default;
};

// Throws std::invalid_argument with the first that is out of its range.
void check(const MegaParticleOptions& options);

}  // namespace cloud
