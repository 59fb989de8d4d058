// SPDX-License-Identifier: MIT
// The two colours of a vertex: lit by OpenGL, or its own. Both APIs light in camera space by the same equation, but
// Direct3D's camera looks along +z and OpenGL's along -z, which matters where the viewer is infinitely far. So camera
// space is given to OpenGL with z negated, here and in gl_geometry.h.
#pragma once

#include <optional>
#include <string>

#include "pipeline/frame/frame.h"

namespace peers {

// The frame's camera space to OpenGL's: scales z by -1.
pipeline::Mat4 opengl_view(const pipeline::Camera& camera);

// Replaces the modelview matrix.
void set_lighting(const pipeline::LightingState& lighting, const pipeline::Camera& camera);

// Vertices' colours pass through, or the current ones of OpenGL for what is no array.
void set_no_lighting(bool add_specular);

// Why OpenGL does not light like this, or nothing.
std::optional<std::string> cannot_light(const pipeline::LightingState& lighting);

// Something that it does light, in its place.
void make_expressible(pipeline::LightingState& lighting);

}  // namespace peers
