// SPDX-License-Identifier: MIT
// Gradient noise in the plane, from an integer hash and + - * alone: the same bits on every machine. Values are about
// -1..1 with mean 0; one lattice cell is one unit. A period (in cells, 0: none) makes the noise repeat, for textures
// that tile.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace demo {

std::uint32_t hash_lattice(std::int32_t x, std::int32_t y, std::uint32_t seed);

// 0..1, by the same hash.
float hash_unit(std::int32_t x, std::int32_t y, std::uint32_t seed);

struct Period {
    std::int32_t x = 0, y = 0;
};

float noise(float x, float y, std::uint32_t seed, Period period = {});

// Sum of `octaves` noises, each at twice the frequency and half the amplitude of the one before, about -1..1.
float fractal_noise(float x, float y, int octaves, std::uint32_t seed, Period period = {});

// 1 on the creases where noise is zero, falling to 0: cracks, ridges, gullies. Octaves as above; 0..1.
float ridged_noise(float x, float y, int octaves, std::uint32_t seed, Period period = {});

// The same functions over the points of a grid, a row at a time: the same bits, several times faster, for what depends on
// the column alone is found once for all rows, and a cell's gradients once for all its points in a row. x: coordinates of
// the columns. A row has a value for each of them.
class NoiseGrid {
  public:
    explicit NoiseGrid(std::span<const float> x, int octaves = 1);
    std::vector<float> noise_row(float y, std::uint32_t seed, Period period = {}) const;  // of the first octave
    std::vector<float> fractal_row(float y, std::uint32_t seed, Period period = {}) const;
    std::vector<float> ridged_row(float y, std::uint32_t seed, Period period = {}) const;

  private:
    // Neighbouring columns in the same cell.
    struct Run {
        std::int32_t cell;
        std::size_t first, end;
    };
    // At one octave: each column's place in its cell, and the weight of the cell's right side.
    struct Columns {
        std::vector<Run> runs;
        std::vector<float> dx, weight;
    };
    // Calls take(column, noise) for each column.
    template <class Take>
    void for_each_noise(const Columns& columns, float y, std::uint32_t seed, Period period, Take&& take) const;

    std::size_t size_;
    std::vector<Columns> octaves_;
};

// The largest integer not above `value`, which fits; std::floor is a call where SSE4.1 is not assumed.
constexpr std::int32_t floor_to_int(float value) {
    const auto truncated = static_cast<std::int32_t>(value);
    return value < static_cast<float>(truncated) ? truncated - 1 : truncated;
}

// 0 below `low`, 1 above `high`, a cubic between.
constexpr float smooth_step(float low, float high, float value) {
    const float t = value <= low ? 0.0f : value >= high ? 1.0f : (value - low) / (high - low);
    return t * t * (3.0f - 2.0f * t);
}

constexpr float mix(float a, float b, float t) {
    return a + (b - a) * t;
}

}  // namespace demo
