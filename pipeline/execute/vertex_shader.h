// SPDX-License-Identifier: MIT
// What the vertex stage (vertex_stage.h) makes of a vertex by itself: position, colours, fog and texture coordinates.
// Vertices that no clip plane cuts go through in blocks, by the kernels of raster/vertex_blocks.h where they have what
// the state asks for. Those at a cut stay floats, one at a time; both ways give the same bits.
#pragma once

#include <cstdint>
#include <span>

#include "pipeline/execute/clip.h"
#include "pipeline/execute/lighting.h"
#include "pipeline/execute/window.h"
#include "pipeline/frame/frame.h"
#include "raster/vertex_blocks.h"

namespace pipeline {

// How shade_block is done, for tests: Scalar is one vertex at a time, whatever the state.
enum class ShadingPath : std::uint8_t { Kernels, Scalar };

class VertexShader {
  public:
    // Refers to all of them.
    VertexShader(const Frame& frame, const Pass& pass, const DrawTriangles& draw, const PixelRect& viewport,
                 float guard_band = kGuardBand, ShadingPath path = ShadingPath::Kernels);

    // Both: of the frame's vertices that are listed, kVertexBlock at most.
    void place_block(std::span<const std::uint32_t> vertices, raster::PlacedVertices& out) const;
    void shade_block(std::span<const std::uint32_t> vertices, raster::Vertex* out) const;

    ClipVertex shade(const Vertex& vertex) const;
    const Window& window() const { return window_; }

  private:
    void shade_one_by_one(std::span<const std::uint32_t> vertices, raster::Vertex* out) const;
    void fog_block(const raster::Points4& camera, int count, raster::VertexLanes<std::uint32_t>& out) const;
    void light_block(std::span<const std::uint32_t> vertices, raster::VertexColors& colors) const;
    void coords_block(std::span<const std::uint32_t> vertices, const raster::Points4& camera,
                      raster::Vertex* out) const;

    const std::vector<Vertex>& source_;
    const PipelineState& state_;
    Window window_;
    CameraLighting lighting_;
    int stage_count_;
    Mat4 object_to_camera_{1.0f}, object_to_clip_{1.0f};

    // For the kernels.
    raster::VertexKernels kernels_;
    raster::WindowTransform window_transform_;
    raster::Matrix4 to_camera_{}, to_clip_{};
    raster::LinearFog fog_;
    raster::DirectionalLighting directional_;
    bool one_by_one_  = false;
    bool uses_camera_ = false;  // the vertex in camera space is read by something
};

// The bytes and texture coordinates of a vertex that has been placed.
void set_attributes(const ClipVertex& from, raster::Vertex& to);

}  // namespace pipeline
