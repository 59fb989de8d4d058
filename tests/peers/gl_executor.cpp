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

GlExecutor::GlExecutor(const Frame& frame, std::optional<WindowTriangles> given)
    : frame_(frame), given_(given), memory_(frame) {
    check_errors();
}

void GlExecutor::draw_pass(std::size_t index) {
    const Pass& pass = frame_.passes[index];
    memory_.bind(pass.color, pass.depth);
    set_scissor(area_of(frame_, pass).scissor);
    clear(pass.clear);
    set_fragment_state(pass.state);
    const auto draw_given = [&](const DrawTriangles& draw) {
        if (given_)
            draw_window_triangles(frame_, pass, draw, *given_, memory_);
        else
            draw_triangles(frame_, pass, draw, memory_);
    };
    for (const Draw& draw : pass.draws)
        std::visit(Overloaded{draw_given,
                              [&](const DrawRectangle& d) {
                                  const bool snaps = given_ == WindowTriangles::Snapped;
                                  draw_rectangle(frame_, pass, snaps ? snapped(d) : d, memory_);
                              },
                              [&](const CopyRectangle& d) { copy(pass, d, memory_); }},
                   draw);
    check_errors();
}

}  // namespace peers
