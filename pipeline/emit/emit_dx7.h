// SPDX-License-Identifier: MIT
// A frame as a C++ program against Direct3D 7 (IDirect3DDevice7), in one file that MinGW-w64 builds:
//   x86_64-w64-mingw32-g++ frame.cpp -o frame.exe -lddraw -ldxguid -static
//   frame.exe [PICTURE.bmp [PREFIX]]     writes the output target, and with PREFIX each pass's colour target after it
// Transforms, lights, fog and texture stages are the API's; each pass is a function that starts from known states.
// The legal frame's window coordinates are Direct3D 7's, with pixel centres at integers, and are written as they stand.
// Rounding is the card's: the API promises none of the rules in Frame::arithmetic.
// Sources: DirectX 7 SDK help; MSDN Library of April 2000.
#pragma once

#include <string_view>

#include "pipeline/emit/emitted.h"
#include "pipeline/legalize/legalize.h"

namespace pipeline {

// data_file: the name under which the program opens Emitted::data. Throws std::invalid_argument if legal.left is not
// empty, or for window triangles whose two pairs of texture coordinates have different q.
Emitted emit_dx7(const LegalFrame& legal, std::string_view data_file);

}  // namespace pipeline
