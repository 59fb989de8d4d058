// SPDX-License-Identifier: MIT
#include "pipeline/truth/vertices.h"

#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>

namespace pipeline::truth {
namespace {

glm::dvec3 texture_coords(const TextureStage& stage, const Vertex& vertex, const glm::dvec3& camera) {
    switch (stage.coords) {
        case CoordSource::Vertex0:
            return {vertex.uv0.x, vertex.uv0.y, 1.0};
        case CoordSource::Vertex1:
            return {vertex.uv1.x, vertex.uv1.y, 1.0};
        case CoordSource::CameraPosition:
            return glm::dvec3(glm::dmat4(stage.transform) * glm::dvec4(camera, 1.0));
    }
    return {};
}

WindowCorner to_window(const ClipVertex& vertex, const PixelRect& viewport) {
    const glm::dvec4& p = vertex.position;
    return {.x        = viewport.x0 + (1.0 + p.x / p.w) * (viewport.x1 - viewport.x0) / 2.0,
            .y        = viewport.y0 + (1.0 - p.y / p.w) * (viewport.y1 - viewport.y0) / 2.0,
            .z        = clamp01(p.z / p.w),
            .rhw      = 1.0 / p.w,
            .diffuse  = clamp01(vertex.diffuse),
            .specular = clamp01(vertex.specular),
            .uv       = vertex.uv};
}

// Twice the area in pixels, positive if the corners go clockwise on the screen.
double area(const WindowTriangle& t) {
    return (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (t[1].y - t[0].y);
}

bool is_culled(CullMode mode, const WindowTriangle& triangle) {
    const double turned = area(triangle);
    return turned == 0.0 || (mode == CullMode::Clockwise && turned > 0.0) ||
           (mode == CullMode::CounterClockwise && turned < 0.0);
}

// As raster/primitives.h has it of texture coordinates.
bool is_in_range(const WindowTriangle& triangle) {
    for (const WindowCorner& corner : triangle)
        for (const glm::dvec3& uv : corner.uv)
            for (int i = 0; i < 3; ++i)
                if (!(std::abs(uv[i] * corner.rhw) < 0x1p40)) return false;
    return true;
}

void append(WindowTriangle triangle, const PipelineState& state, std::vector<WindowTriangle>& out) {
    if (is_culled(state.cull, triangle) || !is_in_range(triangle)) return;
    out.push_back(triangle);
}

void give_colors_of(const WindowCorner& first, WindowTriangle& triangle) {
    for (WindowCorner& corner : triangle) {
        corner.diffuse  = first.diffuse;
        corner.specular = first.specular;
    }
}

bool is_finite(const glm::dvec4& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
}

}  // namespace

VertexSetup::VertexSetup(const Frame& frame, const Pass& pass, const DrawTriangles& draw)
    : state(pass.state), view(frame.cameras[static_cast<std::size_t>(pass.camera.index)].view) {
    to_camera = view * glm::dmat4(draw.world);
    to_clip   = glm::dmat4(frame.cameras[static_cast<std::size_t>(pass.camera.index)].projection) * to_camera;
    const glm::dmat3 linear  = glm::dmat3(to_camera);
    const glm::dmat3 inverse = glm::inverseTranspose(linear);
    const double determinant = glm::determinant(linear);
    normal_to_camera         = determinant != 0.0 && std::isfinite(1.0 / determinant) ? inverse : linear;
}

ClipVertex shade(const VertexSetup& setup, const Vertex& vertex) {
    const glm::dvec4 position(vertex.position, 1.0);
    const glm::dvec3 camera(setup.to_camera * position);
    ClipVertex out;
    out.position = setup.to_clip * position;
    light(setup, vertex, camera, out);
    out.specular.a = fog_factor(setup.state.fog, camera);
    for (int stage = 0; stage < stage_count(setup.state); ++stage)
        out.uv[stage] = texture_coords(setup.state.stages[stage], vertex, camera);
    return out;
}

std::vector<WindowTriangle> window_triangles(const Frame& frame, const Pass& pass, const DrawTriangles& draw,
                                             const PixelRect& viewport) {
    const VertexSetup setup(frame, pass, draw);
    std::vector<WindowTriangle> out;
    for (std::uint32_t i = draw.first_index; i + 2 < draw.first_index + draw.index_count; i += 3) {
        const auto corner = [&](std::uint32_t k) { return shade(setup, frame.vertices[frame.indices[i + k]]); };
        const std::array<ClipVertex, 3> triangle{corner(0), corner(1), corner(2)};
        if (!is_finite(triangle[0].position) || !is_finite(triangle[1].position) || !is_finite(triangle[2].position))
            continue;
        const std::vector<ClipVertex> polygon = clip(triangle, viewport);
        for (std::size_t k = 2; k < polygon.size(); ++k) {
            WindowTriangle piece{to_window(polygon[0], viewport), to_window(polygon[k - 1], viewport),
                                 to_window(polygon[k], viewport)};
            if (pass.state.shade == ShadeMode::Flat) {
                WindowCorner first;
                first.diffuse  = clamp01(triangle[0].diffuse);
                first.specular = clamp01(triangle[0].specular);
                give_colors_of(first, piece);
            }
            append(piece, pass.state, out);
        }
    }
    return out;
}

std::vector<WindowTriangle> window_triangles(const Frame& frame, const Pass& pass, const DrawWindowTriangles& draw) {
    std::vector<WindowTriangle> out;
    for (std::uint32_t i = draw.first_index; i + 2 < draw.first_index + draw.index_count; i += 3) {
        const auto corner = [&](std::uint32_t k) {
            const WindowVertex& v = frame.window_vertices[frame.indices[i + k]];
            return WindowCorner{v.x, v.y, v.z, v.rhw, to_color(v.diffuse), to_color(v.specular), {v.uv0, v.uv1}};
        };
        WindowTriangle triangle{corner(0), corner(1), corner(2)};
        if (pass.state.shade == ShadeMode::Flat) give_colors_of(WindowCorner(triangle[0]), triangle);
        append(triangle, pass.state, out);
    }
    return out;
}

}  // namespace pipeline::truth
