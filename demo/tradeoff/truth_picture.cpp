// SPDX-License-Identifier: MIT
#include "demo/tradeoff/truth_picture.h"

namespace demo {

RealPicture truth_picture(const pipeline::Frame& frame) {
    return to_real(pipeline::execute(frame).output);
}

}  // namespace demo
