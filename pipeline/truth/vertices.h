// SPDX-License-Identifier: MIT
// From object space to window space: transform, lighting, fog, texture coordinates, clipping, viewport. The formulas are
// those of the frame's headers, pipeline/execute/vertex_stage.h and lighting.h, in double.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "pipeline/truth/samples.h"

namespace pipeline::truth {

// All of it is linear over a triangle. specular: its alpha is the fog factor, 1 for none. uv: (s, t, q).
struct ClipVertex {
    glm::dvec4 position{0.0};
    Color diffuse{1.0}, specular{0.0, 0.0, 0.0, 1.0};
    std::array<glm::dvec3, kTextureStages> uv{glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.0, 0.0, 1.0)};
};

// x, y in pixels.
struct WindowCorner {
    double x = 0.0, y = 0.0, z = 0.0, rhw = 1.0;
    Color diffuse{1.0}, specular{0.0, 0.0, 0.0, 1.0};
    std::array<glm::dvec3, kTextureStages> uv{glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.0, 0.0, 1.0)};
};
using WindowTriangle = std::array<WindowCorner, 3>;

// What the vertices of a draw share.
struct VertexSetup {
    VertexSetup(const Frame& frame, const Pass& pass, const DrawTriangles& draw);
    const PipelineState& state;
    glm::dmat4 view, to_camera, to_clip;
    glm::dmat3 normal_to_camera;
};
ClipVertex shade(const VertexSetup& setup, const Vertex& vertex);

// pipeline/truth/lighting.cpp. camera: the position in camera space.
void light(const VertexSetup& setup, const Vertex& vertex, const glm::dvec3& camera, ClipVertex& out);
double fog_factor(const FogState& fog, const glm::dvec3& camera);

// To the near and far plane and the guard band around the viewport; a convex polygon, or nothing. pipeline/truth/clip.cpp.
std::vector<ClipVertex> clip(const std::array<ClipVertex, 3>& triangle, const PixelRect& viewport);

// What is drawn: not culled, not out of range; in order.
std::vector<WindowTriangle> window_triangles(const Frame& frame, const Pass& pass, const DrawTriangles& draw,
                                             const PixelRect& viewport);
std::vector<WindowTriangle> window_triangles(const Frame& frame, const Pass& pass, const DrawWindowTriangles& draw);

}  // namespace pipeline::truth
