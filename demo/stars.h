// SPDX-License-Identifier: MIT
// Stars: soft dots on the sky's dome, which fade into the sky's own colour around them, so that no blending is needed.
#pragma once

#include <cstdint>

#include "demo/scene_data.h"

namespace demo {

// On a dome of radius 1 around the origin, in front of the sky's own; returns their range of `geometry`'s indices.
TexturedRange append_stars(SceneGeometry& geometry, const Sky& sky, const Vec3& to_sun);

}  // namespace demo
