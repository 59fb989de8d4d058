// SPDX-License-Identifier: MIT
// A draw's colours: by the chip's lights where they say what the frame's lighting says, else computed here, for the vertices.
// The chip's colour channel 0 gives, with all lights' terms in floats and the sum made an integer and kept within 0..255,
//   L = ambient + sum of color * max(0, N.L) / (k0 + k1 d + k2 d^2)     colour = material * (L + (L >> 7)) >> 8
// with N made a unit vector after its matrix. It has no light that takes light away, none that ends at a range, no ambient
// of a light, no emission beside a vertex's colour, and L is cut before the material takes its part. Rather than to list
// such cases, its formula is evaluated at every vertex of a draw: it is used if no byte is more than kLightTolerance from the
// frame's (pipeline/execute/lighting.h). Highlights are always computed here.
// A directional light is a point kDirectionalDistance times as far away as the draw's farthest vertex is from the eye.
// Sources: libogc, gx.h, GX_SetChanCtrl and GX_InitLightAttn; the formula: hwtests, gxtest/lighting.cpp, and Dolphin, pull
// request 360 and VideoBackends/Software/TransformUnit.cpp.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "pipeline/emit/gx_transform.h"
#include "pipeline/execute/lighting.h"
#include "pipeline/frame/frame.h"

namespace pipeline {

inline constexpr int kLightTolerance        = 2;  // of 255
inline constexpr float kDirectionalDistance = 4096.0f;

// In eye space. With a0 = 1, a1 = a2 = 0 no light is a spot.
struct GxLight {
    Vec3 position = Vec3(0.0f);
    Argb color;
    Vec3 k                                = Vec3(1.0f, 0.0f, 0.0f);
    bool operator==(const GxLight&) const = default;
};

struct GxLighting {
    bool material_from_vertex = false, alpha_from_vertex = false;
    Argb ambient, material;
    GxMatrix normal{};
    std::vector<GxLight> lights;
};

// indices: the draw's. Nothing if the chip's lights do not say it.
std::optional<GxLighting> chip_lighting(const Frame& frame, const Pass& pass, const DrawTriangles& draw,
                                        std::span<const std::uint32_t> indices, const GxTransform& transform);

// What the chip makes of a vertex by the formula above.
Argb chip_lit(const GxLighting& lighting, const GxMatrix& position, const Vertex& vertex);

// The frame's colours of vertices: both as bytes, and in the second's alpha the fog factor, 255 for none.
struct VertexBytes {
    Argb first, second;
};
// Refers to the pass.
class VertexColorist {
  public:
    VertexColorist(const Frame& frame, const Pass& pass, const DrawTriangles& draw);
    VertexBytes operator()(const Vertex& vertex) const;

  private:
    const PipelineState& state_;
    CameraLighting lighting_;
    Mat4 object_to_camera_;
};

}  // namespace pipeline
