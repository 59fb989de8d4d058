// SPDX-License-Identifier: MIT
#include "demo/metrics/studio.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <string>

#include "cloud/bounds.h"
#include "demo/camera_matrices.h"
#include "demo/cloud_motion.h"
#include "demo/metrics/blits.h"
#include "demo/metrics/kernel.h"

namespace demo {
namespace {

constexpr std::string_view kSpheresPass = "mega-particles, alpha 1";

// The cloud at that moment, with nothing left in its plan that moves.
SceneCloud stopped(const SceneCloud& cloud, const cloud::Daylight& light, double seconds) {
    SceneCloud still = cloud;
    if (moves(cloud.plan)) {
        cloud::Cloud now = cloud_at(cloud, seconds);
        if (reshapes(cloud.plan))
            still.baked = cloud::bake(now, light, cloud.baked);
        else
            still.baked.cloud = std::move(now);
    }
    const cloud::Cloud settings = still.plan.settings;
    still.plan                  = {};
    still.plan.settings         = settings;
    still.file                  = nullptr;
    still.grown                 = still.baked.cloud;
    return still;
}

Scene stopped(const Scene& scene, int index) {
    Scene still               = scene;
    const double seconds      = index / scene.description.fps;
    CameraPath& camera        = still.description.camera;
    camera.position           = eye_at(scene.description.camera, index, seconds);
    camera.target             = target_at(scene.description.camera, seconds);
    camera.orbit_deg          = 0.0;
    camera.position_path      = {};
    camera.target_path        = {};
    still.description.weather = {};
    for (SceneCloud& cloud : still.clouds) cloud = stopped(cloud, scene.description.light, seconds);
    std::erase_if(still.clouds, [](const SceneCloud& cloud) { return cloud.baked.cloud.particles.empty(); });
    return still;
}

// The scissor in whole pixels of an image.
pipeline::PixelRect area_of(const pipeline::Pass& pass, const Plane& image) {
    const pipeline::PixelRect& scissor = pass.state.scissor;
    return scissor == pipeline::PixelRect{} ? pipeline::PixelRect{0, 0, image.width, image.height}
                                            : cloud::grow(scissor, 0, image.width, image.height);
}

// The spheres' alpha, of all clouds one over the other.
Plane shape_in(Studio& studio, const pipeline::Frame& frame) {
    const pipeline::Target& output = frame.targets[static_cast<std::size_t>(frame.output.index)];
    Plane clear(output.width, output.height, 1.0f);
    studio.run(frame, [&](const pipeline::FinishedPass& pass) {
        if (!pass.pass.label.ends_with(kSpheresPass)) return;
        const Plane alpha              = alpha_of(pass.read_color());
        const pipeline::PixelRect area = area_of(pass.pass, alpha);
        for (int y = area.y0; y < area.y1; ++y)
            for (int x = area.x0; x < area.x1; ++x) clear.at(x, y) *= 1.0f - alpha.at(x, y);
    });
    for (float& value : clear.values) value = 1.0f - value;
    return clear;
}

}  // namespace

Studio::Studio(const Scene& scene, const StudioOptions& options)
    : moving_(&scene), scene_(stopped(scene, options.frame)), original_(scene_), options_(options) {}

std::vector<Studio> Studio::takes() const {
    constexpr int kTakes = 5;
    const int frames     = std::max(frame_count(*moving_), moving_->description.camera.orbit_frames);
    std::vector<Studio> takes;
    for (int i = 0; i < std::min(kTakes, frames); ++i) {
        StudioOptions options = options_;
        options.frame         = (options_.frame + frames * i / kTakes) % std::max(frames, options_.frame + 1);
        takes.emplace_back(*moving_, options);
    }
    return takes;
}

bool Studio::has_cloud() const {
    return !scene_.clouds.empty();
}

Vec3 Studio::cloud_middle() const {
    Vec3 low(1e30f), high(-1e30f);
    for (const SceneCloud& cloud : scene_.clouds)
        for (const cloud::Particle& particle : cloud.baked.cloud.particles) {
            low  = glm::min(low, particle.center);
            high = glm::max(high, particle.center);
        }
    return (low + high) * 0.5f;
}

const cloud::Particle& Studio::greatest_particle() const {
    const cloud::Particle* greatest = nullptr;
    for (const SceneCloud& cloud : scene_.clouds)
        for (const cloud::Particle& particle : cloud.baked.cloud.particles)
            if (greatest == nullptr || particle.radius > greatest->radius) greatest = &particle;
    return *greatest;
}

pipeline::Frame Studio::frame(const FrameOptions& options) const {
    FrameOptions apart          = options;
    apart.mega_particles.passes = cloud::Passes::OneByOne;  // what is measured are each cloud's passes
    return scene_frame(scene_, options_.size, options_.frame, apart);
}

Plane Studio::coverage(FrameOptions options, const Change& change) {
    const auto over = [&](float grey) {
        options.flat_scene    = Vec3(grey);
        pipeline::Frame frame = this->frame(options);
        if (change) change(frame);
        return picture(frame);
    };
    const pipeline::ColorImage white = over(1.0f);
    return coverage_of(white, over(0.0f));
}

const Plane& Studio::plain_coverage() {
    if (!plain_coverage_) plain_coverage_ = coverage(shot());
    return *plain_coverage_;
}

const Plane& Studio::detailless_coverage() {
    if (!detailless_coverage_) {
        FrameOptions options = shot();
        options.has_detail   = false;
        detailless_coverage_ = coverage(options);
    }
    return *detailless_coverage_;
}

const Anatomy& Studio::anatomy() {
    if (anatomy_) return *anatomy_;
    // All of the scene first, so that all of it hides spheres.
    FrameOptions options;
    options.order         = cloud::Order::OrderFree;
    pipeline::Frame whole = frame(options);
    Anatomy anatomy{.shape = shape_in(*this, whole), .shape_alone = {}, .scene_m = {}, .shape_m = {}};
    for (std::size_t i = 0; i < whole.passes.size(); ++i)
        if (const std::optional<FoundBlur> blur = find_blur(whole, i)) {
            const std::span<const pipeline::Pass> blits(whole.passes.data() + blur->first, blur->end - blur->first);
            const double sigma = kernel_figures(column_responses(whole, blits, blur->image, blur->levels)).sigma_px;
            if (sigma > anatomy.sigma_px) anatomy.sigma_px = sigma, anatomy.levels = blur->levels;
            i = blur->end;
        }
    remove_scene(whole);
    anatomy.shape_alone = shape_in(*this, whole);

    float near_m = std::numeric_limits<float>::infinity(), far_m = 0.0f;
    const pipeline::Vec4 toward(glm::vec4(whole.cameras[0].view[0][2], whole.cameras[0].view[1][2],
                                          whole.cameras[0].view[2][2], whole.cameras[0].view[3][2]));
    for (const SceneCloud& cloud : scene_.clouds)
        for (const cloud::Particle& particle : cloud.baked.cloud.particles) {
            const cloud::Sphere sphere = cloud::bounding_sphere(particle, cloud.baked.cloud);
            const float ahead          = -glm::dot(toward, pipeline::Vec4(sphere.center, 1.0f));
            near_m                     = std::min(near_m, ahead - sphere.radius);
            far_m                      = std::max(far_m, ahead + sphere.radius);
        }
    const CameraPath& camera = scene_.description.camera;
    near_m         = std::clamp(near_m, 1.01f * static_cast<float>(camera.near_m), static_cast<float>(camera.far_m));
    far_m          = std::max(far_m, near_m * 1.01f);
    anatomy.near_m = near_m;

    if (const std::optional<std::size_t> spheres = last_pass(whole, kSpheresPass)) {
        cut(whole, *spheres + 1, {0});
        anatomy.shape_m = depth_of(*this, std::move(whole), near_m, far_m);
    } else {
        anatomy.shape_m = Plane(options_.size.width, options_.size.height, std::numeric_limits<float>::infinity());
    }
    options.has_clouds = false;
    anatomy.scene_m    = depth_of(*this, frame(options), near_m, far_m);
    anatomy_           = std::move(anatomy);
    return *anatomy_;
}

void Studio::look_from(Vec3 eye, Vec3 target) {
    scene_.description.camera.position = eye;
    scene_.description.camera.target   = target;
}

void Studio::restore() {
    scene_ = original_;
}

bool is_cloud_pass(const pipeline::Pass& pass) {
    return pass.label.find(": ") != std::string::npos;  // the scene's own have no colon
}

void remove_scene(pipeline::Frame& frame) {
    for (pipeline::Pass& pass : frame.passes)
        if (!is_cloud_pass(pass)) pass.draws.clear();
}

std::optional<std::size_t> last_pass(const pipeline::Frame& frame, std::string_view what) {
    for (std::size_t i = frame.passes.size(); i-- > 0;)
        if (frame.passes[i].label.find(what) != std::string::npos) return i;
    return std::nullopt;
}

void cut(pipeline::Frame& frame, std::size_t end, pipeline::TargetId output) {
    frame.passes.resize(end);
    frame.output = output;
}

std::optional<FoundBlur> find_blur(const pipeline::Frame& frame, std::size_t from) {
    for (std::size_t i = from; i < frame.passes.size(); ++i) {
        if (!frame.passes[i].label.ends_with(kSpheresPass)) continue;
        FoundBlur blur{.first = i + 1, .end = i + 1, .image = frame.passes[i].color};
        while (blur.end < frame.passes.size() && is_blit(frame.passes[blur.end])) {
            if (scale_of(frame.passes[blur.end], frame) < 0.75) ++blur.levels;
            ++blur.end;
        }
        return blur.end > blur.first ? std::optional(blur) : std::nullopt;
    }
    return std::nullopt;
}

Plane depth_of(Studio& studio, pipeline::Frame frame, float near_m, float far_m) {
    constexpr int kSteps            = 1024;
    const pipeline::Target output   = frame.targets[static_cast<std::size_t>(frame.output.index)];
    const pipeline::Mat4 projection = frame.cameras[0].projection;
    pipeline::Pass& ladder          = frame.passes.emplace_back();
    ladder.label                    = "depth, in steps";
    ladder.color                    = frame.output;
    ladder.depth                    = {1};
    ladder.clear.color              = pipeline::Argb{0};
    ladder.state.depth.func         = pipeline::CompareFunc::Greater;
    const auto meters               = [&](int step) {
        return near_m + (far_m - near_m) * static_cast<float>(step) / static_cast<float>(kSteps - 1);
    };
    for (int step = kSteps - 1; step >= 0; --step) {
        pipeline::DrawRectangle rectangle;
        rectangle.x1    = static_cast<float>(output.width);
        rectangle.y1    = static_cast<float>(output.height);
        // z / w of a point at that distance.
        rectangle.depth = std::clamp(-projection[2][2] + projection[3][2] / meters(step), 0.0f, 1.0f);
        rectangle.color = {static_cast<std::uint32_t>(step + 1)};
        ladder.draws.emplace_back(rectangle);
    }
    const pipeline::ColorImage steps = studio.picture(frame);
    Plane depth(steps.width, steps.height, std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < depth.values.size(); ++i)
        if (const auto step = static_cast<int>(steps.pixels[i] & 0xffffff); step > 0)
            depth.values[i] = meters(step - 1);
    return depth;
}

}  // namespace demo
