// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "pipeline/frame/frame.h"

namespace pipeline {

// The alpha of all that a pass draws, as far as it shows without drawing: vertex or rectangle colours, unlit, without
// texture stages.
class DrawnAlpha {
  public:
    DrawnAlpha(const Frame& frame, const Pass& pass) {
        is_known_ = stage_count(pass.state) == 0 && !pass.state.lighting.enabled;
        for (const Draw& draw : pass.draws) {
            if (const auto* rectangle = std::get_if<DrawRectangle>(&draw)) add(rectangle->color);
            if (const auto* triangles = std::get_if<DrawTriangles>(&draw)) add(frame, *triangles, frame.vertices);
            if (const auto* triangles = std::get_if<DrawWindowTriangles>(&draw))
                add(frame, *triangles, frame.window_vertices);
        }
    }
    bool is(std::uint32_t alpha) const { return is_known_ && alpha_ == alpha; }

  private:
    template <class Triangles, class AnyVertex>
    void add(const Frame& frame, const Triangles& draw, const std::vector<AnyVertex>& vertices) {
        for (std::uint32_t i = 0; i < draw.index_count && is_known_; ++i)
            add(vertices[frame.indices[draw.first_index + i]].diffuse);
    }
    void add(Argb color) {
        const std::uint32_t alpha = color.value >> 24;
        is_known_                 = is_known_ && alpha_.value_or(alpha) == alpha;
        alpha_                    = alpha;
    }
    bool is_known_ = true;
    std::optional<std::uint32_t> alpha_;
};

}  // namespace pipeline
