// SPDX-License-Identifier: MIT
// The limits of compare.h for a pass of a frame, from its own formulas and geometry: what roundings, perspective, edges and
// ties may make of each pixel in the picture of a peer that follows the same rules.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "pipeline/frame/frame.h"
#include "tests/peers/compare.h"
#include "tests/peers/isolate.h"
#include "tests/peers/pass_geometry.h"
#include "tests/peers/rounding.h"

namespace peers {

// In pixels. The half steps are for what is thinner than a whole one.
inline constexpr float kNudges[] = {-1.0f / 16.0f, -1.0f / 32.0f, 0.0f, 1.0f / 32.0f, 1.0f / 16.0f};

struct LimitOptions {
    std::function<pipeline::ColorImage(const pipeline::Frame&)> draw;  // what nudges are seen in; ours if empty
    std::span<const float> nudges = kNudges;
    bool in_perspective           = true;   // the peer interpolates colours so, the frame does not
    bool same_edges               = false;  // the peer has our grid: no edge or surface may differ
    bool excuses_ties             = false;  // with same edges, but for centres exactly on one
    bool layers_of_neighbors      = false;  // another primitive may be seen at any pixel
};

class PassLimits {
  public:
    // All but the options outlive this.
    PassLimits(const pipeline::Frame& frame, std::size_t index, const std::vector<TargetPictures>& before,
               LimitOptions options = {});

    // Refers to this.
    Limits limits();

    // Of a mean of differences.
    double explained_mean();

    // Units, at any pixel; 0 before a pixel differs.
    int most_allowed() const { return most_allowed_; }

  private:
    std::vector<int> by_rounding();
    int with_perspective(int x, int y);
    Envelope envelope() const;
    bool is_excused(int x, int y);
    int of_nudged(int x, int y);
    int at_edge(int x, int y);
    int allowed_within(double pixels, int x, int y, int layers);
    pipeline::ColorImage drawn_with(const Nudge& nudge) const;
    int layers_around(int x, int y) const;
    bool samples_between_texels() const;
    const PassGeometry& geometry();
    std::vector<int> alpha_references() const;

    const pipeline::Frame& frame_;
    const pipeline::Pass& pass_;
    std::size_t index_;
    const std::vector<TargetPictures>& before_;
    LimitOptions options_;
    FragmentError error_;
    double alpha_error_ = error_.alpha;  // the greatest, as far as is known
    int most_allowed_   = 0;
    std::vector<int> layers_;  // by pixel
    int width_ = 0;
    std::optional<PassGeometry> geometry_;
};

}  // namespace peers
