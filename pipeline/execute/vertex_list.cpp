// SPDX-License-Identifier: MIT
#include "pipeline/execute/vertex_list.h"

#include <algorithm>

namespace pipeline {
namespace {

// By a table over the interval of indices.
VertexList list_dense(std::span<const std::uint32_t> indices, std::uint32_t least, std::size_t interval) {
    constexpr std::uint32_t kUnused = 0xffffffff;
    std::vector<std::uint32_t> place(interval, kUnused);
    VertexList list;
    list.corners.reserve(indices.size());
    for (const std::uint32_t index : indices) {
        std::uint32_t& found = place[index - least];
        if (found == kUnused) {
            found = static_cast<std::uint32_t>(list.vertices.size());
            list.vertices.push_back(index);
        }
        list.corners.push_back(found);
    }
    return list;
}

// By sorting: few indices far apart must not cost memory for all that lies between them.
VertexList list_sparse(std::span<const std::uint32_t> indices) {
    VertexList list;
    list.vertices.assign(indices.begin(), indices.end());
    std::sort(list.vertices.begin(), list.vertices.end());
    list.vertices.erase(std::unique(list.vertices.begin(), list.vertices.end()), list.vertices.end());
    list.corners.reserve(indices.size());
    for (const std::uint32_t index : indices) {
        const auto found = std::lower_bound(list.vertices.begin(), list.vertices.end(), index);
        list.corners.push_back(static_cast<std::uint32_t>(found - list.vertices.begin()));
    }
    return list;
}

}  // namespace

VertexList list_vertices(std::span<const std::uint32_t> indices) {
    if (indices.empty()) return {};
    const auto [least, greatest] = std::minmax_element(indices.begin(), indices.end());
    const std::size_t interval   = std::size_t{*greatest} - *least + 1;
    return interval <= 16 * indices.size() ? list_dense(indices, *least, interval) : list_sparse(indices);
}

}  // namespace pipeline
