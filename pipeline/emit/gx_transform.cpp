// SPDX-License-Identifier: MIT
#include "pipeline/emit/gx_transform.h"

#include <cmath>

namespace pipeline {

namespace {

using Row = glm::dvec4;

Row row_of(const glm::dmat4& matrix, int row) {
    return Row(matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row]);
}

void set_row(GxMatrix& matrix, std::size_t row, const Row& values) {
    for (int column = 0; column < 4; ++column)
        matrix[row][static_cast<std::size_t>(column)] = static_cast<float>(values[column] + 0.0);  // no -0
}

bool is_affine(const glm::dmat4& matrix) {
    return row_of(matrix, 3) == Row(0.0, 0.0, 0.0, 1.0);
}

std::array<float, 6> rounded(const std::array<double, 6>& p) {
    std::array<float, 6> out{};
    for (std::size_t i = 0; i < p.size(); ++i) out[i] = static_cast<float>(p[i]);
    return out;
}

GxMatrix eye_matrix(const glm::dmat4& object_to_camera, double eye_z) {
    GxMatrix matrix{};
    set_row(matrix, 0, row_of(object_to_camera, 0));
    set_row(matrix, 1, row_of(object_to_camera, 1));
    set_row(matrix, 2, row_of(object_to_camera, 2) * eye_z);
    return matrix;
}

// With the depth of distance d being E + F / d, near is where it is 0 and far where it is 1. GX_SetFog asks for 0 < near < far.
std::optional<GxDepthRange> perspective_range(double e, double f) {
    if (!(e > 1.0) || !(f < 0.0)) return {};
    return GxDepthRange{static_cast<float>(-f / e), static_cast<float>(f / (1.0 - e))};
}

// x and y of a row each, and z.
std::optional<GxTransform> perspective(const glm::dmat4& projection, const glm::dmat4& object_to_camera) {
    const Row x = row_of(projection, 0), y = row_of(projection, 1), z = row_of(projection, 2),
              w = row_of(projection, 3);
    if (w.x != 0.0 || w.y != 0.0 || w.w != 0.0 || w.z == 0.0) return {};
    if (x.y != 0.0 || x.w != 0.0 || y.x != 0.0 || y.w != 0.0 || z.x != 0.0 || z.y != 0.0) return {};
    const double scale = std::abs(w.z), eye_z = w.z > 0.0 ? -1.0 : 1.0;
    GxTransform out;
    out.projection.is_perspective = true;
    out.projection.p              = rounded(
                     {x.x / scale, eye_z * x.z / scale, y.y / scale, eye_z * y.z / scale, 1.0 + eye_z * z.z / scale, z.w / scale});
    out.eye_z     = static_cast<float>(eye_z);
    out.position  = eye_matrix(object_to_camera, eye_z);
    out.fog_range = perspective_range(-eye_z * z.z / scale, z.w / scale);
    return out;
}

std::optional<GxDepthRange> orthographic_range(double e, double f) {
    const double near = -f / e, far = (1.0 - f) / e;
    if (near >= 0.0 && far >= 0.0) return GxDepthRange{static_cast<float>(near), static_cast<float>(far)};
    if (near <= 0.0 && far <= 0.0) return GxDepthRange{static_cast<float>(-near), static_cast<float>(-far)};
    return {};
}

// The camera looks along the -z of eye space either way.
std::optional<GxTransform> orthographic(const glm::dmat4& projection, const glm::dmat4& object_to_camera) {
    const Row x = row_of(projection, 0), y = row_of(projection, 1), z = row_of(projection, 2),
              w = row_of(projection, 3);
    if (w.x != 0.0 || w.y != 0.0 || w.z != 0.0 || !(w.w > 0.0)) return {};
    if (x.y != 0.0 || x.z != 0.0 || y.x != 0.0 || y.z != 0.0 || z.x != 0.0 || z.y != 0.0 || z.z == 0.0) return {};
    const double e = z.z / w.w, f = z.w / w.w, eye_z = e > 0.0 ? -1.0 : 1.0;
    GxTransform out;
    out.projection.p = rounded({x.x / w.w, x.w / w.w, y.y / w.w, y.w / w.w, eye_z * e, f - 1.0});
    out.eye_z        = static_cast<float>(eye_z);
    out.position     = eye_matrix(object_to_camera, eye_z);
    out.fog_range    = orthographic_range(e, f);
    return out;
}

// What is left of a row when `part` times another is taken from it, against how large it was.
bool is_small(const glm::dvec3& rest, const glm::dvec3& whole) {
    constexpr double kRounding = 1e-5;  // of the frame's floats
    return glm::dot(rest, rest) <= kRounding * kRounding * glm::dot(whole, whole);
}

std::optional<GxTransform> folded(const glm::dmat4& object_to_clip) {
    const Row x = row_of(object_to_clip, 0), y = row_of(object_to_clip, 1), z = row_of(object_to_clip, 2),
              w = row_of(object_to_clip, 3);
    GxTransform out;
    const glm::dvec3 w3(w), z3(z);
    if (w3 == glm::dvec3(0.0)) {
        if (!(w.w > 0.0)) return {};
        out.projection.p = rounded({1.0, 0.0, 1.0, 0.0, 1.0, -1.0});
        set_row(out.position, 0, x / w.w);
        set_row(out.position, 1, y / w.w);
        set_row(out.position, 2, z / w.w);
        return out;
    }
    const double part = glm::dot(z3, w3) / glm::dot(w3, w3);
    if (!is_small(z3 - part * w3, z3)) return {};
    out.projection.is_perspective = true;
    out.projection.p              = rounded({1.0, 0.0, 1.0, 0.0, 1.0 - part, z.w - part * w.w});
    set_row(out.position, 0, x);
    set_row(out.position, 1, y);
    set_row(out.position, 2, -w);
    return out;
}

}  // namespace

std::optional<GxTransform> gx_transform(const Camera& camera, const Mat4& world) {
    const glm::dmat4 object_to_camera = glm::dmat4(camera.view) * glm::dmat4(world), projection(camera.projection);
    if (is_affine(object_to_camera)) {
        if (const auto found = perspective(projection, object_to_camera)) return found;
        if (const auto found = orthographic(projection, object_to_camera)) return found;
    }
    return folded(projection * object_to_camera);
}

std::array<std::array<float, 4>, 4> gx_rows(const GxProjection& projection) {
    const std::array<float, 6>& p = projection.p;
    if (projection.is_perspective)
        return {
            {{p[0], 0.0f, p[1], 0.0f}, {0.0f, p[2], p[3], 0.0f}, {0.0f, 0.0f, p[4], p[5]}, {0.0f, 0.0f, -1.0f, 0.0f}}};
    return {{{p[0], 0.0f, 0.0f, p[1]}, {0.0f, p[2], 0.0f, p[3]}, {0.0f, 0.0f, p[4], p[5]}, {0.0f, 0.0f, 0.0f, 1.0f}}};
}

GxMatrix gx_texture_matrix(const Camera& camera, const Mat4& world, const Mat4& transform) {
    glm::dmat4 to_camera = glm::dmat4(camera.view) * glm::dmat4(world);
    for (int column = 0; column < 4; ++column) to_camera[column][3] = column == 3 ? 1.0 : 0.0;  // w is taken as 1
    const glm::dmat4 to_texture = glm::dmat4(transform) * to_camera;
    GxMatrix matrix{};
    for (int row = 0; row < 3; ++row) set_row(matrix, static_cast<std::size_t>(row), row_of(to_texture, row));
    return matrix;
}

}  // namespace pipeline
