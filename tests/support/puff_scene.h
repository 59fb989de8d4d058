// SPDX-License-Identifier: MIT
// A scene that is small and quick: one cloud of one particle before the sky.
#pragma once

#include <string>

namespace tests {

// more: of the camera.
struct PuffScene {
    std::string size = "48, 32", radius = "10", blur = "1", more;
};

inline std::string puff_scene(const PuffScene& puff = {}) {
    return "summary = \"One puff\"\n[output]\nsize = [" + puff.size + R"(]
[camera]
position = [0, 5, 60]
target = [0, 5, 0]
)" + puff.more +
           "[[cloud]]\ncores = [[0, 5, 0, " + puff.radius + "]]\nblur = " + puff.blur + R"(
[cloud.fractal]
size = 16
octaves = 2
)";
}

}  // namespace tests
