// SPDX-License-Identifier: MIT
// The sky as a dome of vertex colours: from the horizon's haze up to a deep zenith, warmer and brighter around the sun.
// Below the horizon the dome goes on in the horizon's colour, where distant land has vanished in haze.
#pragma once

#include <cstdint>
#include <vector>

#include "demo/scene_data.h"

namespace demo {

// direction: unit.
Vec3 sky_color(const Sky& sky, const Vec3& to_sun, const Vec3& direction);

// A dome of radius 1 around the origin, appended; returns its range of `geometry`'s indices.
TexturedRange append_sky_dome(SceneGeometry& geometry, const Sky& sky, const Vec3& to_sun);

}  // namespace demo
