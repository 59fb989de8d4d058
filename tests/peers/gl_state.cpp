// SPDX-License-Identifier: MIT
#include "tests/peers/gl_state.h"

#include <algorithm>

#include "tests/peers/gl_names.h"

namespace peers {

using namespace pipeline;

namespace {

void enable(GLenum what, bool on) {
    if (on)
        glEnable(what);
    else
        glDisable(what);
}

// The frame compares bytes, OpenGL the fraction that will be rounded to one. a OP reference on bytes is the same as
// that on fractions with the reference almost half a unit up or down, on the side that keeps every byte where it
// belongs. Not quite half: llvmpipe rounds both to bytes first, and would round the reference away.
float alpha_reference(const AlphaTestState& test) {
    const bool includes_reference_below = test.func == CompareFunc::LessEqual || test.func == CompareFunc::Greater;
    const bool includes_reference_above = test.func == CompareFunc::GreaterEqual || test.func == CompareFunc::Less;
    const float half                    = includes_reference_below ? 0.499f : includes_reference_above ? -0.499f : 0.0f;
    return (test.reference + half) / 255.0f;
}

}  // namespace

PassArea area_of(const Frame& frame, const Pass& pass) {
    const Target& target = frame.targets[(pass.color ? pass.color : pass.depth).index];
    const PixelRect whole{0, 0, target.width, target.height};
    const auto resolved      = [&](const PixelRect& rect) { return rect == PixelRect{} ? whole : rect; };
    const PixelRect viewport = resolved(pass.state.viewport), scissor = resolved(pass.state.scissor);
    return {viewport,
            {std::max(viewport.x0, scissor.x0), std::max(viewport.y0, scissor.y0), std::min(viewport.x1, scissor.x1),
             std::min(viewport.y1, scissor.y1)}};
}

void set_scissor(const PixelRect& scissor) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(scissor.x0, scissor.y0, std::max(0, scissor.x1 - scissor.x0), std::max(0, scissor.y1 - scissor.y0));
}

void clear(const Clear& clear) {
    GLbitfield buffers = 0;
    if (clear.color) {
        const std::array<float, 4> color = gl_color(*clear.color);
        glClearColor(color[0], color[1], color[2], color[3]);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        buffers |= GL_COLOR_BUFFER_BIT;
    }
    if (clear.depth) {
        glClearDepth(*clear.depth);
        glDepthMask(GL_TRUE);
        buffers |= GL_DEPTH_BUFFER_BIT;
    }
    if (buffers != 0) glClear(buffers);
}

void set_fragment_state(const PipelineState& state) {
    enable(GL_BLEND, state.blend != kReplace);
    glBlendFunc(gl_name(state.blend.source), gl_name(state.blend.dest));
    glColorMask(state.color_mask.red, state.color_mask.green, state.color_mask.blue, state.color_mask.alpha);

    enable(GL_ALPHA_TEST, state.alpha_test.func != CompareFunc::Always);
    glAlphaFunc(gl_name(state.alpha_test.func), alpha_reference(state.alpha_test));

    // Without the test OpenGL does not write depth either.
    enable(GL_DEPTH_TEST, state.depth.func != CompareFunc::Always || state.depth.write);
    glDepthFunc(gl_name(state.depth.func));
    glDepthMask(state.depth.write);

    glShadeModel(state.shade == ShadeMode::Flat ? GL_FLAT : GL_SMOOTH);
    glProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
    glDisable(GL_DITHER);
}

void set_fog(const FogState& fog) {
    if (fog.mode == FogMode::None) {
        glDisable(GL_FOG);
        return;
    }
    glEnable(GL_FOG);
    glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_START, 1.0f);
    glFogf(GL_FOG_END, 0.0f);
    glFogfv(GL_FOG_COLOR, gl_color(fog.color).data());
}

// With y down front faces, counter-clockwise to OpenGL, are those that turn clockwise on the screen.
void set_culling(CullMode cull) {
    glFrontFace(GL_CCW);
    if (cull == CullMode::None) {
        glDisable(GL_CULL_FACE);
        return;
    }
    glEnable(GL_CULL_FACE);
    glCullFace(cull == CullMode::Clockwise ? GL_FRONT : GL_BACK);
}

}  // namespace peers
