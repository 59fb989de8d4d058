// SPDX-License-Identifier: MIT
#include "cloud/mega_particles/mega_particles.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <map>
#include <string>

#include "cloud/mega_particles/blur.h"
#include "cloud/mega_particles/cloud_draw.h"
#include "cloud/mega_particles/composite.h"
#include "cloud/mega_particles/copy_scene.h"
#include "cloud/mega_particles/displacement.h"
#include "cloud/mega_particles/draw_particles.h"
#include "cloud/mega_particles/fractal_box.h"
#include "cloud/mega_particles/scaled_depth.h"
#include "cloud/mega_particles/share_passes.h"

namespace cloud {

using namespace pipeline;

namespace {

// The fractal erodes once, or once more by a second box. The last to do so composites as well; but a constant opacity is
// one factor more than two texture stages can take, and comes in a rectangle of its own.
void append_erosions_and_composite(const CloudDraw& draw) {
    const Cloud& cloud          = draw.baked.cloud;
    const CloudTargets& targets = draw.targets;
    const bool at_once          = cloud.opacity >= 1.0f;
    const auto second_turn      = cloud.second_box_turn;
    const TargetId last         = second_turn ? targets.finished : targets.eroded;
    Erosion first{.from = targets.particles, .into = targets.eroded, .turn = cloud.box_turn};
    if (at_once && !second_turn) first.into = draw.scene.back_buffer;
    append_eroding_box(draw, first);
    if (second_turn)
        append_eroding_box(draw, {.from     = targets.eroded,
                                  .into     = at_once ? draw.scene.back_buffer : last,
                                  .turn     = second_turn,
                                  .is_first = false});
    if (!at_once) append_composite(draw, last);
}
bool is_eroded(const Cloud& cloud) {
    return cloud.detail == Detail::Fractal && cloud.mode == Mode::Skirt;
}
bool needs_eroded(const Cloud& cloud) {
    return is_eroded(cloud) && (cloud.opacity < 1.0f || cloud.second_box_turn);
}
bool needs_finished(const Cloud& cloud) {
    return !is_eroded(cloud) || (cloud.opacity < 1.0f && cloud.second_box_turn);
}

// To the back buffer's size; an eroding box does that by itself.
void append_enlargement(const CloudDraw& draw) {
    if (draw.blur.first_level == 0 || is_eroded(draw.baked.cloud)) return;
    const int level = draw.blur.first_level, times = 1 << level;
    Pass& pass =
        append_pass(draw, "enlarge 1:" + std::to_string(times) + " (bilinear)", draw.targets.finished, draw.bounds);
    show_texture(pass.state, TextureFilter::Linear);
    pass.draws.push_back(blit(draw.targets.particles, draw.targets.width >> level, draw.targets.height >> level,
                              static_cast<float>(times), 0.0f));
}

// What gives the rim its relief, fixed to the cloud and not to the screen; and the blend over the back buffer.
void append_detail_and_composite(const CloudDraw& draw) {
    const Cloud& cloud = draw.baked.cloud;
    if (cloud.detail == Detail::Displacement) return append_displaced_composite(draw);
    if (cloud.detail == Detail::Fractal) {
        if (cloud.mode == Mode::Skirt) return append_erosions_and_composite(draw);
        append_multiplying_box(draw, draw.targets.finished, cloud.box_turn);
        if (const auto second_turn = cloud.second_box_turn)
            append_multiplying_box(draw, draw.targets.finished, second_turn);
    }
    append_composite(draw, draw.targets.finished);
}

// The technique. `particles` is a colour target beside the back buffer; both use the scene's depth buffer, or at a
// smaller scale one that holds the same.
void append_cloud(const CloudDraw& draw) {
    const Mode mode = draw.baked.cloud.mode;
    // Around the cloud, for the blur to mix in: the cloud's own colour, or the scene's. Else it is black.
    if (mode == Mode::Skirt) append_skirt(draw);
    if (mode == Mode::Article) append_scene_copy(draw);
    append_particles(draw);  // the basic shape: few large spheres, lit and hidden like any object
    append_blur(draw);       // colour and alpha: hides the spheres' edges, makes the rim soft
    append_enlargement(draw);
    if (draw.baked.cloud.order == Order::OrderFree) append_rim_mask(draw);
    append_detail_and_composite(draw);
    append_whiteout(draw);
}

float nearest_m(const BakedCloud& baked, Vec3 eye) {
    float nearest = 1e30f;
    for (const Particle& particle : baked.cloud.particles)
        nearest = std::min(nearest, glm::length(particle.center - eye) - greatest_radius(particle));
    return nearest;
}

// The blur is given in metres; it is projected at the middle of the cloud.
float wanted_sigma_px(const BakedCloud& baked, const View& view) {
    const Box box        = fractal_box(baked.cloud, baked.lit);
    const float distance = glm::length((box.low + box.high) * 0.5f - view.eye);
    return baked.cloud.blur_m * focal_px(view) / std::max(distance, view.near_m);
}

TargetId append_target(Frame& frame, const std::string& name, int width, int height) {
    frame.targets.push_back({.name = name, .format = TargetFormat::A8R8G8B8, .width = width, .height = height});
    return {static_cast<std::int32_t>(frame.targets.size()) - 1};
}

// What the clouds of a frame ask of their targets. levels: first and last of the pyramid. area: all that they draw
// particles to, in pixels of the picture.
struct Needs {
    int first_level = 0, last_level = 0;
    bool eroded = false, finished = false;
    PixelRect area;
};

CloudTargets append_targets(Frame& frame, const SceneTargets& scene, const View& view, const Needs& needs) {
    CloudTargets targets;
    targets.width          = round_up(view.width, 1 << kMaxBlurLevels);
    targets.height         = round_up(view.height, 1 << kMaxBlurLevels);
    const auto append_full = [&](const std::string& name) {
        return append_target(frame, name, view.width, view.height);
    };
    const auto append_level = [&](const std::string& name, int level) {
        return append_target(frame, name, targets.width >> level, targets.height >> level);
    };
    const int first     = needs.first_level;
    const auto fraction = [](int level) { return " 1/" + std::to_string(1 << level); };
    targets.particles =
        first == 0 ? append_full("mega-particles") : append_level("mega-particles" + fraction(first), first);
    for (int level = 0; level <= needs.last_level; ++level) {
        const std::string name = "blur" + fraction(level);
        targets.front.push_back(level > first ? append_level(name, level) : TargetId{});
        targets.back.push_back(level > 0 && level >= first ? append_level(name + " back", level) : TargetId{});
    }
    if (needs.eroded) targets.eroded = append_full("eroded");
    if (first == 0) {
        targets.depth      = scene.depth;
        targets.camera     = scene.camera;
        targets.projection = view.projection;
        targets.finished   = targets.particles;
        return targets;
    }
    if (needs.finished) targets.finished = append_full("enlarged");
    const ScaledDepth scaled =
        append_scaled_depth(frame, scene, first, targets.width >> first, targets.height >> first, needs.area);
    targets.depth      = scaled.depth;
    targets.camera     = scaled.camera;
    targets.projection = frame.cameras[static_cast<std::size_t>(scaled.camera.index)].projection;
    return targets;
}

// A whiteout lies over all of the picture. Displaced pixels are looked up beyond the halo, where those before have left
// what they drew.
PixelRect reach_of(const CloudDraw& draw) {
    const Cloud& cloud = draw.baked.cloud;
    const bool is_wide = cloud.detail == Detail::Displacement || whiteout(cloud, draw.view) > 0.0f;
    return is_wide ? PixelRect{0, 0, draw.targets.width, draw.targets.height} : draw.halo;
}

// The cloud's passes apart from those of the frame.
CloudPasses passes_of(const CloudDraw& draw) {
    std::vector<Pass>& passes = draw.frame.passes;
    const auto first          = static_cast<std::ptrdiff_t>(passes.size());
    append_cloud(draw);
    CloudPasses own{.name = draw.baked.cloud.name, .reach = reach_of(draw), .passes = {}};
    own.passes.assign(std::move_iterator(passes.begin() + first), std::move_iterator(passes.end()));
    passes.erase(passes.begin() + first, passes.end());
    return own;
}

}  // namespace

void append_mega_particles(Frame& frame, const SceneTargets& scene, const View& view,
                           std::span<const BakedCloud> clouds, const MegaParticleOptions& options) {
    check(options);
    struct Seen {
        const BakedCloud* baked;
        BlurPlan blur;
        PixelRect bounds, halo;
        float nearest;
    };
    std::vector<Seen> seen;
    Needs needs;
    const int width = round_up(view.width, 1 << kMaxBlurLevels), height = round_up(view.height, 1 << kMaxBlurLevels);
    for (const BakedCloud& baked : clouds) {
        const Mode mode = baked.cloud.mode;
        const BlurPlan blur =
            at_target_scale(mode, plan_blur(mode, wanted_sigma_px(baked, view)), options.target_scale);
        const auto rim = static_cast<int>(std::ceil(3.0f * sigma_px(blur)));
        auto bounds    = screen_bounds(baked.cloud, view, rim, 1 << blur.levels);
        // Behind the eye, but around it.
        if (!bounds && whiteout(baked.cloud, view) > 0.0f)
            bounds = PixelRect{0, 0, round_up(view.width, 1 << blur.levels), round_up(view.height, 1 << blur.levels)};
        if (!bounds || baked.cloud.opacity <= 0.0f) continue;
        const PixelRect halo = grow(*bounds, 1 << blur.levels, width, height);
        needs.first_level    = blur.first_level;
        needs.last_level     = std::max(needs.last_level, blur.levels);
        needs.eroded |= needs_eroded(baked.cloud);
        needs.finished |= needs_finished(baked.cloud);
        needs.area = seen.empty() ? halo : hull(needs.area, halo);
        seen.push_back({&baked, blur, *bounds, halo, nearest_m(baked, view.eye)});
    }
    if (seen.empty()) return;

    // Each cloud is blurred and composited by itself, over those behind it, so clouds never smear into each other. What
    // counts is the nearest particle: the centre of a cloud can be farther than another's that it hides.
    std::stable_sort(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) { return a.nearest > b.nearest; });
    const CloudTargets targets = append_targets(frame, scene, view, needs);
    std::map<const FractalFaces*, FractalTextures> fractals;  // clouds may share theirs
    std::vector<CloudPasses> apart;
    for (const Seen& cloud : seen) {
        FractalTextures fractal;
        if (cloud.baked->cloud.detail == Detail::Fractal) {
            const auto [entry, is_new] = fractals.try_emplace(cloud.baked->fractal.get());
            if (is_new) entry->second = append_fractal(frame, *cloud.baked);
            fractal = entry->second;
        }
        const CloudDraw draw{frame,      scene,        view,       *cloud.baked, targets,
                             cloud.blur, cloud.bounds, cloud.halo, fractal,      options};
        if (options.passes == Passes::OneByOne)
            append_cloud(draw);
        else
            apart.push_back(passes_of(draw));
    }
    std::ranges::move(share_passes(frame, std::move(apart)), std::back_inserter(frame.passes));
}

void append_mega_particles(Frame& frame, const SceneTargets& scene, const View& view, const Daylight& light,
                           std::span<const Cloud> clouds, const MegaParticleOptions& options) {
    std::vector<BakedCloud> baked;
    for (const Cloud& cloud : clouds) baked.push_back(bake(cloud, light));
    append_mega_particles(frame, scene, view, baked, options);
}

}  // namespace cloud
