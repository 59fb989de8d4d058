// SPDX-License-Identifier: MIT
#include "demo/canyon.h"

#include <algorithm>
#include <cmath>

#include "demo/noise.h"

namespace demo {
namespace {

// All lengths below are for the default size and height.
constexpr float kLayoutSize = 3200.0f, kLayoutHeight = 165.0f;

// A rounded box, half sizes rx and rz, turned by the angle whose cosine and sine are given, cut off at `top`.
struct Mesa {
    float x, z, rx, rz, cosine, sine, top;
};
constexpr Mesa kMesas[] = {
    {-40.0f, -116.0f, 70.0f, 27.0f, 0.98f, 0.199f, 86.0f},    // behind the open floor
    {17.0f, -17.0f, 3.0f, 9.0f, 1.0f, 0.0f, 17.0f},           // debris at the foot of a tower on it
    {-14.0f, 60.0f, 1.5f, 1.5f, 1.0f, 0.0f, 7.0f},            // and of another
    {-258.0f, -230.0f, 52.0f, 40.0f, 0.866f, 0.5f, 150.0f},   // the great butte to the left
    {-205.0f, -205.0f, 9.0f, 8.0f, 1.0f, 0.0f, 118.0f},       // its thumb
    {236.0f, -262.0f, 44.0f, 62.0f, 0.94f, -0.342f, 140.0f},  // and its brother to the right
    {176.0f, -206.0f, 10.0f, 9.0f, 1.0f, 0.0f, 112.0f},
    {118.0f, -420.0f, 26.0f, 22.0f, 1.0f, 0.0f, 122.0f},
    {-96.0f, -560.0f, 90.0f, 44.0f, 0.96f, 0.28f, 128.0f},
    {-420.0f, -40.0f, 70.0f, 60.0f, 0.8f, -0.6f, 118.0f},
    {430.0f, -60.0f, 90.0f, 50.0f, 0.6f, 0.8f, 118.0f},
    {330.0f, -640.0f, 60.0f, 60.0f, 1.0f, 0.0f, 150.0f},
    {-520.0f, -480.0f, 90.0f, 60.0f, 0.7071f, 0.7071f, 150.0f},
    {620.0f, -400.0f, 70.0f, 70.0f, 1.0f, 0.0f, 132.0f},
};

// The layers: height of the rock face where a wall is entered by `inside` metres (negative: the talus below it).
struct LayerStep {
    float inside, height;
};
constexpr LayerStep kLayers[] = {
    {0.0f, 38.0f},   {2.0f, 67.0f},   {5.0f, 69.0f},   {6.5f, 85.0f},   {13.0f, 89.0f},
    {15.0f, 120.0f}, {25.0f, 129.0f}, {27.0f, 148.0f}, {33.0f, 151.0f}, {35.0f, 165.0f},
};
constexpr float kTalusWidth = 62.0f;

float wall_height(float inside) {
    if (inside <= -kTalusWidth) return 0.0f;
    if (inside < 0.0f) {
        // Debris lies steeper the nearer it is to the cliff.
        const float s = 1.0f + inside / kTalusWidth;
        return kLayers[0].height * s * (0.25f + 0.75f * s);
    }
    const LayerStep* below = &kLayers[0];
    for (const LayerStep& above : kLayers) {
        if (inside < above.inside) {
            const float t = (inside - below->inside) / (above.inside - below->inside);
            return mix(below->height, above.height, t);
        }
        below = &above;
    }
    return below->height;
}

// Distance inside a mesa's outline, negative outside.
float inside_mesa(const Mesa& mesa, float x, float z) {
    const float dx = x - mesa.x, dz = z - mesa.z;
    const float u         = std::abs(dx * mesa.cosine + dz * mesa.sine) - mesa.rx;
    const float v         = std::abs(dz * mesa.cosine - dx * mesa.sine) - mesa.rz;
    // Rounding the corners over r metres: the box shrinks by r, its outline grows by r.
    const float r         = 0.6f * std::min(mesa.rx, mesa.rz);
    const float outside_u = std::max(u + r, 0.0f), outside_v = std::max(v + r, 0.0f);
    return r - std::sqrt(outside_u * outside_u + outside_v * outside_v) - std::min(std::max(u + r, v + r), 0.0f);
}

// Low ledges: heights drawn towards multiples of `step`, with short steep risers between.
float ledges(float height, float step) {
    const float level = std::floor(height / step);
    return step * (level + smooth_step(0.72f, 1.0f, height / step - level));
}

// Distance from the bed of a dry wash, which winds along the creases of slow noise.
float from_wash(float x, float z, std::uint32_t seed) {
    const float crease = std::abs(noise(x / 330.0f + 0.37f, z / 330.0f + 0.21f, seed + 30u)) * 330.0f;
    return crease + 3.0f * noise(x / 26.0f, z / 26.0f, seed + 31u);
}

float floor_height(float x, float z, std::uint32_t seed) {
    const float swell = 5.0f * fractal_noise(x / 210.0f, z / 210.0f, 3, seed + 10u);
    const float stone = ledges(swell + 0.8f * noise(x / 17.0f, z / 17.0f, seed + 20u), 1.7f);
    const float sand  = 0.35f * noise(x / 9.0f, z / 9.0f, seed + 21u);
    const float bank  = smooth_step(3.0f, 15.0f, from_wash(x, z, seed));
    return mix(-4.5f, 0.72f * stone + 0.28f * swell, bank) + sand;
}

constexpr std::uint32_t kSeedStep = 101u;

}  // namespace

float canyon_wash(const CanyonShape& shape, float x_m, float z_m) {
    const float scale = kLayoutSize / shape.size_m;
    return 1.0f - smooth_step(4.0f, 20.0f, from_wash(x_m * scale, z_m * scale, shape.seed * kSeedStep));
}

float canyon_height(const CanyonShape& shape, float x_m, float z_m) {
    const float scale = kLayoutSize / shape.size_m;
    const float x = x_m * scale, z = z_m * scale;
    const std::uint32_t seed = shape.seed * kSeedStep;

    // Walls wander, are fluted by buttresses, and cut by gullies: all as one shift of the distance into the rock.
    // Detail finer than the grid out there is left out.
    const float from_middle = std::sqrt(x * x + z * z);
    const float fine        = 1.0f - smooth_step(250.0f, 700.0f, from_middle);
    const float wander      = 34.0f * fractal_noise(x / 115.0f, z / 115.0f, 3, seed + 40u);
    const float buttresses  = 13.0f * (ridged_noise(x / 37.0f, z / 37.0f, 2, seed + 50u) - 0.6f);
    const float clefts      = fine * 3.4f * (ridged_noise(x / 13.0f, z / 13.0f, 1, seed + 60u) - 0.6f);
    const float shift       = wander + buttresses + clefts;

    float height = 0.0f;
    for (const Mesa& mesa : kMesas) {
        const float reach = std::abs(x - mesa.x) + std::abs(z - mesa.z);
        if (reach > 1.5f * (mesa.rx + mesa.rz) + 2.0f * kTalusWidth + 60.0f) continue;
        // Small towers keep their outline: the shift is bounded by their size.
        const float strength = smooth_step(0.0f, 40.0f, std::min(mesa.rx, mesa.rz));
        const float inside   = inside_mesa(mesa, x, z) + shift * mix(0.2f, 1.0f, strength);
        const float crown    = 1.2f * noise(x / 13.0f, z / 13.0f, seed + 70u);
        height               = std::max(height, std::min(wall_height(inside), mesa.top + crown));
    }
    // The far rim: a plateau with bays, around the open ground.
    const float distance = std::sqrt(x * x + 1.15f * z * z);
    if (distance > 500.0f) {
        const float bays   = 420.0f * fractal_noise(x / 520.0f, z / 520.0f, 4, seed + 80u);
        const float inside = (distance - 1020.0f) * 0.6f + bays + shift;
        height             = std::max(height, 1.05f * wall_height(0.42f * inside));
    }
    const float ground = floor_height(x, z, seed);
    // Talus lies upon the floor; on top of walls the floor's relief fades.
    const float relief = 1.0f - 0.75f * smooth_step(20.0f, 70.0f, height);
    const float scree  = height > 2.0f && height < 40.0f ? 1.3f * ridged_noise(x / 15.0f, z / 15.0f, 2, seed + 90u) *
                                                              smooth_step(2.0f, 12.0f, height)
                                                         : 0.0f;
    return (height + scree + ground * relief) * (shape.height_m / kLayoutHeight);
}

}  // namespace demo
