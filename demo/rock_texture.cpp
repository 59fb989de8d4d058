// SPDX-License-Identifier: MIT
#include "demo/rock_texture.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "demo/noise.h"
#include "demo/texture_pyramid.h"

namespace demo {
namespace {

using pipeline::Vec3;

Vec3 mix_colors(const Vec3& a, const Vec3& b, float t) {
    return a + (b - a) * t;
}

// u or v at the middle of a texel: 0..1.
float middle_of(int texel, int size) {
    return (static_cast<float>(texel) + 0.5f) / static_cast<float>(size);
}

// set_row(v, texels): colours of a row, 0xAARRGGBB; asked for several rows at once.
template <class SetRow>
pipeline::Texture paint(const char* name, int width, int height, SetRow&& set_row) {
    std::vector<std::uint32_t> pixels(static_cast<std::size_t>(width) * height);
    tbb::parallel_for(0, height, [&](int y) {
        set_row(middle_of(y, height),
                std::span(pixels).subspan(static_cast<std::size_t>(y) * width, static_cast<std::size_t>(width)));
    });
    return texture_pyramid(name, width, height, std::move(pixels));
}

std::vector<float> across(int width, int cells) {
    std::vector<float> columns;
    for (int x = 0; x < width; ++x) columns.push_back(middle_of(x, width) * static_cast<float>(cells));
    return columns;
}

// Noise of whole cells across a tile of `width` texels, one of its rows at a time.
class TiledNoise {
  public:
    TiledNoise(int width, int cells_u, int cells_v, std::uint32_t seed)
        : grid_(across(width, cells_u)), period_{cells_u, cells_v}, seed_(seed) {}

    std::vector<float> row(float v) const { return grid_.noise_row(v * static_cast<float>(period_.y), seed_, period_); }

  private:
    NoiseGrid grid_;
    Period period_;
    std::uint32_t seed_;
};

// Fractal noise of as many cells across as down.
class TiledFractal {
  public:
    TiledFractal(int width, int cells, int octaves, std::uint32_t seed)
        : grid_(across(width, cells), octaves), cells_(cells), seed_(seed) {}

    std::vector<float> row(float v) const {
        return grid_.fractal_row(v * static_cast<float>(cells_), seed_, {cells_, cells_});
    }

  private:
    NoiseGrid grid_;
    int cells_;
    std::uint32_t seed_;
};

// At any place.
float tiled(float u, float v, int cells_u, int cells_v, std::uint32_t seed) {
    return noise(u * static_cast<float>(cells_u), v * static_cast<float>(cells_v), seed, {cells_u, cells_v});
}

// Position within a bed of rock: which one, and how far down in it (0 top, 1 bottom).
struct Bed {
    std::int32_t index;
    float depth;
};
Bed bed_at(float v, int beds) {
    const float scaled = v * static_cast<float>(beds);
    const auto level   = floor_to_int(scaled);
    const auto index   = level % beds;
    return {index < 0 ? index + beds : index, scaled - static_cast<float>(level)};
}

constexpr int kThickBeds = 11, kThinBeds = 64;

// Vertical joints split a bed into blocks. They start at its top; some end before its foot.
class Joints {
  public:
    struct Nearest {
        float darkness, block_tone;  // 0..1
    };

    explicit Joints(std::uint32_t seed) {
        for (std::int32_t bed = 0; bed < kThickBeds; ++bed)
            for (std::int32_t i = 0; i < kJoints; ++i)
                at(bed, i) = {0.7f * hash_unit(i, bed, seed), 0.3f + 1.1f * hash_unit(i, bed, seed + 1u),
                              0.02f + 0.05f * hash_unit(i, bed, seed + 2u), hash_unit(i, bed, seed + 3u)};
    }

    Nearest nearest(float u, const Bed& bed) const {
        const float scaled = (u - static_cast<float>(floor_to_int(u))) * static_cast<float>(kJoints);
        const auto cell    = static_cast<std::int32_t>(scaled);
        Nearest nearest{0.0f, 0.0f};
        std::int32_t block = cell;
        for (std::int32_t i = cell - 1; i <= cell + 1; ++i) {
            const std::int32_t name = (i + kJoints) % kJoints;
            const Joint& joint      = at(bed.index, name);
            const float away        = scaled - (static_cast<float>(i) + 0.15f + joint.place);
            if (away >= 0.0f) block = name;
            const float width = joint.width * (1.0f - 0.5f * bed.depth);
            if (std::abs(away) >= width) continue;
            const float dark = (1.0f - smooth_step(0.0f, width, std::abs(away))) *
                               (1.0f - smooth_step(0.8f, 1.0f, bed.depth / joint.length));
            nearest.darkness = std::max(nearest.darkness, dark);
        }
        nearest.block_tone = at(bed.index, block).tone;
        return nearest;
    }

  private:
    static constexpr int kJoints = 9;

    // place: within its cell, less 0.15; tone: of the block after it.
    struct Joint {
        float place, length, width, tone;
    };
    Joint& at(std::int32_t bed, std::int32_t joint) { return joints_[static_cast<std::size_t>(bed * kJoints + joint)]; }
    const Joint& at(std::int32_t bed, std::int32_t joint) const {
        return joints_[static_cast<std::size_t>(bed * kJoints + joint)];
    }
    std::array<Joint, kThickBeds * kJoints> joints_;
};

// A number 0..1 for each bed.
template <std::size_t kBeds>
std::array<float, kBeds> number_of_beds(std::int32_t which, std::uint32_t seed) {
    std::array<float, kBeds> numbers;
    for (std::size_t bed = 0; bed < kBeds; ++bed) numbers[bed] = hash_unit(static_cast<std::int32_t>(bed), which, seed);
    return numbers;
}

constexpr Vec3 kRust(0.70f, 0.37f, 0.235f), kCream(0.89f, 0.68f, 0.50f), kMaroon(0.47f, 0.225f, 0.16f);
constexpr Vec3 kVarnish(0.25f, 0.16f, 0.145f);

class Rock {
  public:
    static constexpr int kWidth = 512, kHeight = 1024;

    explicit Rock(std::uint32_t seed)
        : seed_(seed),
          sag_(kWidth, 3, 7, seed),
          fine_sag_(kWidth, 15, 40, seed + 1u),
          tones_(kWidth, 6, 24, seed + 5u),
          worn_(kWidth, 5, 31, seed + 6u),
          joint_shift_(kWidth, 15, 90, seed + 7u),
          streaks_(kWidth, 22, 4, seed + 9u),
          wide_streaks_(kWidth, 4, 3, seed + 10u),
          grain_(kWidth, 75, 190, seed + 11u),
          fine_grain_(kWidth, 165, 390, seed + 12u),
          joints_(seed + 8u),
          thick_tone_(number_of_beds<kThickBeds>(0, seed + 3u)),
          thin_tone_(number_of_beds<kThinBeds>(1, seed + 4u)),
          thin_hardness_(number_of_beds<kThinBeds>(2, seed + 13u)) {}

    void set_row(float v, std::span<std::uint32_t> texels) const {
        const auto sag = sag_.row(v), fine_sag = fine_sag_.row(v), tones = tones_.row(v), worn = worn_.row(v);
        const auto joint_shift = joint_shift_.row(v), streaks = streaks_.row(v), wide_streaks = wide_streaks_.row(v);
        const auto grain = grain_.row(v), fine_grain = fine_grain_.row(v);
        const float thickness = 0.026f * tiled(0.5f, v, 1, 13, seed_ + 2u);
        for (std::size_t x = 0; x < texels.size(); ++x) {
            // Beds are not quite level, and of uneven thickness.
            const float level = v + (0.0055f * sag[x] + 0.0016f * fine_sag[x]) + thickness;
            texels[x]         = texel({.u            = middle_of(static_cast<int>(x), kWidth),
                                       .level        = level,
                                       .tone         = tones[x],
                                       .worn         = worn[x],
                                       .joint_shift  = joint_shift[x],
                                       .streaks      = streaks[x],
                                       .wide_streaks = wide_streaks[x],
                                       .grain        = 0.6f * grain[x] + 0.4f * fine_grain[x]})
                            .value;
        }
    }

  private:
    // A place in the wall, and the noises there.
    struct Place {
        float u, level, tone, worn, joint_shift, streaks, wide_streaks, grain;
    };

    pipeline::Argb texel(const Place& at) const {
        const Bed thick = bed_at(at.level, kThickBeds), thin = bed_at(at.level, kThinBeds);
        const float tone = 0.55f * thick_tone_[static_cast<std::size_t>(thick.index)] +
                           0.45f * thin_tone_[static_cast<std::size_t>(thin.index)] + 0.16f * at.tone;
        Vec3 color = tone < 0.45f ? mix_colors(kMaroon, kRust, smooth_step(0.08f, 0.45f, tone))
                                  : mix_colors(kRust, kCream, smooth_step(0.5f, 1.0f, tone));

        // Under the lip of a bed the softer rock has weathered back: a dark line below, a pale edge above.
        const float lip   = 1.0f - smooth_step(0.0f, 0.20f, thin.depth) * smooth_step(0.0f, 0.12f, 1.0f - thin.depth);
        const float major = 1.0f - smooth_step(0.0f, 0.07f, thick.depth);
        const float worn  = smooth_step(-0.25f, 0.5f, at.worn);
        color *= 1.0f - 0.22f * lip * worn - 0.28f * major;
        color *= 1.0f + 0.10f * smooth_step(0.9f, 1.0f, thick.depth);

        const Joints::Nearest joint = joints_.nearest(at.u + 0.0044f * at.joint_shift, thick);
        color *= (1.0f + 0.09f * (joint.block_tone - 0.5f)) * (1.0f - 0.36f * joint.darkness);

        // Varnish: streaks that start at ledges and fade downwards.
        const float streak = smooth_step(0.12f, 0.62f, at.streaks + 0.5f * at.wide_streaks);
        color              = mix_colors(color, kVarnish, 0.30f * streak * (1.0f - 0.6f * thick.depth));

        // Hard beds reach further out of the sand than soft ones and joints.
        const float hard = 0.75f * thin_hardness_[static_cast<std::size_t>(thin.index)] + 0.25f * worn;
        const float bare = std::clamp(hard + 0.5f * at.grain - 0.6f * joint.darkness - 0.3f * lip, 0.0f, 1.0f);
        return to_argb(color * (1.0f + 0.13f * at.grain), kLeastBareness + (1.0f - kLeastBareness) * bare * bare);
    }

    std::uint32_t seed_;
    TiledNoise sag_, fine_sag_, tones_, worn_, joint_shift_, streaks_, wide_streaks_, grain_, fine_grain_;
    Joints joints_;
    std::array<float, kThickBeds> thick_tone_;
    std::array<float, kThinBeds> thin_tone_, thin_hardness_;
};

// The nearest of the stones that are strewn one to a cell with some probability; reach in cells.
struct Strewn {
    float distance;  // 0 in the middle, 1 at the outline, more outside
    float lean;      // -1..1 across, towards the light
    float tone;      // 0..1, its own
};
class Stones {
  public:
    Stones(float probability, float radius, std::uint32_t seed) {
        for (std::int32_t row = 0; row < kCells; ++row)
            for (std::int32_t column = 0; column < kCells; ++column) {
                const auto number = [&](std::uint32_t which) { return hash_unit(column, row, seed + which); };
                at(column, row)   = {!(number(0) > probability), number(1), number(2),
                                     radius * (0.45f + 0.55f * number(3)), number(4)};
            }
    }

    Strewn nearest(float u, float v) const {
        Strewn nearest{9.0f, 0.0f, 0.0f};
        const float x = u * static_cast<float>(kCells), y = v * static_cast<float>(kCells);
        const auto column = static_cast<std::int32_t>(x), row = static_cast<std::int32_t>(y);
        for (std::int32_t j = row - 1; j <= row + 1; ++j)
            for (std::int32_t i = column - 1; i <= column + 1; ++i) {
                const Stone& stone = at(i & (kCells - 1), j & (kCells - 1));
                if (!stone.is_there) continue;
                const float dx = x - static_cast<float>(i) - stone.x, dy = y - static_cast<float>(j) - stone.y;
                const float d = std::sqrt(dx * dx + dy * dy) / stone.size;
                if (d < nearest.distance) nearest = {d, (dx + dy) / stone.size, stone.tone};
            }
        return nearest;
    }

  private:
    static constexpr std::int32_t kCells = 64;

    // Place and size in cells.
    struct Stone {
        bool is_there;
        float x, y, size, tone;
    };
    Stone& at(std::int32_t column, std::int32_t row) {
        return stones_[static_cast<std::size_t>(row * kCells + column)];
    }
    const Stone& at(std::int32_t column, std::int32_t row) const {
        return stones_[static_cast<std::size_t>(row * kCells + column)];
    }
    std::vector<Stone> stones_ = std::vector<Stone>(kCells * kCells);
};

class Sand {
  public:
    static constexpr int kSize = 512;

    explicit Sand(std::uint32_t seed)
        : seed_(seed),
          drift_(kSize, 6, 4, seed),
          grain_(kSize, 150, 150, seed + 11u),
          fine_grain_(kSize, 256, 256, seed + 12u),
          stones_(0.22f, 0.28f, seed + 20u) {}

    void set_row(float v, std::span<std::uint32_t> texels) const {
        const auto drift = drift_.row(v), grain = grain_.row(v), fine_grain = fine_grain_.row(v);
        for (std::size_t x = 0; x < texels.size(); ++x)
            texels[x] =
                texel(middle_of(static_cast<int>(x), kSize), v, drift[x], 0.5f * grain[x] + 0.5f * fine_grain[x]).value;
    }

  private:
    pipeline::Argb texel(float u, float v, float drift, float grain) const {
        const float ripple = tiled(u + 0.02f * drift, v + 0.03f * drift, 9, 60, seed_ + 10u);
        Vec3 color =
            mix_colors(Vec3(0.745f, 0.47f, 0.315f), Vec3(0.85f, 0.625f, 0.445f), smooth_step(-0.7f, 0.7f, drift));
        color *= 1.0f + 0.05f * ripple + 0.10f * grain;

        const Strewn stone = stones_.nearest(u, v);
        if (stone.distance < 1.6f) {
            const float edge = 1.0f - smooth_step(0.75f, 1.15f, stone.distance);
            const float lit  = 0.80f + 0.20f * stone.lean;
            color            = mix_colors(color, mix_colors(kRust, kCream, 0.6f * stone.tone) * lit, edge);
        }
        return to_argb(color);
    }

    std::uint32_t seed_;
    TiledFractal drift_;
    TiledNoise grain_, fine_grain_;
    Stones stones_;
};

}  // namespace

pipeline::Texture rock_texture(std::uint32_t seed) {
    const Rock rock(seed * 977u);
    return paint(kRockTextureName, Rock::kWidth, Rock::kHeight,
                 [&](float v, std::span<std::uint32_t> texels) { rock.set_row(v, texels); });
}

pipeline::Texture sand_texture(std::uint32_t seed) {
    const Sand sand(seed * 991u);
    return paint(kSandTextureName, Sand::kSize, Sand::kSize,
                 [&](float v, std::span<std::uint32_t> texels) { sand.set_row(v, texels); });
}

pipeline::Texture variation_texture(std::uint32_t seed) {
    constexpr int kSize = 256;
    const TiledFractal noise(kSize, 4, 6, seed * 983u);
    return paint(kVariationTextureName, kSize, kSize, [&](float v, std::span<std::uint32_t> texels) {
        const auto row = noise.row(v);
        for (std::size_t x = 0; x < texels.size(); ++x)
            texels[x] = to_argb(Vec3(0.5f + 0.16f * row[x], 0.5f + 0.17f * row[x], 0.5f + 0.18f * row[x])).value;
    });
}

}  // namespace demo
