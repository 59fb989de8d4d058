// SPDX-License-Identifier: MIT
// Runs the blend kernels of one state, all instruction sets and both kinds (for this state, and for all states of its
// rule), on one batch of 256 pixels, and fails at the first pixel that is not what is wanted.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "raster/blend_blocks.h"
#include "raster/reference_color.h"
#include "tests/raster/blend_formula.h"
#include "tests/raster/simd_kernels.h"

namespace blend_bench {

using simd_kernels::kLanes;

class BlendBench {
  public:
    explicit BlendBench(const raster::Blend& blend, const raster::ColorFormat& format = {})
        : format_(format), plan_(raster::plan_blend(blend, format)), target_(kLanes, 8) {
        for (const bool generic : {false, true})
            for (auto& [name, kernel, fallback] :
                 simd_kernels::on_every_target([&] { return raster::blend_kernel(plan_, generic); }))
                kernels_.push_back({name + (generic ? " generic" : ""), kernel, fallback});
        batch_->count = raster::kBatchBlocks;
        std::fill_n(batch_->mask.lanes, kLanes, 0xffffffff);
    }
    const raster::Blend& blend() const { return plan_.blend; }
    std::size_t batches() const { return batches_; }

    // The batch, by lane. Lane i is pixel (i, y).
    std::uint32_t* source() { return batch_->color.lanes; }
    std::uint32_t* mask() { return batch_->mask.lanes; }
    std::uint32_t* dest() { return dest_.data(); }
    std::uint32_t* want() { return want_.data(); }  // before the lanes' mask
    void want_formula(int y) {
        for (int i = 0; i < kLanes; ++i)
            want_[i] = blend_formula::blended(blend(), format_, source()[i], dest_[i], i, y);
    }

    // What is slow is left out on demand.
    struct Slow {
        bool reference = true, fallback = true;
    };
    void run(int y, Slow slow) {
        ++batches_;
        for (int block = 0; block < raster::kBatchBlocks; ++block) batch_->at[block] = {block * raster::kBlockWidth, y};
        if (slow.reference)
            for (int i = 0; i < kLanes; ++i)
                check_lane("reference", i, y, want_[i],
                           raster::reference::blended_color(blend(), format_, source()[i], dest_[i], i, y));
        for (int i = 0; i < kLanes; ++i) want_[i] = (want_[i] & mask()[i]) | (dest_[i] & ~mask()[i]);
        for (const auto& [name, kernel, is_fallback] : kernels_) {
            if (is_fallback && !slow.fallback) continue;
            std::uint32_t* const row = target_.row(y);
            std::copy_n(dest(), kLanes, row);
            kernel(plan_, target_, *batch_);
            if (std::equal(row, row + kLanes, want())) continue;
            for (int i = 0; i < kLanes; ++i) check_lane(name, i, y, want_[i], row[i]);
        }
    }

  private:
    void check_lane(const std::string& name, int lane, int y, std::uint32_t want, std::uint32_t got) {
        if (got == want) return;
        std::array<char, 160> text{};
        std::snprintf(text.data(), text.size(),
                      "pixel (%d, %d) source %08x dest %08x mask %08x write mask %08x: got %08x want %08x", lane, y,
                      source()[lane], dest_[lane], mask()[lane], blend().write_mask, got, want);
        FAIL(name << ": " << blend_formula::name_of(blend()) << ", format R" << format_.red << " G" << format_.green
                  << " B" << format_.blue << " A" << format_.alpha << (format_.zero_fill ? " zero fill" : "") << ", "
                  << text.data());
    }

    raster::ColorFormat format_;
    raster::BlendPlan plan_;
    std::vector<simd_kernels::Named<raster::BlendKernel>> kernels_;
    raster::Image target_;
    std::unique_ptr<raster::FragmentBatch> batch_ = std::make_unique<raster::FragmentBatch>();
    std::array<std::uint32_t, kLanes> dest_{}, want_{};
    std::size_t batches_ = 0;
};

}  // namespace blend_bench
