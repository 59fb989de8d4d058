// SPDX-License-Identifier: MIT
// What the programs of raster/special_programs.h draw, in their order, for people.
#pragma once

#include <array>

#include "raster/special_programs.h"

namespace raster {

inline constexpr std::array kTriangleNames{
    "landscape: texture",
    "landscape: texture and detail",
    "landscape: texture laid over",
    "landscape: no texture",
    "sky",
    "vertex colour, depth",
    "thrown light",
    "mega-particles",
    "skirt",
    "rim mask",
    "box: erode, over the scene",
    "box: dissolve",
    "box: multiply",
    "box: multiply, one level",
    "displaced composite",
    "sprites",
    "slices",
};
static_assert(kTriangleNames.size() == kTrianglePrograms.size());

inline constexpr std::array kRectangleNames{
    "blit, linear",
    "blit, point",
    "blit, constant alpha",
    "composite, faded",
    "composite",
    "composite, faded, masked",
    "colour into alpha",
    "colour",
    "colour, depth",
    "colour, over",
    "colour, multiplied",
    "colour, times one more",
    "colour, alpha kept",
    "blit, linear, alpha kept",
};
static_assert(kRectangleNames.size() == kRectanglePrograms.size());

}  // namespace raster
