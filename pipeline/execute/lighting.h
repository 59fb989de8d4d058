// SPDX-License-Identifier: MIT
// The lighting of Direct3D 7, per vertex, in camera space (the viewer at 0, looking along +z). P: the vertex, N: its
// normal times the inverse transpose of the upper 3x3 of view * world (the matrix itself if that is singular),
// normalised only if normalize_normals. For each light, with d = |Plight - P|:
//   L = -direction (unit), A = 1                                                        directional
//   L = norm(Plight - P), A = 1 / (a0 + a1 d + a2 d^2) where d <= range, else 0         point
//   H = norm(L + E)         E = -norm(P) with local_viewer, else (0, 0, -1)
//   diffuse  = Me + Ma (ambient + sum A La) + Md sum A max(0, N.L) Ld                   alpha: that of Md's source
//   specular = Ms sum A (N.H)^power Ls   where N.L > 0 and N.H > 0; (N.H)^0 = 1         0 without specular_enable
// Each colour is clamped to [0, 1] once, after all lights; light colours may be negative. Me, Ma, Md, Ms come from the
// material or from a vertex colour. Source: DirectX 7 SDK help and the MSDN Library of April 2000, "Mathematics of
// Direct3D Lighting"; the attenuation is that of the latter (DirectX 6 scaled d by the range instead).
#pragma once

#include <glm/mat3x3.hpp>
#include <vector>

#include "pipeline/frame/frame.h"

namespace pipeline {

// A light as the loop over vertices wants it.
struct CameraLight {
    bool is_point     = false;
    bool has_specular = false;
    Vec3 to_light     = Vec3(0.0f);  // unit; not of a point light
    Vec3 position     = Vec3(0.0f);  // point light
    Vec3 diffuse, specular, ambient;
    double range = 0.0;
    glm::dvec3 attenuation;
};

struct CameraLighting {
    const LightingState& state;
    glm::mat3 normal_to_camera;
    std::vector<CameraLight> lights;
};

// Done once for many vertices; refers to `state` from then on.
CameraLighting prepare_lighting(const LightingState& state, const Mat4& view, const Mat4& world);

struct VertexColors {
    Vec4 diffuse;
    Vec3 specular;
};

// With lighting disabled: the vertex's own two colours.
VertexColors light_vertex(const CameraLighting& lighting, const Vertex& vertex, const Vec3& camera_position);

// The inverse transpose of the upper 3x3, or that itself if it has no inverse.
glm::mat3 normal_matrix(const glm::dmat4& object_to_camera);

}  // namespace pipeline
