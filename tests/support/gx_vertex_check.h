// SPDX-License-Identifier: MIT
// Does a vertex of a GX program come out where, lit and fogged as the frame has it? With Catch's checks.
#pragma once

#include "pipeline/execute/lighting.h"
#include "pipeline/frame/frame.h"
#include "tests/support/gx_log.h"

namespace test_support {

class GxVertexCheck {
  public:
    GxVertexCheck(const pipeline::Frame& frame, const pipeline::Pass& pass, const pipeline::DrawTriangles& draw);

    // has_vertex_fog: fog comes with the second colour, where it is not the chip's own.
    void operator()(const GxRegisters& r, const pipeline::Vertex& vertex, const GxVertexRead& read,
                    bool has_vertex_fog) const;

  private:
    GxVertexCheck(const pipeline::Camera& camera, const pipeline::Pass& pass, const pipeline::DrawTriangles& draw);

    const pipeline::Pass& pass_;
    glm::dmat4 to_camera_, to_clip_;
    pipeline::CameraLighting lighting_;
};

}  // namespace test_support
