// SPDX-License-Identifier: MIT
// Camera matrices in the frame's conventions: right-handed world and view space with y up, looking along -z; clip space
// of Direct3D, 0 <= z <= w, w the distance ahead of the eye. Computed in double in a fixed order, then rounded to
// float.
#pragma once

#include "demo/scene_data.h"

namespace demo {

// From `eye` towards `target`. Straight up or down the picture's right is +x; where both are one point it looks along -z.
Mat4 look_at(const Vec3& eye, const Vec3& target);

// aspect: width over height.
Mat4 perspective(double vfov_deg, double aspect, double near_m, double far_m);

// Where the camera of frame `index`, `seconds` into the animation, stands and looks: on its path, or, without one, it
// swings about the target's vertical through +-orbit_deg as a sine, from the middle.
Vec3 eye_at(const CameraPath& camera, int index, double seconds);
Vec3 target_at(const CameraPath& camera, double seconds);

}  // namespace demo
