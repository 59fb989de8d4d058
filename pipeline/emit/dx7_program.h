// SPDX-License-Identifier: MIT
// The parts of the Direct3D 7 program that are the same for every frame.
#pragma once

#include <string_view>

namespace pipeline::dx7 {

extern const std::string_view kHead;      // includes, error check, types of the tables
extern const std::string_view kDevice;    // side file, device, pixel formats
extern const std::string_view kSurfaces;  // surfaces, textures, meshes
extern const std::string_view kPasses;    // what passes call
extern const std::string_view kMain;      // pictures and main

}  // namespace pipeline::dx7
