// SPDX-License-Identifier: MIT
#include "pipeline/execute/execute.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <span>
#include <stdexcept>

#include "pipeline/execute/frame_memory.h"
#include "pipeline/execute/lower.h"
#include "pipeline/execute/schedule.h"
#include "pipeline/execute/vertex_list.h"
#include "pipeline/execute/vertex_stage.h"
#include "pipeline/execute/window.h"
#include "pipeline/validate/validate.h"
#include "raster/copy_row.h"
#include "raster/fill_pass.h"
#include "raster/reference.h"
#include "raster/simd_targets.h"
#include "raster/thread_arena.h"

namespace pipeline {

// What one frame leaves for the next.
struct ExecutorMemory {
    FrameMemory frame;
    VertexStage vertex_stage;
    VertexList window_list;
    raster::PassFiller filler;
    std::vector<raster::PassFill>
        fills;  // of the groups, one after the other: a pass finds the memory of its draws again
    std::vector<raster::KernelCounts> filled;
    std::vector<VertexStageDraw> stage_draws;
};

namespace {

// May a colour decide what is counted?
bool tests_alpha(const Frame& frame) {
    return std::any_of(frame.passes.begin(), frame.passes.end(), [](const Pass& pass) {
        return pass.state.alpha_test.func != CompareFunc::Always || pass.state.dest_alpha_test != DestAlphaTest::Off;
    });
}

bool is_whole(const PixelRect& rect) {
    return rect == PixelRect{};
}

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

raster::Vertex lower(const WindowVertex& vertex) {
    return {.diffuse  = vertex.diffuse.value,
            .specular = vertex.specular.value,
            .x        = vertex.x,
            .y        = vertex.y,
            .z        = vertex.z,
            .rhw      = vertex.rhw,
            .uv       = {{{vertex.uv0.x, vertex.uv0.y, vertex.uv0.z}, {vertex.uv1.x, vertex.uv1.y, vertex.uv1.z}}}};
}

raster::CopyChannels lower(CopyChannels channels) {
    switch (channels) {
        case CopyChannels::All:
            break;
        case CopyChannels::AlphaToColor:
            return raster::CopyChannels::AlphaToColor;
        case CopyChannels::GreenToAlpha:
            return raster::CopyChannels::GreenToAlpha;
    }
    return raster::CopyChannels::All;
}

raster::Rect to_rect(const PixelRect& rect) {
    return {rect.x0, rect.y0, rect.x1, rect.y1};
}

std::uint64_t area(const raster::Rect& rect) {
    return rect.empty() ? 0
                        : static_cast<std::uint64_t>(rect.x1 - rect.x0) * static_cast<std::uint64_t>(rect.y1 - rect.y0);
}

class FrameExecution {
  public:
    FrameExecution(const Frame& frame, const ExecuteOptions& options, ExecutorMemory& memory)
        : frame_(frame),
          options_(options),
          memory_(memory),
          stored_(options.backend == Backend::Reference ? &raster::reference_stored
                                                        : static_cast<StoreFunction*>(&raster::stored)),
          has_colors_(!options.counts_only || is_reference() || tests_alpha(frame)),
          arena_(options.threads) {
        arena_.run(
            [&] { memory.frame.prepare(frame, stored_, {.colors = has_colors_, .alpha_quads = !is_reference()}); });
    }

    // Adds what the passes did to the counts of `out`. index: of the group.
    void run(const PassGroup& group, std::size_t index, Execution& out) {
        arena_.run([&] {
            // The first of the fills sets new targets to zeros, the others are the passes.
            const std::size_t size = group.end - group.first, first_fill = group.first + index;
            if (memory_.fills.size() < first_fill + size + 1) memory_.fills.resize(first_fill + size + 1);
            const std::span all_fills = std::span(memory_.fills).subspan(first_fill, size + 1);
            const std::span fills     = all_fills.subspan(1);
            memory_.filled.assign(size + 1, {});
            const std::span passes = std::span(frame_.passes).subspan(group.first, size);

            memory_.stage_draws.clear();
            for (std::size_t i = 0; i < size; ++i) prepare(passes[i], fills[i]);
            memory_.vertex_stage.run(frame_, memory_.stage_draws);
            set_zero_fill(group, fills[0], all_fills[0]);
            for (std::size_t i = 0; i < size; ++i) {
                if (group.copies && passes[i].clear == Clear{}) continue;
                memory_.frame.add_drawn(passes[i].color, fills[i].scissor);
                memory_.frame.add_drawn(passes[i].depth, fills[i].scissor);
            }
            if (is_reference())
                for (std::size_t i = 0; i <= size; ++i)
                    memory_.filled[i] = {.special = raster::reference_fill_pass(all_fills[i]), .general = {}};
            else
                memory_.filler.fill(all_fills, memory_.filled, {options_.tile_order_seed, options_.counts_fragments});

            for (const VertexStageDraw& draw : memory_.stage_draws)
                add_stage_counts(draw.counts, out.counts[static_cast<std::size_t>(draw.pass - frame_.passes.data())]);
            for (std::size_t i = 0; i < size; ++i) {
                count_window_triangles(passes[i], fills[i], out.counts[group.first + i]);
                PassCounts& pass_counts            = out.counts[group.first + i];
                const raster::KernelCounts& filled = memory_.filled[i + 1];
                count_clear(passes[i], fills[i].scissor, pass_counts);
                count_fill(passes[i], filled.total(), pass_counts);
                if (!is_reference()) out.kernels[group.first + i] = {filled.special.covered, filled.general.covered};
                for (const Draw& draw : passes[i].draws)
                    if (const auto* rectangle = std::get_if<CopyRectangle>(&draw))
                        copy(passes[i], *rectangle, pass_counts);
            }
        });
    }

    void read(TargetId id, ColorImage& out) {
        if (!id) {
            out = {};
            return;
        }
        arena_.run([&] {
            memory_.frame.set_zeros(id);
            const raster::Image* image = memory_.frame.image(id);
            const Target& target       = frame_.targets[id.index];
            out.width                  = target.width;
            out.height                 = target.height;
            out.pixels.resize(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
            if (image == nullptr) {
                std::fill(out.pixels.begin(), out.pixels.end(), memory_.frame.zero(id));
                return;
            }
            tbb::parallel_for(0, out.height, [&](int y) {
                raster::copy_row(image->row(y), out.width,
                                 out.pixels.data() + static_cast<std::ptrdiff_t>(y) * out.width);
            });
        });
    }

  private:
    bool is_reference() const { return options_.backend == Backend::Reference; }

    PixelRect resolve(const PixelRect& rect, const Pass& pass) const {
        if (!is_whole(rect)) return rect;
        const Target& target = frame_.targets[(pass.color ? pass.color : pass.depth).index];
        return {0, 0, target.width, target.height};
    }

    TargetFormat format(TargetId id) const { return frame_.targets[id.index].format; }
    std::uint64_t pixel_bytes(TargetId id) const {
        return id ? static_cast<std::uint64_t>(bytes_per_pixel(format(id))) : 0;
    }

    // All but the triangles, which the vertex stage makes.
    void prepare(const Pass& pass, raster::PassFill& fill) {
        const PixelRect viewport = resolve(pass.state.viewport, pass);
        fill.color               = memory_.frame.image(pass.color);
        fill.depth               = memory_.frame.image(pass.depth);
        fill.depth_bits          = pass.depth ? depth_bits(format(pass.depth)) : 24;
        fill.format              = pass.color ? color_format(format(pass.color)) : raster::ColorFormat{};
        fill.grid                = pixel_grid(frame_.arithmetic);
        fill.scissor             = raster::intersect(to_rect(viewport), to_rect(resolve(pass.state.scissor, pass)));
        fill.clear_color.reset();
        fill.clear_depth.reset();
        if (pass.clear.color && has_colors_) fill.clear_color = stored_(fill.format, pass.clear.color->value);
        if (pass.clear.depth)
            fill.clear_depth = raster::to_depth_format(raster::depth_value(*pass.clear.depth), fill.depth_bits);

        fill.draws.resize(pass.draws.size());
        for (std::size_t i = 0; i < pass.draws.size(); ++i) {
            raster::Draw& out = fill.draws[i];
            out.rectangles.clear();
            if (const auto* triangles = std::get_if<DrawTriangles>(&pass.draws[i])) {
                out.state = state(pass, triangles->textures);
                memory_.stage_draws.push_back(
                    {.pass = &pass, .draw = triangles, .viewport = viewport, .out = &out, .counts = {}});
                continue;
            }
            out.triangles.clear();
            if (const auto* triangles = std::get_if<DrawWindowTriangles>(&pass.draws[i])) {
                out.state = state(pass, triangles->textures);
                out.flat  = pass.state.shade == ShadeMode::Flat;
                set_triangles(*triangles, pass.state.cull, out);
            }
            if (const auto* rectangle = std::get_if<DrawRectangle>(&pass.draws[i])) {
                out.state     = state(pass, rectangle->textures);
                out.state.fog = false;
                out.rectangles.push_back(lower(*rectangle));
            }
        }
    }

    // Those that are not culled, with the vertices that their indices name, from the least to the greatest.
    void set_triangles(const DrawWindowTriangles& draw, CullMode cull, raster::Draw& out) const {
        const std::span indices = std::span(frame_.indices).subspan(draw.first_index, draw.index_count);
        out.vertices.clear();
        if (indices.empty()) return;
        VertexList& list = memory_.window_list;
        list.set(indices);
        const raster::PixelGrid grid = pixel_grid(frame_.arithmetic);
        out.vertices.resize(list.size());
        for (std::uint32_t place = 0; place < list.size(); ++place)
            out.vertices[place] = lower(frame_.window_vertices[list.vertex(place)]);
        const auto snapped = [&](std::uint32_t corner) {
            return raster::snap_to_subpixels(grid, out.vertices[corner].x, out.vertices[corner].y);
        };
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
            const raster::TriangleCorners corners{list.corner(i), list.corner(i + 1), list.corner(i + 2)};
            if (!is_culled(cull, area_of(snapped(corners[0]), snapped(corners[1]), snapped(corners[2]))))
                out.triangles.push_back(corners);
        }
    }

    raster::FillState state(const Pass& pass, const TextureBindings& textures) {
        for (const TextureBinding& binding : textures) memory_.frame.set_zeros(binding.target);
        const std::optional<TargetFormat> color = pass.color ? std::optional(format(pass.color)) : std::nullopt;
        raster::FillState state                 = lower(frame_.arithmetic, pass.state, color, textures, memory_.frame);
        if (!has_colors_) state.blend.write_mask = 0;
        return state;
    }

    // What the group's targets need before they are drawn to for the first time, unless its first pass clears all of
    // it.
    void set_zero_fill(const PassGroup& group, const raster::PassFill& first, raster::PassFill& fill) {
        FrameMemory::Start color = memory_.frame.start(group.color), depth = memory_.frame.start(group.depth);
        const auto is_cleared = [&](const raster::Rect& rect) { return intersect(rect, first.scissor) == rect; };
        if (first.color && first.clear_color && is_cleared(color.rect)) color.rect = {};
        if (first.depth && first.clear_depth && is_cleared(depth.rect)) depth.rect = {};

        fill.color   = memory_.frame.image(group.color);
        fill.depth   = memory_.frame.image(group.depth);
        fill.scissor = hull(color.rect, depth.rect);
        fill.draws.clear();
        fill.clear_color.reset();
        fill.clear_depth.reset();
        if (!color.rect.empty()) fill.clear_color = color.value;
        if (!depth.rect.empty()) fill.clear_depth = depth.value;
    }

    void copy(const Pass& pass, const CopyRectangle& rectangle, PassCounts& counts) {
        memory_.frame.set_zeros(rectangle.source);
        const PixelRect& from = rectangle.from;
        const int scale       = rectangle.halve ? 2 : 1;
        const raster::CopyFill fill{.source        = memory_.frame.image(rectangle.source),
                                    .source_format = color_format(format(rectangle.source)),
                                    .from          = to_rect(from),
                                    .target        = memory_.frame.image(pass.color),
                                    .target_format = color_format(format(pass.color)),
                                    .x             = rectangle.x,
                                    .y             = rectangle.y,
                                    .halve         = rectangle.halve,
                                    .channels      = lower(rectangle.channels)};
        if (rectangle.channels != CopyChannels::All) memory_.frame.set_zeros(pass.color);
        memory_.frame.add_drawn(
            pass.color, {fill.x, fill.y, fill.x + (from.x1 - from.x0) / scale, fill.y + (from.y1 - from.y0) / scale});
        if (has_colors_) (is_reference() ? raster::reference_copy_pixels : raster::copy_pixels)(fill);
        const std::uint64_t read    = area(fill.from);
        const std::uint64_t written = read / (rectangle.halve ? 4 : 1);
        ++counts.copies;
        counts.texels += read;
        counts.color_written += written;
        counts.bytes += read * pixel_bytes(rectangle.source) + written * pixel_bytes(pass.color);
    }

    // Do its fragments write a channel that the target has?
    bool writes_color(const Pass& pass) const {
        const ColorMask& mask = pass.state.color_mask;
        return pass.color &&
               (mask.red || mask.green || mask.blue || (mask.alpha && color_format(format(pass.color)).alpha > 0));
    }

    static void count_window_triangles(const Pass& pass, const raster::PassFill& fill, PassCounts& counts) {
        for (std::size_t i = 0; i < pass.draws.size(); ++i) {
            const auto* triangles = std::get_if<DrawWindowTriangles>(&pass.draws[i]);
            if (triangles == nullptr) continue;
            counts.triangles_in += triangles->index_count / 3;
            counts.triangles_drawn += fill.draws[i].triangles.size();
        }
    }

    static void add_stage_counts(const VertexStageCounts& stage, PassCounts& counts) {
        counts.vertices += stage.vertices;
        counts.triangles_in += stage.triangles_in;
        counts.triangles_drawn += stage.triangles_drawn;
    }

    void count_clear(const Pass& pass, const raster::Rect& scissor, PassCounts& counts) const {
        const auto add = [&](bool clears, TargetId target) {
            if (!clears) return;
            counts.cleared += area(scissor);
            counts.bytes += area(scissor) * pixel_bytes(target);
        };
        add(pass.clear.color.has_value(), pass.color);
        add(pass.clear.depth.has_value(), pass.depth);
    }

    // What follows from the fragments and the state.
    void count_fill(const Pass& pass, raster::FillCounts filled, PassCounts& counts) const {
        if (!has_colors_ && writes_color(pass)) filled.color_written = filled.depth_passed;
        const PipelineState& state = pass.state;
        const bool masked          = state.color_mask != ColorMask{} || state.alpha_test.fail == AlphaFail::RgbOnly;
        const bool blends          = reads_destination(frame_.arithmetic, state);
        counts.rectangles +=
            static_cast<std::uint64_t>(std::count_if(pass.draws.begin(), pass.draws.end(), [](const Draw& draw) {
                return std::holds_alternative<DrawRectangle>(draw);
            }));
        counts.covered = filled.covered;
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
    ExecutorMemory& memory_;
    StoreFunction* stored_;
    bool has_colors_;
    raster::ThreadArena arena_;
};

}  // namespace

Executor::Executor() : memory_(std::make_unique<ExecutorMemory>()) {}
Executor::~Executor() = default;

void Executor::execute(const Frame& frame, Execution& out, const ExecuteOptions& options,
                       const PassObserver& observer) {
    const std::vector<Finding> findings = validate(frame);
    if (!findings.empty()) throw std::invalid_argument(findings[0].where + " " + findings[0].what);
    FrameExecution execution(frame, options, *memory_);
    out.counts.assign(frame.passes.size(), {});
    out.kernels.assign(frame.passes.size(), {});
    const bool one_by_one = observer || options.backend == Backend::Reference;
    std::size_t index     = 0;
    for (const PassGroup& group : schedule_passes(frame, one_by_one)) {
        execution.run(group, index++, out);
        if (!observer) continue;
        const Pass& pass      = frame.passes[group.first];
        const auto read_color = [&] {
            ColorImage image;
            execution.read(pass.color, image);
            return image;
        };
        observer({group.first, pass, out.counts[group.first], out.kernels[group.first], read_color});
    }
    execution.read(options.counts_only ? TargetId{} : frame.output, out.output);
}

Execution Executor::execute(const Frame& frame, const ExecuteOptions& options, const PassObserver& observer) {
    Execution out;
    execute(frame, out, options, observer);
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
