// SPDX-License-Identifier: MIT
// Grows a cumulus on given cores: a crown of smaller particles on the cores' upper sides, and a rim of small ones all
// over both. Azimuths follow the golden angle, so no two children of a parent line up; a child that would be buried in
// what already stands is moved on, at last to another parent, or left out. Ratios near one half from one generation to the next make the outline
// self-similar.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cloud/cloud.h"

namespace cloud {

// seat: of a child's centre, in radii of its parent. A child's radius is that of the core it descends from times a value
// that falls from the first to the last child of its generation, but at most 0.6 of its parent's; the sine of its
// elevation rises from lowest to lowest + rise. Parents get children in proportion to their surface.
struct Generation {
    int count             = 0;
    float seat            = 0.85f;
    float first_radius    = 0.55f;
    float last_radius     = 0.30f;
    float lowest          = 0.15f;
    float rise            = 0.80f;
    float greatest_burial = 0.7f;  // share of a child's surface inside other particles
};

struct Growth {
    Generation crown{.count = 14};
    Generation rim{.count           = 24,
                   .seat            = 0.9f,
                   .first_radius    = 0.30f,
                   .last_radius     = 0.16f,
                   .lowest          = -0.35f,
                   .rise            = 1.3f,
                   .greatest_burial = 0.65f};
    float jitter = 0.0f;  // of the azimuth, in turns (0.1: up to a tenth of a turn either way), and of radius (share)
    std::uint32_t seed = 1;  // of the jitter
};

// The cores (generation 0) as given, then the crown (1), then the rim (2). Children take their parent's colour and
// alpha.
std::vector<Particle> grow(std::span<const Particle> cores, const Growth& growth);

// The share of `particle`'s surface that lies inside any of `others`, 0..1, by 42 points.
float buried_share(const Particle& particle, std::span<const Particle> others);

}  // namespace cloud
