// SPDX-License-Identifier: MIT
// nimbus7 scenes: lists the built-in scenes, one line each; with --sheet draws each instead, at a fifth and two fifths
// of its frames, on one picture.
#pragma once

#include <string>

namespace demo {

void list_scenes();

// Throws std::runtime_error for a path that cannot be written.
void draw_scene_sheet(const std::string& path);

}  // namespace demo
