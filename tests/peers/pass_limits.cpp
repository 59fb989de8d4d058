// SPDX-License-Identifier: MIT
#include "tests/peers/pass_limits.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pipeline/execute/execute.h"

namespace peers {

using namespace pipeline;

namespace {

constexpr float kTexelNudge = 1.0f / 256.0f;  // texels
constexpr double kDiagonal  = 1.42;           // along both axes, of a step along each

// Of each value and its eight neighbours, and at least 1: on another grid another primitive may be there, or one where
// we have none.
std::vector<int> greatest_around(const std::vector<int>& values, int width, int height) {
    std::vector<int> greatest(values.size(), 1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int j = std::max(0, y - 1); j <= std::min(height - 1, y + 1); ++j)
                for (int i = std::max(0, x - 1); i <= std::min(width - 1, x + 1); ++i) {
                    int& value = greatest[static_cast<std::size_t>(y * width + x)];
                    value      = std::max(value, values[static_cast<std::size_t>(j * width + i)]);
                }
    return greatest;
}

}  // namespace

PassLimits::PassLimits(const Frame& frame, std::size_t index, const std::vector<TargetPictures>& before,
                       LimitOptions options)
    : frame_(frame),
      pass_(frame.passes[index]),
      index_(index),
      before_(before),
      options_(std::move(options)),
      error_(fragment_error(pass_)) {}

Limits PassLimits::limits() {
    return {.by_rounding      = [this] { return by_rounding(); },
            .with_perspective = [this](int x, int y) { return with_perspective(x, y); },
            .envelope         = [this] { return envelope(); },
            .of_nudged        = [this](int x, int y) { return of_nudged(x, y); },
            .at_edge          = [this](int x, int y) { return at_edge(x, y); },
            .is_excused       = [this](int x, int y) { return is_excused(x, y); }};
}

std::vector<int> PassLimits::by_rounding() {
    const ColorImage counted = execute(count_layers(frame_, index_, before_)).output;
    width_                   = counted.width;
    for (const std::uint32_t count : counted.pixels) layers_.push_back(static_cast<int>(count & 255));
    if (options_.layers_of_neighbors) layers_ = greatest_around(layers_, counted.width, counted.height);
    std::vector<int> allowed;
    for (const int layers : layers_) allowed.push_back(allowed_difference(pass_, error_, layers));
    most_allowed_ = *std::max_element(allowed.begin(), allowed.end());
    return allowed;
}

// Nothing where no fragment is.
int PassLimits::with_perspective(int x, int y) {
    const double perspective  = options_.in_perspective ? geometry().perspective(x, y) : 0.0;
    const FragmentError error = fragment_error(pass_, perspective);
    alpha_error_              = std::max(alpha_error_, error.alpha);
    return allowed_difference(pass_, error, layers_[static_cast<std::size_t>(y * width_ + x)]);
}

Envelope PassLimits::envelope() const {
    Envelope envelope(drawn_with({}));
    for (const int reference : alpha_references()) {
        for (const float y : options_.nudges)
            for (const float x : options_.nudges)
                envelope.include(drawn_with({.x = x, .y = y, .alpha_reference = reference}));
        for (const float v : {-kTexelNudge, kTexelNudge})
            for (const float u : {-kTexelNudge, kTexelNudge})
                envelope.include(drawn_with({.alpha_reference = reference, .u = u, .v = v}));
    }
    return envelope;
}

bool PassLimits::is_excused(int x, int y) {
    if (options_.same_edges) return options_.excuses_ties && geometry().has_tie(x, y);
    return geometry().has_sliver(x, y) || geometry().has_depth_tie(x, y);
}

// What only a nudge shows may be the one fragment anywhere near.
int PassLimits::of_nudged(int x, int y) {
    const bool has_edge = !options_.same_edges && geometry().has_edge(x, y);
    return allowed_within(has_edge ? kDiagonal * double{options_.nudges.back()} : 0.0, x, y,
                          std::max(1, layers_around(x, y)));
}

int PassLimits::at_edge(int x, int y) {
    if (options_.same_edges || !geometry().has_edge(x, y)) return 0;
    return allowed_within(geometry().reach(), x, y, layers_around(x, y));
}

// Where colours are displaced by as many pixels.
int PassLimits::allowed_within(double pixels, int x, int y, int layers) {
    const double perspective = options_.in_perspective ? geometry().perspective(x, y) : 0.0;
    const double change      = pixels > 0.0 ? geometry().change_within(pixels, x, y) : 0.0;
    return allowed_difference(pass_, fragment_error(pass_, perspective + change), layers);
}

// Of a mean of differences. Between texels, at their common corner, one sum of four in four is a tie: up in ours, to
// either side in OpenGL. Of perspective all is known but its sign.
double PassLimits::explained_mean() {
    double mean = samples_between_texels() ? 1.0 / 8.0 : 0.0;
    if (!options_.in_perspective || width_ == 0) return mean;
    double perspective = 0.0;
    for (std::size_t i = 0; i < layers_.size(); ++i)
        if (layers_[i] > 0)
            perspective += geometry().perspective(static_cast<int>(i) % width_, static_cast<int>(i) / width_);
    return mean + perspective / static_cast<double>(layers_.size());
}

ColorImage PassLimits::drawn_with(const Nudge& nudge) const {
    const Frame alone = isolate_pass(frame_, index_, before_, nudge);
    return options_.draw ? options_.draw(alone) : execute(alone).output;
}

// Another primitive than ours may be what the peer shows there.
int PassLimits::layers_around(int x, int y) const {
    const int height = static_cast<int>(layers_.size()) / width_;
    int greatest     = 0;
    for (int j = std::max(0, y - 1); j <= std::min(height - 1, y + 1); ++j)
        for (int i = std::max(0, x - 1); i <= std::min(width_ - 1, x + 1); ++i)
            greatest = std::max(greatest, layers_[static_cast<std::size_t>(j * width_ + i)]);
    return greatest;
}

bool PassLimits::samples_between_texels() const {
    const auto& stages = pass_.state.stages;
    return std::any_of(stages.begin(), stages.begin() + stage_count(pass_.state),
                       [](const TextureStage& stage) { return stage.filter == TextureFilter::Linear; });
}

const PassGeometry& PassLimits::geometry() {
    if (!geometry_) geometry_.emplace(frame_, index_);
    return *geometry_;
}

std::vector<int> PassLimits::alpha_references() const {
    if (pass_.state.alpha_test.func == CompareFunc::Always) return {0};
    const int units = static_cast<int>(std::ceil(alpha_error_));
    return {-units, 0, units};
}

}  // namespace peers
