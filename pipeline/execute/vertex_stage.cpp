// SPDX-License-Identifier: MIT
#include "pipeline/execute/vertex_stage.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>
#include <optional>

#include "pipeline/execute/vertex_list.h"

namespace pipeline {
namespace {

// What raster/primitives.h asks of texture coordinates. Not-a-number is out of range as well.
bool has_coords_in_range(const raster::Vertex& vertex) {
    const auto in_range = [&](float value) { return std::abs(value * vertex.rhw) < 0x1p40f; };
    return std::all_of(vertex.uv.begin(), vertex.uv.end(),
                       [&](const raster::TexCoord& uv) { return in_range(uv.s) && in_range(uv.t) && in_range(uv.q); });
}

// A vertex after placing. Marks are set by several threads.
struct Place {
    std::int32_t x = 0, y = 0;        // snapped
    std::uint16_t flags         = 0;  // raster::PlaceFlags
    std::uint8_t is_referred_to = 0, is_needed = 0;
    std::uint8_t is_out_of_range = 0;
};
void mark(std::uint8_t& what) {
    std::atomic_ref(what).store(1, std::memory_order_relaxed);
}

// Corners of a triangle are places in the draw's vertices, or, from kExtra on, in its chunk's extra ones.
constexpr std::uint32_t kExtra = 0x80000000;

// A draw on its way through the stage.
struct Work {
    VertexStageDraw* draw = nullptr;
    std::optional<VertexShader> shader;
    VertexList list;
    std::vector<Place> places;
    std::atomic<bool> has_out_of_range              = false;
    std::atomic<std::uint64_t> vertices_referred_to = 0;
};

// A part of a draw's vertices or triangles, which one task takes through a step.
struct VertexChunk {
    Work* work;
    std::uint32_t first, end;  // places
};
struct TriangleChunk {
    Work* work        = nullptr;
    std::size_t first = 0, end = 0;               // corners
    std::vector<raster::TriangleCorners> kept;    // what is left of them
    std::vector<raster::Vertex> extra;            // made by clipping
    std::size_t first_kept = 0, first_extra = 0;  // where they go in raster::Draw
};
constexpr std::uint32_t kChunkVertices = 1024;
constexpr std::size_t kChunkCorners    = 3 * 1024;

// Vertices on their way through a kernel.
class VertexBlock {
  public:
    explicit VertexBlock(const Work& work) : work_(work) {}
    std::span<const std::uint32_t> vertices() const { return {vertices_, count_}; }
    std::uint32_t place(std::size_t i) const { return places_[i]; }
    bool is_full() const { return count_ == raster::kVertexBlock; }
    void clear() { count_ = 0; }
    void add(std::uint32_t place) {
        places_[count_]     = place;
        vertices_[count_++] = work_.list.vertex(place);
    }

  private:
    const Work& work_;
    std::uint32_t places_[raster::kVertexBlock], vertices_[raster::kVertexBlock];
    std::size_t count_ = 0;
};

void place_vertices(const VertexChunk& chunk) {
    Work& work = *chunk.work;
    VertexBlock block(work);
    raster::PlacedVertices placed;
    for (std::uint32_t place = chunk.first; place < chunk.end; ++place) {
        block.add(place);
        if (!block.is_full() && place + 1 < chunk.end) continue;
        work.shader->place_block(block.vertices(), placed);
        for (std::size_t i = 0; i < block.vertices().size(); ++i) {
            const int lane              = static_cast<int>(i);
            work.places[block.place(i)] = {
                .x = placed.x[lane], .y = placed.y[lane], .flags = static_cast<std::uint16_t>(placed.flags[lane])};
        }
        block.clear();
    }
}

ClipVertex with_colors_of(const ClipVertex& first, ClipVertex vertex) {
    vertex.diffuse  = first.diffuse;
    vertex.specular = first.specular;
    vertex.fog      = first.fog;
    return vertex;
}

// Adds what clipping leaves, as a fan around the polygon's first corner.
void clip(const Frame& frame, const std::array<std::uint32_t, 3>& corners, TriangleChunk& chunk) {
    const Work& work           = *chunk.work;
    const PipelineState& state = work.draw->pass->state;
    const Window& window       = work.shader->window();
    std::array<ClipVertex, 3> triangle;
    for (int i = 0; i < 3; ++i) triangle[i] = work.shader->shade(frame.vertices[work.list.vertex(corners[i])]);
    const ClippedPolygon polygon = clip_triangle(window.guard_band(), triangle);
    std::array<raster::Vertex, ClippedPolygon::kMaxCorners> corner;
    std::array<raster::Subpixel, ClippedPolygon::kMaxCorners> snapped;
    for (int i = 0; i < polygon.count; ++i) {
        window.place(polygon.corners[i].position, corner[i]);
        snapped[i]         = window.snap(corner[i]);
        const bool is_flat = state.shade == ShadeMode::Flat;
        set_attributes(is_flat ? with_colors_of(triangle[0], polygon.corners[i]) : polygon.corners[i], corner[i]);
    }
    if (!std::all_of(corner.begin(), corner.begin() + polygon.count, has_coords_in_range)) return;

    const std::uint32_t first = kExtra + static_cast<std::uint32_t>(chunk.extra.size());
    chunk.extra.insert(chunk.extra.end(), corner.begin(), corner.begin() + polygon.count);
    for (int i = 2; i < polygon.count; ++i) {
        if (is_culled(state.cull, area_of(snapped[0], snapped[i - 1], snapped[i]))) continue;
        const auto last = first + static_cast<std::uint32_t>(i);
        chunk.kept.push_back({first, last - 1, last});
    }
}

void cull_triangles(const Frame& frame, TriangleChunk& chunk) {
    Work& work          = *chunk.work;
    const CullMode cull = work.draw->pass->state.cull;
    chunk.kept.clear();
    chunk.extra.clear();
    for (std::size_t i = chunk.first; i < chunk.end; i += 3) {
        const std::array corners{work.list.corner(i), work.list.corner(i + 1), work.list.corner(i + 2)};
        Place &a = work.places[corners[0]], &b = work.places[corners[1]], &c = work.places[corners[2]];
        mark(a.is_referred_to), mark(b.is_referred_to), mark(c.is_referred_to);
        const unsigned any = a.flags | b.flags | c.flags;
        if ((any & raster::kNotFinite) || (a.flags & b.flags & c.flags & raster::kOutsideViewport)) continue;
        if (any & raster::kOutsideBand) {
            clip(frame, corners, chunk);
            continue;
        }
        if (is_culled(cull, area_of({a.x, a.y}, {b.x, b.y}, {c.x, c.y}))) continue;
        mark(a.is_needed), mark(b.is_needed), mark(c.is_needed);
        chunk.kept.push_back(corners);
    }
}

void shade_vertices(const VertexChunk& chunk) {
    Work& work = *chunk.work;
    VertexBlock block(work);
    std::array<raster::Vertex, raster::kVertexBlock> shaded;
    std::uint64_t referred_to = 0;
    const auto shade          = [&] {
        work.shader->shade_block(block.vertices(), shaded.data());
        for (std::size_t i = 0; i < block.vertices().size(); ++i) {
            work.draw->out->vertices[block.place(i)] = shaded[i];
            if (has_coords_in_range(shaded[i])) continue;
            work.places[block.place(i)].is_out_of_range = 1;
            work.has_out_of_range                       = true;
        }
        block.clear();
    };
    for (std::uint32_t place = chunk.first; place < chunk.end; ++place) {
        referred_to += work.places[place].is_referred_to;
        if (work.places[place].is_needed) block.add(place);
        if (block.is_full()) shade();
    }
    shade();
    work.vertices_referred_to += referred_to;
}

void copy_triangles(const TriangleChunk& chunk) {
    raster::Draw& out           = *chunk.work->draw->out;
    const std::uint32_t shifted = static_cast<std::uint32_t>(chunk.first_extra) - kExtra;
    std::copy(chunk.extra.begin(), chunk.extra.end(),
              out.vertices.begin() + static_cast<std::ptrdiff_t>(chunk.first_extra));
    std::transform(chunk.kept.begin(), chunk.kept.end(),
                   out.triangles.begin() + static_cast<std::ptrdiff_t>(chunk.first_kept),
                   [&](raster::TriangleCorners corners) {
                       for (std::uint32_t& corner : corners)
                           if (corner >= kExtra) corner += shifted;
                       return corners;
                   });
}

void drop_out_of_range(Work& work) {
    const auto is_out = [&](const raster::TriangleCorners& corners) {
        return std::any_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
            return corner < work.places.size() && work.places[corner].is_out_of_range;
        });
    };
    std::erase_if(work.draw->out->triangles, is_out);
}

}  // namespace

struct VertexStage::Memory {
    std::deque<Work> works;  // both grow only, so that what their elements hold is kept
    std::vector<TriangleChunk> triangle_chunks;
    std::vector<VertexChunk> vertex_chunks;

    void prepare(const Frame& frame, std::span<VertexStageDraw> draws, ShadingPath path);
    std::span<TriangleChunk> list_chunks(std::size_t work_count);
    void make_room(std::span<TriangleChunk> chunks, std::size_t work_count);
};

void VertexStage::Memory::prepare(const Frame& frame, std::span<VertexStageDraw> draws, ShadingPath path) {
    while (works.size() < draws.size()) works.emplace_back();
    tbb::parallel_for(std::size_t{0}, draws.size(), [&](std::size_t i) {
        Work& work                = works[i];
        VertexStageDraw& draw     = draws[i];
        work.draw                 = &draw;
        work.has_out_of_range     = false;
        work.vertices_referred_to = 0;
        work.shader.emplace(frame, *draw.pass, *draw.draw, draw.viewport, draw.guard_band, path);
        work.list.set(std::span(frame.indices).subspan(draw.draw->first_index, draw.draw->index_count));
        work.places.resize(work.list.size());
        draw.out->flat = draw.pass->state.shade == ShadeMode::Flat;
    });
}

std::span<TriangleChunk> VertexStage::Memory::list_chunks(std::size_t work_count) {
    vertex_chunks.clear();
    std::size_t count = 0;
    for (std::size_t i = 0; i < work_count; ++i) {
        Work& work = works[i];
        for (std::uint32_t first = 0; first < work.list.size(); first += kChunkVertices)
            vertex_chunks.push_back({&work, first, std::min(first + kChunkVertices, work.list.size())});
        const std::size_t corners = work.list.corner_count() / 3 * 3;
        for (std::size_t first = 0; first < corners; first += kChunkCorners) {
            if (count == triangle_chunks.size()) triangle_chunks.emplace_back();
            TriangleChunk& chunk = triangle_chunks[count++];
            chunk.work           = &work;
            chunk.first          = first;
            chunk.end            = std::min(first + kChunkCorners, corners);
        }
    }
    return std::span(triangle_chunks).first(count);
}

// In each draw for what its chunks have kept, one after the other; extra vertices come after the others.
void VertexStage::Memory::make_room(std::span<TriangleChunk> chunks, std::size_t work_count) {
    std::size_t chunk = 0;
    for (std::size_t i = 0; i < work_count; ++i) {
        Work& work        = works[i];
        std::size_t kept  = 0;
        std::size_t extra = work.places.size();
        for (; chunk < chunks.size() && chunks[chunk].work == &work; ++chunk) {
            chunks[chunk].first_kept  = kept;
            chunks[chunk].first_extra = extra;
            kept += chunks[chunk].kept.size();
            extra += chunks[chunk].extra.size();
        }
        work.draw->out->triangles.resize(kept);
        work.draw->out->vertices.resize(extra);
    }
}

VertexStage::VertexStage() : memory_(std::make_unique<Memory>()) {}
VertexStage::~VertexStage() = default;

void VertexStage::run(const Frame& frame, std::span<VertexStageDraw> draws, ShadingPath path) {
    Memory& memory = *memory_;
    memory.prepare(frame, draws, path);
    const std::span<TriangleChunk> triangles    = memory.list_chunks(draws.size());
    const std::span<const VertexChunk> vertices = memory.vertex_chunks;
    tbb::parallel_for(std::size_t{0}, vertices.size(), [&](std::size_t i) { place_vertices(vertices[i]); });
    tbb::parallel_for(std::size_t{0}, triangles.size(), [&](std::size_t i) { cull_triangles(frame, triangles[i]); });
    memory.make_room(triangles, draws.size());
    tbb::parallel_for(std::size_t{0}, vertices.size() + triangles.size(), [&](std::size_t i) {
        if (i < vertices.size())
            shade_vertices(vertices[i]);
        else
            copy_triangles(triangles[i - vertices.size()]);
    });
    for (std::size_t i = 0; i < draws.size(); ++i) {
        Work& work = memory.works[i];
        if (work.has_out_of_range) drop_out_of_range(work);
        draws[i].counts = {.vertices        = work.vertices_referred_to,
                           .triangles_in    = work.list.corner_count() / 3,
                           .triangles_drawn = draws[i].out->triangles.size()};
    }
}

VertexStageCounts run_vertex_stage(const Frame& frame, const Pass& pass, const DrawTriangles& draw,
                                   const PixelRect& viewport, raster::Draw& out, ShadingPath path) {
    VertexStageDraw stage_draw{.pass = &pass, .draw = &draw, .viewport = viewport, .out = &out, .counts = {}};
    VertexStage().run(frame, {&stage_draw, 1}, path);
    return stage_draw.counts;
}

}  // namespace pipeline
