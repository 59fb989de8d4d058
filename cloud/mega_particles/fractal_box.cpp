// SPDX-License-Identifier: MIT
#include "cloud/mega_particles/fractal_box.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace cloud {

using namespace pipeline;

namespace {

struct Box {
    Vec3 low, high;
};

// The particles, and the rim that the blur gives them. Its width is mostly fixed, so that the fractal does not move
// within the cloud; only where the blur is wider than was asked for (far away, where it cannot be narrow) does the box
// grow.
Box box_around(const CloudDraw& draw) {
    const LitParticles& lit = draw.baked.lit;
    const Vec3 middle       = (lit.low + lit.high) * 0.5f;
    const float farthest    = glm::length(middle - draw.view.eye) + glm::length(lit.high - middle);
    const float sigma_m     = sigma_px(draw.blur) / focal_px(draw.view) * farthest;
    const Vec3 rim(std::max(4.0f * draw.baked.cloud.blur_m, 2.5f * sigma_m));
    return {lit.low - rim, lit.high + rim};
}

// From outside the near sides are drawn, from inside the far ones: always one layer. The near plane cuts holes into
// the near sides a little before the eye is inside. There the article's "culling off" would draw both.
CullMode cull_of(const CloudDraw& draw, const Box& box) {
    const auto contains = [&](float reach) {
        return glm::all(glm::greaterThan(draw.view.eye, box.low - reach)) &&
               glm::all(glm::lessThan(draw.view.eye, box.high + reach));
    };
    if (!contains(near_reach_m(draw.view))) return CullMode::Clockwise;
    return draw.baked.cloud.mode == Mode::Article && contains(0.0f) ? CullMode::None : CullMode::CounterClockwise;
}

TextureId append_texture(const CloudDraw& draw, int face) {
    const int size = draw.baked.cloud.fractal.face_size;
    Texture texture;
    texture.name   = draw.baked.cloud.name + " fractal " + "+-"[face % 2] + "xyz"[face / 2];
    texture.format = TextureFormat::A8;
    texture.width = texture.height = size;
    texture.levels                 = fractal_levels(size);
    texture.texels                 = draw.baked.fractal[static_cast<std::size_t>(face)];
    draw.frame.textures.push_back(std::move(texture));
    return {static_cast<std::int32_t>(draw.frame.textures.size()) - 1};
}

// One side of the box; uv from centre to centre of the fractal's border texels (fractal.h).
DrawTriangles append_side(const CloudDraw& draw, const Box& box, int face, int stage) {
    Frame& frame     = draw.frame;
    const int axis   = face / 2;
    const bool far   = face % 2 == 0;
    const float edge = 0.5f / static_cast<float>(draw.baked.cloud.fractal.face_size);
    const auto first = static_cast<std::uint32_t>(frame.vertices.size());
    for (int corner = 0; corner < 4; ++corner) {
        const bool right = corner == 1 || corner == 2, down = corner >= 2;
        Vertex vertex;
        vertex.position[axis]           = far ? box.high[axis] : box.low[axis];
        vertex.position[(axis + 1) % 3] = right ? box.high[(axis + 1) % 3] : box.low[(axis + 1) % 3];
        vertex.position[(axis + 2) % 3] = down ? box.high[(axis + 2) % 3] : box.low[(axis + 2) % 3];
        vertex.normal[axis]             = far ? 1.0f : -1.0f;
        vertex.uv0                      = Vec2(right ? 1.0f - edge : edge, down ? 1.0f - edge : edge);
        frame.vertices.push_back(vertex);
    }
    DrawTriangles side;
    side.first_index = static_cast<std::uint32_t>(frame.indices.size());
    side.index_count = 6;
    // Counter-clockwise from outside: the two texture axes and the outward normal of a far side are right-handed.
    for (std::uint32_t index : {0u, far ? 1u : 2u, far ? 2u : 1u, 0u, far ? 2u : 3u, far ? 3u : 2u})
        frame.indices.push_back(first + index);
    side.textures[static_cast<std::size_t>(stage)].texture = append_texture(draw, face);
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

void append_multiplying_box(const CloudDraw& draw) {
    const Box box         = box_around(draw);
    Pass& pass            = append_pass(draw, "fractal box: multiply alpha only", draw.targets.particles, draw.bounds);
    pass.camera           = draw.scene.camera;
    pass.state.blend      = kMultiply;
    pass.state.color_mask = {.red = false, .green = false, .blue = false, .alpha = true};
    pass.state.cull       = cull_of(draw, box);
    show_texture(pass.state, TextureFilter::Linear);
    sample_fractal(pass.state.stages[0]);
    for (int face = 0; face < kBoxFaces; ++face) pass.draws.push_back(append_side(draw, box, face, 0));
}

void append_eroding_box(const CloudDraw& draw, TargetId into, BlendState blend) {
    const Box box   = box_around(draw);
    const bool over = !(blend == kReplace);
    Pass& pass = append_pass(draw, over ? "fractal box: erode and composite" : "fractal box: erode", into, draw.bounds);
    if (!over) pass.clear.color = Argb{0x00000000};  // where the box does not reach
    pass.camera      = draw.scene.camera;
    pass.state.blend = blend;
    pass.state.cull  = cull_of(draw, box);
    show_texture(pass.state, TextureFilter::Point);
    pass.state.stages[0].coords    = CoordSource::CameraPosition;
    pass.state.stages[0].transform = screen_coordinates(draw.view.projection);
    TextureStage& erosion          = pass.state.stages[1];
    sample_fractal(erosion);
    erosion.color_op = TextureOp::SelectArg2;  // the colour so far; the fractal stores n / 2
    erosion.alpha_op = TextureOp::AddSigned2X;
    for (int face = 0; face < kBoxFaces; ++face) {
        DrawTriangles side      = append_side(draw, box, face, 1);
        side.textures[0].target = draw.targets.particles;
        pass.draws.push_back(side);
    }
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
