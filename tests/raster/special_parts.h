// SPDX-License-Identifier: MIT
// The programs of raster/special_programs.h, and what of a program each step of the fill loop depends on, so that a
// test of one step finds the special programs that it stands for.
#pragma once

#include <algorithm>
#include <array>

#include "raster/special_programs.h"

namespace special_parts {

inline constexpr auto kPrograms = [] {
    std::array<raster::FillProgram, raster::kTrianglePrograms.size() + raster::kRectanglePrograms.size()> all;
    std::copy(raster::kRectanglePrograms.begin(), raster::kRectanglePrograms.end(),
              std::copy(raster::kTrianglePrograms.begin(), raster::kTrianglePrograms.end(), all.begin()));
    return all;
}();

// Of steps 2 to 4 of raster/fill_state.h: what the colour is made of.
constexpr raster::FillProgram color_part(const raster::FillProgram& program) {
    raster::FillProgram part;
    part.makes_color    = program.makes_color;
    part.reads_diffuse  = program.reads_diffuse;
    part.reads_specular = program.reads_specular;
    part.stage_count    = program.stage_count;
    part.combine_rule   = program.combine_rule;
    part.stages         = program.stages;
    part.add_specular   = program.add_specular;
    part.fog            = program.fog;
    part.fog_rule       = program.fog_rule;
    for (std::size_t i = 0; i < part.textures.size(); ++i) {
        part.textures[i].is_read    = program.textures[i].is_read;
        part.textures[i].has_texels = program.textures[i].has_texels;
    }
    return part;
}

// Of steps 5 to 9: what becomes of a colour.
constexpr raster::FillProgram shade_part(const raster::FillProgram& program) {
    raster::FillProgram part = program;
    part.floor_colors = part.reads_diffuse = part.reads_specular = part.reads_fog_only = false;
    part.add_specular = part.fog = false;
    part.stage_count             = 0;
    part.combine_rule            = {};
    part.fog_rule                = {};
    part.stages                  = {};
    part.textures                = {};
    return part;
}

}  // namespace special_parts
