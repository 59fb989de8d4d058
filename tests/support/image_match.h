// SPDX-License-Identifier: MIT
// Compares two pictures exactly, and shows where they differ. Pixels are 0xAARRGGBB.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "pipeline/execute/execute.h"

namespace test_support {

// worst: the pixel with the greatest difference of a channel, the first of several. Pictures of two sizes have only
// those.
struct ImageMatch {
    int got_width = 0, got_height = 0, want_width = 0, want_height = 0;
    std::size_t differing = 0;  // pixels
    int worst_x = 0, worst_y = 0, worst_difference = 0;
    std::uint32_t worst_got = 0, worst_want = 0;

    bool same_size() const { return got_width == want_width && got_height == want_height; }
    bool equal() const { return same_size() && differing == 0; }
};

ImageMatch match_images(const pipeline::ColorImage& got, const pipeline::ColorImage& want);

// Of red, green and blue, absolute, in units of 255. The pictures must be of one size.
double mean_difference(const pipeline::ColorImage& a, const pipeline::ColorImage& b);

// One line for a person; "" if equal.
std::string describe(const ImageMatch& match);

// For pictures of one size: opaque; a channel is 0 where both agree, else 64 + 3/4 of the difference, so that one step
// can be seen.
pipeline::ColorImage difference_image(const pipeline::ColorImage& got, const pipeline::ColorImage& want);

// If the pictures differ, writes NAME.got.png, NAME.want.png and (for one size) NAME.difference.png into the folder,
// which is made if it is not there, and returns describe() and where they lie; else removes what an earlier failure
// has left there, and returns "".
std::string compare_pictures(const pipeline::ColorImage& got, const pipeline::ColorImage& want,
                             const std::string& folder, const std::string& name);

}  // namespace test_support
