// SPDX-License-Identifier: MIT
// Clouds that reach into each other are one cloud: drawn one after the other, the blurred rim of the second would lie
// over the first even where the first is nearer.
#pragma once

#include <vector>

#include "cloud/bake.h"

namespace cloud {

// Clouds of equal settings whose particles touch become one, with the name, the fractal and the box of the first. Clouds
// that are drawn differently stay apart: they are meant to be layers. Keeps the order of the firsts.
std::vector<BakedCloud> merge_touching(std::vector<BakedCloud> clouds);

}  // namespace cloud
