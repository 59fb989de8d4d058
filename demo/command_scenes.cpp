// SPDX-License-Identifier: MIT
#include "demo/command_scenes.h"

#include <algorithm>
#include <future>
#include <string>
#include <vector>

#include "demo/contact_sheet.h"
#include "demo/image_file.h"
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

void draw_scene_sheet(const std::string& path) {
    constexpr Size kDrawn{640, 360};
    const std::future<void> loading = preload_image_module();  // while the first scene is built
    check_image_output(path);
    ContactSheet sheet;
    pipeline::Executor executor;
    const auto picture = [&](const Scene& scene, int index) {
        pipeline::Execution execution;
        executor.execute(scene_frame(scene, kDrawn, index), execution);
        return execution.output;
    };
    for (const SceneInfo& info : built_in_scenes()) {
        const ScenePtr scene = load_scene(info.name);
        const int fifth      = frame_count(*scene) / 5;
        sheet.add(info.name + ", frames " + std::to_string(fifth) + " and " + std::to_string(2 * fifth),
                  picture(*scene, fifth), picture(*scene, 2 * fifth));
    }
    write_image(path, sheet.draw(), Channels::Rgb);
    print(path + "\n");
}

}  // namespace demo
