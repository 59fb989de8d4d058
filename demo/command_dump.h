// SPDX-License-Identifier: MIT
// nimbus7 dump: one frame of a scene as text, which `nimbus7 render` takes back.
#pragma once

#include <optional>
#include <string>

#include "demo/scene.h"

namespace demo {

struct DumpOptions {
    std::string scene;
    std::optional<Size> size;  // else the scene's
    int frame = 0;
    FrameOptions changes;               // of how the scene draws its clouds
    std::optional<std::string> output;  // else standard output
};

void dump(const DumpOptions& options);

}  // namespace demo
