// SPDX-License-Identifier: MIT
// A frame for the GameCube as one C program against libogc's GX calls, complete in state and data: run on the console, it draws the
// frame and shows it. The side file holds textures in the chip's tiles, vertices and indices; the program has it assembled in.
// What the chip says in another way stands in the program's head, and at pipeline/emit/gx_*.h.
// Sources: libogc (github.com/devkitPro/libogc), gc/ogc/gx.h, gu.h, video.h and libogc/gx.c; for what registers do, Dolphin
// (github.com/dolphin-emu/dolphin).
#pragma once

#include <string_view>

#include "pipeline/emit/emitted.h"
#include "pipeline/legalize/legalize.h"

namespace pipeline {

// legal: from legalize() for the profile "gamecube". data_file: the name under which the program's assembler finds
// Emitted::data. Throws std::invalid_argument if the frame has something left that the chip cannot do, or a projection that
// GX has no numbers for (gx_transform.h), or if the name has quotes, backslashes or control characters.
Emitted emit_gx(const LegalFrame& legal, std::string_view data_file);

}  // namespace pipeline
