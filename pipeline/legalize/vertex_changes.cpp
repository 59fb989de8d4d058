// SPDX-License-Identifier: MIT
#include "pipeline/legalize/vertex_changes.h"

#include <algorithm>
#include <map>
#include <utility>

namespace pipeline {

namespace {

constexpr std::size_t kNoKind = static_cast<std::size_t>(-1);

// Of one kind of vertex, and the draws that use it.
template <class AnyVertex, class Triangles>
class Changes {
  public:
    Changes(Frame& frame, std::vector<AnyVertex>& vertices, std::span<const VertexChange> kinds)
        : frame_(frame), vertices_(vertices), kinds_(kinds), original_(vertices), kind_(vertices.size(), kNoKind) {}

    void change(Triangles& draw, std::size_t kind) {
        bool shares = false;
        for (const std::uint32_t vertex : std::span(frame_.indices).subspan(draw.first_index, draw.index_count)) {
            if (kind_[vertex] == kNoKind) {
                kind_[vertex] = kind;
                apply(kind, vertices_[vertex]);
            }
            shares = shares || kind_[vertex] != kind;
        }
        if (shares) draw.first_index = own_indices(draw, kind);
    }

  private:
    void apply(std::size_t kind, Vertex& vertex) const {
        if (kinds_[kind].vertex) kinds_[kind].vertex(vertex);
    }
    void apply(std::size_t kind, WindowVertex& vertex) const {
        if (kinds_[kind].window_vertex) kinds_[kind].window_vertex(vertex);
    }

    // Draws of the same indices and kind share them again.
    std::uint32_t own_indices(const Triangles& draw, std::size_t kind) {
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
        found->second = static_cast<std::uint32_t>(vertices_.size());
        vertices_.push_back(original_[vertex]);
        apply(kind, vertices_.back());
        return found->second;
    }

    Frame& frame_;
    std::vector<AnyVertex>& vertices_;
    std::span<const VertexChange> kinds_;
    std::vector<AnyVertex> original_;
    std::vector<std::size_t> kind_;  // that a vertex has in its first place
    std::map<std::pair<std::pair<std::uint32_t, std::uint32_t>, std::size_t>, std::uint32_t> ranges_;
    std::map<std::pair<std::uint32_t, std::size_t>, std::uint32_t> copies_;
};

}  // namespace

void change_vertices(Frame& frame, std::span<const ChangedDraw> draws, std::span<const VertexChange> kinds) {
    Changes<Vertex, DrawTriangles> vertices(frame, frame.vertices, kinds);
    Changes<WindowVertex, DrawWindowTriangles> window_vertices(frame, frame.window_vertices, kinds);
    for (const auto& [draw, kind] : draws) {
        if (auto* triangles = std::get_if<DrawTriangles>(draw)) vertices.change(*triangles, kind);
        if (auto* triangles = std::get_if<DrawWindowTriangles>(draw)) window_vertices.change(*triangles, kind);
    }
}

std::uint32_t append_changed(Frame& frame, const DrawWindowTriangles& draw,
                             const std::function<void(WindowVertex&)>& change) {
    const auto first = static_cast<std::uint32_t>(frame.indices.size());
    std::map<std::uint32_t, std::uint32_t> places;
    for (std::uint32_t i = 0; i < draw.index_count; ++i) {
        const std::uint32_t vertex = frame.indices[draw.first_index + i];
        const auto [found, is_new] = places.insert({vertex, static_cast<std::uint32_t>(frame.window_vertices.size())});
        if (is_new) {
            frame.window_vertices.push_back(frame.window_vertices[vertex]);
            change(frame.window_vertices.back());
        }
        frame.indices.push_back(found->second);
    }
    return first;
}

VertexChange change_of_diffuse(std::function<Argb(Argb)> change) {
    const auto change_any = [change = std::move(change)](auto& vertex) { vertex.diffuse = change(vertex.diffuse); };
    return {change_any, change_any};
}

}  // namespace pipeline
