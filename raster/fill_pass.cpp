// SPDX-License-Identifier: MIT
#include "raster/fill_pass.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "raster/bin.h"
#include "raster/fill_plan.h"
#include "raster/fill_tile.h"

namespace raster {
namespace {

// Primitives of one draw, or one clear: consecutive ones in the order of all that is to be drawn.
struct Run {
    enum class Kind : std::uint8_t { Clear, Triangles, Rectangles };
    Kind kind            = Kind::Clear;
    std::uint32_t pass   = 0;
    const FillPlan* plan = nullptr;
    const Draw* draw     = nullptr;
    std::uint32_t first = 0, count = 0;  // of the draw's primitives of that kind
};

// Large primitives fall into many tiles each. These bound what is held at a time: of a part, and of all before tiles
// are filled.
constexpr std::uint32_t kPartPrimitives = 512, kBlockPrimitives = 64;
constexpr std::size_t kPartEntries = 1 << 16;
constexpr std::size_t kWaveParts   = 128;

// What has been set up and binned. Grows only, as far as it is needed; commands point to what it holds, which must not
// move.
class PartMemory {
  public:
    std::vector<SetUpRectangle> rectangles;
    std::vector<Command> commands;
    Bin bin;

    void clear() {
        rectangles.clear();
        commands.clear();
        commands.reserve(kPartPrimitives);
        bin.clear();
    }
    // Room for `count` triangles from `first` on.
    SetUpTriangle* triangles(std::size_t first, std::size_t count, bool textured) {
        triangles_.reserve(kPartPrimitives);
        triangles_.resize(std::max(triangles_.size(), first + count));
        if (textured) {
            textures_.reserve(kMaxTextures * kPartPrimitives);
            textures_.resize(std::max(textures_.size(), kMaxTextures * (first + count)));
            for (std::size_t i = first; i < first + count; ++i)
                triangles_[i].textures = textures_.data() + kMaxTextures * i;
        }
        return triangles_.data() + first;
    }

  private:
    std::vector<SetUpTriangle> triangles_;
    std::vector<TexturePlanes> textures_;  // of those that have any
};

// What one task sets up and bins: some runs, of about kPartPrimitives in all.
struct Part {
    std::size_t first_run = 0, end_run = 0;
    // Where to go on once what is binned has been filled.
    std::size_t next_run     = 0;
    std::uint32_t next_first = 0;
    bool is_binned           = false;
    PartMemory* memory       = nullptr;
    bool is_finished() const { return next_run == end_run; }
};

// 0, 1, 2, .. or a fixed shuffle of it.
void set_tile_order(int count, std::uint32_t seed, std::vector<int>& order) {
    order.resize(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    if (seed == 0) return;
    for (std::size_t i = order.size(); i > 1; --i) {
        seed = seed * 1664525u + 1013904223u;
        std::swap(order[i - 1], order[(seed >> 8) % i]);
    }
}

Rect area_of(std::span<const PassFill> passes) {
    Rect area;
    for (const PassFill& pass : passes) area = hull(area, pass.scissor);
    return area;
}

FillTarget target_of(std::span<const PassFill> passes) {
    FillTarget target;
    for (const PassFill& pass : passes) {
        if (pass.color) target.color = pass.color;
        if (pass.depth) target.depth = pass.depth;
    }
    return target;
}

}  // namespace

struct PassFiller::Memory {
    // What a thread keeps to itself.
    struct alignas(64) Thread {
        std::vector<const Command*> commands;  // of the tile at hand
        std::vector<KernelCounts> counts;      // by pass
    };

    std::span<const PassFill> passes;
    std::vector<FillPlan> plans;
    std::vector<Run> runs;
    std::vector<Part> parts;
    std::array<PartMemory, kWaveParts> part_memory;  // in turn
    std::vector<int> order;
    std::vector<Thread> threads;

    void list_runs();
    void list_parts();
    void bin(Part& part, const TileGrid& grid);
    void fill_tile(std::span<const Part> wave, const Rect& tile, int index, const FillTarget& target, Thread& thread);
    void clear(const PassFill& pass, const Rect& tile);
};

void PassFiller::Memory::list_runs() {
    std::size_t draws = 0;
    for (const PassFill& pass : passes) draws += pass.draws.size();
    plans.clear();
    plans.reserve(draws);  // runs point to them
    runs.clear();
    for (std::uint32_t i = 0; i < passes.size(); ++i) {
        const PassFill& pass = passes[i];
        if (pass.scissor.empty()) continue;
        if (pass.clear_color || pass.clear_depth) runs.push_back({.kind = Run::Kind::Clear, .pass = i, .count = 1});
        for (const Draw& draw : pass.draws) {
            if (draw.triangles.empty() && draw.rectangles.empty()) continue;
            const FillPlan& plan =
                plans.emplace_back(plan_fill(draw.state, pass.color != nullptr, pass.format, pass.depth_bits));
            const auto add = [&](Run::Kind kind, std::size_t size) {
                for (std::uint32_t first = 0; first < size; first += kPartPrimitives)
                    runs.push_back({kind, i, &plan, &draw, first,
                                    std::min(kPartPrimitives, static_cast<std::uint32_t>(size) - first)});
            };
            add(Run::Kind::Triangles, draw.triangles.size());
            add(Run::Kind::Rectangles, draw.rectangles.size());
        }
    }
}

void PassFiller::Memory::list_parts() {
    parts.clear();
    for (std::size_t first = 0; first < runs.size();) {
        std::size_t end     = first;
        std::uint32_t count = 0;
        while (end < runs.size() && (end == first || count + runs[end].count <= kPartPrimitives))
            count += runs[end++].count;
        parts.push_back(
            {.first_run = first, .end_run = end, .next_run = first, .memory = &part_memory[parts.size() % kWaveParts]});
        first = end;
    }
}

// From where the part was left, until it is done or has its fill of entries.
void PassFiller::Memory::bin(Part& part, const TileGrid& grid) {
    PartMemory& memory = *part.memory;
    memory.clear();
    std::size_t triangles = 0;
    while (part.next_run < part.end_run && memory.bin.entry_count() < kPartEntries) {
        const Run& run       = runs[part.next_run];
        const PassFill& pass = passes[run.pass];
        const std::uint32_t count =
            run.kind == Run::Kind::Clear ? 1 : std::min(kBlockPrimitives, run.count - part.next_first);
        const std::uint32_t first = run.first + part.next_first;
        switch (run.kind) {
            case Run::Kind::Clear:
                // A command without a plan: the pass says what to clear.
                memory.commands.push_back({.pass = run.pass});
                memory.bin.add(memory.commands.back(), pass.scissor, grid);
                break;
            case Run::Kind::Triangles: {
                const SetupNeeds& needs  = run.plan->needs;
                SetUpTriangle* const out = memory.triangles(triangles, count, needs.texture[0] || needs.texture[1]);
                const TriangleList list{run.draw->vertices, std::span(run.draw->triangles).subspan(first, count),
                                        run.draw->flat};
                const std::size_t added = set_up_triangles(list, needs, pass.grid, pass.scissor, out);
                for (std::size_t i = 0; i < added; ++i) {
                    memory.commands.push_back({.plan = run.plan, .triangle = out + i, .pass = run.pass});
                    memory.bin.add(memory.commands.back(), grid);
                }
                triangles += added;
                break;
            }
            case Run::Kind::Rectangles:
                memory.rectangles.reserve(kPartPrimitives);
                for (std::uint32_t i = 0; i < count; ++i) {
                    SetUpRectangle& out = memory.rectangles.emplace_back();
                    if (!set_up_rectangle(run.draw->rectangles[first + i], run.plan->needs, pass.grid, pass.scissor,
                                          out)) {
                        memory.rectangles.pop_back();
                        continue;
                    }
                    memory.commands.push_back({.plan = run.plan, .rectangle = &out, .pass = run.pass});
                    memory.bin.add(memory.commands.back(), grid);
                }
                break;
        }
        part.next_first += count;
        if (part.next_first == run.count) {
            ++part.next_run;
            part.next_first = 0;
        }
    }
    memory.bin.sort();
    part.is_binned = true;
}

void PassFiller::Memory::clear(const PassFill& pass, const Rect& tile) {
    const Rect inside = intersect(pass.scissor, tile);
    if (pass.clear_color) fill_rect(*pass.color, inside, *pass.clear_color);
    if (pass.clear_depth) fill_rect(*pass.depth, inside, *pass.clear_depth);
}

void PassFiller::Memory::fill_tile(std::span<const Part> wave, const Rect& tile, int index, const FillTarget& target,
                                   Thread& thread) {
    std::vector<const Command*>& commands = thread.commands;
    const auto fill                       = [&] {
        if (!commands.empty()) raster::fill_tile(commands, tile, target, thread.counts);
        commands.clear();
    };
    bool has_begun = false;
    for (const Part& part : wave)
        for (const Command& command : part.memory->bin.commands(index)) {
            if (!has_begun) prefetch_tile(target, tile);
            has_begun = true;
            if (command.plan) {
                commands.push_back(&command);
                continue;
            }
            fill();
            clear(passes[command.pass], tile);
        }
    fill();
}

PassFiller::PassFiller() : memory_(std::make_unique<Memory>()) {}
PassFiller::~PassFiller() = default;

void PassFiller::fill(std::span<const PassFill> passes, std::span<KernelCounts> counts, const FillOptions& options) {
    Memory& memory  = *memory_;
    const Rect area = area_of(passes);
    if (area.empty()) return;
    const TileGrid grid(area);
    const FillTarget target = target_of(passes);
    memory.passes           = passes;
    memory.list_runs();
    memory.list_parts();
    set_tile_order(grid.count(), options.tile_order_seed, memory.order);
    memory.threads.resize(
        std::max(memory.threads.size(), static_cast<std::size_t>(tbb::this_task_arena::max_concurrency())));
    for (Memory::Thread& thread : memory.threads) thread.counts.assign(options.counts ? passes.size() : 0, {});

    const std::span<Part> parts = memory.parts;
    for (std::size_t first = 0; first < parts.size();) {
        const std::size_t end = std::min(first + kWaveParts, parts.size());
        tbb::parallel_for(first, end, [&](std::size_t i) {
            if (!parts[i].is_binned) memory.bin(parts[i], grid);
        });
        // What comes after a part that is not finished has to wait.
        std::size_t stop = first;
        while (stop < end && parts[stop].is_finished()) ++stop;
        const std::span<const Part> wave = parts.subspan(first, std::min(stop + 1, end) - first);
        tbb::parallel_for(std::size_t{0}, memory.order.size(), [&](std::size_t i) {
            const int index = memory.order[i];
            Memory::Thread& thread =
                memory.threads[static_cast<std::size_t>(tbb::this_task_arena::current_thread_index())];
            memory.fill_tile(wave, grid.tile(index), index, target, thread);
        });
        if (stop < end) parts[stop].is_binned = false;
        first = stop;
    }
    for (const Memory::Thread& thread : memory.threads)
        for (std::size_t i = 0; i < thread.counts.size(); ++i) counts[i] += thread.counts[i];
}

FillCounts fill_pass(const PassFill& pass, const FillOptions& options) {
    KernelCounts counts;
    PassFiller().fill({&pass, 1}, {&counts, 1}, options);
    return counts.total();
}

Rect hull(const Rect& a, const Rect& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

void fill_rect(Image& image, const Rect& rect, std::uint32_t value) {
    const Rect inside = intersect(rect, image.bounds());
    if (inside.empty()) return;
    for (int y = inside.y0; y < inside.y1; ++y) std::fill(image.row(y) + inside.x0, image.row(y) + inside.x1, value);
}

}  // namespace raster
