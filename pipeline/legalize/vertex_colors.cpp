// SPDX-License-Identifier: MIT
#include "pipeline/legalize/vertex_colors.h"

#include <algorithm>
#include <map>
#include <utility>

namespace pipeline {

namespace {

constexpr std::size_t kNoKind = static_cast<std::size_t>(-1);

std::span<const std::uint32_t> indices_of(const Frame& frame, const DrawTriangles& draw) {
    return std::span(frame.indices).subspan(draw.first_index, draw.index_count);
}

class VertexColors {
  public:
    VertexColors(Frame& frame, std::span<const Recolor> kinds)
        : frame_(frame), kinds_(kinds), original_(frame.vertices), kind_(frame.vertices.size(), kNoKind) {}

    void recolor(DrawTriangles& draw, std::size_t kind) {
        bool shares = false;
        for (const std::uint32_t vertex : indices_of(frame_, draw)) {
            if (kind_[vertex] == kNoKind) {
                kind_[vertex] = kind;
                kinds_[kind](frame_.vertices[vertex]);
            }
            shares = shares || kind_[vertex] != kind;
        }
        if (shares) draw.first_index = own_indices(draw, kind);
    }

  private:
    // Draws of the same indices and kind share them again.
    std::uint32_t own_indices(const DrawTriangles& draw, std::size_t kind) {
        const auto [found, is_new] = ranges_.insert({{{draw.first_index, draw.index_count}, kind}, 0});
        if (!is_new) return found->second;
        found->second = static_cast<std::uint32_t>(frame_.indices.size());
        for (std::uint32_t i = 0; i < draw.index_count; ++i) {
            const std::uint32_t vertex = frame_.indices[draw.first_index + i];
            frame_.indices.push_back(kind_[vertex] == kind ? vertex : copy_of(vertex, kind));
        }
        return found->second;
    }

    std::uint32_t copy_of(std::uint32_t vertex, std::size_t kind) {
        const auto [found, is_new] = copies_.insert({{vertex, kind}, 0});
        if (!is_new) return found->second;
        found->second = static_cast<std::uint32_t>(frame_.vertices.size());
        frame_.vertices.push_back(original_[vertex]);
        kinds_[kind](frame_.vertices.back());
        return found->second;
    }

    Frame& frame_;
    std::span<const Recolor> kinds_;
    std::vector<Vertex> original_;
    std::vector<std::size_t> kind_;  // that a vertex has in its first place
    std::map<std::pair<std::pair<std::uint32_t, std::uint32_t>, std::size_t>, std::uint32_t> ranges_;
    std::map<std::pair<std::uint32_t, std::size_t>, std::uint32_t> copies_;
};

}  // namespace

void recolor_vertices(Frame& frame, std::span<const DrawColors> draws, std::span<const Recolor> kinds) {
    VertexColors colors(frame, kinds);
    for (const auto& [draw, kind] : draws) colors.recolor(*draw, kind);
}

}  // namespace pipeline
