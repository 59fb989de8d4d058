// SPDX-License-Identifier: MIT
// The silver lining: seen against the sun, the thin parts of a cloud shine, for what little there is scatters most of the
// light forward. What it adds to the light of a vertex, N its normal, V the unit vector from the eye to it, L that to the
// sun:
//   light = silver_lining * sun * T * (1 - |N.V|) * P(V.L)
// T: what of the sun comes through the cloud (vertex_light.h); little where more than a puff is behind. 1 - |N.V|: the
// cloud is thin where it is seen at a grazing angle. P: the phase function of L. Henyey and J. Greenstein ("Diffuse
// radiation in the galaxy", 1941) with g = 0.7, less its value at a right angle and scaled to 1 at 0 degrees: 0.52 at 15,
// 0.17 at 30, 0 from 90 on, so that nothing is added with the sun beside or behind the camera.
#pragma once

#include "cloud/vertex_light.h"

namespace cloud {

// To be multiplied with the particle's colour. At most silver_lining * sun; 0 at the eye itself.
Vec3 silver_lining(const Cloud& cloud, const Daylight& daylight, const LitVertex& vertex, Vec3 eye);

// P. cosine: -1..1.
float forward_scattering(float cosine);

}  // namespace cloud
