// SPDX-License-Identifier: MIT
// Runs the blend of one state, on all instruction sets, as it is compiled for any state and, if there is one, for a
// special program, on 256 pixels, and fails at the first that is not what is wanted.
#pragma once

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "raster/reference_color.h"
#include "tests/raster/blend_formula.h"
#include "tests/raster/fill_steps.h"
#include "tests/raster/simd_kernels.h"

namespace blend_bench {

using simd_kernels::kLanes;

class BlendBench {
  public:
    // state: what is drawn, of which only the alpha test and the blend matter.
    explicit BlendBench(const raster::FillState& state, const raster::ColorFormat& format = {})
        : format_(format),
          blend_(state.blend),
          plan_(raster::plan_fill(state, true, format, 24, true)),
          kernels_(simd_kernels::of_every_kind(
              [&](fill_steps::Kind kind) { return fill_steps::shade_step(plan_.program, kind); })) {
        fragments_->live.fill(0xffff);
    }
    explicit BlendBench(const raster::Blend& blend, const raster::ColorFormat& format = {})
        : BlendBench(state_of(blend), format) {}

    const raster::Blend& blend() const { return blend_; }
    std::size_t batches() const { return batches_; }
    std::size_t special_kernels() const { return kernels_.size() - pipeline::simd_targets().size(); }

    // By lane. Lane i is pixel (i, y).
    std::uint32_t* source() { return fragments_->color.data(); }
    std::uint32_t* dest() { return dest_.data(); }
    std::uint32_t* want() { return want_.data(); }
    // The bits of the target that a fragment may change: all at first. What is left is up to the state's alpha test.
    std::uint32_t* mask() { return mask_.data(); }
    void set_live(int lane, bool is) { fragments_->set_live(lane, is); }
    bool is_live(int lane) const { return fragments_->is_live(lane); }

    void want_formula(int y) {
        for (int i = 0; i < kLanes; ++i)
            want_[i] = blend_formula::blended(blend_, format_, source()[i], dest_[i], i, y);
    }

    // What is slow is left out on demand.
    struct Slow {
        bool reference = true, fallback = true;
    };
    void run(int y, Slow slow) {
        ++batches_;
        fragments_->y = y;
        if (slow.reference)
            for (int i = 0; i < kLanes; ++i)
                check_lane("reference", i, want_[i],
                           raster::reference::blended_color(blend_, format_, source()[i], dest_[i], i, y));
        for (int i = 0; i < kLanes; ++i) {
            const std::uint32_t mask = is_live(i) ? mask_[i] : 0;
            want_[i]                 = (want_[i] & mask) | (dest_[i] & ~mask);
        }
        for (const auto& [name, kernel, is_fallback] : kernels_) {
            if (is_fallback && !slow.fallback) continue;
            targets_->color = dest_;
            raster::FillCounts counts;
            kernel(plan_, *fragments_, *targets_, counts);
            if (targets_->color == want_) continue;
            for (int i = 0; i < kLanes; ++i) check_lane(name, i, want_[i], targets_->color[i]);
        }
    }

  private:
    static raster::FillState state_of(const raster::Blend& blend) {
        raster::FillState state;
        state.blend = blend;
        return state;
    }
    static fill_steps::Colors all_bits() {
        fill_steps::Colors mask;
        mask.fill(0xffffffff);
        return mask;
    }

    void check_lane(const std::string& name, int lane, std::uint32_t want, std::uint32_t got) {
        if (got == want) return;
        std::array<char, 160> text{};
        std::snprintf(text.data(), text.size(),
                      "pixel (%d, %d) source %08x dest %08x mask %08x write mask %08x: got %08x want %08x", lane,
                      fragments_->y, source()[lane], dest_[lane], is_live(lane) ? mask_[lane] : 0, blend_.write_mask,
                      got, want);
        FAIL(name << ": " << blend_formula::name_of(blend_) << ", format R" << format_.red << " G" << format_.green
                  << " B" << format_.blue << " A" << format_.alpha << (format_.zero_fill ? " zero fill" : "") << ", "
                  << text.data());
    }

    raster::ColorFormat format_;
    raster::Blend blend_;
    raster::FillPlan plan_;
    std::vector<simd_kernels::Named<fill_steps::Shade>> kernels_;
    std::unique_ptr<fill_steps::Fragments> fragments_ = std::make_unique<fill_steps::Fragments>();
    std::unique_ptr<fill_steps::Targets> targets_     = std::make_unique<fill_steps::Targets>();
    fill_steps::Colors dest_{}, want_{}, mask_ = all_bits();
    std::size_t batches_ = 0;
};

}  // namespace blend_bench
