// SPDX-License-Identifier: MIT
// Fixed-function transform (xemu, pgraph/glsl/vsh-ff.c): window = COMPOSITE * position, divided by w, plus VIEWPORT_OFFSET; so the
// viewport is in the composite matrix, as Xbox Direct3D has it, and z comes out in depth units. MODEL_VIEW serves lights, fog
// and generated coordinates; its last row is that of no projection, as the frame takes w for 1 there. Fog factors:
//   LINEAR  p0 + p1 d - 1          EXP  2^(16 p1 d)          EXP2  2^(-32 p1^2 d^2)          p0 = 3/2 of the last two
#include <cmath>
#include <numbers>

#include "pipeline/emit/nv2a_draw.h"
#include "pipeline/emit/nv2a_lighting.h"
#include "pipeline/emit/nv2a_values.h"
#include "pipeline/frame/text_values.h"
#include "pipeline/legalize/window_map.h"

namespace pipeline {
namespace {

enum TexGen : std::uint32_t { kDisable = 0, kEyeLinear = 0x2400 };
enum FogGen : std::uint32_t { kSpecAlpha = 0, kRadial = 1, kAbsPlanar = 3 };

void set_matrix(Nv2aStream& out, const Nv2aMethod& method, const Mat4& matrix, std::string_view what) {
    for (int row = 0; row < 4; ++row) {
        const Vec4 values    = matrix_row(matrix, row);
        const float floats[] = {values.x, values.y, values.z, values.w};
        out.set_floats(method, static_cast<std::size_t>(row), floats,
                       row == 0 ? std::string(what) : "row " + std::to_string(row));
    }
}

// x = X + (1 + cx / cw) W / 2, y = Y + (1 - cy / cw) H / 2, z = cz / cw * greatest depth.
glm::dmat4 to_window(const PixelRect& viewport, double greatest_depth) {
    const double half_width = (viewport.x1 - viewport.x0) / 2.0, half_height = (viewport.y1 - viewport.y0) / 2.0;
    glm::dmat4 matrix(1.0);
    matrix[0][0] = half_width;
    matrix[1][1] = -half_height;
    matrix[2][2] = greatest_depth;
    matrix[3][0] = viewport.x0 + half_width;
    matrix[3][1] = viewport.y0 + half_height;
    return matrix;
}

Mat4 depth_units(const Nv2aDraw& draw) {
    Mat4 matrix(1.0f);
    matrix[2][2] = draw.greatest_depth();
    return matrix;
}

void set_object_matrices(Nv2aStream& out, const Nv2aDraw& draw) {
    const Camera& camera       = draw.frame.cameras[static_cast<std::size_t>(draw.pass.camera.index)];
    const glm::dmat4 to_camera = glm::dmat4(camera.view) * glm::dmat4(draw.triangles()->world);
    const glm::dmat4 composite = to_window(viewport_of(draw.frame, draw.pass), draw.greatest_depth()) *
                                 (glm::dmat4(camera.projection) * to_camera);
    set_matrix(out, nv097::SET_COMPOSITE_MATRIX, Mat4(composite), "viewport * projection * view * world, row 0");
    Mat4 model_view(to_camera);
    for (int column = 0; column < 4; ++column) model_view[column][3] = column == 3 ? 1.0f : 0.0f;
    set_matrix(out, nv097::SET_MODEL_VIEW_MATRIX, model_view, "view * world, row 0");
}

void set_texgen(Nv2aStream& out, const Nv2aDraw& draw, std::size_t stage) {
    const TextureStage& state = draw.state().stages[stage];
    const bool generates      = draw.triangles() != nullptr && state.coords == CoordSource::CameraPosition;
    const auto set            = [&](const Nv2aMethod& method, bool on) {
        out.set(method, stage, {on ? kEyeLinear : kDisable}, on ? "EYE_LINEAR" : "DISABLE: the vertex's");
    };
    set(nv097::SET_TEXGEN_S, generates);
    set(nv097::SET_TEXGEN_T, generates);
    set(nv097::SET_TEXGEN_R, false);
    set(nv097::SET_TEXGEN_Q, generates);
    if (!generates) return;
    // (u, v) = (x, y) / z of the result, and the texture is read at (s, t) / q.
    constexpr std::size_t kPlanes[] = {0, 1, 3};
    for (int row = 0; row < 3; ++row) {
        const Vec4 plane     = matrix_row(state.transform, row);
        const float values[] = {plane.x, plane.y, plane.z, plane.w};
        const std::size_t to = kPlanes[row];
        out.set_floats(nv097::SET_TEXGEN_PLANE, 4 * stage + to, values,
                       "texture " + std::to_string(stage) + ", " + "STRQ"[to]);
    }
}

struct FogParams {
    float p0 = 0.0f, p1 = 0.0f;
};

FogParams fog_params(const FogState& fog) {
    constexpr double kLog256 = 8.0 * std::numbers::ln2;
    switch (fog.mode) {
        case FogMode::None:
            break;
        case FogMode::Linear: {
            if (fog.start == fog.end) return {1.0f, 0.0f};  // a factor of 0
            const double slope = -1.0 / (static_cast<double>(fog.end) - fog.start);
            return {static_cast<float>(1.0 - fog.end * slope), static_cast<float>(slope)};
        }
        case FogMode::Exp:
            return {1.5f, static_cast<float>(-fog.density / (2.0 * kLog256))};
        case FogMode::Exp2:
            return {1.5f, static_cast<float>(-fog.density / (2.0 * std::sqrt(kLog256)))};
    }
    return {};
}

void set_fog_curve(Nv2aStream& out, FogGen gen, std::string_view gen_text, const Nv2aValue& mode,
                   const FogParams& params, std::string_view curve) {
    out.set(nv097::SET_FOG_GEN_MODE, {gen}, gen_text);
    out.set(nv097::SET_FOG_MODE, mode);
    const float values[] = {params.p0, params.p1, 0.0f};
    out.set_floats(nv097::SET_FOG_PARAMS, 0, values, curve);
}

std::string curve_text(const FogState& fog) {
    if (fog.mode != FogMode::Linear) return "density " + numbers({{fog.density}});
    return "from " + numbers({{fog.start}}) + " to " + numbers({{fog.end}});
}

void set_fog(Nv2aStream& out, const Nv2aDraw& draw) {
    const FogState& fog = draw.state().fog;
    out.set_flag(nv097::SET_FOG_ENABLE, draw.has_fog());
    if (!draw.has_fog()) return;
    const std::uint32_t argb = fog.color.value;
    out.set(nv097::SET_FOG_COLOR, {(argb & 0xff00ff00) | (argb >> 16 & 0xff) | (argb & 0xff) << 16},
            hex(argb) + " (ARGB) as ABGR");
    if (draw.window_triangles() != nullptr) {
        set_fog_curve(out, kSpecAlpha, "SPEC_ALPHA: the vertex's factor", nv2a_fog_mode(FogMode::Linear), {1.0f, 1.0f},
                      "factor = distance");
    } else {
        const float plane[] = {0.0f, 0.0f, 1.0f, 0.0f};
        out.set_floats(nv097::SET_FOG_PLANE, 0, plane, "distance along z, in camera space");
        set_fog_curve(out, fog.range ? kRadial : kAbsPlanar, fog.range ? "RADIAL" : "ABS_PLANAR",
                      nv2a_fog_mode(fog.mode), fog_params(fog), curve_text(fog));
    }
    out.note_once("The frame clamps fog factors at vertices, the chip at pixels. Not known: the third of FOG_PARAMS.");
    if (draw.state().shade == ShadeMode::Flat)
        out.note_once("Not known: whether flat shading takes the fog of the first vertex too, as in the frame.");
}

}  // namespace

float Nv2aDraw::greatest_depth() const {
    return nv2a_greatest_depth(pass.depth ? frame.targets[static_cast<std::size_t>(pass.depth.index)].format
                                          : TargetFormat::D24);
}

void set_transform(Nv2aStream& out, const Nv2aDraw& draw) {
    const float none[] = {0.0f, 0.0f, 0.0f, 0.0f};
    out.set_floats(nv097::SET_VIEWPORT_OFFSET, 0, none, "it is in the composite matrix");
    if (draw.triangles() != nullptr)
        set_object_matrices(out, draw);
    else
        set_matrix(out, nv097::SET_COMPOSITE_MATRIX, depth_units(draw), "vertices are in window space, row 0");
    for (std::size_t stage = 0; stage < kTextureStages; ++stage) set_texgen(out, draw, stage);
    set_lights(out, draw);
    set_fog(out, draw);
}

}  // namespace pipeline
