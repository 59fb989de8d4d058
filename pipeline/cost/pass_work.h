// SPDX-License-Identifier: MIT
// What a pass gives a chip to do: its counts, shared out among its draws by what the frame says of them. The counts
// are taken as they are; the frame gives shapes and proportions.
//   Rectangles   have the fragments that their corners say; if a pass has nothing else, in proportion to its count
//   Triangles    have the rest, shared out among their draws by their indices
// Texels of a sample that the samples before did not read, a range, with n those that the filter takes and r = texels
// of a rectangle's uv / its pixels: min(r, n) to at least one; of triangles, whose r is not known, one to n.
#pragma once

#include <vector>

#include "pipeline/cost/range.h"
#include "pipeline/execute/pass_counts.h"
#include "pipeline/frame/frame.h"

namespace pipeline {

// A texture, or a target read as one, in a stage.
struct TextureRead {
    TextureBinding binding;
    int width = 0, height = 0, bytes = 0;  // of a texel
    int samples = 1;                       // 2 with linear mips
    int texels  = 1;                       // of all samples: those that PassCounts has for a fragment
    Range fresh;                           // of those, texels not there from the sample before
    PixelRect span;                        // texels of a rectangle's uv
};

struct DrawWork {
    bool is_rectangle = false;
    PixelRect covered;       // of a rectangle
    double fragments = 0.0;  // counted
    double triangles = 0.0;  // drawn
    std::vector<TextureRead> textures;
};

struct PassWork {
    PixelRect limits;  // what viewport and scissor leave of the target
    std::vector<DrawWork> draws;
    double texel_scale  = 1.0;                            // counted texels for each that `draws` say
    double cleared      = 0.0;                            // pixels, colour and depth together
    double copied       = 0.0;                            // pixels read
    double frame_bytes  = 0.0;                            // of targets read and written; of copies what is read
    double copied_bytes = 0.0;                            // written by copies
    bool accesses_color = false, accesses_depth = false;  // by draws
    bool clears_color = false, clears_depth = false;
    int color_bytes = 0;  // of a pixel; 0 without
    int depth_bytes = 0;
};

PassWork pass_work(const Frame& frame, const Pass& pass, const PassCounts& counts);

// Memory that the binding takes, mip levels too.
double bytes_of(const Frame& frame, const TextureBinding& binding);

}  // namespace pipeline
