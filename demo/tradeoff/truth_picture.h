// SPDX-License-Identifier: MIT
// The truth that settings are measured against, as a picture.
#pragma once

#include "demo/tradeoff/picture_error.h"
#include "pipeline/frame/frame.h"

namespace demo {

RealPicture truth_picture(const pipeline::Frame& frame);

}  // namespace demo
