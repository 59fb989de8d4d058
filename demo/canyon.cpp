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
    const auto level = static_cast<float>(floor_to_int(height / step));
    return step * (level + smooth_step(0.72f, 1.0f, height / step - level));
}

// Distance from the bed of a dry wash, which winds along the creases of slow noise. Both noises: of the point over these
// lengths, shifted.
constexpr float kWashLength = 330.0f, kWashShiftX = 0.37f, kWashShiftZ = 0.21f, kWashEdgeLength = 26.0f;

float from_wash(float noise, float edge_noise) {
    const float crease = std::abs(noise) * kWashLength;
    return crease + 3.0f * edge_noise;
}

// The noises: of the floor's swell, its stones and its sand.
float floor_height(float swell_noise, float stone_noise, float sand_noise, float wash_m) {
    const float swell = 5.0f * swell_noise;
    const float stone = ledges(swell + 0.8f * stone_noise, 1.7f);
    const float sand  = 0.35f * sand_noise;
    const float bank  = smooth_step(3.0f, 15.0f, wash_m);
    return mix(-4.5f, 0.72f * stone + 0.28f * swell, bank) + sand;
}

std::vector<float> scaled(std::span<const float> values, float scale) {
    std::vector<float> result(values.begin(), values.end());
    for (float& value : result) value *= scale;
    return result;
}

constexpr std::uint32_t kSeedStep = 101u;

}  // namespace

float canyon_wash(const CanyonShape& shape, float x_m, float z_m) {
    const float scale = kLayoutSize / shape.size_m;
    const float x = x_m * scale, z = z_m * scale;
    const std::uint32_t seed = shape.seed * kSeedStep;
    const float crease       = noise(x / kWashLength + kWashShiftX, z / kWashLength + kWashShiftZ, seed + 30u);
    const float edge         = noise(x / kWashEdgeLength, z / kWashEdgeLength, seed + 31u);
    return 1.0f - smooth_step(4.0f, 20.0f, from_wash(crease, edge));
}

CanyonHeights::CanyonHeights(const CanyonShape& shape, std::span<const float> x)
    : scale_(kLayoutSize / shape.size_m),
      height_scale_(shape.height_m / kLayoutHeight),
      seed_(shape.seed * kSeedStep),
      x_(scaled(x, scale_)),
      wander_(noise_of(115.0f, 3)),
      buttresses_(noise_of(37.0f, 2)),
      clefts_(noise_of(13.0f)),
      bays_(noise_of(520.0f, 4)),
      scree_(noise_of(15.0f, 2)),
      swell_(noise_of(210.0f, 3)),
      stones_(noise_of(17.0f)),
      sand_(noise_of(9.0f)),
      wash_(noise_of(kWashLength, 1, kWashShiftX)),
      wash_edge_(noise_of(kWashEdgeLength)) {}

NoiseGrid CanyonHeights::noise_of(float length_m, int octaves, float shift) const {
    std::vector<float> columns;
    for (const float x : x_) columns.push_back(x / length_m + shift);
    return NoiseGrid(columns, octaves);
}

void CanyonHeights::row(float z_m, std::span<float> heights) const {
    const float z     = z_m * scale_;
    const auto wander = wander_.fractal_row(z / 115.0f, seed_ + 40u), bays = bays_.fractal_row(z / 520.0f, seed_ + 80u);
    const auto buttresses = buttresses_.ridged_row(z / 37.0f, seed_ + 50u);
    const auto clefts = clefts_.ridged_row(z / 13.0f, seed_ + 60u), crowns = clefts_.noise_row(z / 13.0f, seed_ + 70u);
    const auto swell = swell_.fractal_row(z / 210.0f, seed_ + 10u), stones = stones_.noise_row(z / 17.0f, seed_ + 20u);
    const auto sand = sand_.noise_row(z / 9.0f, seed_ + 21u), scree = scree_.ridged_row(z / 15.0f, seed_ + 90u);
    const auto wash      = wash_.noise_row(z / kWashLength + kWashShiftZ, seed_ + 30u);
    const auto wash_edge = wash_edge_.noise_row(z / kWashEdgeLength, seed_ + 31u);

    const auto is_beyond = [](const Mesa& mesa, float reach) {
        return reach > 1.5f * (mesa.rx + mesa.rz) + 2.0f * kTalusWidth + 60.0f;
    };
    std::vector<Mesa> mesas;
    for (const Mesa& mesa : kMesas)
        if (!is_beyond(mesa, std::abs(z - mesa.z))) mesas.push_back(mesa);

    for (std::size_t i = 0; i < x_.size(); ++i) {
        const float x           = x_[i];
        // Walls wander, are fluted by buttresses, and cut by gullies: all as one shift of the distance into the rock.
        // Detail finer than the grid out there is left out.
        const float from_middle = std::sqrt(x * x + z * z);
        const float fine        = 1.0f - smooth_step(250.0f, 700.0f, from_middle);
        const float shift       = 34.0f * wander[i] + 13.0f * (buttresses[i] - 0.6f) + fine * 3.4f * (clefts[i] - 0.6f);

        float height = 0.0f;
        for (const Mesa& mesa : mesas) {
            if (is_beyond(mesa, std::abs(x - mesa.x) + std::abs(z - mesa.z))) continue;
            // Small towers keep their outline: the shift is bounded by their size.
            const float strength = smooth_step(0.0f, 40.0f, std::min(mesa.rx, mesa.rz));
            const float inside   = inside_mesa(mesa, x, z) + shift * mix(0.2f, 1.0f, strength);
            height               = std::max(height, std::min(wall_height(inside), mesa.top + 1.2f * crowns[i]));
        }
        // The far rim: a plateau with bays, around the open ground.
        const float distance = std::sqrt(x * x + 1.15f * z * z);
        if (distance > 500.0f) {
            const float inside = (distance - 1020.0f) * 0.6f + 420.0f * bays[i] + shift;
            height             = std::max(height, 1.05f * wall_height(0.42f * inside));
        }
        const float ground = floor_height(swell[i], stones[i], sand[i], from_wash(wash[i], wash_edge[i]));
        // Talus lies upon the floor; on top of walls the floor's relief fades.
        const float relief = 1.0f - 0.75f * smooth_step(20.0f, 70.0f, height);
        const float debris =
            height > 2.0f && height < 40.0f ? 1.3f * scree[i] * smooth_step(2.0f, 12.0f, height) : 0.0f;
        heights[i] = (height + debris + ground * relief) * height_scale_;
    }
}

float canyon_height(const CanyonShape& shape, float x, float z) {
    float height = 0.0f;
    CanyonHeights(shape, {&x, 1}).row(z, {&height, 1});
    return height;
}

}  // namespace demo
