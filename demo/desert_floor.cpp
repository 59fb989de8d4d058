// SPDX-License-Identifier: MIT
#include "demo/desert_floor.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "demo/noise.h"
#include "demo/texture_pyramid.h"

namespace demo {
namespace {

using pipeline::Vec3;

constexpr int kWidth = 1024, kHeight = 512;
constexpr float kTexelsPerMeter = static_cast<float>(kWidth) / kDesertFloorWidth;
static_assert(static_cast<float>(kHeight) / kDesertFloorHeight == kTexelsPerMeter);
constexpr float kToSunU = 0.95f, kToSunV = 0.31f;

// A slow function over the tile, kept at every fourth texel and linear between.
class SlowField {
  public:
    // Fractal noise of square cells: `cells` down the tile, twice as many across.
    SlowField(int cells, int octaves, std::uint32_t seed) : values_(kColumns * kRows) {
        std::vector<float> across;
        for (int column = 0; column < kColumns; ++column)
            across.push_back(static_cast<float>(column) / static_cast<float>(kColumns) * static_cast<float>(2 * cells));
        const NoiseGrid noise(across, octaves);
        for (int row = 0; row < kRows; ++row) {
            const float v    = static_cast<float>(row) / static_cast<float>(kRows);
            const auto found = noise.fractal_row(v * static_cast<float>(cells), seed, {2 * cells, cells});
            std::copy(found.begin(), found.end(), values_.begin() + row * kColumns);
        }
    }
    float at(float x, float y) const {
        const float column = x * (1.0f / kStep), row = y * (1.0f / kStep);
        const int left = floor_to_int(column), top = floor_to_int(row);
        const int i = left & (kColumns - 1), j = top & (kRows - 1);
        const int i1 = (i + 1) & (kColumns - 1), j1 = (j + 1) & (kRows - 1);
        const float tx = column - static_cast<float>(left);
        return mix(mix(values_[j * kColumns + i], values_[j * kColumns + i1], tx),
                   mix(values_[j1 * kColumns + i], values_[j1 * kColumns + i1], tx), row - static_cast<float>(top));
    }

  private:
    static constexpr int kStep = 4, kColumns = kWidth / kStep, kRows = kHeight / kStep;
    std::vector<float> values_;
};

// Something small that lies on the ground: a rounded body, lit from the sun's side, and its shade.
struct Lump {
    float x, y, radius;  // texels
    Vec3 color;          // over that of the sand
    float relief;        // how much its sunny side is lighter than its middle
    float ragged;        // 0: round
};

class Floor {
  public:
    explicit Floor(std::uint32_t seed) : seed_(seed), overgrown_(3, 4, seed + 40u), pixels_(kWidth * kHeight) {}

    void paint_sand() {
        const SlowField slow(3, 4, seed_), rills(4, 2, seed_ + 10u), presence(2, 2, seed_ + 20u);
        const SlowField pavement(3, 5, seed_ + 80u);
        tbb::parallel_for(0, kHeight, [&](int y) {
            for (int x = 0; x < kWidth; ++x) {
                const auto fx = static_cast<float>(x), fy = static_cast<float>(y);
                const float tone  = slow.at(fx, fy);
                Vec3 color        = Vec3(1.0f + 0.20f * tone, 1.0f + 0.23f * tone, 1.0f + 0.25f * tone);
                // Pavement of dark pebbles, where the wind has taken the sand; a haze of grass around the shrubs.
                const float bare  = smooth_step(0.05f, 0.22f, pavement.at(fx, fy));
                const float green = smooth_step(0.0f, 0.6f, overgrown_.at(fx, fy));
                color *=
                    mix(1.0f, 0.83f, bare) * Vec3(1.0f - 0.14f * green, 1.0f - 0.07f * green, 1.0f - 0.10f * green);
                // Dry rills along the creases of noise: a pale bed, one bank in the shade.
                const float across = rills.at(fx, fy), here = smooth_step(-0.1f, 0.4f, presence.at(fx, fy));
                const float bed  = 1.0f - smooth_step(0.012f, 0.035f, std::abs(across));
                const float bank = 1.0f - smooth_step(0.006f, 0.03f, std::abs(across - 0.05f));
                color *= 1.0f + here * (0.11f * bed - 0.11f * bank);
                pixels_[static_cast<std::size_t>(y * kWidth + x)] = color;
            }
        });
    }

    void strew() {
        std::vector<Lump> lumps;
        const auto lay = [&](const Lump& lump) { lumps.push_back(lump); };
        const SlowField stony(4, 3, seed_ + 30u);
        strew_cells(160, seed_ + 50u, [&](float x, float y, float chance, float size, float tone) {
            const float density = smooth_step(0.05f, 0.65f, stony.at(x, y));
            if (chance > 0.04f + 0.5f * density) return;
            const Vec3 color = tone < 0.6f ? Vec3(0.80f, 0.70f, 0.68f) : Vec3(1.08f, 1.10f, 1.12f);
            lay({x, y, (0.14f + 0.55f * size * size * size) * kTexelsPerMeter, color, 0.30f, 0.15f});
        });
        strew_cells(112, seed_ + 60u, [&](float x, float y, float chance, float size, float tone) {
            const float density = smooth_step(-0.1f, 0.6f, overgrown_.at(x, y));
            if (chance > 0.06f + 0.62f * density * density) return;
            // Sage, dark juniper, dry grass.
            const Vec3 color  = tone < 0.55f   ? Vec3(0.60f, 0.75f, 0.68f)
                                : tone < 0.80f ? Vec3(0.40f, 0.54f, 0.46f)
                                               : Vec3(0.92f, 1.02f, 0.86f);
            const float large = size * size * size;
            lay({x, y, (0.22f + (0.35f + 0.5f * density) * large) * kTexelsPerMeter, color, 0.26f, 0.35f});
        });
        // Each band of rows takes all lumps in their order, for they lie upon one another.
        constexpr int kBandRows = 32;
        tbb::parallel_for(0, kHeight / kBandRows, [&](int band) {
            for (const Lump& lump : lumps) draw(lump, band * kBandRows, (band + 1) * kBandRows);
        });
    }

    pipeline::Texture texture() && {
        std::vector<std::uint32_t> argb;
        argb.reserve(pixels_.size());
        for (const Vec3& pixel : pixels_) argb.push_back(to_argb(0.5f * pixel).value);
        pixels_ = std::vector<Vec3>();
        return texture_pyramid(kDesertFloorTextureName, kWidth, kHeight, std::move(argb));
    }

  private:
    // One candidate in each of `columns` by half as many cells, each at its own place and with its own numbers 0..1.
    template <class Candidate>
    void strew_cells(int columns, std::uint32_t seed, Candidate&& candidate) {
        const float cell = static_cast<float>(kWidth) / static_cast<float>(columns);
        for (int row = 0; row < columns / 2; ++row)
            for (int column = 0; column < columns; ++column) {
                const auto number = [&](std::uint32_t which) { return hash_unit(column, row, seed + which); };
                candidate((static_cast<float>(column) + number(0)) * cell, (static_cast<float>(row) + number(1)) * cell,
                          number(2), number(3), number(4));
            }
    }

    // Its part in rows first_row <= y < end_row.
    void draw(const Lump& lump, int first_row, int end_row) {
        const float reach = 2.2f * lump.radius + 1.0f;
        const int x0 = static_cast<int>(std::floor(lump.x - reach)), x1 = static_cast<int>(lump.x + reach) + 1;
        const int y0 = static_cast<int>(std::floor(lump.y - reach)), y1 = static_cast<int>(lump.y + reach) + 1;
        const float soft = 0.5f / lump.radius;  // half a texel
        for (int y = y0; y <= y1; ++y) {
            const int row = y & (kHeight - 1);
            if (row < first_row || row >= end_row) continue;
            for (int x = x0; x <= x1; ++x) {
                Vec3& pixel    = pixels_[static_cast<std::size_t>(row * kWidth + (x & (kWidth - 1)))];
                const float dx = (static_cast<float>(x) - lump.x) / lump.radius;
                const float dy = (static_cast<float>(y) - lump.y) / lump.radius;
                // The shade is the body's, moved away from the sun and stretched.
                const float sx = dx + 0.75f * kToSunU, sy = dy + 0.75f * kToSunV;
                const float along = sx * kToSunU + sy * kToSunV, shade2 = sx * sx + sy * sy - 0.4f * along * along;
                if (shade2 < 1.7f)
                    pixel *= 1.0f - 0.42f * (1.0f - smooth_step(0.7f - soft, 1.1f + soft, std::sqrt(shade2)));
                const float uneven =
                    lump.ragged * noise(static_cast<float>(x) * 0.43f, static_cast<float>(y) * 0.43f, seed_ + 70u);
                const float from_middle = std::sqrt(dx * dx + dy * dy) + uneven;
                if (from_middle > 1.0f + soft) continue;
                const float lit    = 1.0f + lump.relief * (dx * kToSunU + dy * kToSunV) + uneven;
                const float inside = 1.0f - smooth_step(0.9f - soft, 1.0f + soft, from_middle);
                pixel += (lump.color * lit - pixel) * inside;
            }
        }
    }

    std::uint32_t seed_;
    SlowField overgrown_;  // where shrubs grow
    std::vector<Vec3> pixels_;
};

}  // namespace

pipeline::Texture desert_floor_texture(std::uint32_t seed) {
    Floor floor(seed * 997u);
    floor.paint_sand();
    floor.strew();
    return std::move(floor).texture();
}

}  // namespace demo
