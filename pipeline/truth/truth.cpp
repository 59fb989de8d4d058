// SPDX-License-Identifier: MIT
#include "pipeline/truth/truth.h"

#include <stdexcept>

#include "pipeline/truth/blur_chain.h"
#include "pipeline/truth/draw_pass.h"

namespace pipeline {
namespace {

using namespace truth;

Samples zeros(const Target& target, int per_axis) {
    Samples out{.width = target.width, .height = target.height, .per_axis = per_axis, .color = {}, .depth = {}};
    const std::size_t count = static_cast<std::size_t>(out.columns()) * static_cast<std::size_t>(out.rows());
    if (is_depth(target.format)) {
        out.depth.assign(count, 0.0);
        return out;
    }
    out.color.assign(count, Color(0.0, 0.0, 0.0, has_alpha(target.format) ? 0.0 : missing_alpha(target.format)));
    return out;
}

TruthPicture picture_of(const Samples& samples) {
    TruthPicture out{.width = samples.width, .height = samples.height, .pixels = {}};
    const int n = samples.per_axis;
    for (int y = 0; y < samples.height; ++y)
        for (int x = 0; x < samples.width; ++x) {
            Color sum(0.0);
            for (int i = 0; i < n * n; ++i) sum += samples.color[samples.at(x * n + i % n, y * n + i / n)];
            sum /= n * n;
            out.pixels.push_back({sum.r, sum.g, sum.b, sum.a});
        }
    return out;
}

}  // namespace

TruthPicture draw_truth(const Frame& frame, const TruthOptions& options) {
    if (options.samples_per_axis < 1 || options.samples_per_axis > 16)
        throw std::invalid_argument("samples_per_axis must lie within 1..16 (got " +
                                    std::to_string(options.samples_per_axis) + ')');
    const SampleGrid grid{options.samples_per_axis, frame.arithmetic.pixel_center / 16.0};
    std::vector<Samples> targets;
    for (const Target& target : frame.targets) targets.push_back(zeros(target, grid.per_axis));

    std::vector<BlurChain> chains;
    if (options.true_gaussian) chains = find_blur_chains(frame);
    auto chain = chains.begin();
    Samples source;  // of the chain that is being drawn, as it was before
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        if (chain != chains.end() && chain->first == i) source = targets[static_cast<std::size_t>(chain->source.index)];
        draw_pass(frame, frame.passes[i], grid, targets);
        if (chain == chains.end() || chain->last != i) continue;
        const auto target = static_cast<std::size_t>(chain->target.index);
        draw_gaussian(*chain, source, has_alpha(frame.targets[target].format), targets[target]);
        ++chain;
    }
    return picture_of(targets[static_cast<std::size_t>(frame.output.index)]);
}

}  // namespace pipeline
