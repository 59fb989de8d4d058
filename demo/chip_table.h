// SPDX-License-Identifier: MIT
// One frame on all four chips, as a table in Markdown: what each makes of it, where it has room for it, what it costs, and how
// far its picture is from the ideal one.
#pragma once

#include <string>

#include "demo/chip_frame.h"

namespace demo {

// options.profile is not used. A row for each chip:
//   picture         the size, and how often textures were halved to fit (options.reduce)
//   passes          of the rewritten frame; in brackets of the scene's
//   blended layers  pixels blended, over those of the picture
//   memory          used, of what there is; of the GameCube its frame buffer
//   ms              as cost() has it, of a sixtieth of a second
//   difference      mean of red, green and blue over the picture, absolute, in units of 255, from the ideal one of that size
// A chip that cannot draw the frame has the number of its findings there.
std::string chip_table(const ChipFrameOptions& options);

}  // namespace demo
