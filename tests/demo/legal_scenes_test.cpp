// SPDX-License-Identifier: MIT
// The built-in scenes as each chip would draw them: rewritten frames are valid, and their pictures differ by rounding.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <string_view>

#include "demo/scene.h"
#include "pipeline/execute/execute.h"
#include "pipeline/legalize/legalize.h"
#include "pipeline/validate/validate.h"

namespace {

using pipeline::ColorImage;

struct Difference {
    double mean      = 0.0;  // of red, green and blue, absolute, in units of 255
    double far_share = 0.0;  // of pixels that differ by more than 8 in one of them
};

Difference difference(const ColorImage& a, const ColorImage& b) {
    Difference result;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        int greatest = 0;
        for (const int shift : {0, 8, 16}) {
            const int apart =
                std::abs(static_cast<int>(a.pixels[i] >> shift & 255) - static_cast<int>(b.pixels[i] >> shift & 255));
            greatest = std::max(greatest, apart);
            result.mean += apart;
        }
        result.far_share += greatest > 8;
    }
    const auto pixels = static_cast<double>(a.pixels.size());
    return {result.mean / (3.0 * pixels), result.far_share / pixels};
}

// What the arithmetic of each costs, as measured, rounded up. dx7 rounds as the frame does; the others cut at each blend,
// which long chains of them show most, and the GameCube's targets with alpha have 6 bits.
Difference most_allowed(std::string_view profile) {
    if (profile == "dx7") return {0.2, 0.001};
    if (profile == "xbox") return {2.0, 0.001};
    if (profile == "ps2") return {3.5, 0.12};
    if (profile == "gamecube") return {5.5, 0.35};
    return {};
}

}  // namespace

TEST_CASE("scenes rewritten for a chip look as they did", "[legalize]") {
    for (const demo::SceneInfo& info : demo::built_in_scenes()) {
        const demo::ScenePtr scene     = demo::load_scene(info.name);
        const pipeline::Frame frame    = demo::scene_frame(*scene, {160, 90}, demo::frame_count(*scene) / 5);
        const ColorImage ideal_picture = pipeline::execute(frame).output;
        for (const pipeline::Profile& profile : pipeline::profiles()) {
            CAPTURE(info.name, profile.name);
            const pipeline::LegalFrame legal = pipeline::legalize(frame, profile);
            CHECK(pipeline::validate(legal.frame).empty());
            const Difference apart = difference(ideal_picture, pipeline::execute(legal.frame).output);
            const Difference most  = most_allowed(profile.name);
            CHECK(apart.mean <= most.mean);
            CHECK(apart.far_share <= most.far_share);
            if (profile.name == "ideal") CHECK(legal.frame == frame);
            CHECK(legal.left.empty());
        }
    }
}
