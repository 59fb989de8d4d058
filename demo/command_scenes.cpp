// SPDX-License-Identifier: MIT
#include "demo/command_scenes.h"

#include <algorithm>
#include <string>
#include <vector>

#include "demo/scene.h"
#include "demo/standard_output.h"

namespace demo {

void list_scenes() {
    const std::vector<SceneInfo> scenes = built_in_scenes();
    std::size_t width                   = 0;
    for (const SceneInfo& scene : scenes) width = std::max(width, scene.name.size());
    for (const SceneInfo& scene : scenes) {
        print(scene.name + std::string(width - scene.name.size() + 2, ' ') + scene.summary + "\n");
    }
}

}  // namespace demo
