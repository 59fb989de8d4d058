// SPDX-License-Identifier: MIT
// What the passes of one cloud share: where they write, from where the cloud is seen, how wide it is blurred and which
// rectangles they are held to. Also the few helpers that all of these passes use.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "cloud/bake.h"
#include "cloud/bounds.h"
#include "cloud/mega_particles/blur_plan.h"
#include "cloud/mega_particles/mega_particles.h"

namespace cloud {

// Memory that all clouds of a frame use, one after the other. The pyramid is that of a target rounded up to width x
// height, multiples of 2^kMaxBlurLevels, so that each level is exactly half the one above: front[k], back[k] are of
// width >> k, and an index of -1 stands for nothing.
// particles: the article's render target, of the back buffer's size; at a smaller scale it is the level of the pyramid
// that the blur begins with. depth: of its size, with the scene's. camera, projection: see through it as the scene's
// see through the picture. finished: what the blur has left, at the back buffer's size; the particles' own at full
// scale, else only there if a cloud needs it, as is eroded.
struct CloudTargets {
    pipeline::TargetId particles, depth, finished, eroded;
    pipeline::CameraId camera;
    Mat4 projection = Mat4(1.0f);
    std::vector<pipeline::TargetId> front, back;
    int width = 0, height = 0;
};

// The textures of the fractal box's sides, in the order of FractalFaces.
using FractalTextures = std::array<pipeline::TextureId, kBoxFaces>;

// bounds: the cloud on the screen with its blurred rim. halo: bounds and as much around it as the blur reads. Both are
// multiples of 2^blur.levels, within the rounded-up target.
struct CloudDraw {
    pipeline::Frame& frame;
    const SceneTargets& scene;
    const View& view;
    const BakedCloud& baked;
    const CloudTargets& targets;
    BlurPlan blur;
    PixelRect bounds, halo;
    FractalTextures fractal;
    MegaParticleOptions options;
};

// A new pass of the frame, "<cloud>: <what>", scissored to `area` of the picture. The reference lasts until the next
// pass.
pipeline::Pass& append_pass(const CloudDraw& draw, const std::string& what, pipeline::TargetId color, PixelRect area);

// A rectangle that shows a texture of source_width x source_height texels magnified by `scale`, moved right and down by
// `shift` pixels; both in steps that 4 bits of fraction hold. It is made larger than the texture, so that it covers
// the target whatever the shift; moving its corners, instead of its uv, keeps every coordinate exact. Magnified by more
// than 2 it is as large, and unshifted.
pipeline::DrawRectangle blit(pipeline::TargetId source, int source_width, int source_height, float scale, float shift);

// Stages that write the bound texture as it is.
void show_texture(pipeline::PipelineState& state, pipeline::TextureFilter filter);

// What blends the finished cloud over the back buffer: bit 7 of its alpha decides, if the cloud is free of order.
void blend_over_scene(const CloudDraw& draw, pipeline::PipelineState& state, pipeline::BlendState blend);

// Rounded to the nearest byte; values are clamped to 0..1.
pipeline::Argb to_argb(Vec3 color, float alpha);

}  // namespace cloud
