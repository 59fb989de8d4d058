// SPDX-License-Identifier: MIT
#include "pipeline/execute/execute.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include "pipeline/execute/frame_memory.h"
#include "pipeline/execute/lower.h"
#include "pipeline/execute/vertex_stage.h"
#include "pipeline/validate/validate.h"
#include "raster/fill_pass.h"
#include "raster/reference.h"
#include "raster/simd_targets.h"
#include "raster/thread_arena.h"

namespace pipeline {
namespace {

bool is_whole(const PixelRect& rect) {
    return rect == PixelRect{};
}

// A part of a draw that one task takes through the vertex stage.
struct VertexJob {
    const DrawTriangles* draw;
    std::uint32_t first, count;
    VertexStageCounts counts{};
    std::uint64_t vertices = 0;  // of the whole draw, at its first job
};
constexpr std::uint32_t kJobIndices = 3 * 1024;

raster::Rectangle lower(const DrawRectangle& rectangle) {
    raster::Rectangle out{.x0    = rectangle.x0,
                          .y0    = rectangle.y0,
                          .x1    = rectangle.x1,
                          .y1    = rectangle.y1,
                          .z     = rectangle.depth,
                          .color = rectangle.color.value,
                          .uv    = {}};
    for (int i = 0; i < kTextureStages; ++i)
        out.uv[i] = {rectangle.uv[i].u0, rectangle.uv[i].v0, rectangle.uv[i].u1, rectangle.uv[i].v1};
    return out;
}

// The distinct vertices that a draw refers to.
std::uint64_t count_vertices(const Frame& frame, const DrawTriangles& draw) {
    const auto indices       = std::span(frame.indices).subspan(draw.first_index, draw.index_count);
    const auto [least, most] = std::minmax_element(indices.begin(), indices.end());
    if (least == indices.end()) return 0;
    std::vector<bool> seen(*most - *least + 1);
    for (const std::uint32_t index : indices) seen[index - *least] = true;
    return static_cast<std::uint64_t>(std::count(seen.begin(), seen.end(), true));
}

class FrameExecution {
  public:
    FrameExecution(const Frame& frame, const ExecuteOptions& options, FrameMemory& memory)
        : frame_(frame),
          options_(options),
          memory_(memory),
          stored_(options.backend == Backend::Reference ? &raster::reference_stored
                                                        : static_cast<StoreFunction*>(&raster::stored)),
          arena_(options.threads) {
        arena_.run([&] { memory.prepare(frame, stored_); });
    }

    PassCounts run(const Pass& pass) {
        const PixelRect viewport = resolve(pass.state.viewport, pass);
        const PixelRect scissor  = resolve(pass.state.scissor, pass);
        raster::PassFill fill{.color      = memory_.image(pass.color),
                              .depth      = memory_.image(pass.depth),
                              .depth_bits = pass.depth ? depth_bits(format(pass.depth)) : 24,
                              .format     = pass.color ? color_format(format(pass.color)) : raster::ColorFormat{},
                              .grid       = pixel_grid(frame_.arithmetic),
                              .scissor    = raster::intersect({viewport.x0, viewport.y0, viewport.x1, viewport.y1},
                                                              {scissor.x0, scissor.y0, scissor.x1, scissor.y1}),
                              .draws      = {}};
        PassCounts counts;
        clear(pass, fill, counts);
        for (const Draw& draw : pass.draws)
            if (const auto* rectangle = std::get_if<CopyRectangle>(&draw)) copy(pass, *rectangle, counts);
        add_draws(pass, viewport, fill, counts);
        const raster::FillCounts filled =
            options_.backend == Backend::Reference
                ? raster::reference_fill_pass(fill)
                : arena_.run([&] { return raster::fill_pass(fill, {options_.tile_order_seed}); });
        count(pass, filled, counts);
        return counts;
    }

    ColorImage read(TargetId id) const {
        if (!id) return {};
        const raster::Image& image = *memory_.image(id);
        ColorImage out{image.width(), image.height(), {}};
        out.pixels.reserve(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
        for (int y = 0; y < out.height; ++y)
            out.pixels.insert(out.pixels.end(), image.row(y), image.row(y) + out.width);
        return out;
    }

  private:
    PixelRect resolve(const PixelRect& rect, const Pass& pass) const {
        if (!is_whole(rect)) return rect;
        const Target& target = frame_.targets[(pass.color ? pass.color : pass.depth).index];
        return {0, 0, target.width, target.height};
    }

    TargetFormat format(TargetId id) const { return frame_.targets[id.index].format; }
    std::uint64_t pixel_bytes(TargetId id) const {
        return id ? static_cast<std::uint64_t>(bytes_per_pixel(format(id))) : 0;
    }

    void clear(const Pass& pass, const raster::PassFill& fill, PassCounts& counts) {
        const auto set = [&](raster::Image& image, std::uint32_t value, TargetId target) {
            raster::fill_rect(image, fill.scissor, value);
            if (fill.scissor.empty()) return;
            const std::uint64_t pixels = static_cast<std::uint64_t>(fill.scissor.x1 - fill.scissor.x0) *
                                         static_cast<std::uint64_t>(fill.scissor.y1 - fill.scissor.y0);
            counts.cleared += pixels;
            counts.bytes += pixels * pixel_bytes(target);
        };
        if (pass.clear.color) set(*fill.color, stored_(fill.format, pass.clear.color->value), pass.color);
        if (pass.clear.depth)
            set(*fill.depth, raster::to_depth_format(raster::depth_value(*pass.clear.depth), fill.depth_bits),
                pass.depth);
    }

    void copy(const Pass& pass, const CopyRectangle& rectangle, PassCounts& counts) {
        const PixelRect& from = rectangle.from;
        const raster::CopyFill fill{.source        = memory_.image(rectangle.source),
                                    .source_format = color_format(format(rectangle.source)),
                                    .from          = {from.x0, from.y0, from.x1, from.y1},
                                    .target        = memory_.image(pass.color),
                                    .target_format = color_format(format(pass.color)),
                                    .x             = rectangle.x,
                                    .y             = rectangle.y,
                                    .halve         = rectangle.halve};
        if (options_.backend == Backend::Reference)
            raster::reference_copy_pixels(fill);
        else
            arena_.run([&] { raster::copy_pixels(fill); });
        const std::uint64_t read =
            static_cast<std::uint64_t>(from.x1 - from.x0) * static_cast<std::uint64_t>(from.y1 - from.y0);
        const std::uint64_t written = read / (rectangle.halve ? 4 : 1);
        ++counts.copies;
        counts.texels += read;
        counts.color_written += written;
        counts.bytes += read * pixel_bytes(rectangle.source) + written * pixel_bytes(pass.color);
    }

    // Each vertex job becomes a draw of its own; the order stays that of the pass.
    void add_draws(const Pass& pass, const PixelRect& viewport, raster::PassFill& fill, PassCounts& counts) {
        std::vector<VertexJob> jobs;
        const auto state = [&](const TextureBindings& textures) {
            return lower(frame_.arithmetic, pass.state, pass.color ? std::optional(format(pass.color)) : std::nullopt,
                         textures, memory_);
        };
        for (const Draw& draw : pass.draws) {
            if (const auto* triangles = std::get_if<DrawTriangles>(&draw)) {
                for (std::uint32_t done = 0; done < triangles->index_count; done += kJobIndices) {
                    jobs.push_back({triangles, triangles->first_index + done,
                                    std::min(kJobIndices, triangles->index_count - done)});
                    fill.draws.push_back({state(triangles->textures), {}, {}});
                }
            } else if (const auto* rectangle = std::get_if<DrawRectangle>(&draw)) {
                jobs.push_back({nullptr, 0, 0});
                fill.draws.push_back({state(rectangle->textures), {}, {lower(*rectangle)}});
                fill.draws.back().state.fog = false;
                ++counts.rectangles;
            }
        }
        arena_.run([&] {
            tbb::parallel_for(std::size_t{0}, jobs.size(), [&](std::size_t i) {
                VertexJob& job = jobs[i];
                if (!job.draw) return;
                job.counts =
                    run_vertex_stage(frame_, pass, *job.draw, job.first, job.count, viewport, fill.draws[i].triangles);
                if (job.first == job.draw->first_index) job.vertices = count_vertices(frame_, *job.draw);
            });
        });
        for (const VertexJob& job : jobs) {
            counts.vertices += job.vertices;
            counts.triangles_in += job.counts.triangles_in;
            counts.triangles_drawn += job.counts.triangles_drawn;
        }
    }

    // What follows from the fragments and the state.
    void count(const Pass& pass, const raster::FillCounts& filled, PassCounts& counts) const {
        const PipelineState& state = pass.state;
        const bool masked          = state.color_mask != ColorMask{} || state.alpha_test.fail == AlphaFail::RgbOnly;
        const bool blends          = reads_destination(frame_.arithmetic, state);
        counts.covered             = filled.covered;
        counts.texels += filled.texels;
        counts.depth_tested  = state.depth.func != CompareFunc::Always ? filled.alpha_passed : 0;
        counts.depth_passed  = filled.depth_passed;
        counts.depth_written = filled.depth_written;
        counts.color_written += filled.color_written;
        counts.blended = blends ? filled.color_written : 0;
        counts.bytes += filled.texel_bytes + pixel_bytes(pass.color) * filled.dest_alpha_tested +
                        pixel_bytes(pass.depth) * (counts.depth_tested + counts.depth_written) +
                        pixel_bytes(pass.color) * filled.color_written * (blends || masked ? 2 : 1);
    }

    const Frame& frame_;
    const ExecuteOptions& options_;
    FrameMemory& memory_;
    StoreFunction* stored_;
    raster::ThreadArena arena_;
};

}  // namespace

Executor::Executor() : memory_(std::make_unique<FrameMemory>()) {}
Executor::~Executor() = default;

Execution Executor::execute(const Frame& frame, const ExecuteOptions& options, const PassObserver& observer) {
    const std::vector<Finding> findings = validate(frame);
    if (!findings.empty()) throw std::invalid_argument(findings[0].where + " " + findings[0].what);
    FrameExecution execution(frame, options, *memory_);
    Execution out;
    out.counts.reserve(frame.passes.size());
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        const Pass& pass = frame.passes[i];
        out.counts.push_back(execution.run(pass));
        if (observer) observer({i, pass, out.counts.back(), [&] { return execution.read(pass.color); }});
    }
    out.output = execution.read(frame.output);
    return out;
}

Execution execute(const Frame& frame, const ExecuteOptions& options, const PassObserver& observer) {
    return Executor().execute(frame, options, observer);
}

std::vector<std::string> simd_targets() {
    return raster::simd_targets();
}

void force_simd_target(const std::string& name) {
    if (raster::force_simd_target(name)) return;
    std::string known;
    for (const std::string& target : raster::simd_targets()) known += (known.empty() ? "" : ", ") + target;
    throw std::invalid_argument("unknown instruction set '" + name + "' (this machine has " + known + ")");
}

}  // namespace pipeline
