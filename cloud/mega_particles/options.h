// SPDX-License-Identifier: MIT
// What the technique can be drawn with for less time, or for more. By default all is as the cloud's size in the picture
// asks for; every other choice costs accuracy, or gains some, and changes nothing else.
#pragma once

#include <cstdint>
#include <optional>

namespace cloud {

// Shared: clouds that are apart in the picture have passes in common (share_passes.h); the picture is the same. OneByOne:
// each has its own, for those who look at a cloud's passes.
enum class Passes : std::uint8_t { Shared, OneByOne };

// How the blur comes back from its coarsest level. Steps: doubled level by level, with tents between. Jump: enlarged at
// once, without tents; the kernel is then another at every pixel, and crawls under motion.
enum class BlurRise : std::uint8_t { Steps, Jump };

// target_scale: 1, 2 or 4. Particles are drawn, and the blur ends, in a target of 1/target_scale of the picture in both
// axes, against a depth buffer of that size that the scene is drawn into once more, without colour; the last draw
// enlarges bilinearly. The particles are then in no depth buffer of the scene's: what comes after the clouds is hidden
// by all but them.
// blur_levels: of the pyramid, more than were chosen (fewer, if below 0), from -4 to 4, as far as the width can be kept;
// that of article mode cannot.
// sphere_levels: of subdivision, more than choose_level() asks for (fewer, if below 0), from -3 to 3; the levels that
// there are limit it.
// fractal_boxes: 1 or 2, whatever the clouds have. A second box that a cloud does not have is its first, turned half way
// round. Absent: as the clouds say.
// skirt: of clouds in skirt mode. Without it the blur mixes the cloud's mean colour into its rim.
struct MegaParticleOptions {
    Passes passes      = Passes::Shared;
    int target_scale   = 1;
    int blur_levels    = 0;
    BlurRise blur_rise = BlurRise::Steps;
    int sphere_levels  = 0;
    std::optional<int> fractal_boxes;
    bool skirt                                        = true;
    bool operator==(const MegaParticleOptions&) const = default;
};

// Throws std::invalid_argument with the first that is out of its range.
void check(const MegaParticleOptions& options);

}  // namespace cloud
