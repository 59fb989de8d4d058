// SPDX-License-Identifier: MIT
#include "demo/thrown_light.h"

#include <algorithm>
#include <glm/matrix.hpp>

#include "demo/texture_pyramid.h"

namespace demo {

namespace pl = pipeline;

namespace {

// From camera space to the texture: u along one axis of the world, v along the other; -1 is the texture's middle.
Mat4 project_along(const ThrownLight& light, const Mat4& view, int first_axis, int second_axis) {
    Mat4 from_world(0.0f);
    int row = 0;
    for (const int axis : {first_axis, second_axis}) {
        if (axis >= 0) {
            from_world[axis][row] = 0.5f / light.range;
            from_world[3][row]    = 0.5f - 0.5f / light.range * light.center[axis];
        } else {
            from_world[3][row] = 0.5f;
        }
        ++row;
    }
    from_world[3][2] = 1.0f;
    return from_world * glm::inverse(view);
}

}  // namespace

pl::Texture light_texture() {
    constexpr int kSize = 64;
    pl::Texture texture{.name   = "thrown light",
                        .format = pl::TextureFormat::L8,
                        .width  = kSize,
                        .height = kSize,
                        .levels = 1,
                        .texels = {}};
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            // The border texels are 0, for clamping.
            const double u = (2.0 * x - (kSize - 1)) / (kSize - 1), v = (2.0 * y - (kSize - 1)) / (kSize - 1);
            const double within = std::max(0.0, 1.0 - u * u - v * v);
            texture.texels.push_back(static_cast<std::uint8_t>(255.0 * within * within * within + 0.5));
        }
    return texture;
}

pl::PipelineState thrown_light_state(const ThrownLight& light, const Mat4& view, const pl::FogState& fog) {
    pl::PipelineState state;
    state.depth          = {.func = pl::CompareFunc::LessEqual, .write = false};
    state.cull           = pl::CullMode::Clockwise;
    state.blend          = {.source = pl::BlendFactor::DestColor, .dest = pl::BlendFactor::One};
    state.color_mask     = {.red = true, .green = true, .blue = true, .alpha = false};
    state.texture_factor = to_argb(light.color);
    state.fog            = fog;
    state.fog.color      = pl::Argb{0xff000000};  // haze hides light, too
    for (std::size_t i = 0; i < 2; ++i) {
        pl::TextureStage& stage = state.stages[i];
        stage.color_op          = pl::TextureOp::Modulate;
        stage.color_arg2        = {.source = i == 0 ? pl::ArgSource::TFactor : pl::ArgSource::Current};
        stage.alpha_op          = pl::TextureOp::SelectArg2;
        stage.alpha_arg2        = stage.color_arg2;
        stage.filter            = pl::TextureFilter::Linear;
        stage.address_u = stage.address_v = pl::TextureAddress::Clamp;
        stage.coords                      = pl::CoordSource::CameraPosition;
    }
    state.stages[0].transform = project_along(light, view, 0, 2);
    state.stages[1].transform = project_along(light, view, 1, -1);
    return state;
}

}  // namespace demo
