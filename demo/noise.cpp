// SPDX-License-Identifier: MIT
#include "demo/noise.h"

#include <cmath>

namespace demo {
namespace {

struct Direction {
    float x, y;
};
// Eight directions of equal length, sqrt(2), which makes the noise span about -1..1.
constexpr Direction kGradients[8] = {{1.4142135f, 0.0f},  {1.0f, 1.0f},   {0.0f, 1.4142135f},  {-1.0f, 1.0f},
                                     {-1.4142135f, 0.0f}, {-1.0f, -1.0f}, {0.0f, -1.4142135f}, {1.0f, -1.0f}};

std::int32_t wrap(std::int32_t cell, std::int32_t period) {
    if (period == 0 || (cell >= 0 && cell < period)) return cell;
    const std::int32_t rest = cell % period;
    return rest < 0 ? rest + period : rest;
}

// Of a cell within the period.
const Direction& gradient(std::int32_t cell_x, std::int32_t cell_y, std::uint32_t seed) {
    return kGradients[hash_lattice(cell_x, cell_y, seed) >> 29];
}

float slope(std::int32_t cell_x, std::int32_t cell_y, float dx, float dy, std::uint32_t seed) {
    const Direction& g = gradient(cell_x, cell_y, seed);
    return g.x * dx + g.y * dy;
}

Period doubled(Period period) {
    return {period.x * 2, period.y * 2};
}

float fade(float t) {
    return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

}  // namespace

std::uint32_t hash_lattice(std::int32_t x, std::int32_t y, std::uint32_t seed) {
    std::uint32_t h =
        static_cast<std::uint32_t>(x) * 0x9e3779b1u ^ static_cast<std::uint32_t>(y) * 0x85ebca77u ^ seed * 0xc2b2ae3du;
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 12;
    h *= 0x297a2d39u;
    h ^= h >> 15;
    return h;
}

float hash_unit(std::int32_t x, std::int32_t y, std::uint32_t seed) {
    return static_cast<float>(hash_lattice(x, y, seed) >> 8) * (1.0f / 16777216.0f);
}

float noise(float x, float y, std::uint32_t seed, Period period) {
    const std::int32_t cell_x = floor_to_int(x), cell_y = floor_to_int(y);
    const float dx = x - static_cast<float>(cell_x), dy = y - static_cast<float>(cell_y);
    const float u = fade(dx), v = fade(dy);
    const std::int32_t left = wrap(cell_x, period.x), right = wrap(cell_x + 1, period.x);
    const std::int32_t upper = wrap(cell_y, period.y), lower = wrap(cell_y + 1, period.y);
    const float top = mix(slope(left, upper, dx, dy, seed), slope(right, upper, dx - 1.0f, dy, seed), u);
    const float bottom =
        mix(slope(left, lower, dx, dy - 1.0f, seed), slope(right, lower, dx - 1.0f, dy - 1.0f, seed), u);
    return mix(top, bottom, v);
}

float fractal_noise(float x, float y, int octaves, std::uint32_t seed, Period period) {
    float sum = 0.0f, amplitude = 0.5f;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += amplitude * noise(x, y, seed + static_cast<std::uint32_t>(octave), period);
        x *= 2.0f;
        y *= 2.0f;
        period = doubled(period);
        amplitude *= 0.5f;
    }
    return sum * 1.3f;
}

float ridged_noise(float x, float y, int octaves, std::uint32_t seed, Period period) {
    float sum = 0.0f, amplitude = 1.0f, total = 0.0f;
    for (int octave = 0; octave < octaves; ++octave) {
        const float ridge = 1.0f - std::abs(noise(x, y, seed + static_cast<std::uint32_t>(octave), period));
        sum += amplitude * ridge * ridge;
        total += amplitude;
        x *= 2.0f;
        y *= 2.0f;
        period = doubled(period);
        amplitude *= 0.5f;
    }
    return sum / total;
}

NoiseGrid::NoiseGrid(std::span<const float> x, int octaves)
    : size_(x.size()), octaves_(static_cast<std::size_t>(octaves)) {
    float frequency = 1.0f;
    for (Columns& columns : octaves_) {
        for (std::size_t i = 0; i < x.size(); ++i) {
            const float scaled      = x[i] * frequency;
            const std::int32_t cell = floor_to_int(scaled);
            if (columns.runs.empty() || columns.runs.back().cell != cell) columns.runs.push_back({cell, i, i});
            ++columns.runs.back().end;
            columns.dx.push_back(scaled - static_cast<float>(cell));
            columns.weight.push_back(fade(columns.dx.back()));
        }
        frequency *= 2.0f;
    }
}

template <class Take>
void NoiseGrid::for_each_noise(const Columns& columns, float y, std::uint32_t seed, Period period, Take&& take) const {
    const std::int32_t cell_y = floor_to_int(y);
    const float dy = y - static_cast<float>(cell_y), v = fade(dy);
    // The slopes at the upper and the lower end of a side between two cells: along x, and the share of dy.
    struct Side {
        float top_x, top_y, bottom_x, bottom_y;
    };
    const std::int32_t upper = wrap(cell_y, period.y), lower = wrap(cell_y + 1, period.y);
    const auto side_at = [&](std::int32_t cell_x) {
        const std::int32_t cell = wrap(cell_x, period.x);
        const Direction &top = gradient(cell, upper, seed), &bottom = gradient(cell, lower, seed);
        return Side{top.x, top.y * dy, bottom.x, bottom.y * (dy - 1.0f)};
    };
    const float* const all_dx     = columns.dx.data();
    const float* const all_weight = columns.weight.data();
    Side left{}, right{};
    const Run* before = nullptr;
    for (const Run& run : columns.runs) {
        left   = before != nullptr && run.cell == before->cell + 1 ? right : side_at(run.cell);
        right  = side_at(run.cell + 1);
        before = &run;
        for (std::size_t i = run.first; i < run.end; ++i) {
            const float dx = all_dx[i], u = all_weight[i];
            const float top = mix(left.top_x * dx + left.top_y, right.top_x * (dx - 1.0f) + right.top_y, u);
            const float bottom =
                mix(left.bottom_x * dx + left.bottom_y, right.bottom_x * (dx - 1.0f) + right.bottom_y, u);
            take(i, mix(top, bottom, v));
        }
    }
}

std::vector<float> NoiseGrid::noise_row(float y, std::uint32_t seed, Period period) const {
    std::vector<float> row(size_);
    float* const values = row.data();
    for_each_noise(octaves_[0], y, seed, period, [=](std::size_t i, float noise) { values[i] = noise; });
    return row;
}

std::vector<float> NoiseGrid::fractal_row(float y, std::uint32_t seed, Period period) const {
    std::vector<float> row(size_, 0.0f);
    float* const sums = row.data();
    float amplitude   = 0.5f;
    for (const Columns& columns : octaves_) {
        for_each_noise(columns, y, seed++, period, [=](std::size_t i, float noise) { sums[i] += amplitude * noise; });
        y *= 2.0f;
        period = doubled(period);
        amplitude *= 0.5f;
    }
    for (float& sum : row) sum *= 1.3f;
    return row;
}

std::vector<float> NoiseGrid::ridged_row(float y, std::uint32_t seed, Period period) const {
    std::vector<float> row(size_, 0.0f);
    float* const sums = row.data();
    float amplitude = 1.0f, total = 0.0f;
    for (const Columns& columns : octaves_) {
        for_each_noise(columns, y, seed++, period, [=](std::size_t i, float noise) {
            const float ridge = 1.0f - std::abs(noise);
            sums[i] += amplitude * ridge * ridge;
        });
        total += amplitude;
        y *= 2.0f;
        period = doubled(period);
        amplitude *= 0.5f;
    }
    for (float& sum : row) sum /= total;
    return row;
}

}  // namespace demo
