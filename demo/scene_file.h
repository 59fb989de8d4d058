// SPDX-License-Identifier: MIT
// Scene files: TOML to a description, strictly. demo/scenes/canyon.toml explains every key. An empty file is a valid
// scene: a sky.
#pragma once

#include <string>
#include <string_view>

#include "demo/scene_data.h"

namespace demo {

// file: as the user named it, for complaints; files that the text names are relative to its folder. Throws SceneError.
SceneDescription parse_scene(std::string_view text, const std::string& file, const std::string& name);

// Reads and parses the file at `path`. Throws SceneError.
SceneDescription read_scene_file(const std::string& path);

}  // namespace demo
