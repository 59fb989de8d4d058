// SPDX-License-Identifier: MIT
#include "demo/builtin_scenes.h"

#include <algorithm>

namespace demo {

std::optional<EmbeddedScene> find_embedded_scene(std::string_view name) {
    const auto scenes = embedded_scenes();
    const auto found =
        std::find_if(scenes.begin(), scenes.end(), [&](const EmbeddedScene& scene) { return scene.name == name; });
    return found == scenes.end() ? std::nullopt : std::optional(*found);
}

}  // namespace demo
