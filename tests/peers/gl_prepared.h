// SPDX-License-Identifier: MIT
// The second executor at its best, for times: what does not change from one drawing of a frame to the next is handed
// to OpenGL once. Textures and targets are as in GlExecutor; each draw of triangles is a vertex buffer with an entry
// for each vertex, its fog coordinate with it, and an index buffer, in a vertex array object; state that a draw
// shares with the one before it in its pass is left as it is. What remains is the API's calls and the driver's work.
#pragma once

#include <optional>
#include <vector>

#include "pipeline/frame/frame.h"
#include "tests/peers/gl.h"
#include "tests/peers/gl_memory.h"

namespace peers {

// In a current GlContext, as everything here. The frame is valid, can be expressed, and outlives this.
class GlPreparedFrame {
  public:
    explicit GlPreparedFrame(const pipeline::Frame& frame);
    ~GlPreparedFrame();
    GlPreparedFrame(const GlPreparedFrame&)            = delete;
    GlPreparedFrame& operator=(const GlPreparedFrame&) = delete;

    // All passes, to the end: returns when the last pixel is there.
    void draw();
    pipeline::ColorImage read() { return memory_.read(frame_.output); }

  private:
    struct Arrays {
        GLuint object = 0, vertices = 0, indices = 0;
        GLenum primitive    = GL_TRIANGLES;
        GLuint vertex_count = 0;
        GLsizei index_count = 0;
    };
    static Arrays make_arrays(const std::vector<struct Corner>& corners, const std::vector<std::uint32_t>& indices,
                              int stages);
    Arrays prepare(const pipeline::Pass& pass, const pipeline::Draw& draw) const;
    void draw_pass(const pipeline::Pass& pass, const std::vector<Arrays>& draws);

    const pipeline::Frame& frame_;
    GlMemory memory_;
    std::vector<std::vector<Arrays>> arrays_;  // by pass and draw; of copies empty
};

}  // namespace peers
