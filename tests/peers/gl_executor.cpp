// SPDX-License-Identifier: MIT
#include "tests/peers/gl_executor.h"

#include <stdexcept>

#include "tests/peers/gl_geometry.h"
#include "tests/peers/gl_state.h"

namespace peers {

using namespace pipeline;

namespace {

template <class... Cases>
struct Overloaded : Cases... {
    using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

void check_errors() {
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        throw std::runtime_error("OpenGL reports error " + std::to_string(error));
}

// Without a format in between: the pass's target takes the other's bytes.
void copy(const Pass& pass, const CopyRectangle& draw, GlMemory& memory) {
    const PixelRect& from = draw.from;
    memory.bind(draw.source, {});
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, memory.texture({.texture = {}, .target = pass.color}));
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, draw.x, draw.y, from.x0, from.y0, from.x1 - from.x0, from.y1 - from.y0);
    memory.bind(pass.color, pass.depth);
}

}  // namespace

GlExecutor::GlExecutor(const Frame& frame) : frame_(frame), memory_(frame) {
    check_errors();
}

void GlExecutor::draw_pass(std::size_t index) {
    const Pass& pass = frame_.passes[index];
    memory_.bind(pass.color, pass.depth);
    set_scissor(area_of(frame_, pass).scissor);
    clear(pass.clear);
    set_fragment_state(pass.state);
    for (const Draw& draw : pass.draws)
        std::visit(Overloaded{[&](const DrawTriangles& d) { draw_triangles(frame_, pass, d, memory_); },
                              [&](const DrawRectangle& d) { draw_rectangle(frame_, pass, d, memory_); },
                              [&](const CopyRectangle& d) { copy(pass, d, memory_); }},
                   draw);
    check_errors();
}

Drawn draw_with_gl(const Frame& frame, bool keeps_passes) {
    GlExecutor executor(frame);
    Drawn drawn;
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        executor.draw_pass(i);
        const TargetId color = frame.passes[i].color;
        if (keeps_passes) drawn.passes.push_back(color ? executor.read(color) : ColorImage{});
    }
    drawn.output = executor.read(frame.output);
    return drawn;
}

}  // namespace peers
