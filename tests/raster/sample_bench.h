// SPDX-License-Identifier: MIT
// Runs the sampling kernels of one sampler, all instruction sets, on up to 256 points, and fails at the first that is
// not what is wanted. Points of a block must have one v and an evenly advancing u if the kernel for rectangles is to
// run too.
#pragma once

#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "raster/reference_texture.h"
#include "raster/sample_blocks.h"
#include "tests/raster/simd_kernels.h"

namespace sample_bench {

using simd_kernels::kLanes;

enum class Kernels { Any, AndRectangles };

class SampleBench {
  public:
    SampleBench(const raster::Sampler& sampler, Kernels kernels)
        : sampler_(sampler), plan_(raster::plan_sampler(sampler)) {
        targets_ = simd_kernels::on_every_target([&] { return raster::sample_kernel(plan_); });
        if (kernels == Kernels::Any) return;
        for (auto& [name, kernel, fallback] :
             simd_kernels::on_every_target([&] { return raster::sample_rectangle_kernel(plan_); }))
            targets_.push_back({name + " for rectangles", kernel, fallback});
    }
    raster::SamplePoints& points() { return *points_; }
    std::uint32_t* want() { return want_.data(); }
    std::size_t batches() const { return batches_; }

    // What is slow is left out on demand.
    void run(int blocks, bool slow_too) {
        ++batches_;
        const int lanes = blocks * raster::kBlockWidth;
        for (const auto& [name, kernel, is_fallback] : targets_) {
            if (is_fallback && !slow_too) continue;
            kernel(plan_, *points_, blocks, *out_);
            if (!std::equal(want(), want() + lanes, out_->lanes))
                for (int i = 0; i < lanes; ++i) check_lane(name, i, out_->lanes[i]);
        }
        if (slow_too)
            for (int i = 0; i < lanes; ++i)
                check_lane("reference", i,
                           raster::reference::sample(
                               sampler_, {points_->u.lanes[i], points_->v.lanes[i], points_->lod.lanes[i]}));
    }

  private:
    void check_lane(const std::string& name, int i, std::uint32_t got) {
        if (got == want_[i]) return;
        std::array<char, 120> text{};
        std::snprintf(text.data(), text.size(), "lane %d u %d v %d lod %d: got %08x want %08x", i, points_->u.lanes[i],
                      points_->v.lanes[i], points_->lod.lanes[i], got, want_[i]);
        FAIL(name << ": filter rule " << static_cast<int>(sampler_.rule) << (sampler_.linear ? " linear" : " point")
                  << ", level 0 " << sampler_.levels[0].width << " wide, " << text.data());
    }

    raster::Sampler sampler_;
    raster::SamplePlan plan_;
    std::vector<simd_kernels::Named<raster::SampleKernel>> targets_;
    std::unique_ptr<raster::SamplePoints> points_          = std::make_unique<raster::SamplePoints>();
    std::unique_ptr<raster::BlockRows<std::uint32_t>> out_ = std::make_unique<raster::BlockRows<std::uint32_t>>();
    std::array<std::uint32_t, kLanes> want_{};
    std::size_t batches_ = 0;
};

}  // namespace sample_bench
