// SPDX-License-Identifier: MIT
// Seeded gradient noise in three dimensions, and sums of its octaves. Values are -1..1 and have no preferred sign.
// Equal points give equal bits on every machine: only + - * and integers are used. Method: K. Perlin, "Improving
// Noise", SIGGRAPH 2002, with a hash in place of the permutation table.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cloud/cloud.h"

namespace cloud {

// One feature a unit; 0 at integer points. |p| below 2^30.
float gradient_noise(Vec3 p, std::uint32_t seed);

// Each octave has twice the frequency of the one before and `gain` times its amplitude.
float fbm(Vec3 p, int octaves, float gain, std::uint32_t seed);

// fbm of each of the points, which `sums` has a place for: the same values, several points at once.
void fbm(std::span<const Vec3> points, int octaves, float gain, std::uint32_t seed, std::span<float> sums);

// Octaves of 1 - 2|noise|: round lumps between sharp folds.
float billow(Vec3 p, int octaves, float gain, std::uint32_t seed);

// The same sums at the points of a lattice, a row at a time: the same bits, several times faster, for each coordinate is
// looked at once, and several points of a row are computed at once.
class NoiseLattice {
  public:
    // coordinates: those of the points along x, y and z, ascending.
    NoiseLattice(const std::array<std::vector<float>, 3>& coordinates, int octaves);

    // The points beside `point`, indices into the coordinates, along axis `along`: one value for each coordinate there.
    using Point = std::array<std::size_t, 3>;
    std::vector<float> fbm_row(std::size_t along, Point point, float gain, std::uint32_t seed) const;
    std::vector<float> billow_row(std::size_t along, Point point, float gain, std::uint32_t seed) const;

  private:
    // Coordinates of one axis at one octave: their cells, places in them, and weights of the cells' far ends.
    struct Axis {
        std::vector<std::int32_t> cells;
        std::vector<float> places, weights;
    };
    using Octave = std::array<Axis, 3>;

    template <class OfNoise>
    std::vector<float> row(std::size_t along, Point point, float gain, std::uint32_t seed, OfNoise&& of_noise) const;
    // Calls add(index, noise) for each coordinate along the axis.
    template <std::size_t kAlong, class Add>
    static void for_each_noise(const Octave& axes, Point point, std::uint32_t seed, Add&& add);

    std::vector<Octave> octaves_;
};

}  // namespace cloud
