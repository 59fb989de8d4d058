// SPDX-License-Identifier: MIT
// The scene files of demo/scenes, compiled in by demo/embed_scenes.cmake, in alphabetical order.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace demo {

// name: the file's, without ".toml".
struct EmbeddedScene {
    std::string_view name, text;
};

// Defined in the generated file.
std::span<const EmbeddedScene> embedded_scenes();

std::optional<EmbeddedScene> find_embedded_scene(std::string_view name);

}  // namespace demo
