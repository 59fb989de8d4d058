// SPDX-License-Identifier: MIT
#include "demo/camera_matrices.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "demo/trigonometry.h"

namespace demo {

Mat4 look_at(const Vec3& eye, const Vec3& target) {
    const glm::dvec3 e(eye);
    // Differences of floats: what is not 0 has a length.
    const auto unit = [](const glm::dvec3& v, const glm::dvec3& if_zero) {
        return v == glm::dvec3(0.0) ? if_zero : glm::normalize(v);
    };
    const glm::dvec3 back  = unit(e - glm::dvec3(target), {0.0, 0.0, 1.0});
    const glm::dvec3 right = unit(glm::cross(glm::dvec3(0.0, 1.0, 0.0), back), {1.0, 0.0, 0.0});
    const glm::dvec3 up    = glm::cross(back, right);
    glm::dmat4 view(1.0);
    for (int axis = 0; axis < 3; ++axis) {
        view[axis][0] = right[axis];
        view[axis][1] = up[axis];
        view[axis][2] = back[axis];
    }
    view[3] = glm::dvec4(-glm::dot(right, e), -glm::dot(up, e), -glm::dot(back, e), 1.0);
    return Mat4(view);
}

Mat4 perspective(double vfov_deg, double aspect, double near_m, double far_m) {
    const double focal = 1.0 / tangent(radians(vfov_deg) / 2.0);
    glm::dmat4 projection(0.0);
    projection[0][0] = focal / aspect;
    projection[1][1] = focal;
    projection[2][2] = far_m / (near_m - far_m);
    projection[2][3] = -1.0;
    projection[3][2] = near_m * far_m / (near_m - far_m);
    return Mat4(projection);
}

Vec3 eye_at(const CameraPath& camera, int index, double seconds) {
    if (!camera.position_path.empty()) return camera.position_path.smooth(seconds);
    const int step     = index % camera.orbit_frames;
    const double swing = radians(camera.orbit_deg) * sine(2.0 * kPi * step / camera.orbit_frames);
    const glm::dvec3 offset(camera.position - camera.target);
    const double c = cosine(swing), s = sine(swing);
    const glm::dvec3 turned(c * offset.x + s * offset.z, offset.y, c * offset.z - s * offset.x);
    return Vec3(glm::dvec3(camera.target) + turned);
}

Vec3 target_at(const CameraPath& camera, double seconds) {
    return camera.target_path.empty() ? camera.target : camera.target_path.smooth(seconds);
}

}  // namespace demo
