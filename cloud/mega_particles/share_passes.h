// SPDX-License-Identifier: MIT
// Clouds that do not meet in the picture share passes: each pass that they have in common is written once, with a draw or
// a rectangle for each of them. A cloud's passes read and write nothing outside its part of the picture and that part of
// the pyramid, so those of two clouds whose parts are apart may come in any order, and the picture is the same to the
// bit, as are blended pixels, texels and bytes.
//
// What a pass is held to by its scissor must be held to without it, as a pass has but one:
//   rectangles   are cut to it, the coordinates of their texture too
//   triangles    share a pass if all of their corners are projected into it; otherwise the pass stays as it is
//   clears       become rectangles, in a pass of their own that tests no depth
#pragma once

#include <string>
#include <vector>

#include "cloud/bounds.h"
#include "pipeline/frame/frame.h"

namespace cloud {

// reach: all pixels of the picture that its passes read or write, in whatever target. Labels are "<name>: <what>".
struct CloudPasses {
    std::string name;
    PixelRect reach;
    std::vector<pipeline::Pass> passes;
};

// The passes of all clouds, which are given farthest first. A cloud goes with the first clouds that come after all those
// that it meets; what clouds that go together have in common is found as a longest common subsequence. Passes are shared
// that are equal but for draws, scissor and name; their scissor is the smallest around all. Labels name up to three
// clouds: "a, b: <what>", "a, b and 3 more: <what>". frame: with all that the passes refer to.
std::vector<pipeline::Pass> share_passes(const pipeline::Frame& frame, std::vector<CloudPasses> clouds);

// The part of a rectangle within `area`: the same pixels get the same texels. The coordinates of its corners are floats,
// rounded; so that no pixel falls short of the 1/256 texel that it had (raster/sampling_rules.h floors to it), all are
// moved by half of that. What is read must lie on 1/256 texel, as that of a blit does, in a target of up to 8192 pixels.
pipeline::DrawRectangle cut_rectangle(const pipeline::Frame& frame, const pipeline::DrawRectangle& rectangle,
                                      const PixelRect& area);

}  // namespace cloud
