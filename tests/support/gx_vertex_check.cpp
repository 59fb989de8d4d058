// SPDX-License-Identifier: MIT
#include "tests/support/gx_vertex_check.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "pipeline/execute/fog.h"
#include "tests/support/gx_shading.h"

namespace test_support {

using namespace pipeline;

namespace {

// Homogeneous: the same up to a positive factor, with z' = z - w.
void check_clip(const glm::dvec4& want, const std::array<double, 4>& got) {
    const double scale = std::max({std::abs(want.x), std::abs(want.y), std::abs(want.w), 1e-3});
    if (std::abs(want.w) < 1e-4 * scale) return;
    const double factor = got[3] / want.w, margin = 2e-5 * scale;
    CHECK(factor > 0.0);
    CHECK(got[0] / factor == Approx(want.x).margin(margin));
    CHECK(got[1] / factor == Approx(want.y).margin(margin));
    CHECK(got[2] / factor == Approx(want.z - want.w).margin(margin));
}

struct Lit {
    std::array<int, 4> first{}, second{};
};
Lit frame_colors(const Pass& pass, const CameraLighting& lighting, const Vec3& camera, const Vertex& vertex) {
    const VertexColors colors = light_vertex(lighting, vertex, camera);
    const auto byte           = [](double c) { return static_cast<int>(std::clamp(c, 0.0, 1.0) * 255.0 + 0.5); };
    const auto bytes          = [&](double x, double y, double z, double w) {
        return std::array<int, 4>{byte(x), byte(y), byte(z), byte(w)};
    };
    return {bytes(colors.diffuse.r, colors.diffuse.g, colors.diffuse.b, colors.diffuse.a),
            bytes(colors.specular.r, colors.specular.g, colors.specular.b, fog_factor(pass.state.fog, camera))};
}

void check_coordinates(const Pass& pass, const GxRegisters& r, const Vertex& vertex, const GxVertexRead& read,
                       const Vec3& in_camera) {
    for (std::size_t i = 0; i < kTextureStages; ++i) {
        const int coordinate = coordinate_of(r, static_cast<int>(i));
        if (coordinate < 0) continue;
        const TextureStage& stage      = pass.state.stages[i];
        const std::array<double, 3> st = generated(r, coordinate, read);
        if (stage.coords == CoordSource::CameraPosition) {
            const glm::dvec4 want = glm::dmat4(stage.transform) * glm::dvec4(glm::dvec3(in_camera), 1.0);
            CHECK(st[0] / st[2] == Approx(want.x / want.z).margin(1e-4));
            CHECK(st[1] / st[2] == Approx(want.y / want.z).margin(1e-4));
        } else {
            const Vec2 want = stage.coords == CoordSource::Vertex0 ? vertex.uv0 : vertex.uv1;
            CHECK(st == std::array<double, 3>{static_cast<double>(want.x), static_cast<double>(want.y), 1.0});
        }
    }
}

}  // namespace

GxVertexCheck::GxVertexCheck(const Frame& frame, const Pass& pass, const DrawTriangles& draw)
    : GxVertexCheck(frame.cameras[static_cast<std::size_t>(pass.camera.index)], pass, draw) {}

GxVertexCheck::GxVertexCheck(const Camera& camera, const Pass& pass, const DrawTriangles& draw)
    : pass_(pass),
      to_camera_(glm::dmat4(camera.view) * glm::dmat4(draw.world)),
      to_clip_(glm::dmat4(camera.projection) * to_camera_),
      lighting_(prepare_lighting(pass.state.lighting, camera.view, draw.world)) {}

void GxVertexCheck::operator()(const GxRegisters& r, const Vertex& vertex, const GxVertexRead& read,
                               bool has_vertex_fog) const {
    const bool chip_has_fog = r.fog[0] != 0.0;
    const glm::dvec4 want   = to_clip_ * glm::dvec4(glm::dvec3(vertex.position), 1.0);
    check_clip(want, clip(r, read));
    const Vec3 in_camera(to_camera_ * glm::dvec4(glm::dvec3(vertex.position), 1.0));
    const Lit colors = frame_colors(pass_, lighting_, in_camera, vertex);
    if (r.channel.at(0)[0] == 1) {
        const std::array<int, 4> by_chip = lit(r, read);
        for (std::size_t k = 0; k < 4; ++k) CHECK(std::abs(by_chip[k] - colors.first[k]) <= 2);
    } else {
        CHECK(read.color0 == colors.first);
    }
    if (r.channels > 1 && !std::equal(read.color1.begin(), read.color1.begin() + 3, colors.second.begin()))
        CHECK(read.color1 == colors.second);
    if (has_vertex_fog) CHECK(read.color1[3] == colors.second[3]);
    const double depth = want.z / want.w;
    if (chip_has_fog && want.w > 0.0 && depth > 0.0 && depth < 1.0)
        CHECK(chip_fog(r, depth) == Approx(static_cast<double>(fog_factor(pass_.state.fog, in_camera))).margin(0.006));
    check_coordinates(pass_, r, vertex, read, in_camera);
}

}  // namespace test_support
