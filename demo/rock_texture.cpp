// SPDX-License-Identifier: MIT
#include "demo/rock_texture.h"

#include <algorithm>
#include <cmath>
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

// texel_of(u, v), u and v in 0..1 at texel centres.
template <class TexelOf>
pipeline::Texture paint(const char* name, int width, int height, TexelOf&& texel_of) {
    std::vector<std::uint32_t> pixels;
    pixels.reserve(static_cast<std::size_t>(width) * height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            pixels.push_back(texel_of((static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                                      (static_cast<float>(y) + 0.5f) / static_cast<float>(height))
                                 .value);
    return texture_pyramid(name, width, height, std::move(pixels));
}

// Noise of whole cells across the tile.
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
    const float level  = std::floor(scaled);
    const auto index   = static_cast<std::int32_t>(level) % beds;
    return {index < 0 ? index + beds : index, scaled - level};
}

// Vertical joints split a bed into blocks. They start at its top; some end before its foot.
struct Joint {
    float darkness, block_tone;  // 0..1
};
Joint joint_at(float u, const Bed& bed, std::uint32_t seed) {
    constexpr int kJoints  = 9;
    const float scaled     = (u - std::floor(u)) * static_cast<float>(kJoints);
    const auto cell        = static_cast<std::int32_t>(scaled);
    const auto joint_place = [&](std::int32_t i) {
        return static_cast<float>(i) + 0.15f + 0.7f * hash_unit((i + kJoints) % kJoints, bed.index, seed);
    };
    Joint joint{0.0f, 0.0f};
    std::int32_t block = cell;
    for (std::int32_t i = cell - 1; i <= cell + 1; ++i) {
        const std::int32_t name = (i + kJoints) % kJoints;
        const float away        = scaled - joint_place(i);
        if (away >= 0.0f) block = name;
        const float length = 0.3f + 1.1f * hash_unit(name, bed.index, seed + 1u);
        const float width  = (0.02f + 0.05f * hash_unit(name, bed.index, seed + 2u)) * (1.0f - 0.5f * bed.depth);
        const float dark =
            (1.0f - smooth_step(0.0f, width, std::abs(away))) * (1.0f - smooth_step(0.8f, 1.0f, bed.depth / length));
        joint.darkness = std::max(joint.darkness, dark);
    }
    joint.block_tone = hash_unit(block, bed.index, seed + 3u);
    return joint;
}

constexpr Vec3 kRust(0.70f, 0.37f, 0.235f), kCream(0.89f, 0.68f, 0.50f), kMaroon(0.47f, 0.225f, 0.16f);
constexpr Vec3 kVarnish(0.25f, 0.16f, 0.145f);

pipeline::Argb rock_texel(float u, float v, std::uint32_t seed) {
    // Beds are not quite level, and of uneven thickness.
    const float sag   = 0.0055f * tiled(u, v, 3, 7, seed) + 0.0016f * tiled(u, v, 15, 40, seed + 1u);
    const float level = v + sag + 0.026f * tiled(0.5f, v, 1, 13, seed + 2u);
    const Bed thick = bed_at(level, 11), thin = bed_at(level, 64);
    const float tone = 0.55f * hash_unit(thick.index, 0, seed + 3u) + 0.45f * hash_unit(thin.index, 1, seed + 4u) +
                       0.16f * tiled(u, v, 6, 24, seed + 5u);
    Vec3 color = tone < 0.45f ? mix_colors(kMaroon, kRust, smooth_step(0.08f, 0.45f, tone))
                              : mix_colors(kRust, kCream, smooth_step(0.5f, 1.0f, tone));

    // Under the lip of a bed the softer rock has weathered back: a dark line below, a pale edge above.
    const float lip   = 1.0f - smooth_step(0.0f, 0.20f, thin.depth) * smooth_step(0.0f, 0.12f, 1.0f - thin.depth);
    const float major = 1.0f - smooth_step(0.0f, 0.07f, thick.depth);
    const float worn  = smooth_step(-0.25f, 0.5f, tiled(u, v, 5, 31, seed + 6u));
    color *= 1.0f - 0.22f * lip * worn - 0.28f * major;
    color *= 1.0f + 0.10f * smooth_step(0.9f, 1.0f, thick.depth);

    const Joint joint = joint_at(u + 0.0044f * tiled(u, v, 15, 90, seed + 7u), thick, seed + 8u);
    color *= (1.0f + 0.09f * (joint.block_tone - 0.5f)) * (1.0f - 0.36f * joint.darkness);

    // Varnish: streaks that start at ledges and fade downwards.
    const float streak =
        smooth_step(0.12f, 0.62f, tiled(u, v, 22, 4, seed + 9u) + 0.5f * tiled(u, v, 4, 3, seed + 10u));
    color = mix_colors(color, kVarnish, 0.30f * streak * (1.0f - 0.6f * thick.depth));

    const float grain = 0.6f * tiled(u, v, 75, 190, seed + 11u) + 0.4f * tiled(u, v, 165, 390, seed + 12u);
    // Hard beds reach further out of the sand than soft ones and joints.
    const float hard  = 0.75f * hash_unit(thin.index, 2, seed + 13u) + 0.25f * worn;
    const float bare  = std::clamp(hard + 0.5f * grain - 0.6f * joint.darkness - 0.3f * lip, 0.0f, 1.0f);
    return to_argb(color * (1.0f + 0.13f * grain), kLeastBareness + (1.0f - kLeastBareness) * bare * bare);
}

// The nearest of the stones that are strewn one to a cell with some probability; reach in cells.
struct Strewn {
    float distance;  // 0 in the middle, 1 at the outline, more outside
    float lean;      // -1..1 across, towards the light
    float tone;      // 0..1, its own
};
Strewn strewn_at(float u, float v, int cells, float probability, float radius, std::uint32_t seed) {
    Strewn nearest{9.0f, 0.0f, 0.0f};
    const float x = u * static_cast<float>(cells), y = v * static_cast<float>(cells);
    const auto column = static_cast<std::int32_t>(x), row = static_cast<std::int32_t>(y);
    for (std::int32_t j = row - 1; j <= row + 1; ++j) {
        for (std::int32_t i = column - 1; i <= column + 1; ++i) {
            const std::int32_t cell_x = (i + cells) % cells, cell_y = (j + cells) % cells;
            if (hash_unit(cell_x, cell_y, seed) > probability) continue;
            const float dx   = x - static_cast<float>(i) - hash_unit(cell_x, cell_y, seed + 1u);
            const float dy   = y - static_cast<float>(j) - hash_unit(cell_x, cell_y, seed + 2u);
            const float size = radius * (0.45f + 0.55f * hash_unit(cell_x, cell_y, seed + 3u));
            const float d    = std::sqrt(dx * dx + dy * dy) / size;
            if (d < nearest.distance) nearest = {d, (dx + dy) / size, hash_unit(cell_x, cell_y, seed + 4u)};
        }
    }
    return nearest;
}

pipeline::Argb sand_texel(float u, float v, std::uint32_t seed) {
    const float drift  = fractal_noise(u * 6.0f, v * 6.0f, 4, seed, {6, 6});
    const float ripple = tiled(u + 0.02f * drift, v + 0.03f * drift, 9, 60, seed + 10u);
    const float grain  = 0.5f * tiled(u, v, 150, 150, seed + 11u) + 0.5f * tiled(u, v, 256, 256, seed + 12u);
    Vec3 color = mix_colors(Vec3(0.745f, 0.47f, 0.315f), Vec3(0.85f, 0.625f, 0.445f), smooth_step(-0.7f, 0.7f, drift));
    color *= 1.0f + 0.05f * ripple + 0.10f * grain;

    const Strewn stone = strewn_at(u, v, 64, 0.22f, 0.28f, seed + 20u);
    if (stone.distance < 1.6f) {
        const float edge = 1.0f - smooth_step(0.75f, 1.15f, stone.distance);
        const float lit  = 0.80f + 0.20f * stone.lean;
        color            = mix_colors(color, mix_colors(kRust, kCream, 0.6f * stone.tone) * lit, edge);
    }
    return to_argb(color);
}

}  // namespace

pipeline::Texture rock_texture(std::uint32_t seed) {
    return paint(kRockTextureName, 512, 1024, [&](float u, float v) { return rock_texel(u, v, seed * 977u); });
}

pipeline::Texture sand_texture(std::uint32_t seed) {
    return paint(kSandTextureName, 512, 512, [&](float u, float v) { return sand_texel(u, v, seed * 991u); });
}

pipeline::Texture variation_texture(std::uint32_t seed) {
    return paint(kVariationTextureName, 256, 256, [&](float u, float v) {
        const float slow = fractal_noise(u * 4.0f, v * 4.0f, 6, seed * 983u, {4, 4});
        return to_argb(Vec3(0.5f + 0.16f * slow, 0.5f + 0.17f * slow, 0.5f + 0.18f * slow));
    });
}

}  // namespace demo
