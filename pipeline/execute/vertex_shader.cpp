// SPDX-License-Identifier: MIT
#include "pipeline/execute/vertex_shader.h"

#include <algorithm>

#include "pipeline/execute/fog.h"
#include "pipeline/execute/lower.h"
#include "pipeline/execute/vector_math.h"

namespace pipeline {
namespace {

// round(c * 255), half up; exact in double.
std::uint32_t to_byte(float channel) {
    return static_cast<std::uint32_t>(clamp01(channel) * 255.0 + 0.5);
}

std::uint32_t pack(float alpha, const Vec3& color) {
    return to_byte(alpha) << 24 | to_byte(color.r) << 16 | to_byte(color.g) << 8 | to_byte(color.b);
}

raster::Matrix4 to_kernel(const Mat4& matrix) {
    raster::Matrix4 out;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) out[column][row] = matrix[column][row];
    return out;
}

raster::DirectionalLighting::Color to_kernel(ColorSource source, const Vec4& material) {
    using Source = raster::DirectionalLighting::Source;
    switch (source) {
        case ColorSource::Material:
            break;
        case ColorSource::Color1:
            return {Source::Color1, {}};
        case ColorSource::Color2:
            return {Source::Color2, {}};
    }
    return {Source::Constant, {material.r, material.g, material.b, material.a}};
}

bool has_kernel(const CameraLighting& lighting) {
    const auto is_simple = [](const CameraLight& light) { return !light.is_point && !light.has_specular; };
    return lighting.lights.size() <= raster::DirectionalLighting::kMaxLights &&
           std::all_of(lighting.lights.begin(), lighting.lights.end(), is_simple);
}

raster::DirectionalLighting to_kernel(const CameraLighting& lighting) {
    const LightingState& state = lighting.state;
    const Material& material   = state.material;
    raster::DirectionalLighting out;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) out.normal[column][row] = lighting.normal_to_camera[column][row];
    out.normalize = state.normalize_normals;
    out.emissive  = to_kernel(state.emissive_source, Vec4(material.emissive, 1.0f));
    out.ambient   = to_kernel(state.ambient_source, Vec4(material.ambient, 1.0f));
    out.diffuse   = to_kernel(state.diffuse_source, material.diffuse);
    Vec3 ambient  = state.ambient;
    for (const CameraLight& light : lighting.lights) {
        ambient += light.ambient;
        out.lights[out.light_count++] = {{light.to_light.x, light.to_light.y, light.to_light.z},
                                         {light.diffuse.r, light.diffuse.g, light.diffuse.b}};
    }
    out.ambient_light = {ambient.r, ambient.g, ambient.b};
    return out;
}

ClipVertex::TexCoord texture_coords(const TextureStage& stage, const Vertex& vertex, const Vec3& camera_position) {
    switch (stage.coords) {
        case CoordSource::Vertex0:
            return {vertex.uv0.x, vertex.uv0.y, 1.0f};
        case CoordSource::Vertex1:
            return {vertex.uv1.x, vertex.uv1.y, 1.0f};
        case CoordSource::CameraPosition:
            return stage.transform * Vec4(camera_position, 1.0f);
    }
    return {};
}

int size_of(std::span<const std::uint32_t> vertices) {
    return static_cast<int>(vertices.size());
}

void load(const std::vector<Vertex>& source, std::span<const std::uint32_t> vertices, Vec3 Vertex::*vector,
          raster::Points3& out) {
    for (int i = 0; i < size_of(vertices); ++i) {
        const Vec3& v = source[vertices[i]].*vector;
        out.x[i] = v.x, out.y[i] = v.y, out.z[i] = v.z;
    }
}

}  // namespace

VertexShader::VertexShader(const Frame& frame, const Pass& pass, const DrawTriangles& draw, const PixelRect& viewport,
                           float guard_band, ShadingPath path)
    : source_(frame.vertices),
      state_(pass.state),
      window_(viewport, pixel_grid(frame.arithmetic), guard_band),
      lighting_(prepare_lighting(pass.state.lighting, frame.cameras[pass.camera.index].view, draw.world)),
      stage_count_(stage_count(pass.state)),
      kernels_(raster::vertex_kernels()),
      window_transform_(window_.transform()) {
    const Camera& camera              = frame.cameras[pass.camera.index];
    const glm::dmat4 object_to_camera = glm::dmat4(camera.view) * glm::dmat4(draw.world);
    object_to_camera_                 = Mat4(object_to_camera);
    object_to_clip_                   = Mat4(glm::dmat4(camera.projection) * object_to_camera);
    to_camera_                        = to_kernel(object_to_camera_);
    to_clip_                          = to_kernel(object_to_clip_);

    const FogState& fog = state_.fog;
    fog_                = {.end = fog.end, .span = static_cast<double>(fog.end) - fog.start, .by_distance = fog.range};
    one_by_one_         = path == ShadingPath::Scalar || (state_.lighting.enabled && !has_kernel(lighting_));
    if (state_.lighting.enabled && !one_by_one_) directional_ = to_kernel(lighting_);
    const auto from_camera = [](const TextureStage& stage) { return stage.coords == CoordSource::CameraPosition; };
    uses_camera_           = fog.mode != FogMode::None ||
                   std::any_of(state_.stages.begin(), state_.stages.begin() + stage_count_, from_camera);
}

void VertexShader::place_block(std::span<const std::uint32_t> vertices, raster::PlacedVertices& out) const {
    raster::Points3 positions{};
    raster::Points4 clip;
    load(source_, vertices, &Vertex::position, positions);
    kernels_.transform(to_clip_, positions, size_of(vertices), clip);
    kernels_.place(window_transform_, clip, size_of(vertices), out);
}

void VertexShader::shade_block(std::span<const std::uint32_t> vertices, raster::Vertex* out) const {
    if (one_by_one_) return shade_one_by_one(vertices, out);
    const int count = size_of(vertices);
    raster::Points3 positions{};
    raster::Points4 clip, window, camera{};
    load(source_, vertices, &Vertex::position, positions);
    kernels_.transform(to_clip_, positions, count, clip);
    kernels_.to_window(window_transform_, clip, count, window);
    if (uses_camera_) kernels_.transform(to_camera_, positions, count, camera);

    raster::VertexLanes<std::uint32_t> fog;
    raster::VertexColors colors{};
    fog_block(camera, count, fog);
    light_block(vertices, colors);
    for (int i = 0; i < count; ++i)
        out[i] = {.diffuse  = colors.first[i],
                  .specular = (colors.second[i] & 0x00ffffff) | fog[i] << 24,
                  .x        = window.x[i],
                  .y        = window.y[i],
                  .z        = window.z[i],
                  .rhw      = window.w[i],
                  .uv       = {}};
    coords_block(vertices, camera, out);
}

void VertexShader::shade_one_by_one(std::span<const std::uint32_t> vertices, raster::Vertex* out) const {
    for (int i = 0; i < size_of(vertices); ++i) {
        const ClipVertex shaded = shade(source_[vertices[i]]);
        window_.place(shaded.position, out[i]);
        set_attributes(shaded, out[i]);
    }
}

// As bytes.
void VertexShader::fog_block(const raster::Points4& camera, int count, raster::VertexLanes<std::uint32_t>& out) const {
    switch (state_.fog.mode) {
        case FogMode::None:
            std::fill_n(out.lanes, count, 255u);
            break;
        case FogMode::Linear:
            kernels_.fog(fog_, camera, count, out);
            break;
        case FogMode::Exp:
        case FogMode::Exp2:
            for (int i = 0; i < count; ++i)
                out[i] = to_byte(fog_factor(state_.fog, Vec3(camera.x[i], camera.y[i], camera.z[i])));
            break;
    }
}

// Without lighting the colours are the bytes they were: c / 255 * 255 + 0.5 has the whole part c.
void VertexShader::light_block(std::span<const std::uint32_t> vertices, raster::VertexColors& colors) const {
    for (int i = 0; i < size_of(vertices); ++i) {
        const Vertex& vertex = source_[vertices[i]];
        colors.first[i]      = vertex.diffuse.value;
        colors.second[i]     = vertex.specular.value;
    }
    if (!state_.lighting.enabled) return;
    raster::Points3 normals{};
    raster::VertexLanes<std::uint32_t> lit;
    load(source_, vertices, &Vertex::normal, normals);
    kernels_.light(directional_, normals, colors, size_of(vertices), lit);
    colors.first = lit;
    std::fill_n(colors.second.lanes, size_of(vertices), 0u);
}

void VertexShader::coords_block(std::span<const std::uint32_t> vertices, const raster::Points4& camera,
                                raster::Vertex* out) const {
    for (int stage = 0; stage < stage_count_; ++stage) {
        const TextureStage& state = state_.stages[stage];
        for (int i = 0; i < size_of(vertices); ++i) {
            const Vec3 uv    = state.coords == CoordSource::CameraPosition
                                   ? texture_coords(state, {}, Vec3(camera.x[i], camera.y[i], camera.z[i]))
                                   : texture_coords(state, source_[vertices[i]], {});
            out[i].uv[stage] = {uv.x, uv.y, uv.z};
        }
    }
}

ClipVertex VertexShader::shade(const Vertex& vertex) const {
    const Vec4 position(vertex.position, 1.0f);
    const Vec3 camera_position(object_to_camera_ * position);
    const VertexColors colors = light_vertex(lighting_, vertex, camera_position);
    ClipVertex result{.position = object_to_clip_ * position,
                      .diffuse  = colors.diffuse,
                      .specular = colors.specular,
                      .fog      = fog_factor(state_.fog, camera_position)};
    for (int stage = 0; stage < stage_count_; ++stage)
        result.uv[stage] = texture_coords(state_.stages[stage], vertex, camera_position);
    return result;
}

void set_attributes(const ClipVertex& from, raster::Vertex& to) {
    to.diffuse  = pack(from.diffuse.a, Vec3(from.diffuse));
    to.specular = pack(from.fog, from.specular);
    for (std::size_t stage = 0; stage < to.uv.size(); ++stage)
        to.uv[stage] = {from.uv[stage].x, from.uv[stage].y, from.uv[stage].z};
}

}  // namespace pipeline
