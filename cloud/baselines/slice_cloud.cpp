// SPDX-License-Identifier: MIT
#include "cloud/baselines/slice_cloud.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "cloud/baselines/farthest_first.h"
#include "cloud/mega_particles/cloud_draw.h"

namespace cloud {

using namespace pipeline;

namespace {

Vec3 corner_of(const SliceVolume& volume, int corner) {
    return Vec3(corner & 1 ? volume.high.x : volume.low.x, corner & 2 ? volume.high.y : volume.low.y,
                corner & 4 ? volume.high.z : volume.low.z);
}

float opacity_of(const SliceVolume& volume) {
    return volume.cloud.opacity * (1.0f - volume.cloud.dissolve);
}

// Not if all corners are outside of one side of the picture, or nearer than the near plane.
bool is_in_view(const SliceVolume& volume, const View& view) {
    const Mat4 clip = view.projection * view.view;
    int outside[5]  = {};
    for (int corner = 0; corner < 8; ++corner) {
        const Vec4 at = clip * Vec4(corner_of(volume, corner), 1.0f);
        outside[0] += at.x < -at.w;
        outside[1] += at.x > at.w;
        outside[2] += at.y < -at.w;
        outside[3] += at.y > at.w;
        outside[4] += at.w < view.near_m;
    }
    for (const int corners : outside)
        if (corners == 8) return false;
    return true;
}

// The one along which the eye is farthest from the middle: from there the box is seen as far off that axis as can be 45
// degrees, but no more.
int axis_towards(Vec3 eye, const SliceVolume& volume) {
    const Vec3 from_eye = (volume.low + volume.high) * 0.5f - eye;
    int axis            = 0;
    for (int other : {1, 2})
        if (std::abs(from_eye[other]) > std::abs(from_eye[axis])) axis = other;
    return axis;
}

float place_m(const SliceVolume& volume, int axis, int slice) {
    const float share = (static_cast<float>(slice) + 0.5f) / static_cast<float>(volume.size);
    return volume.low[axis] + (volume.high[axis] - volume.low[axis]) * share;
}

TextureId append_texture(Frame& frame, const SliceVolume& volume, int axis, int slice) {
    const std::uint8_t* texels =
        volume.stacks[static_cast<std::size_t>(axis)].data() + volume.slice_bytes() * static_cast<std::size_t>(slice);
    Texture texture;
    texture.name   = volume.cloud.name + " slice " + "xyz"[axis] + std::to_string(slice);
    texture.format = TextureFormat::A8R8G8B8;
    texture.width = texture.height = volume.size;
    texture.texels.assign(texels, texels + volume.slice_bytes());
    frame.textures.push_back(std::move(texture));
    return {static_cast<std::int32_t>(frame.textures.size()) - 1};
}

// The part of the slice that is not clear.
DrawTriangles append_slice(Frame& frame, const SliceVolume& volume, int axis, int slice, const PixelRect& part) {
    const auto first = static_cast<std::uint32_t>(frame.vertices.size());
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int corner = 0; corner < 4; ++corner) {
        const bool right = corner == 1 || corner == 2, down = corner >= 2;
        Vertex vertex;
        vertex.uv0 = Vec2(static_cast<float>(right ? part.x1 : part.x0), static_cast<float>(down ? part.y1 : part.y0)) /
                     static_cast<float>(volume.size);
        vertex.position[axis] = place_m(volume, axis, slice);
        vertex.position[u]    = volume.low[u] + (volume.high[u] - volume.low[u]) * vertex.uv0.x;
        vertex.position[v]    = volume.low[v] + (volume.high[v] - volume.low[v]) * vertex.uv0.y;
        vertex.diffuse        = to_argb(Vec3(1.0f), opacity_of(volume));
        frame.vertices.push_back(vertex);
    }
    DrawTriangles quad;
    quad.first_index = static_cast<std::uint32_t>(frame.indices.size());
    quad.index_count = 6;
    for (const std::uint32_t index : {0u, 1u, 2u, 0u, 2u, 3u}) frame.indices.push_back(first + index);
    quad.textures[0].texture = append_texture(frame, volume, axis, slice);
    return quad;
}

// The texel's colour, and its alpha times the vertex's.
void show_slice(TextureStage& stage) {
    stage.color_op   = TextureOp::SelectArg1;
    stage.alpha_op   = TextureOp::Modulate;
    stage.alpha_arg2 = {.source = ArgSource::Diffuse};
    stage.filter     = TextureFilter::Linear;
    stage.address_u = stage.address_v = TextureAddress::Clamp;
}

void append_volume(Frame& frame, const SceneTargets& scene, const View& view, const SliceVolume& volume) {
    const int axis = axis_towards(view.eye, volume);
    Pass pass;
    pass.label            = volume.cloud.name + ": slices across " + "xyz"[axis] + ", back to front";
    pass.color            = scene.back_buffer;
    pass.depth            = scene.depth;
    pass.camera           = scene.camera;
    pass.state.blend      = kAlphaOver;
    pass.state.depth      = {.func = CompareFunc::LessEqual, .write = false};
    pass.state.fog        = scene.fog;
    pass.state.alpha_test = {
        .func = CompareFunc::Greater, .reference = 0, .fail = AlphaFail::Keep};  // clear texels change nothing
    show_slice(pass.state.stages[0]);
    // Slices on either side of the eye do not hide each other, so their distances may be compared.
    std::vector<float> distances;
    for (int slice = 0; slice < volume.size; ++slice)
        distances.push_back(std::abs(place_m(volume, axis, slice) - view.eye[axis]));
    for (const std::size_t slice : farthest_first(distances)) {
        const PixelRect& part = volume.visible[static_cast<std::size_t>(axis)][slice];
        if (part == PixelRect{}) continue;
        pass.draws.emplace_back(append_slice(frame, volume, axis, static_cast<int>(slice), part));
    }
    frame.passes.push_back(std::move(pass));
}

}  // namespace

void append_slice_clouds(Frame& frame, const SceneTargets& scene, const View& view,
                         std::span<const SliceVolume> clouds) {
    std::vector<float> distances;
    for (const SliceVolume& volume : clouds) distances.push_back(nearest_particle_m(volume.cloud, view.eye));
    for (const std::size_t index : farthest_first(distances)) {
        const SliceVolume& volume = clouds[index];
        if (volume.size == 0 || opacity_of(volume) <= 0.0f || !is_in_view(volume, view)) continue;
        append_volume(frame, scene, view, volume);
    }
}

void append_slice_clouds(Frame& frame, const SceneTargets& scene, const View& view, std::span<const BakedCloud> clouds,
                         const SliceOptions& options) {
    std::vector<SliceVolume> volumes;
    for (const BakedCloud& baked : clouds) volumes.push_back(make_slices(baked, options));
    append_slice_clouds(frame, scene, view, volumes);
}

}  // namespace cloud
