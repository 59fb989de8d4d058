// SPDX-License-Identifier: MIT
// The rules of the image files that reference_images/two_clouds.toml names, as whole PNG files (uncompressed, so that
// they do not depend on a compressor). Computed with + - * / in a fixed order: the same bytes everywhere.
#pragma once

#include <string>

namespace tests {

// 129 x 129 pixels, 16 bits of grey: a mountain, and hills around the valley before it. Round hills
// h (1 - d^2/r^2)^3 at the distance d from their middle, two of them times a noise with sharp ridges, and a gentle
// noise everywhere. The lowest point is black, the highest white.
std::string two_clouds_heights_png();

// 64 x 64 pixels, RGB, tiling in both directions. Random values, averaged over a rectangle around each pixel, mix two
// colours. Grass: 3 x 3 pixels, and a dry stalk here and there. Rock: 7 x 3 pixels.
std::string two_clouds_grass_png();
std::string two_clouds_rock_png();

}  // namespace tests
