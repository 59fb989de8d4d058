// SPDX-License-Identifier: MIT
// A scene file's text, any bytes: a scene, or one line that begins with the file.
#include "demo/scene_file.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const demo::SceneDescription scene = demo::parse_scene(fuzz::as_text(data, size), "a/b.toml", "b");
        fuzz::require(scene.size.width >= 1 && scene.size.width <= demo::kMaxOutputSize, "a width out of range");
        fuzz::require(scene.clouds.size() <= demo::kMaxClouds, "too many clouds");
    } catch (const demo::SceneError& error) {
        fuzz::require(std::string_view(error.what()).starts_with("a/b.toml:"), error.what());
    }
    return 0;
}
