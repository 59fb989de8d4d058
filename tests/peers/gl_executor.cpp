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
                              [&](const CopyRectangle& d) { memory_.copy(d, pass.color); },
                              [](const DrawWindowTriangles&) {}},  // cannot be expressed
                   draw);
    check_errors();
}

}  // namespace peers
