// SPDX-License-Identifier: MIT
#include "tests/peers/compare_frame.h"

#include <optional>

#include "pipeline/execute/execute.h"
#include "tests/peers/gl_context.h"
#include "tests/peers/gl_executor.h"
#include "tests/peers/isolate.h"
#include "tests/peers/pass_limits.h"

namespace peers {

using namespace pipeline;

namespace {

// Where both pictures are on OpenGL's grid, the rounding of floats moves a corner by one step of that.
constexpr float kFineNudges[] = {-1.0f / 128.0f, -1.0f / 256.0f, 0.0f, 1.0f / 256.0f, 1.0f / 128.0f};

ColorImage draw_with_gl(const Frame& frame, std::optional<WindowTriangles> given) {
    GlExecutor executor(frame, given);
    for (std::size_t i = 0; i < frame.passes.size(); ++i) executor.draw_pass(i);
    return executor.read(frame.output);
}

LimitOptions options_of(Part part) {
    switch (part) {
        case Part::Whole:
            return {};
        case Part::Raster:
            return {.in_perspective = false, .same_edges = true, .excuses_ties = is_driver(Driver::Softpipe)};
        case Part::Vertices:
            return {.draw           = [](const Frame& frame) { return draw_with_gl(frame, WindowTriangles::Placed); },
                    .nudges         = kFineNudges,
                    .in_perspective = false,
                    .layers_of_neighbors = true};
    }
    return {};
}

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
        PassLimits limits(frame, i, before, options_of(part));
        Comparison comparison =
            compare(placed ? placed->read(pass.color) : ours, executor.read(pass.color), limits.limits());
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
