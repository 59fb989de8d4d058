// SPDX-License-Identifier: MIT
// Vectors and matrices of the frame: GLM's, in single precision. Matrices are column-major and multiply column
// vectors (clip = projection * view * world * position); clip space is Direct3D's: -w <= x, y <= w and 0 <= z <= w.
// Window space and rectangles: x right, y down, in pixels; pixel (0, 0) covers [0, 1) x [0, 1), and is sampled where
// Arithmetic::pixel_center says.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace pipeline {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec4 = glm::vec4;
using Mat4 = glm::mat4;

// A colour of four bytes, 0xAARRGGBB as in Direct3D.
struct Argb {
    std::uint32_t value                = 0xffffffff;
    bool operator==(const Argb&) const = default;
};

}  // namespace pipeline
