// SPDX-License-Identifier: MIT
// Scene files whose numbers are at the ends of what they may be: they are scenes, and their frames are valid.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "demo/camera_matrices.h"
#include "demo/scene_build.h"
#include "demo/scene_file.h"
#include "pipeline/validate/validate.h"

using namespace demo;

namespace {

std::string finding(const std::string& text, int index) {
    const Scene scene   = build_scene(parse_scene(text, "x.toml", "x"));
    const auto findings = validate(scene_frame(scene, {32, 18}, index));
    return findings.empty() ? "" : findings[0].where + " " + findings[0].what;
}

bool is_finite(const Mat4& matrix) {
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            if (!std::isfinite(matrix[i][j])) return false;
    return true;
}

}  // namespace

TEST_CASE("a camera's path may lead through its target, or straight over it", "[demo][scene_file]") {
    // A second a key, 30 frames a second: frame 15 is half-way.
    for (const char* keys : {"[0, 0, 20, 100, 0, 20, 0], [1, 0, 20, -100, 0, 20, 0]",
                             "[0, 0, 60, 100, 0, 20, 0], [1, 0, 60, -100, 0, 20, 0]"}) {
        const std::string path = "[output]\nframes = 31\n[camera]\npath = [" + std::string(keys) + "]\n";
        for (const int index : {0, 14, 15, 16, 30}) {
            INFO(keys << ", frame " << index);
            CHECK(finding(path + "[[cloud]]\ncores = [[0, 20, 0, 10]]\nfractal.size = 8\n", index) == "");
        }
    }
}

TEST_CASE("a camera looks somewhere, wherever its target is", "[demo]") {
    const Vec3 at(3.0f, 5.0f, 7.0f);
    for (const Vec3& to : {at, at + Vec3(0.0f, 9.0f, 0.0f), at - Vec3(0.0f, 9.0f, 0.0f)}) {
        const Mat4 view = look_at(at, to);
        CHECK(is_finite(view));
        CHECK(view[0][0] == 1.0f);  // right is +x
        const glm::vec4 eye = view * glm::vec4(at, 1.0f);
        CHECK(glm::length(Vec3(eye)) < 1e-5f);
    }
    // From below, the target lies ahead.
    CHECK((look_at(at, at + Vec3(0.0f, 9.0f, 0.0f)) * glm::vec4(at + Vec3(0.0f, 9.0f, 0.0f), 1.0f)).z == -9.0f);
    CHECK(is_finite(look_at(Vec3(0.0f), Vec3(0.0f, 0.0f, 1e-45f))));
}

TEST_CASE("the thinnest solids are drawn", "[demo][scene_file]") {
    for (const char* solid : {"kind = \"spire\"\nfrom = [0, 1e5, 0]\nto = [0.001, -1e5, 0.001]",
                              "kind = \"box\"\nfrom = [0, 0, 0]\nto = [0.001, 0.001, 0.001]\ntile = 0.01",
                              "kind = \"cylinder\"\nfrom = [0, 0, 0]\nto = [0.001, 0, 0]\nradius = 1e-320"}) {
        INFO(solid);
        CHECK(finding("[[solid]]\n" + std::string(solid), 0) == "");
    }
}
