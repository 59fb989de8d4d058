// SPDX-License-Identifier: MIT
#include "raster/fill_pass.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "raster/bin.h"
#include "raster/fill_plan.h"
#include "raster/fill_tile.h"

namespace raster {
namespace {

// Some of a draw's primitives, set up and binned by one task.
struct Part {
    const FillPlan* plan;
    std::span<const Triangle> triangles;
    std::span<const Rectangle> rectangles;
    std::size_t entries_at_most;
    std::vector<SetUpTriangle> set_up_triangles;
    std::vector<SetUpRectangle> set_up_rectangles;
    std::vector<Command> commands;
};

// Large primitives fall into many tiles each. These bound what is set up at a time: of a part by a task, of a pass before
// its tiles are filled.
constexpr std::size_t kPartPrimitives = 512;
constexpr std::size_t kPartEntries    = 1 << 16;
constexpr std::size_t kWaveEntries    = 1 << 22;

// Pixels that a primitive may cover, wherever in a pixel it is sampled.
Rect box(const Rectangle& r) {
    return {static_cast<int>(std::floor(r.x0)), static_cast<int>(std::floor(r.y0)),
            static_cast<int>(std::floor(r.x1)) + 2, static_cast<int>(std::floor(r.y1)) + 2};
}
Rect box(const Triangle& t) {
    const auto [x0, x1] = std::minmax({t[0].x, t[1].x, t[2].x});
    const auto [y0, y1] = std::minmax({t[0].y, t[1].y, t[2].y});
    return box(Rectangle{.x0 = x0, .y0 = y0, .x1 = x1, .y1 = y1, .uv = {}});
}

template <class Primitive>
void split(const std::vector<Primitive>& primitives, const FillPlan& plan, std::span<const Primitive> Part::*member,
           const Rect& scissor, const TileGrid& grid, std::vector<Part>& parts) {
    std::size_t first = 0, entries = 0;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        const Rect pixels = intersect(box(primitives[i]), scissor);
        if (!pixels.empty()) {
            const Rect tiles = grid.tiles_touched(pixels);
            entries += static_cast<std::size_t>(tiles.x1 - tiles.x0) * static_cast<std::size_t>(tiles.y1 - tiles.y0);
        }
        const std::size_t count = i + 1 - first;
        if (count < kPartPrimitives && entries < kPartEntries && i + 1 < primitives.size()) continue;
        Part& part           = parts.emplace_back();
        part.plan            = &plan;
        part.*member         = std::span(primitives).subspan(first, count);
        part.entries_at_most = entries;
        first                = i + 1;
        entries              = 0;
    }
}

void set_up_and_bin(Part& part, const PassFill& pass, const TileGrid& tiles, std::vector<TileEntry>& entries) {
    // Commands point into these, so they must not move: room for all first.
    part.set_up_triangles.reserve(part.triangles.size());
    part.set_up_rectangles.reserve(part.rectangles.size());
    part.commands.reserve(part.triangles.size() + part.rectangles.size());
    const FillPlan& plan = *part.plan;
    for (const Triangle& triangle : part.triangles) {
        SetUpTriangle& out = part.set_up_triangles.emplace_back();
        if (set_up_triangle(triangle, plan.needs, pass.grid, pass.scissor, out))
            part.commands.push_back({.plan = &plan, .triangle = &out, .rectangle = nullptr});
        else
            part.set_up_triangles.pop_back();
    }
    for (const Rectangle& rectangle : part.rectangles) {
        SetUpRectangle& out = part.set_up_rectangles.emplace_back();
        if (set_up_rectangle(rectangle, plan.needs, pass.grid, pass.scissor, out))
            part.commands.push_back({.plan = &plan, .triangle = nullptr, .rectangle = &out});
        else
            part.set_up_rectangles.pop_back();
    }
    for (const Command& command : part.commands) bin_command(command, tiles, entries);
}

// 0, 1, 2, .. or a fixed shuffle of it.
std::vector<int> tile_order(int count, std::uint32_t seed) {
    std::vector<int> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    if (seed == 0) return order;
    for (std::size_t i = order.size(); i > 1; --i) {
        seed = seed * 1664525u + 1013904223u;
        std::swap(order[i - 1], order[(seed >> 8) % i]);
    }
    return order;
}

// Sets up, bins and fills a run of parts.
FillCounts fill_wave(std::span<Part> parts, const PassFill& pass, const TileGrid& grid, const std::vector<int>& order) {
    std::vector<std::vector<TileEntry>> entries(parts.size());
    tbb::parallel_for(std::size_t{0}, parts.size(),
                      [&](std::size_t i) { set_up_and_bin(parts[i], pass, grid, entries[i]); });
    const Bins bins(grid.count(), entries);

    std::vector<FillCounts> counts(order.size());
    tbb::parallel_for(std::size_t{0}, order.size(), [&](std::size_t i) {
        counts[i] = fill_tile(bins.commands(order[i]), grid.tile(order[i]), pass.color, pass.depth);
    });
    for (Part& part : parts) part = {};
    FillCounts total;
    for (const FillCounts& tile : counts) total += tile;
    return total;
}

}  // namespace

FillCounts fill_pass(const PassFill& pass, const FillOptions& options) {
    if (pass.scissor.empty()) return {};
    const TileGrid grid(pass.scissor);
    std::vector<FillPlan> plans;
    plans.reserve(pass.draws.size());
    std::vector<Part> parts;
    for (const Draw& draw : pass.draws) {
        const FillPlan& plan =
            plans.emplace_back(plan_fill(draw.state, pass.color != nullptr, pass.format, pass.depth_bits));
        split(draw.triangles, plan, &Part::triangles, pass.scissor, grid, parts);
        split(draw.rectangles, plan, &Part::rectangles, pass.scissor, grid, parts);
    }
    const std::vector<int> order = tile_order(grid.count(), options.tile_order_seed);
    FillCounts total;
    for (std::size_t first = 0; first < parts.size();) {
        std::size_t end = first, entries = 0;
        while (end < parts.size() && (end == first || entries + parts[end].entries_at_most <= kWaveEntries))
            entries += parts[end++].entries_at_most;
        total += fill_wave(std::span(parts).subspan(first, end - first), pass, grid, order);
        first = end;
    }
    return total;
}

void fill_rect(Image& image, const Rect& rect, std::uint32_t value) {
    const Rect inside = intersect(rect, image.bounds());
    if (inside.empty()) return;
    for (int y = inside.y0; y < inside.y1; ++y) std::fill(image.row(y) + inside.x0, image.row(y) + inside.x1, value);
}

}  // namespace raster
