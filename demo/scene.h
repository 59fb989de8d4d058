// SPDX-License-Identifier: MIT
// A scene: what a scene file describes, and how it becomes a frame. A scene file is TOML (the README has a commented example);
// the built-in scenes are such files, compiled in. Errors are demo::SceneError, whose what() is the whole line for the user:
// "scenes/x.toml:12:8: cloud.blur must be >= 0 (got -3)".
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cloud/cloud.h"
#include "cloud/mega_particles/options.h"
#include "pipeline/frame/frame.h"

namespace demo {

struct SceneError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct SceneInfo {
    std::string name, summary;
};
std::vector<SceneInfo> built_in_scenes();

struct Scene;  // scene_data.h; only the scene's own files look inside
using ScenePtr = std::shared_ptr<const Scene>;

// A built-in name, or the path of a .toml file; files it names are relative to it.
ScenePtr load_scene(const std::string& name_or_path);

struct Size {
    int width = 0, height = 0;
};
Size default_size(const Scene& scene);

// The number of frames of the scene's animation.
int frame_count(const Scene& scene);

// How clouds are drawn: as the scene says, or by one of the two techniques that the article compares itself with.
enum class Technique : std::uint8_t { MegaParticles, Sprites, Slices };

// Exact: as good as the technique is at the picture's size. Fast: with what precision.cpp gives up for time.
enum class Precision : std::uint8_t { Exact, Fast };

// What a picture of the scene is changed in, for comparisons and measurements.
struct FrameOptions {
    Technique technique = Technique::MegaParticles;
    Precision precision = Precision::Exact;
    std::optional<cloud::Mode> mode;           // of all clouds
    std::optional<cloud::Order> order;         // of all clouds; OrderFree draws them after all else
    std::optional<pipeline::Vec3> flat_scene;  // all but the clouds in one colour; depth as it was
    bool has_clouds = true, has_detail = true;
    cloud::MegaParticleOptions mega_particles;
    std::optional<std::size_t> only_cloud;           // of the scene's, counted from 0
    pipeline::Vec2 shift_px = pipeline::Vec2(0.0f);  // of the picture: the projection's middle moves
};

// Frame `index` of the scene's animation (0 is the still picture) at the given size.
pipeline::Frame scene_frame(const Scene& scene, Size size, int index, const FrameOptions& options = {});

}  // namespace demo
