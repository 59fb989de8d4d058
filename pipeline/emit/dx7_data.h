// SPDX-License-Identifier: MIT
// The side file of the Direct3D 7 program, and where in it things are: texels as the frame has them, level by level, and
// meshes. A mesh is what one call can draw: at most 65535 vertices and triangles, and 16 bit indices that count from its
// first vertex (D3DMAXNUMVERTICES, D3DMAXNUMPRIMITIVES). Everything is little endian and starts at a multiple of 16.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <vector>

#include "pipeline/frame/frame.h"

namespace pipeline::dx7 {

inline constexpr std::size_t kMaxMeshVertices = 65535, kMaxMeshTriangles = 65535;

// position, normal, diffuse, specular, two pairs of coordinates: D3DFVF_XYZ | NORMAL | DIFFUSE | SPECULAR | TEX2
inline constexpr std::size_t kVertexBytes       = 48;
// x y z rhw, diffuse, specular, two pairs: D3DFVF_XYZRHW | DIFFUSE | SPECULAR | TEX2
inline constexpr std::size_t kWindowVertexBytes = 40;

struct Mesh {
    bool is_window            = false;
    std::uint32_t first_index = 0;               // of the frame
    std::size_t vertices = 0, vertex_count = 0;  // byte offset
    std::size_t indices = 0, index_count = 0;
};

struct MeshRange {
    std::size_t first = 0, count = 0;
};

struct Data {
    std::vector<std::uint8_t> bytes;
    std::vector<std::size_t> textures;  // byte offset, for each of the frame's
    std::vector<Mesh> meshes;
    std::vector<std::vector<MeshRange>> draws;  // by pass and draw; empty for what has no mesh
};

// Throws std::invalid_argument for window triangles that cannot be said (emit_dx7.h). Draws of the same indices share
// their meshes.
Data make_data(const Frame& frame);

}  // namespace pipeline::dx7
