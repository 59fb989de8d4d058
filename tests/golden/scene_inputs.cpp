// SPDX-License-Identifier: MIT
#include "tests/golden/scene_inputs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/support/png_bytes.h"

namespace tests {
namespace {

// 0..1 in steps of 2^-24, another value each time (the "quick and dirty" generator of Numerical Recipes).
class Sequence {
  public:
    explicit Sequence(std::uint32_t seed) : state_(seed) {}
    double next() {
        state_ = state_ * 1664525u + 1013904223u;
        return static_cast<double>(state_ >> 8) / 16777216.0;
    }

  private:
    std::uint32_t state_;
};

constexpr int kMapSize = 129;

// Smooth, 0..1: random values at the corners of square cells of `cell` pixels, a quintic between them.
double value_noise(double x, double y, int cell, std::uint32_t seed) {
    const auto corner = [&](int column, int row) {
        std::uint32_t h = (static_cast<std::uint32_t>(column) * 0x9e3779b1u) ^
                          (static_cast<std::uint32_t>(row) * 0x85ebca77u) ^ (seed * 0xc2b2ae3du);
        h = (h ^ (h >> 15)) * 0x2c1b3c6du;
        h = (h ^ (h >> 12)) * 0x297a2d39u;
        return static_cast<double>((h ^ (h >> 15)) >> 8) / 16777216.0;
    };
    const auto curve = [](double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); };
    const int column = static_cast<int>(x / cell), row = static_cast<int>(y / cell);
    const double tx = curve(x / cell - column), ty = curve(y / cell - row);
    const double top    = corner(column, row) * (1.0 - tx) + corner(column + 1, row) * tx;
    const double bottom = corner(column, row + 1) * (1.0 - tx) + corner(column + 1, row + 1) * tx;
    return top * (1.0 - ty) + bottom * ty;
}

// 0..1, sharp along the top.
double ridges(double x, double y) {
    double sum = 0.0, weight = 0.5, upper = 1.0;
    for (const int cell : {32, 16, 8, 4}) {
        const double fold = 1.0 - std::abs(2.0 * value_noise(x, y, cell, 3) - 1.0);
        const double edge = fold * fold * upper;
        sum += weight * edge;
        weight *= 0.5;
        upper = std::min(2.0 * edge, 1.0);  // fine ridges on coarse ones, valleys stay smooth
    }
    return sum / 0.9375;
}

// In pixels of the map across and down; heights are scaled at the end.
struct Hill {
    double x, y, radius, height;
};

double height(double x, double y) {
    static constexpr Hill kHills[]  = {{22, 14, 44, 70}, {8, 46, 34, 50},   {126, 62, 30, 55},
                                       {34, 98, 36, 20}, {104, 92, 34, 26}, {84, 22, 50, 70}};
    static constexpr Hill kRidges[] = {{84, 22, 42, 270}, {20, 6, 40, 120}};
    const auto rise                 = [&](const Hill& hill) {
        const double dx = x - hill.x, dy = y - hill.y;
        const double inside = std::max(1.0 - (dx * dx + dy * dy) / (hill.radius * hill.radius), 0.0);
        return hill.height * (inside * inside * inside);
    };
    double sum = 14.0 * value_noise(x, y, 16, 1) + 5.0 * value_noise(x, y, 8, 2);
    for (const Hill& hill : kHills) sum += rise(hill);
    double rough = 0.0;
    for (const Hill& hill : kRidges) rough += rise(hill);
    return sum + rough * ridges(x, y);
}

using Color = std::array<int, 3>;

// stalks: share of pixels, in 1/256, that are of the third colour.
struct TextureRule {
    std::uint32_t seed;
    int reach_x, reach_y;  // of the rectangle, to either side
    Color dark, light, stalk;
    int stalks;
};

std::string texture_png(const TextureRule& rule) {
    constexpr int kSize = 64;
    Sequence random(rule.seed);
    std::array<int, kSize * kSize> values{};
    for (int& value : values) value = static_cast<int>(256.0 * random.next());
    const auto at = [&](int x, int y) { return values[(y & (kSize - 1)) * kSize + (x & (kSize - 1))]; };
    std::vector<std::string> rows(kSize);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            int sum = 0, count = 0;
            for (int dy = -rule.reach_y; dy <= rule.reach_y; ++dy)
                for (int dx = -rule.reach_x; dx <= rule.reach_x; ++dx, ++count) sum += at(x + dx, y + dy);
            // The mean of many values keeps near 128: spread three times as wide.
            const int share     = std::clamp(128 + 3 * (sum / count - 128), 0, 255);
            const bool is_stalk = at(x, y) >= 256 - rule.stalks;
            for (std::size_t c = 0; c < 3; ++c) {
                const int mixed = rule.dark[c] + (rule.light[c] - rule.dark[c]) * share / 255;
                rows[y] += static_cast<char>(is_stalk ? rule.stalk[c] : mixed);
            }
        }
    return png_bytes(kSize, kSize, {.color_type = 2, .bits = 8}, rows);
}

}  // namespace

std::string two_clouds_heights_png() {
    std::vector<double> heights;
    for (int y = 0; y < kMapSize; ++y)
        for (int x = 0; x < kMapSize; ++x) heights.push_back(height(x, y));
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    std::vector<std::string> rows(kMapSize);
    for (int i = 0; i < kMapSize * kMapSize; ++i) {
        const auto grey = static_cast<std::uint32_t>((heights[i] - *low) / (*high - *low) * 65535.0 + 0.5);
        rows[i / kMapSize] += static_cast<char>(grey >> 8);
        rows[i / kMapSize] += static_cast<char>(grey & 255);
    }
    return png_bytes(kMapSize, kMapSize, {.color_type = 0, .bits = 16}, rows);
}

std::string two_clouds_grass_png() {
    return texture_png({.seed    = 11,
                        .reach_x = 1,
                        .reach_y = 1,
                        .dark    = {94, 120, 60},
                        .light   = {124, 147, 78},
                        .stalk   = {150, 154, 92},
                        .stalks  = 12});
}

std::string two_clouds_rock_png() {
    return texture_png({.seed    = 5,
                        .reach_x = 3,
                        .reach_y = 1,
                        .dark    = {98, 96, 84},
                        .light   = {156, 152, 132},
                        .stalk   = {},
                        .stalks  = 0});
}

}  // namespace tests
