// SPDX-License-Identifier: MIT
// The vertices that a range of indices uses, each once, in the order of first use or of the indices themselves.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace pipeline {

struct VertexList {
    std::vector<std::uint32_t> vertices;  // into Frame::vertices
    std::vector<std::uint32_t> corners;   // for each index of the range, its place in `vertices`
};

VertexList list_vertices(std::span<const std::uint32_t> indices);

}  // namespace pipeline
