// SPDX-License-Identifier: MIT
// Particles that are born, move and end, all by one law: smoke, a plume, an explosion. A function of time alone, so any
// frame of an animation can be drawn by itself. Lengths in metres, times in seconds.
#pragma once

#include <cstdint>
#include <vector>

#include "cloud/cloud.h"
#include "demo/track.h"

namespace demo {

using pipeline::Vec3;

// Age runs from 0 to 1 over life_s seconds. Particle i leaves in
// direction i times the golden angle, and turns about the vertical by swirl_deg a second.
//   Steady  in full flow from the start: particle i is i / count of a life ahead, and is born again at the end
//   Fill    nothing is there at the start; particle i is born after i / count of a life, and again at each end
//   Burst   all are born at the start, once
struct ParticleStream {
    enum class Birth : std::uint8_t { Steady, Fill, Burst } birth = Birth::Steady;
    int count                                                     = 24;
    double life_s                                                 = 6.0;
    // By age. spread: from the axis, or in a ball from the middle in all directions; height above the cloud's position.
    struct Stage {
        float spread = 0.0f, height = 0.0f, radius = 1.0f, alpha = 1.0f;
        Stage operator+(const Stage& s) const {
            return {spread + s.spread, height + s.height, radius + s.radius, alpha + s.alpha};
        }
        Stage operator*(float f) const { return {spread * f, height * f, radius * f, alpha * f}; }
    };
    Track<Stage> stages;
    Track<Vec3> color, glow;  // by age as well; empty: white, none
    bool in_ball       = false;
    float swirl_deg    = 0.0f;
    // Smaller ones around each, in its own surface, rolling with it.
    int bumps          = 0;
    float bump_radius  = 0.45f;  // over the particle's
    float irregularity = 0.0f;   // of spread, height and radius, 0..1
    std::uint32_t seed = 1;
};

// Each particle followed by its bumps, around the origin; always as many, so that each keeps its place and with it the
// lumps of its surface. One that is not there is a clear speck of a centimetre.
std::vector<cloud::Particle> stream_particles(const ParticleStream& stream, double seconds);

}  // namespace demo
