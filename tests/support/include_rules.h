// SPDX-License-Identifier: MIT
// Which file may include which: the layers raster <- pipeline <- cloud <- demo, as rules on the text of the sources.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace tests {

// Path from the top of the repository ("raster/tile.h") to the file's text.
using Sources = std::map<std::string, std::string>;

// The sources of the four layers and of the tests below `top`.
Sources read_sources(const std::string& top);

// One line for each fault, "raster/a.cpp includes pipeline/b.h: raster/ may include only raster/"; empty if there is
// none.
std::vector<std::string> include_faults(const Sources& sources);

}  // namespace tests
