// SPDX-License-Identifier: MIT
// A cloud as a volume of texels, which a chip without volume textures keeps three times: as stacks of slices across
// each axis. Lengths in metres. n x n x n texels of A8R8G8B8 take 12 n^3 bytes with all three stacks: 3 MiB for n = 64,
// 24 MiB for n = 128, of the 32 MiB a card of 1999 had for everything. Mega-particles take no volume at all.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cloud/bake.h"

namespace cloud {

struct SliceOptions {
    int size       = 64;    // slices of each stack, and texels along a slice's edges: 4 to 256
    float coverage = 6.0f;  // optical depth along the greatest particle's radius: 0.1 to 1000
};

// The box low..high, cut into size^3 cells. stacks[a]: slices across axis a, from low to high, of size x size texels
// (B, G, R, A), u along axis a+1 and v along axis a+2 (modulo 3). visible[a]: of each slice, the rectangle of texels
// within which filtering finds one that is not clear, all zero where there is none. cloud: whose volume it is.
struct SliceVolume {
    Cloud cloud;
    Vec3 low = Vec3(0.0f), high = Vec3(0.0f);
    int size = 0;
    std::array<std::vector<std::uint8_t>, 3> stacks;
    std::array<std::vector<pipeline::PixelRect>, 3> visible;

    std::size_t slice_bytes() const { return std::size_t{4} * static_cast<std::size_t>(size * size); }
};

// The box is that of the cloud's vertices, with room for the soft rim. A cell's density, at its centre, is
//   clamp(1/2 - (d - noise) / (2 w), 0, 1) times the particle's alpha,
// d: the distance from the nearest particle's surface, below 0 inside, w: the blur's deviation, at least a cell's
// longest edge; noise: the cloud's own fractal, without octaves finer than two cells, its amplitude 2w. A slice has
// alpha 1 - exp(-k density s), s being the distance between slices and k coverage over the greatest particle's radius:
// blended one over the other they let through what the volume does, looking along the stack.
// The colour is the nearest particle's times the baked light of its vertex in that direction, plus its glow, clear
// cells included, so that filtering brings nothing foreign into the rim. The outermost texels of a slice are clear.
// Without particles: size 0. Throws std::invalid_argument for options out of range.
SliceVolume make_slices(const BakedCloud& baked, const SliceOptions& options = {});

}  // namespace cloud
