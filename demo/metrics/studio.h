// SPDX-License-Identifier: MIT
// One moment of a scene, stopped, to be photographed under changed conditions: over black and over white, from
// elsewhere, without the scene, with other clouds. Clouds, camera and solids are those of the scene's frame; light that
// changes over time is that of its start. What is measured in several ways is taken once and kept.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "demo/metrics/metric.h"
#include "demo/metrics/plane.h"
#include "demo/scene_data.h"

namespace demo {

struct StudioOptions {
    Size size           = {480, 270};
    int frame           = 0;
    Technique technique = Technique::MegaParticles;
    Precision precision = Precision::Exact;
};

// shape: alpha of the clouds' spheres, hidden by all of the scene; shape_alone: not hidden. scene_m, shape_m: how far
// ahead of the eye the scene is, and the spheres alone, in metres, infinite where there is nothing. Both are only
// looked for from near_m, that of the nearest sphere, to the farthest one; what is nearer counts as at near_m.
// sigma_px, levels: of the widest blur.
struct Anatomy {
    Plane shape, shape_alone, scene_m, shape_m;
    float near_m    = 0.0f;
    double sigma_px = 0.0;
    int levels      = 0;
};

// A blur in a frame: its passes, and the target they read and write.
struct FoundBlur {
    std::size_t first = 0, end = 0;
    pipeline::TargetId image;
    int levels = 0;
};

class Studio {
  public:
    // The scene must outlive the studio.
    Studio(const Scene& scene, const StudioOptions& options);

    const StudioOptions& options() const { return options_; }
    // The scene at up to five frames, this one and others evenly over its animation.
    std::vector<Studio> takes() const;
    bool is_mega() const { return options_.technique == Technique::MegaParticles; }
    const std::vector<SceneCloud>& clouds() const { return scene_.clouds; }
    bool has_cloud() const;
    Vec3 eye() const { return scene_.description.camera.position; }
    Vec3 target() const { return scene_.description.camera.target; }
    Vec3 cloud_middle() const;                         // of the box around all centres
    const cloud::Particle& greatest_particle() const;  // by its radius; only if there are clouds

    // Frames with the technique in question and the changes asked for.
    FrameOptions shot() const { return {.technique = options_.technique, .precision = options_.precision}; }
    pipeline::Frame frame(const FrameOptions& options) const;
    pipeline::Frame frame() const { return frame(shot()); }

    pipeline::ColorImage picture(const pipeline::Frame& frame) { return executor_->execute(frame).output; }
    pipeline::Execution run(const pipeline::Frame& frame, const pipeline::PassObserver& observer = {}) {
        return executor_->execute(frame, {}, observer);
    }

    using Change = std::function<void(pipeline::Frame&)>;
    // The clouds' coverage of a frame with these options, changed by `change` if there is one.
    Plane coverage(FrameOptions options, const Change& change = {});
    Plane coverage() { return coverage(shot()); }

    // Taken at the first call and kept, whatever is edited later. The anatomy is that of mega-particles, whatever the
    // technique.
    const Anatomy& anatomy();
    const Plane& plain_coverage();       // of the scene as it is
    const Plane& detailless_coverage();  // without the fractal

    // The scene from elsewhere, or with other contents; until the next call of restore().
    void look_from(Vec3 eye, Vec3 target);
    Scene& edit() { return scene_; }
    void restore();

  private:
    const Scene* moving_;
    Scene scene_, original_;
    StudioOptions options_;
    std::unique_ptr<pipeline::Executor> executor_ = std::make_unique<pipeline::Executor>();
    std::optional<Anatomy> anatomy_;
    std::optional<Plane> plain_coverage_, detailless_coverage_;
};

// Is it one of a cloud's? Their labels start with the cloud's name and a colon.
bool is_cloud_pass(const pipeline::Pass& pass);

// Takes all draws from passes that are not a cloud's.
void remove_scene(pipeline::Frame& frame);

// The last pass whose label contains `what`, if there is one.
std::optional<std::size_t> last_pass(const pipeline::Frame& frame, std::string_view what);

// Drops all passes from `end` on, and shows what `output` holds then.
void cut(pipeline::Frame& frame, std::size_t end, pipeline::TargetId output);

// The first cloud's blur from pass `from` on, if there is one.
std::optional<FoundBlur> find_blur(const pipeline::Frame& frame, std::size_t from = 0);

// Depth that the frame's depth target holds at its end: 1024 rectangles, from far to near, each colour the pixels that
// are nearer. Returns metres in steps of a 1024th of the range; near_m for what is nearer, infinite for what is
// farther.
Plane depth_of(Studio& studio, pipeline::Frame frame, float near_m, float far_m);

}  // namespace demo
