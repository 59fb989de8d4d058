// SPDX-License-Identifier: MIT
#include "demo/scene.h"

#include <filesystem>

#include "demo/embedded_texts.h"
#include "demo/scene_build.h"
#include "demo/scene_data.h"
#include "demo/scene_file.h"

namespace demo {
namespace {

SceneDescription parse_embedded(const EmbeddedText& scene) {
    const std::string name(scene.name);
    return parse_scene(scene.text, name, name);
}

[[noreturn]] void fail_unknown(const std::string& name) {
    std::string names;
    for (const EmbeddedText& scene : embedded_scenes()) names += (names.empty() ? "" : ", ") + std::string(scene.name);
    throw SceneError(name + ": no such file, and no built-in scene (there is " + names + ")");
}

}  // namespace

std::vector<SceneInfo> built_in_scenes() {
    std::vector<SceneInfo> scenes;
    for (const EmbeddedText& scene : embedded_scenes())
        scenes.push_back({std::string(scene.name), parse_embedded(scene).summary});
    return scenes;
}

ScenePtr load_scene(const std::string& name_or_path) {
    if (const auto scene = find_text(embedded_scenes(), name_or_path))
        return std::make_shared<const Scene>(build_scene(parse_embedded(*scene)));
    std::error_code error;
    if (!std::filesystem::exists(name_or_path, error)) fail_unknown(name_or_path);
    return std::make_shared<const Scene>(build_scene(read_scene_file(name_or_path)));
}

Size default_size(const Scene& scene) {
    return scene.description.size;
}

int frame_count(const Scene& scene) {
    return scene.description.frames;
}

}  // namespace demo
