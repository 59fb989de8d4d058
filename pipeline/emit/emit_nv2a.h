// SPDX-License-Identifier: MIT
// A frame as what the Xbox's NV2A is told: methods of the class NV097 (Kelvin), and NV062 and NV09F for copies, in the order
// in which they go into the push buffer. A line is
//   <offset>[*] <name>[<entry>] <value> ... ; <meaning>
// with the offset and up to 8 values in hexadecimal: the first is for that offset, each further one for the next word, or
// with * all for the same. Lines that begin with # are for the reader. Before the methods stands what memory holds:
//   surface <address> <bytes> ; <what>
//   data <address> <bytes> <from> ; <what>     bytes of the side file from byte <from> on
// Addresses are in bytes of the memory that the DMA objects cover; they are those of pipeline/check/memory_map.h, with the
// vertices after the textures. Every pass writes all the state that it needs, and its later draws what differs.
//   vertices  The chip transforms. It lights if the sources agree on how; else the colours are lit here (nv2a_lighting.h).
//             Rectangles and window vertices go through an identity.
//   texels    Textures whose sizes are powers of two are swizzled, all others and the targets linear.
// Sources of names, offsets, fields and of what they do, all read as facts: xemu (github.com/xemu-project/xemu, as in
// abaire/xemu ebe34071), hw/xbox/nv2a; nxdk (github.com/XboxDev/nxdk 29638d0b), lib/pbkit; pbkitplusplus
// (github.com/abaire/pbkitplusplus 0088614e). What they leave open stands in the text where it matters.
#pragma once

#include <string_view>

#include "pipeline/emit/emitted.h"
#include "pipeline/legalize/legalize.h"

namespace pipeline {

// data_file: the name under which the side file is looked for. Throws std::invalid_argument if the frame is not legal on
// "xbox", or a value does not fit its register.
Emitted emit_nv2a(const LegalFrame& legal, std::string_view data_file);

}  // namespace pipeline
