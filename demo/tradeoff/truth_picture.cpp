// SPDX-License-Identifier: MIT
#include "demo/tradeoff/truth_picture.h"

#include "pipeline/truth/truth.h"

namespace demo {

RealPicture truth_picture(const pipeline::Frame& frame) {
    const pipeline::TruthPicture truth = pipeline::draw_truth(frame);
    RealPicture picture{truth.width, truth.height, {}};
    picture.pixels.reserve(truth.pixels.size());
    for (const auto& [red, green, blue, alpha] : truth.pixels)
        picture.pixels.push_back({255.0 * red, 255.0 * green, 255.0 * blue});
    return picture;
}

}  // namespace demo
