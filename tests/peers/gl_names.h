// SPDX-License-Identifier: MIT
// The frame's enumerators and colours in OpenGL's terms.
#pragma once

#include <array>

#include "pipeline/frame/frame.h"
#include "tests/peers/gl.h"

namespace peers {

GLenum gl_name(pipeline::CompareFunc func);
GLenum gl_name(pipeline::BlendFactor factor);
GLenum gl_name(pipeline::TextureAddress address);

// Red, green, blue, alpha in 0..1.
std::array<float, 4> gl_color(pipeline::Argb color);

}  // namespace peers
