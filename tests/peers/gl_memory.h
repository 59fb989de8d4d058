// SPDX-License-Identifier: MIT
// A frame's targets and textures as objects of OpenGL. Row 0 of every image is its top row, as in the frame: what
// OpenGL takes for the bottom, so all drawing is upside down to it (see gl_geometry.h).
#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "pipeline/execute/execute.h"
#include "pipeline/frame/frame.h"
#include "tests/peers/gl.h"

namespace peers {

class GlMemory {
  public:
    // Targets become all zeros. Needs a current context, as everything here does; the frame must outlive this.
    explicit GlMemory(const pipeline::Frame& frame);
    ~GlMemory();
    GlMemory(const GlMemory&)            = delete;
    GlMemory& operator=(const GlMemory&) = delete;

    // The texture that is bound, or a white one if nothing is.
    GLuint texture(const pipeline::TextureBinding& binding) const;

    GLuint sampler(int unit) const { return samplers_[static_cast<std::size_t>(unit)]; }

    // Makes the two targets, one of which may refer to nothing, what is drawn to and read from.
    void bind(pipeline::TargetId color, pipeline::TargetId depth);

    // Into a colour target that is bound alone, and stays so.
    void copy(const pipeline::CopyRectangle& draw, pipeline::TargetId into);

    pipeline::ColorImage read(pipeline::TargetId color);
    void write(pipeline::TargetId color, const pipeline::ColorImage& picture);

  private:
    void make_target(const pipeline::Target& target);
    void make_texture(const pipeline::Texture& texture);
    void clear_targets();

    const pipeline::Frame& frame_;
    std::vector<GLuint> targets_;  // textures for colour, renderbuffers for depth
    std::vector<GLuint> textures_;
    GLuint white_ = 0;
    std::array<GLuint, pipeline::kTextureStages> samplers_{};
    std::map<std::pair<int, int>, GLuint> framebuffers_;  // by colour and depth target
};

}  // namespace peers
