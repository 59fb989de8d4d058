// SPDX-License-Identifier: MIT
// Clouds that reach into each other are one cloud: drawn one after the other, the blurred rim of the second would lie
// over the first even where the first is nearer.
#pragma once

#include <vector>

#include "cloud/bake.h"

namespace cloud {

// Clouds of equal settings whose particles touch become one, with the name and the fractal of the one with the
// most particles, in a box around all; the result does not depend on their order. Clouds that are drawn differently stay apart: they are
// meant to be layers.
std::vector<BakedCloud> merge_touching(std::vector<BakedCloud> clouds);

// Does a particle of one reach into a particle of the other?
bool touch(const BakedCloud& a, const BakedCloud& b);

}  // namespace cloud
