// SPDX-License-Identifier: MIT
#include "cloud/mega_particles/fractal_box.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace cloud {

using namespace pipeline;

namespace {

struct PlacedBox {
    Vec3 middle, half;
    Turn turn;

    Vec3 to_world(Vec3 p) const { return middle + Vec3(turn.x * p.x + turn.y * p.z, p.y, turn.x * p.z - turn.y * p.x); }
    Vec3 to_box(Vec3 p) const {
        p -= middle;
        return Vec3(turn.x * p.x - turn.y * p.z, p.y, turn.x * p.z + turn.y * p.x);
    }
};

// The particles, and the rim that the blur gives them. Its width is mostly fixed, so that the fractal does not move
// within the cloud; only where the blur is wider than was asked for (far away, where it cannot be narrow) does the box
// grow.
PlacedBox box_around(const CloudDraw& draw, const std::optional<Turn>& turn) {
    const Box box        = fractal_box(draw.baked.cloud, draw.baked.lit);
    const Vec3 middle    = (box.low + box.high) * 0.5f;
    const float farthest = glm::length(middle - draw.view.eye) + glm::length(box.high - middle);
    const float sigma_m  = sigma_px(draw.blur) / focal_px(draw.view) * farthest;
    const Vec3 rim(std::max(4.0f * draw.baked.cloud.blur_m, 2.5f * sigma_m));
    return {middle, box.high - middle + rim, turn.value_or(Turn(1.0f, 0.0f))};
}

// From outside the near sides are drawn, from inside the far ones: always one layer. The near plane cuts holes into
// the near sides a little before the eye is inside. There the article's "culling off" would draw both.
CullMode cull_of(const CloudDraw& draw, const PlacedBox& box) {
    const Vec3 eye      = glm::abs(box.to_box(draw.view.eye));
    const auto contains = [&](float reach) { return glm::all(glm::lessThan(eye, box.half + reach)); };
    if (!contains(near_reach_m(draw.view))) return CullMode::Clockwise;
    return draw.baked.cloud.mode == Mode::Article && contains(0.0f) ? CullMode::None : CullMode::CounterClockwise;
}

// One side of the box; uv from centre to centre of the fractal's border texels (fractal.h).
DrawTriangles append_side(const CloudDraw& draw, const PlacedBox& box, int face, int stage) {
    Frame& frame     = draw.frame;
    const int axis   = face / 2;
    const bool far   = face % 2 == 0;
    const float edge = 0.5f / static_cast<float>(draw.baked.cloud.fractal.face_size);
    const auto first = static_cast<std::uint32_t>(frame.vertices.size());
    for (int corner = 0; corner < 4; ++corner) {
        const bool right = corner == 1 || corner == 2, down = corner >= 2;
        Vec3 position;
        position[axis]           = far ? box.half[axis] : -box.half[axis];
        position[(axis + 1) % 3] = right ? box.half[(axis + 1) % 3] : -box.half[(axis + 1) % 3];
        position[(axis + 2) % 3] = down ? box.half[(axis + 2) % 3] : -box.half[(axis + 2) % 3];
        Vertex vertex;
        vertex.position     = box.to_world(position);
        vertex.normal[axis] = far ? 1.0f : -1.0f;
        vertex.normal       = box.to_world(vertex.normal) - box.middle;
        vertex.uv0          = Vec2(right ? 1.0f - edge : edge, down ? 1.0f - edge : edge);
        frame.vertices.push_back(vertex);
    }
    DrawTriangles side;
    side.first_index = static_cast<std::uint32_t>(frame.indices.size());
    side.index_count = 6;
    // Counter-clockwise from outside: the two texture axes and the outward normal of a far side are right-handed.
    for (std::uint32_t index : {0u, far ? 1u : 2u, far ? 2u : 1u, 0u, far ? 2u : 3u, far ? 3u : 2u})
        frame.indices.push_back(first + index);
    side.textures[static_cast<std::size_t>(stage)].texture = draw.fractal[static_cast<std::size_t>(face)];
    return side;
}

void sample_fractal(TextureStage& stage) {
    stage.filter     = TextureFilter::Linear;
    stage.mip_filter = MipFilter::Linear;
    stage.address_u  = TextureAddress::Clamp;
    stage.address_v  = TextureAddress::Clamp;
    stage.coords     = CoordSource::Vertex0;
}

}  // namespace

void append_multiplying_box(const CloudDraw& draw, TargetId into, const std::optional<Turn>& turn) {
    const Cloud& cloud  = draw.baked.cloud;
    const bool all      = cloud.mode == Mode::Premultiplied;
    const PlacedBox box = box_around(draw, turn);
    Pass& pass =
        append_pass(draw, all ? "fractal box: multiply" : "fractal box: multiply alpha only", into, draw.bounds);
    pass.camera           = draw.scene.camera;
    pass.state.blend      = all ? BlendState{.source = BlendFactor::Zero, .dest = BlendFactor::SourceAlpha} : kMultiply;
    pass.state.color_mask = {.red = all, .green = all, .blue = all, .alpha = true};
    pass.state.cull       = cull_of(draw, box);
    show_texture(pass.state, TextureFilter::Linear);
    sample_fractal(pass.state.stages[0]);
    for (int face = 0; face < kBoxFaces; ++face) pass.draws.push_back(append_side(draw, box, face, 0));
}

void append_eroding_box(const CloudDraw& draw, const Erosion& erosion) {
    const Cloud& cloud  = draw.baked.cloud;
    const PlacedBox box = box_around(draw, erosion.turn);
    const bool over     = erosion.into == draw.scene.back_buffer;
    Pass& pass =
        append_pass(draw, over ? "fractal box: erode and composite" : "fractal box: erode", erosion.into, draw.bounds);
    pass.camera     = draw.scene.camera;
    pass.state.cull = cull_of(draw, box);
    if (over)
        blend_over_scene(draw, pass.state, kAlphaOver);
    else
        pass.clear.color = Argb{0x00000000};  // where the box does not reach
    const bool enlarges = erosion.from == draw.targets.particles && draw.blur.first_level > 0;
    show_texture(pass.state, enlarges ? TextureFilter::Linear : TextureFilter::Point);
    TextureStage& cloud_so_far = pass.state.stages[0];
    cloud_so_far.coords        = CoordSource::CameraPosition;
    cloud_so_far.transform     = screen_coordinates(enlarges ? draw.targets.projection : draw.view.projection);
    if (erosion.is_first && (cloud.tint || cloud.dissolve > 0.0f)) {
        pass.state.texture_factor = to_argb(cloud.tint.value_or(Vec3(1.0f)), cloud.dissolve);
        cloud_so_far.color_op     = TextureOp::Modulate;
        cloud_so_far.color_arg2   = {.source = ArgSource::TFactor};
        cloud_so_far.alpha_op     = TextureOp::Subtract;
        cloud_so_far.alpha_arg2   = {.source = ArgSource::TFactor};
    }
    TextureStage& fractal = pass.state.stages[1];
    sample_fractal(fractal);
    fractal.color_op = TextureOp::SelectArg2;  // the colour so far; the fractal stores n / 2
    fractal.alpha_op = TextureOp::AddSigned2X;
    for (int face = 0; face < kBoxFaces; ++face) {
        DrawTriangles side      = append_side(draw, box, face, 1);
        side.textures[0].target = erosion.from;
        pass.draws.push_back(side);
    }
}

FractalTextures append_fractal(Frame& frame, const BakedCloud& baked) {
    FractalTextures textures;
    const int size = baked.cloud.fractal.face_size;
    for (int face = 0; face < kBoxFaces; ++face) {
        Texture& texture = frame.textures.emplace_back();
        texture.name     = baked.cloud.name + " fractal " + "+-"[face % 2] + "xyz"[face / 2];
        texture.format   = TextureFormat::A8;
        texture.width = texture.height           = size;
        texture.levels                           = fractal_levels(size);
        texture.texels                           = (*baked.fractal)[static_cast<std::size_t>(face)];
        textures[static_cast<std::size_t>(face)] = {static_cast<std::int32_t>(frame.textures.size()) - 1};
    }
    return textures;
}

Mat4 screen_coordinates(const Mat4& projection) {
    // u = (1 + x/w) / 2 and v = (1 - y/w) / 2, as (x + w, w - y) / 2 over w; z takes no part.
    Mat4 screen(0.0f);
    screen[0][0] = 0.5f, screen[3][0] = 0.5f;
    screen[1][1] = -0.5f, screen[3][1] = 0.5f;
    screen[3][2] = 1.0f;
    return screen * projection;
}

}  // namespace cloud
