// SPDX-License-Identifier: MIT
// A fractal over the six faces of a box, without seams: the texels of a face's border lie on the box's edges, so faces
// that share an edge evaluate the noise at the same points and get the same bytes. The box is spanned by texel centres:
// u = 0.5 / size at one edge and 1 - 0.5 / size at the other. Values n are 0..1, all equally frequent, their mean 1/2,
// whatever the noise; coarser mip levels average them, and average border texels over the faces that share them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cloud/cloud.h"
#include "cloud/for_each.h"

namespace cloud {

// Faces +x, -x, +y, -y, +z, -z. On the faces of axis a, u runs along axis a+1 and v along a+2 (modulo 3).
inline constexpr int kBoxFaces = 6;

// What a texel stores of n. Half: n / 2, at most 127, so that ADDSIGNED2X of a clear texel stays 0. Factor: clamp(0.6 +
// 0.8 n), which is 1 for half of all n.
enum class FractalCode : std::uint8_t { Half, Factor };

// A8 texels of each face, all mip levels down to 1x1 one after the other, as pipeline::Texture has them.
using FractalFaces = std::array<std::vector<std::uint8_t>, kBoxFaces>;

// box_size: edges of the box in metres; only their ratio matters, and keeps the noise free of stretching.
FractalFaces make_fractal(const Fractal& fractal, Vec3 box_size, FractalCode code,
                          const ForEach& for_each = one_by_one);

// The number of mip levels of a face.
int fractal_levels(int face_size);

}  // namespace cloud
