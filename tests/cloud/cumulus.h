// SPDX-License-Identifier: MIT
// A cumulus of five cores with a flat base, about 100 m wide, and cameras to see it through, for tests of the clouds.
#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "cloud/cloud.h"
#include "cloud/generate.h"

inline std::vector<cloud::Particle> cumulus_cores() {
    const auto core = [](float x, float y, float z, float radius) {
        return cloud::Particle{.center = cloud::Vec3(x, y, z), .radius = radius};
    };
    return {core(0, 60, 0, 18), core(-20, 58, 4, 15), core(19, 58, -3, 16), core(-36, 55, 2, 11), core(36, 55, 0, 12)};
}

inline cloud::Cloud cumulus() {
    cloud::Cloud cloud;
    cloud.name              = "cumulus";
    cloud.particles         = cloud::grow(cumulus_cores(), {});
    cloud.base_y            = 48.0f;
    cloud.fractal.face_size = 32;
    return cloud;
}

inline cloud::View look(cloud::Vec3 eye, cloud::Vec3 at, int width = 320, int height = 240) {
    cloud::View view;
    view.eye  = eye;
    view.view = glm::lookAtRH(eye, at, cloud::Vec3(0.0f, 1.0f, 0.0f));
    view.projection =
        glm::perspectiveRH_ZO(0.7853982f, static_cast<float>(width) / static_cast<float>(height), 0.5f, 2000.0f);
    view.width  = width;
    view.height = height;
    view.near_m = 0.5f;
    return view;
}
