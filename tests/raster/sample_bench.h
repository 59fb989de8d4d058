// SPDX-License-Identifier: MIT
// Reads one sampler at up to 256 points, on all instruction sets, as compiled for any sampler and, if there is one, for
// that of a special program, and fails at the first point that is not what is wanted. Points that are set as rows are
// read in both ways, that of triangles and that of rectangles.
#pragma once

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "raster/fill_plan.h"
#include "raster/reference_texture.h"
#include "tests/raster/exact.h"
#include "tests/raster/fill_steps.h"
#include "tests/raster/simd_kernels.h"

namespace sample_bench {

using simd_kernels::kLanes;

class SampleBench {
  public:
    explicit SampleBench(const raster::Sampler& sampler)
        : sampler_(sampler),
          program_(program_of(sampler)),
          plan_(raster::plan_sampler(sampler, program_.alpha_quads)),
          samples_(simd_kernels::of_every_kind(
              [&](fill_steps::Kind kind) { return fill_steps::sample_step(program_, kind); })),
          rows_samples_(simd_kernels::of_every_kind(
              [&](fill_steps::Kind kind) { return fill_steps::sample_rows_step(program_, kind); })) {}

    // By lane: u, v in 1/256 texel, lod in 1/256 level.
    fill_steps::SamplePoints& points() { return *points_; }
    std::uint32_t* want() { return want_.data(); }
    std::size_t batches() const { return batches_; }
    bool has_special_kernels() const { return samples_.size() > pipeline::simd_targets().size(); }

    // The points of a block: u is start at its first lane and advances by step, both in 1/65536 texel.
    void set_row(int block, std::int32_t start, std::int32_t step, std::int32_t v) {
        rows_->start[block] = start;
        rows_->step[block]  = step;
        rows_->v[block]     = v;
        for (int lane = 0; lane < raster::kBlockWidth; ++lane) {
            const int i   = block * raster::kBlockWidth + lane;
            const auto u  = static_cast<std::int32_t>(static_cast<std::uint32_t>(start + std::int64_t{step} * lane));
            points_->u[i] = exact::floor_quotient(u, 256);
            points_->v[i] = v;
        }
    }

    // What is slow is left out on demand.
    void run_points(int blocks, bool slow_too) {
        ++batches_;
        const int lanes = blocks * raster::kBlockWidth;
        for (const auto& [name, sample, is_fallback] : samples_) {
            if (is_fallback && !slow_too) continue;
            sample(program_, plan_, *points_, blocks, *out_);
            check(name, lanes);
        }
        if (!slow_too) return;
        for (int i = 0; i < lanes; ++i)
            check_lane("reference", i,
                       raster::reference::sample(sampler_, {points_->u[i], points_->v[i], points_->lod[i]}));
    }
    void run_rows(int blocks, bool slow_too) {
        run_points(blocks, slow_too);
        for (const auto& [name, sample, is_fallback] : rows_samples_) {
            if (is_fallback && !slow_too) continue;
            sample(program_, plan_, *rows_, blocks, *out_);
            check(name + " for rectangles", blocks * raster::kBlockWidth);
        }
    }

  private:
    static raster::TextureProgram program_of(const raster::Sampler& sampler) {
        raster::FillState state;
        state.stage_count       = 1;
        state.stages[0].color.a = {.source = raster::CombineArg::Source::Texel};
        state.samplers[0]       = sampler;
        return raster::plan_fill(state, true, {}, 24).program.textures[0];
    }

    void check(const std::string& name, int lanes) const {
        if (std::equal(out_->begin(), out_->begin() + lanes, want_.begin())) return;
        for (int i = 0; i < lanes; ++i) check_lane(name, i, (*out_)[i]);
    }
    void check_lane(const std::string& name, int i, std::uint32_t got) const {
        if (got == want_[i]) return;
        std::array<char, 120> text{};
        std::snprintf(text.data(), text.size(), "lane %d u %d v %d lod %d: got %08x want %08x", i, points_->u[i],
                      points_->v[i], points_->lod[i], got, want_[i]);
        FAIL(name << ": filter rule " << static_cast<int>(sampler_.rule) << (sampler_.linear ? " linear" : " point")
                  << ", level 0 " << sampler_.levels[0].width << " wide, " << text.data());
    }

    raster::Sampler sampler_;
    raster::TextureProgram program_;
    raster::SamplePlan plan_;
    std::vector<simd_kernels::Named<fill_steps::Sample>> samples_;
    std::vector<simd_kernels::Named<fill_steps::SampleRowsStep>> rows_samples_;
    std::unique_ptr<fill_steps::SamplePoints> points_ = std::make_unique<fill_steps::SamplePoints>();
    std::unique_ptr<fill_steps::SampleRows> rows_     = std::make_unique<fill_steps::SampleRows>();
    std::unique_ptr<fill_steps::Colors> out_          = std::make_unique<fill_steps::Colors>();
    std::array<std::uint32_t, kLanes> want_{};
    std::size_t batches_ = 0;
};

}  // namespace sample_bench
