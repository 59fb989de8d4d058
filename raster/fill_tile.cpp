// SPDX-License-Identifier: MIT
#include "raster/fill_tile.h"

#include <algorithm>

namespace raster {
namespace {

class TileFill {
  public:
    TileFill(Image* color, Image* depth) : color_(color), depth_(depth) {}

    void fill(const Command& command, const Rect& tile) {
        const CoverKernels& cover = command.plan->cover;
        if (command.rectangle) {
            const Rect bounds = intersect(command.rectangle->bounds, tile);
            for (int y = bounds.y0; y < bounds.y1;) {
                alive_ = 0;
                y      = cover.rectangle(bounds, y, batch_, alive_);
                shade(command);
            }
        } else {
            TileEdges edges;
            if (!enter_tile(*command.triangle, tile, edges)) return;
            for (int y = edges.bounds.y0; y < edges.bounds.y1;) {
                alive_ = 0;
                y      = cover.triangle(edges, y, batch_, alive_);
                if (alive_ > 0) shade(command);
            }
        }
    }
    const FillCounts& counts() const { return counts_; }

  private:
    // Everything after coverage, for one batch of one primitive. alive_: its fragments that have passed all tests so far.
    void shade(const Command& command) {
        const FillPlan& plan = *command.plan;
        counts_.covered += alive_;
        counts_.texels += alive_ * plan.texels_per_fragment;
        counts_.texel_bytes += alive_ * plan.texel_bytes_per_fragment;

        if (!plan.tests_first) {
            make_color(command);
            alive_ = plan.test.alpha(plan.state.alpha_func, plan.state.alpha_reference, plan.state.alpha_fail, batch_);
        }
        if (plan.state.dest_alpha_test != DestAlphaTest::Off) {
            counts_.dest_alpha_tested += alive_;
            alive_ = plan.test.dest_alpha(plan.state.dest_alpha_test, *color_, batch_);
        }
        counts_.alpha_passed += alive_;
        if (plan.uses_depth) test_depth(command);
        counts_.depth_passed += alive_;
        if (!plan.writes_color || alive_ == 0) return;
        if (plan.tests_first) make_color(command);
        if (plan.fails_on) alive_ = plan.test.limit_color(bits_if_failed(plan.state), batch_);
        counts_.color_written += alive_;
        plan.blend(plan.blend_plan, *color_, batch_);
    }

    void test_depth(const Command& command) {
        const FillPlan& plan = *command.plan;
        if (command.rectangle)
            plan.interpolate.constant(to_depth_format(command.rectangle->depth, plan.depth_bits), batch_, batch_.depth);
        else
            plan.interpolate.depth(*command.triangle, plan.depth_bits, batch_);
        const bool passed_only = plan.fails_on && plan.state.alpha_fail != AlphaFail::DepthOnly;
        alive_ = plan.test.depth(plan.state.depth_func, plan.state.depth_write, passed_only, *depth_, batch_,
                                 counts_.depth_written);
    }

    // The bits of the colour target that a fragment may change in spite of the alpha test.
    static std::uint32_t bits_if_failed(const FillState& state) {
        switch (state.alpha_fail) {
            case AlphaFail::Keep:
            case AlphaFail::DepthOnly:
                break;
            case AlphaFail::ColorOnly:
                return state.blend.write_mask;
            case AlphaFail::RgbOnly:
                return state.blend.write_mask & 0x00ffffff;
        }
        return 0;
    }

    void make_color(const Command& command) {
        const FillPlan& plan = *command.plan;
        if (command.rectangle)
            color_rectangle(plan, *command.rectangle);
        else
            color_triangle(plan, *command.triangle);
        if (plan.state.stage_count == 0)
            std::copy_n(batch_.diffuse.lanes, batch_.count * kBlockWidth, batch_.color.lanes);
        // Below about three live lanes of four, moving them is cheaper than reading textures for the dead ones.
        if (command.triangle && (plan.sample[0] || plan.sample[1]))
            plan.pack(batch_, 4 * alive_ > 3 * batch_lanes(), packed_);
        for (int i = 0; i < plan.state.stage_count; ++i) {
            if (plan.sample[i])
                command.rectangle ? sample_rectangle(plan, *command.rectangle, i)
                                  : sample_triangle(plan, *command.triangle, i);
            plan.combine.stage(plan.state.stages[i], plan.state.combine_rule, i, plan.state.constant, batch_);
        }
        if (plan.state.add_specular) plan.combine.add_specular(batch_);
        if (plan.state.fog) plan.combine.fog(plan.state.fog_rule, plan.state.fog_color, batch_);
    }

    void color_rectangle(const FillPlan& plan, const SetUpRectangle& rectangle) {
        if (plan.needs.diffuse) plan.interpolate.constant(rectangle.color, batch_, batch_.diffuse);
        if (plan.needs.specular) plan.interpolate.constant(Vertex{}.specular, batch_, batch_.specular);
    }

    void color_triangle(const FillPlan& plan, const SetUpTriangle& triangle) {
        const auto make = [&](bool varies, const std::array<Plane, 4>& planes, std::uint32_t flat,
                              BlockRows<std::uint32_t>& out) {
            if (!varies)
                plan.interpolate.constant(flat, batch_, out);
            else
                (plan.state.floor_colors ? plan.interpolate.floor_color : plan.interpolate.color)(planes, batch_, out);
        };
        if (plan.needs.diffuse) make(triangle.diffuse_varies, triangle.diffuse, triangle.flat_diffuse, batch_.diffuse);
        if (plan.needs.specular)
            make(triangle.specular_varies, triangle.specular, triangle.flat_specular, batch_.specular);
    }

    void sample_rectangle(const FillPlan& plan, const SetUpRectangle& rectangle, int i) {
        const SamplePlan& sampler = plan.samplers[i];
        if (plan.needs.texture[i]) plan.interpolate.rectangle_uv(rectangle.textures[i], sampler.lod_max(), batch_);
        plan.sample_rectangle[i](sampler, batch_.points, batch_.count, batch_.texel[i]);
    }

    void sample_triangle(const FillPlan& plan, const SetUpTriangle& triangle, int i) {
        const SamplePlan& sampler = plan.samplers[i];
        if (plan.needs.texture[i])
            plan.interpolate.triangle_uv(triangle.textures[i], sampler.lod_max(), batch_, packed_);
        const bool in_place = static_cast<std::uint64_t>(packed_.lanes) == batch_lanes();
        plan.sample[i](sampler, packed_.points, packed_.blocks(), in_place ? batch_.texel[i] : packed_.texel);
        if (in_place) return;
        for (int lane = 0; lane < packed_.lanes; ++lane)
            batch_.texel[i].lanes[packed_.index.lanes[lane]] = packed_.texel.lanes[lane];
    }

    std::uint64_t batch_lanes() const { return static_cast<std::uint64_t>(batch_.count) * kBlockWidth; }

    Image* color_;
    Image* depth_;
    FragmentBatch batch_{};
    PackedPoints packed_{};
    std::uint64_t alive_ = 0;
    FillCounts counts_;
};

}  // namespace

FillCounts fill_tile(std::span<const Command* const> commands, const Rect& tile, Image* color, Image* depth) {
    if (commands.empty()) return {};
    TileFill fill(color, depth);
    for (const Command* command : commands) fill.fill(*command, tile);
    return fill.counts();
}

}  // namespace raster
