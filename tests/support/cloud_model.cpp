// SPDX-License-Identifier: MIT
#include "tests/support/cloud_model.h"

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include "tests/support/glb_file.h"

namespace tests {
namespace {

// Metres, at the end. start, half: shares of the size at 0 and at 1.5 seconds; the heads grow last.
struct Puff {
    float x, y, z, radius, height, start, half;
};
constexpr Puff kPuffs[] = {
    // The base, wide and flat.
    {0, 5, 0, 14, 0.7f, 0.80f, 0.95f},
    {-16, 4, 3, 11, 0.7f, 0.75f, 0.93f},
    {15, 4, -4, 12, 0.7f, 0.75f, 0.93f},
    {4, 4, 14, 10, 0.7f, 0.70f, 0.92f},
    {-6, 4, -13, 10, 0.7f, 0.70f, 0.92f},
    {-28, 4, -3, 8, 0.7f, 0.60f, 0.88f},
    {28, 4, 4, 9, 0.7f, 0.60f, 0.88f},
    {17, 4, 13, 7, 0.7f, 0.60f, 0.88f},
    {-17, 3, 15, 7, 0.7f, 0.60f, 0.88f},
    {-37, 3, 2, 5, 0.7f, 0.50f, 0.80f},
    {38, 3, -2, 5, 0.7f, 0.50f, 0.80f},
    // The middle.
    {-3, 15, 1, 13, 1.0f, 0.55f, 0.85f},
    {10, 14, -5, 11, 1.0f, 0.50f, 0.82f},
    {-14, 12, -4, 10, 1.0f, 0.50f, 0.82f},
    {6, 13, 9, 9, 1.0f, 0.48f, 0.80f},
    {-9, 13, 9, 8, 1.0f, 0.45f, 0.80f},
    {21, 11, 2, 8, 1.0f, 0.45f, 0.78f},
    {-24, 9, 4, 7, 1.0f, 0.45f, 0.78f},
    // The heads.
    {-2, 26, -1, 11, 1.1f, 0.25f, 0.70f},
    {9, 24, 3, 9, 1.1f, 0.22f, 0.66f},
    {-11, 22, 2, 8, 1.1f, 0.22f, 0.66f},
    {2, 34, 1, 8, 1.1f, 0.12f, 0.55f},
    {-6, 32, -4, 6, 1.1f, 0.10f, 0.50f},
    {7, 33, -3, 5, 1.1f, 0.10f, 0.50f},
};

std::string particle_name(std::size_t index) {
    char number[8];
    std::snprintf(number, sizeof number, ".%03d", static_cast<int>(index));
    return index == 0 ? "particle" : std::string("particle") + number;
}

}  // namespace

std::string cloud_model_glb() {
    GlbFile file;
    const int times = file.floats("SCALAR", {0.0f, 1.5f, 3.0f});
    std::vector<float> scales;
    for (const Puff& puff : kPuffs) {
        for (const float share : {puff.start, puff.half, 1.0f}) {
            const float wide = puff.radius * share;
            scales.insert(scales.end(), {wide, wide * puff.height, wide});
        }
    }
    const int view = file.view({reinterpret_cast<const char*>(scales.data()), scales.size() * sizeof(float)});

    Json channels = Json::array(), samplers = Json::array();
    const auto move = [&](int node, const char* path, int keys) {
        channels.push_back({{"sampler", samplers.size()}, {"target", {{"node", node}, {"path", path}}}});
        samplers.push_back({{"input", times}, {"interpolation", "LINEAR"}, {"output", keys}});
    };
    Json children = Json::array();
    for (std::size_t i = 0; i < std::size(kPuffs); ++i) {
        const Puff& puff = kPuffs[i];
        const int keys   = file.add(
              "accessors",
              {{"bufferView", view}, {"byteOffset", i * 36}, {"componentType", kFloat}, {"count", 3}, {"type", "VEC3"}});
        const int node = file.add("nodes", {{"name", particle_name(i)}, {"translation", {puff.x, puff.y, puff.z}}});
        children.push_back(node);
        move(node, "scale", keys);
    }
    const int parent = file.root({{"children", children}, {"name", "Cumulus"}});
    move(parent, "translation", file.floats("VEC3", {0, -4, 0, 0, -1, 0, 0, 0, 0}));
    file.add("animations", {{"channels", channels}, {"name", "Swell"}, {"samplers", samplers}});
    return file.glb();
}

}  // namespace tests
