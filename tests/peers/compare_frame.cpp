// SPDX-License-Identifier: MIT
#include "tests/peers/compare_frame.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "pipeline/execute/execute.h"
#include "tests/peers/gl_context.h"
#include "tests/peers/gl_executor.h"
#include "tests/peers/isolate.h"
#include "tests/peers/pass_geometry.h"
#include "tests/peers/rounding.h"

namespace peers {

using namespace pipeline;

namespace {

// In pixels. The half steps are for what is thinner than a whole one.
constexpr float kNudges[]   = {-1.0f / 16.0f, -1.0f / 32.0f, 0.0f, 1.0f / 32.0f, 1.0f / 16.0f};
constexpr float kTexelNudge = 1.0f / 256.0f;  // texels

// Where both pictures are on OpenGL's grid, the rounding of floats moves a corner by one step of that.
constexpr float kFineNudges[] = {-1.0f / 128.0f, -1.0f / 256.0f, 0.0f, 1.0f / 256.0f, 1.0f / 128.0f};

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

ColorImage draw_with_gl(const Frame& frame, std::optional<WindowTriangles> given) {
    GlExecutor executor(frame, given);
    for (std::size_t i = 0; i < frame.passes.size(); ++i) executor.draw_pass(i);
    return executor.read(frame.output);
}

// The contents of all colour targets before each pass, and after the last.
std::vector<TargetPictures> pictures_of(const Frame& frame) {
    TargetPictures now;
    for (const Target& target : frame.targets) {
        const auto pixels        = static_cast<std::size_t>(target.width) * static_cast<std::size_t>(target.height);
        const std::uint32_t zero = target.format == TargetFormat::X8R8G8B8 ? 0xff000000 : 0;
        now.push_back(is_depth(target.format) ? nullptr
                                              : std::make_shared<const ColorImage>(ColorImage{
                                                    target.width, target.height, std::vector(pixels, zero)}));
    }
    std::vector<TargetPictures> pictures{now};
    execute(frame, {}, [&](const FinishedPass& finished) {
        if (const TargetId color = finished.pass.color)
            now[static_cast<std::size_t>(color.index)] = std::make_shared<const ColorImage>(finished.read_color());
        pictures.push_back(now);
    });
    return pictures;
}

class PassLimits {
  public:
    PassLimits(const Frame& frame, std::size_t index, const std::vector<TargetPictures>& before, Part part)
        : frame_(frame),
          pass_(frame.passes[index]),
          index_(index),
          before_(before),
          part_(part),
          error_(fragment_error(pass_)) {}

    std::vector<int> by_rounding() {
        const ColorImage counted = execute(count_layers(frame_, index_, before_)).output;
        width_                   = counted.width;
        for (const std::uint32_t count : counted.pixels) layers_.push_back(static_cast<int>(count & 255));
        if (part_ == Part::Vertices) layers_ = greatest_around(layers_, counted.width, counted.height);
        std::vector<int> allowed;
        for (const int layers : layers_) allowed.push_back(allowed_difference(pass_, error_, layers));
        most_allowed_ = *std::max_element(allowed.begin(), allowed.end());
        return allowed;
    }

    // Nothing where no fragment is.
    int with_perspective(int x, int y) {
        const double perspective  = part_ == Part::Whole ? geometry().perspective(x, y) : 0.0;
        const FragmentError error = fragment_error(pass_, perspective);
        alpha_error_              = std::max(alpha_error_, error.alpha);
        return allowed_difference(pass_, error, layers_[static_cast<std::size_t>(y * width_ + x)]);
    }

    Envelope envelope() const {
        Envelope envelope(drawn_with({}));
        for (const int reference : alpha_references()) {
            const auto& nudges = part_ == Part::Vertices ? kFineNudges : kNudges;
            for (const float y : nudges)
                for (const float x : nudges)
                    envelope.include(drawn_with({.x = x, .y = y, .alpha_reference = reference}));
            for (const float v : {-kTexelNudge, kTexelNudge})
                for (const float u : {-kTexelNudge, kTexelNudge})
                    envelope.include(drawn_with({.alpha_reference = reference, .u = u, .v = v}));
        }
        return envelope;
    }

    bool is_excused(int x, int y) {
        if (part_ == Part::Raster) return is_driver(Driver::Softpipe) && geometry().has_tie(x, y);
        return geometry().has_sliver(x, y) || geometry().has_depth_tie(x, y);
    }

    int at_edge(int x, int y) {
        if (part_ == Part::Raster || !geometry().has_edge(x, y)) return 0;
        const double perspective = part_ == Part::Whole ? geometry().perspective(x, y) : 0.0;
        return allowed_difference(pass_, fragment_error(pass_, perspective + geometry().displacement(x, y)),
                                  layers_around(x, y));
    }

    // Of a mean of differences. Between texels, at their common corner, one sum of four in four is a tie: up in ours, to
    // either side in OpenGL. Of perspective all is known but its sign.
    double explained_mean() {
        double mean = samples_between_texels() ? 1.0 / 8.0 : 0.0;
        if (part_ != Part::Whole || width_ == 0) return mean;
        double perspective = 0.0;
        for (std::size_t i = 0; i < layers_.size(); ++i)
            if (layers_[i] > 0)
                perspective += geometry().perspective(static_cast<int>(i) % width_, static_cast<int>(i) / width_);
        return mean + perspective / static_cast<double>(layers_.size());
    }

    int most_allowed() const { return most_allowed_; }

  private:
    ColorImage drawn_with(const Nudge& nudge) const {
        const Frame alone = isolate_pass(frame_, index_, before_, nudge);
        return part_ == Part::Vertices ? draw_with_gl(alone, WindowTriangles::Placed) : execute(alone).output;
    }

    // Another primitive than ours may be what the peer shows there.
    int layers_around(int x, int y) const {
        const int height = static_cast<int>(layers_.size()) / width_;
        int greatest     = 0;
        for (int j = std::max(0, y - 1); j <= std::min(height - 1, y + 1); ++j)
            for (int i = std::max(0, x - 1); i <= std::min(width_ - 1, x + 1); ++i)
                greatest = std::max(greatest, layers_[static_cast<std::size_t>(j * width_ + i)]);
        return greatest;
    }

    bool samples_between_texels() const {
        const auto& stages = pass_.state.stages;
        return std::any_of(stages.begin(), stages.begin() + stage_count(pass_.state),
                           [](const TextureStage& stage) { return stage.filter == TextureFilter::Linear; });
    }

    const PassGeometry& geometry() {
        if (!geometry_) geometry_.emplace(frame_, index_);
        return *geometry_;
    }

    std::vector<int> alpha_references() const {
        if (pass_.state.alpha_test.func == CompareFunc::Always) return {0};
        const int units = static_cast<int>(std::ceil(alpha_error_));
        return {-units, 0, units};
    }

    const Frame& frame_;
    const Pass& pass_;
    std::size_t index_;
    const std::vector<TargetPictures>& before_;
    Part part_;
    FragmentError error_;
    double alpha_error_ = error_.alpha;  // the greatest, as far as is known
    int most_allowed_   = 0;
    std::vector<int> layers_;  // by pixel
    int width_ = 0;
    std::optional<PassGeometry> geometry_;
};

}  // namespace

std::vector<PassComparison> compare_passes(const Frame& frame, const Frame& peers, Part part) {
    const std::vector<TargetPictures> before = pictures_of(frame);
    GlExecutor executor(peers, part == Part::Raster ? std::optional(WindowTriangles::Snapped) : std::nullopt);
    std::optional<GlExecutor> placed;
    if (part == Part::Vertices) placed.emplace(frame, WindowTriangles::Placed);
    std::vector<PassComparison> result;
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        executor.draw_pass(i);
        if (placed) placed->draw_pass(i);
        const Pass& pass = frame.passes[i];
        if (!pass.color) continue;
        const ColorImage& ours = *before[i + 1][static_cast<std::size_t>(pass.color.index)];
        PassLimits limits(frame, i, before, part);
        Comparison comparison =
            compare(placed ? placed->read(pass.color) : ours, executor.read(pass.color),
                    {.by_rounding      = [&] { return limits.by_rounding(); },
                     .with_perspective = [&](int x, int y) { return limits.with_perspective(x, y); },
                     .envelope         = [&] { return limits.envelope(); },
                     .at_edge          = [&](int x, int y) { return limits.at_edge(x, y); },
                     .is_excused       = [&](int x, int y) { return limits.is_excused(x, y); }});
        if (leans(comparison)) comparison.explained_mean = limits.explained_mean();
        result.push_back({pass.label, comparison, limits.most_allowed()});
        executor.write(pass.color, ours);
        if (placed) placed->write(pass.color, ours);
    }
    return result;
}

Comparison total(const std::vector<PassComparison>& passes) {
    Comparison sum;
    for (const PassComparison& pass : passes) sum.add(pass.comparison);
    return sum;
}

}  // namespace peers
