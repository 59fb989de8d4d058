// SPDX-License-Identifier: MIT
#include "pipeline/execute/vertex_stage.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "pipeline/execute/clip.h"
#include "pipeline/execute/fog.h"
#include "pipeline/execute/lighting.h"
#include "pipeline/execute/lower.h"
#include "pipeline/execute/vector_math.h"
#include "pipeline/execute/vertex_list.h"

namespace pipeline {
namespace {

// round(c * 255), half up; exact in double.
std::uint32_t to_byte(float channel) {
    return static_cast<std::uint32_t>(clamp01(channel) * 255.0 + 0.5);
}

std::uint32_t pack(float alpha, const Vec3& color) {
    return to_byte(alpha) << 24 | to_byte(color.r) << 16 | to_byte(color.g) << 8 | to_byte(color.b);
}

bool is_finite(const Vec4& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

// What raster/primitives.h asks of texture coordinates. Not-a-number is out of range as well.
bool has_coords_in_range(const raster::Vertex& vertex) {
    const auto in_range = [&](float value) { return std::abs(value * vertex.rhw) < 0x1p40f; };
    return std::all_of(vertex.uv.begin(), vertex.uv.end(),
                       [&](const raster::TexCoord& uv) { return in_range(uv.s) && in_range(uv.t) && in_range(uv.q); });
}

// The viewport transform, snapping, and the guard band as bounds of its result.
class Window {
  public:
    Window(const PixelRect& viewport, const raster::PixelGrid& grid)
        : grid_(grid),
          x_(static_cast<float>(viewport.x0)),
          y_(static_cast<float>(viewport.y0)),
          width_(static_cast<float>(viewport.x1 - viewport.x0)),
          height_(static_cast<float>(viewport.y1 - viewport.y0)) {}

    ClipVolume guard_band() const {
        return {.gx = 1.0 + 2.0 * kGuardBand / width_, .gy = 1.0 + 2.0 * kGuardBand / height_};
    }

    void place(const Vec4& clip, raster::Vertex& vertex) const {
        const float x = x_ + (1.0f + clip.x / clip.w) * width_ / 2.0f;
        const float y = y_ + (1.0f - clip.y / clip.w) * height_ / 2.0f;
        vertex.x      = std::clamp(x, x_ - kGuardBand, x_ + width_ + kGuardBand);
        vertex.y      = std::clamp(y, y_ - kGuardBand, y_ + height_ + kGuardBand);
        vertex.z      = std::clamp(clip.z / clip.w, 0.0f, 1.0f);
        vertex.rhw    = 1.0f / clip.w;
    }

    raster::Subpixel snap(const raster::Vertex& vertex) const {
        return raster::snap_to_subpixels(grid_, vertex.x, vertex.y);
    }

  private:
    raster::PixelGrid grid_;
    float x_, y_, width_, height_;
};

bool is_culled(CullMode mode, const raster::Subpixel& a, const raster::Subpixel& b, const raster::Subpixel& c) {
    const std::int64_t area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    switch (mode) {
        case CullMode::None:
            return area == 0;
        case CullMode::Clockwise:
            return area >= 0;
        case CullMode::CounterClockwise:
            return area <= 0;
    }
    return false;
}

// What the stage makes of a vertex by itself: everything but clipping.
class VertexShader {
  public:
    VertexShader(const Pass& pass, const Camera& camera, const Mat4& world)
        : state_(pass.state),
          lighting_(prepare_lighting(pass.state.lighting, camera.view, world)),
          stage_count_(stage_count(pass.state)) {
        const glm::dmat4 object_to_camera = glm::dmat4(camera.view) * glm::dmat4(world);
        object_to_camera_                 = Mat4(object_to_camera);
        object_to_clip_                   = Mat4(glm::dmat4(camera.projection) * object_to_camera);
    }

    Vec4 clip_position(const Vertex& vertex) const { return object_to_clip_ * Vec4(vertex.position, 1.0f); }

    ClipVertex shade(const Vertex& vertex, const Vec4& clip_position) const {
        const Vec3 camera_position(object_to_camera_ * Vec4(vertex.position, 1.0f));
        const VertexColors colors = light_vertex(lighting_, vertex, camera_position);
        ClipVertex result{.position = clip_position,
                          .diffuse  = colors.diffuse,
                          .specular = colors.specular,
                          .fog      = fog_factor(state_.fog, camera_position)};
        for (int stage = 0; stage < stage_count_; ++stage)
            result.uv[stage] = texture_coords(state_.stages[stage], vertex, camera_position);
        return result;
    }

  private:
    static ClipVertex::TexCoord texture_coords(const TextureStage& stage, const Vertex& vertex,
                                               const Vec3& camera_position) {
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

    const PipelineState& state_;
    CameraLighting lighting_;
    Mat4 object_to_camera_{1.0f}, object_to_clip_{1.0f};
    int stage_count_;
};

void set_attributes(const ClipVertex& from, raster::Vertex& to) {
    to.diffuse  = pack(from.diffuse.a, Vec3(from.diffuse));
    to.specular = pack(from.fog, from.specular);
    for (std::size_t stage = 0; stage < to.uv.size(); ++stage)
        to.uv[stage] = {from.uv[stage].x, from.uv[stage].y, from.uv[stage].z};
}

// A vertex so far. Shading is the costly part, and put off until a triangle needs it.
struct PlacedVertex {
    Vec4 clip             = Vec4(0.0f);
    bool is_finite        = false;
    bool is_shaded        = false;
    Outcode outside_guard = 0, outside_view = 0;
    raster::Subpixel snapped;  // this and `window` only within the guard band
    raster::Vertex window;     // colours and uv only once shaded
};

class TriangleStage {
  public:
    TriangleStage(const Frame& frame, const Pass& pass, const DrawTriangles& draw, const PixelRect& viewport,
                  std::span<const std::uint32_t> indices, std::vector<raster::Triangle>& out)
        : source_(frame.vertices),
          cull_(pass.state.cull),
          is_flat_(pass.state.shade == ShadeMode::Flat),
          shader_(pass, frame.cameras[pass.camera.index], draw.world),
          window_(viewport, pixel_grid(frame.arithmetic)),
          guard_band_(window_.guard_band()),
          list_(list_vertices(indices)),
          out_(out) {}

    VertexStageCounts run() {
        const std::size_t drawn_before = out_.size();
        place_vertices();
        for (std::size_t i = 0; i + 2 < list_.corners.size(); i += 3)
            add_triangle({list_.corners[i], list_.corners[i + 1], list_.corners[i + 2]});
        return {.triangles_in = list_.corners.size() / 3, .triangles_drawn = out_.size() - drawn_before};
    }

  private:
    using Corners = std::array<std::uint32_t, 3>;  // into placed_

    void place_vertices() {
        constexpr ClipVolume kViewport{};
        placed_.resize(list_.vertices.size());
        for (std::size_t i = 0; i < placed_.size(); ++i) {
            PlacedVertex& vertex = placed_[i];
            vertex.clip          = shader_.clip_position(source_[list_.vertices[i]]);
            vertex.is_finite     = is_finite(vertex.clip);
            if (!vertex.is_finite) continue;
            vertex.outside_view  = outcode(kViewport, vertex.clip);
            vertex.outside_guard = outcode(guard_band_, vertex.clip);
            if (vertex.outside_guard) continue;
            window_.place(vertex.clip, vertex.window);
            vertex.snapped = window_.snap(vertex.window);
        }
    }

    void add_triangle(const Corners& corners) {
        const PlacedVertex &a = placed_[corners[0]], &b = placed_[corners[1]], &c = placed_[corners[2]];
        if (!(a.is_finite && b.is_finite && c.is_finite)) return;
        if (a.outside_view & b.outside_view & c.outside_view) return;
        if (a.outside_guard | b.outside_guard | c.outside_guard)
            add_clipped(corners);
        else
            add_whole(corners);
    }

    ClipVertex shaded(std::uint32_t corner) const {
        return shader_.shade(source_[list_.vertices[corner]], placed_[corner].clip);
    }

    const raster::Vertex& shaded_window(std::uint32_t corner) {
        PlacedVertex& vertex = placed_[corner];
        if (!vertex.is_shaded) set_attributes(shaded(corner), vertex.window);
        vertex.is_shaded = true;
        return vertex.window;
    }

    void add_whole(const Corners& corners) {
        const PlacedVertex &a = placed_[corners[0]], &b = placed_[corners[1]], &c = placed_[corners[2]];
        if (is_culled(cull_, a.snapped, b.snapped, c.snapped)) return;
        raster::Triangle triangle{shaded_window(corners[0]), shaded_window(corners[1]), shaded_window(corners[2])};
        if (!std::all_of(triangle.begin(), triangle.end(), has_coords_in_range)) return;
        if (is_flat_)
            for (raster::Vertex& vertex : triangle) {
                vertex.diffuse  = triangle[0].diffuse;
                vertex.specular = triangle[0].specular;
            }
        out_.push_back(triangle);
    }

    // As a fan around the polygon's first corner.
    void add_clipped(const Corners& corners) {
        const std::array<ClipVertex, 3> triangle{shaded(corners[0]), shaded(corners[1]), shaded(corners[2])};
        const ClippedPolygon polygon = clip_triangle(guard_band_, triangle);
        std::array<raster::Vertex, ClippedPolygon::kMaxCorners> corner;
        for (int i = 0; i < polygon.count; ++i) {
            window_.place(polygon.corners[i].position, corner[i]);
            set_attributes(is_flat_ ? with_colors_of(triangle[0], polygon.corners[i]) : polygon.corners[i], corner[i]);
        }
        if (!std::all_of(corner.begin(), corner.begin() + polygon.count, has_coords_in_range)) return;

        for (int i = 2; i < polygon.count; ++i)
            if (!is_culled(cull_, window_.snap(corner[0]), window_.snap(corner[i - 1]), window_.snap(corner[i])))
                out_.push_back({corner[0], corner[i - 1], corner[i]});
    }

    static ClipVertex with_colors_of(const ClipVertex& first, ClipVertex vertex) {
        vertex.diffuse  = first.diffuse;
        vertex.specular = first.specular;
        vertex.fog      = first.fog;
        return vertex;
    }

    const std::vector<Vertex>& source_;
    CullMode cull_;
    bool is_flat_;
    VertexShader shader_;
    Window window_;
    ClipVolume guard_band_;
    VertexList list_;
    std::vector<PlacedVertex> placed_;
    std::vector<raster::Triangle>& out_;
};

}  // namespace

VertexStageCounts run_vertex_stage(const Frame& frame, const Pass& pass, const DrawTriangles& draw, std::uint32_t first,
                                   std::uint32_t count, const PixelRect& viewport, std::vector<raster::Triangle>& out) {
    const std::span<const std::uint32_t> indices = std::span(frame.indices).subspan(first, count);
    return TriangleStage(frame, pass, draw, viewport, indices, out).run();
}

}  // namespace pipeline
