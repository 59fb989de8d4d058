// SPDX-License-Identifier: MIT
#include "raster/fill_tile.h"

#include <algorithm>

namespace raster {
namespace {

void interpolate_colors(const Command& command, FragmentBatch& batch) {
    const FillPlan& plan = *command.plan;
    if (command.rectangle) {
        if (plan.needs.diffuse) plan.interpolate.constant(command.rectangle->color, batch, batch.diffuse);
        if (plan.needs.specular) plan.interpolate.constant(0xff000000, batch, batch.specular);
        return;
    }
    const SetUpTriangle& triangle = *command.triangle;
    const auto make               = [&](bool varies, const std::array<Plane, 4>& planes, std::uint32_t flat,
                          BlockRows<std::uint32_t>& out) {
        varies ? plan.interpolate.color(planes, batch, out) : plan.interpolate.constant(flat, batch, out);
    };
    if (plan.needs.diffuse) make(triangle.diffuse_varies, triangle.diffuse, triangle.flat_diffuse, batch.diffuse);
    if (plan.needs.specular) make(triangle.specular_varies, triangle.specular, triangle.flat_specular, batch.specular);
}

void sample(const Command& command, int i, FragmentBatch& batch) {
    const FillPlan& plan = *command.plan;
    if (plan.needs.texture[i]) {
        const int lod_max = plan.samplers[i].lod_max();
        command.rectangle ? plan.interpolate.rectangle_uv(command.rectangle->textures[i], lod_max, batch)
                          : plan.interpolate.triangle_uv(command.triangle->textures[i], lod_max, batch);
    }
    const SampleKernel kernel = command.rectangle ? plan.sample_rectangle[i] : plan.sample[i];
    kernel(plan.samplers[i], batch, batch.texel[i]);
}

void make_color(const Command& command, FragmentBatch& batch) {
    const FillPlan& plan = *command.plan;
    interpolate_colors(command, batch);
    if (plan.state.stage_count == 0) std::copy_n(batch.diffuse[0], batch.count * kBlockWidth, batch.color[0]);
    for (int i = 0; i < plan.state.stage_count; ++i) {
        if (plan.sample[i]) sample(command, i, batch);
        plan.combine.stage(plan.state.stages[i], i, plan.state.constant, batch);
    }
    if (plan.state.add_specular) plan.combine.add_specular(batch);
    if (plan.state.fog) plan.combine.fog(plan.state.fog_color, batch);
}

void test_depth(const Command& command, Image& target, FragmentBatch& batch, FillCounts& counts) {
    const FillPlan& plan = *command.plan;
    if (command.rectangle)
        plan.interpolate.constant(to_depth_format(command.rectangle->depth, plan.depth_bits), batch, batch.depth);
    else
        plan.interpolate.depth(*command.triangle, plan.depth_bits, batch);
    counts.depth_passed += plan.test.depth(plan.state.depth_func, plan.state.depth_write, target, batch);
}

// Everything after coverage, for one batch of one primitive.
void shade(const Command& command, std::uint64_t covered, Image* color, Image* depth, FragmentBatch& batch,
           FillCounts& counts) {
    const FillPlan& plan = *command.plan;
    counts.covered += covered;
    counts.texels += covered * plan.texels_per_fragment;
    counts.texel_bytes += covered * plan.texel_bytes_per_fragment;

    if (plan.tests_first) {
        counts.alpha_passed += covered;
        if (plan.uses_depth) test_depth(command, *depth, batch, counts);
        if (plan.writes_color && batch.count > 0) make_color(command, batch);
    } else {
        make_color(command, batch);
        covered = plan.test.alpha(plan.state.alpha_func, plan.state.alpha_reference, batch);
        counts.alpha_passed += covered;
        if (plan.uses_depth) test_depth(command, *depth, batch, counts);
    }
    if (!plan.uses_depth) counts.depth_passed += covered;
    if (plan.writes_color) plan.blend(plan.blend_constants, *color, batch);
}

}  // namespace

FillCounts fill_tile(std::span<const Command* const> commands, const Rect& tile, Image* color, Image* depth) {
    thread_local FragmentBatch batch{};
    FillCounts counts;
    for (const Command* command : commands) {
        const CoverKernels& cover = command->plan->cover;
        if (command->rectangle) {
            const Rect bounds = intersect(command->rectangle->bounds, tile);
            for (int y = bounds.y0; y < bounds.y1;) {
                std::uint64_t covered = 0;
                y                     = cover.rectangle(bounds, y, batch, covered);
                shade(*command, covered, color, depth, batch, counts);
            }
        } else {
            TileEdges edges;
            if (!enter_tile(*command->triangle, tile, edges)) continue;
            for (int y = edges.bounds.y0; y < edges.bounds.y1;) {
                std::uint64_t covered = 0;
                y                     = cover.triangle(edges, y, batch, covered);
                if (covered > 0) shade(*command, covered, color, depth, batch, counts);
            }
        }
    }
    return counts;
}

}  // namespace raster
