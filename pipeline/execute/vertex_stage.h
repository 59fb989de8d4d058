// SPDX-License-Identifier: MIT
// From object space to window space, for triangles: transform, Direct3D 7 lighting, vertex fog, texture coordinate generation,
// clipping, the viewport and culling. Single precision in one fixed order; no function of the C library but sqrt.
//   clip    Against the near and far plane (0 <= z <= w) and a guard band of kGuardBand pixels around the viewport; what lies
//           between the viewport and the guard band is left to the scissor. An edge is always cut from its inside end, so two
//           triangles that share it get the same new vertex.
//   window  x = X + (1 + cx/cw) * W/2, y = Y + (1 - cy/cw) * H/2, z = cz/cw, rhw = 1/cw, for viewport (X, Y, W, H).
//   cull    By the sign of the area of the snapped corners (raster/primitives.h).
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/frame/frame.h"
#include "raster/primitives.h"

namespace pipeline {

inline constexpr float kGuardBand = 4096.0f;  // pixels; with targets of 8192 this stays within raster::kMaxCoordinate

struct VertexStageCounts {
    std::uint64_t vertices = 0, triangles_in = 0, triangles_drawn = 0;
};

// Appends the triangles of draw's indices [first, first + count) to `out`, in order. `viewport` is already resolved (not empty).
// first and count are multiples of 3 from the draw's own first index.
VertexStageCounts run_vertex_stage(const Frame& frame, const Pass& pass, const DrawTriangles& draw, std::uint32_t first,
                                   std::uint32_t count, const PixelRect& viewport, std::vector<raster::Triangle>& out);

}  // namespace pipeline
