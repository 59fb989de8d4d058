// SPDX-License-Identifier: MIT
#include "pipeline/truth/blur_chain.h"

#include <cmath>
#include <optional>

#include "pipeline/truth/draw_pass.h"

namespace pipeline::truth {
namespace {

// Along one axis: a point x of the target reads `scale * x + start` of the source, both in pixels.
struct Mapping {
    double scale = 1.0, start = 0.0;
    double at(double x) const { return scale * x + start; }
};
bool agree(const Mapping& a, const Mapping& b, double x) {
    return std::abs(a.scale - b.scale) < 1e-3 * std::abs(a.scale) && std::abs(a.at(x) - b.at(x)) < 1.0 / 32.0;
}

// A pass that may be one of a chain.
struct Blit {
    TargetId source, target;
    std::array<Mapping, 2> mapping;
    std::vector<PixelRect> drawn;  // of each rectangle
};

bool is_plain(const PipelineState& state) {
    const TextureStage& stage = state.stages[0];
    const TextureArg texture{.source = ArgSource::Texture};
    return state.blend == kReplace && state.gs_blend == GsBlend{} && state.color_mask == ColorMask{} &&
           state.depth == DepthState{} && state.alpha_test.func == CompareFunc::Always &&
           state.dest_alpha_test == DestAlphaTest::Off && !state.lighting.specular_enable && stage_count(state) == 1 &&
           stage.color_op == TextureOp::SelectArg1 && stage.alpha_op == TextureOp::SelectArg1 &&
           stage.color_arg1 == texture && stage.alpha_arg1 == texture && stage.filter == TextureFilter::Linear &&
           stage.address_u == TextureAddress::Clamp && stage.address_v == TextureAddress::Clamp;
}

Mapping mapping_of(double x0, double x1, double u0, double u1, int size) {
    const double scale = (u1 - u0) * size / (x1 - x0);
    return {scale, u0 * size - scale * x0};
}

// Pixels from the first whose point is not before `from`.
int first_pixel(double from, double center) {
    return static_cast<int>(std::ceil(from - center));
}

std::optional<Blit> blit_of(const Frame& frame, const Pass& pass) {
    if (pass.draws.empty() || pass.clear != Clear{} || !pass.color || !is_plain(pass.state)) return std::nullopt;
    const double center = frame.arithmetic.pixel_center / 16.0;
    Blit blit{.target = pass.color};
    for (const Draw& draw : pass.draws) {
        const auto* r = std::get_if<DrawRectangle>(&draw);
        if (r == nullptr || !r->textures[0].target || r->x0 >= r->x1 || r->y0 >= r->y1) return std::nullopt;
        if (blit.source && blit.source != r->textures[0].target) return std::nullopt;
        blit.source          = r->textures[0].target;
        const Target& source = frame.targets[static_cast<std::size_t>(blit.source.index)];
        const Mapping x      = mapping_of(r->x0, r->x1, r->uv[0].u0, r->uv[0].u1, source.width);
        const Mapping y      = mapping_of(r->y0, r->y1, r->uv[0].v0, r->uv[0].v1, source.height);
        if (blit.drawn.empty()) blit.mapping = {x, y};
        if (!(x.scale > 0.0) || !(y.scale > 0.0) || !agree(x, blit.mapping[0], r->x0) ||
            !agree(y, blit.mapping[1], r->y0))
            return std::nullopt;
        blit.drawn.push_back(
            intersected(drawn_area(frame, pass), {first_pixel(r->x0, center), first_pixel(r->y0, center),
                                                  first_pixel(r->x1, center), first_pixel(r->y1, center)}));
        if (blit.drawn.back().x0 >= blit.drawn.back().x1 || blit.drawn.back().y0 >= blit.drawn.back().y1)
            blit.drawn.pop_back();
    }
    if (blit.drawn.empty()) return std::nullopt;
    return blit;
}

// The mean of f(1-f) over pixels first..end-1.
double variance_of(const Mapping& mapping, int first, int end, double center) {
    double sum = 0.0;
    for (int x = first; x < end; ++x) {
        const double texel = mapping.at(x + center) - 0.5;
        const double f     = texel - std::floor(texel);
        sum += f * (1.0 - f);
    }
    return sum / (end - first);
}

// What a blit reads for the pixels `drawn`, within its source.
PixelRect read_by(const Blit& blit, const PixelRect& drawn, const Target& source) {
    // What a few hundredths of a texel reach into does not count: coordinates are floats.
    const auto low  = [](const Mapping& m, int x) { return static_cast<int>(std::floor(m.at(x) + 0.05)); };
    const auto high = [](const Mapping& m, int x) { return static_cast<int>(std::ceil(m.at(x) - 0.05)); };
    return intersected({low(blit.mapping[0], drawn.x0), low(blit.mapping[1], drawn.y0), high(blit.mapping[0], drawn.x1),
                        high(blit.mapping[1], drawn.y1)},
                       {0, 0, source.width, source.height});
}

bool holds(const PixelRect& rect, double x, double y) {
    return rect.x0 <= x && x < rect.x1 && rect.y0 <= y && y < rect.y1;
}

// The chain of a run of blits, if it is one. first: its place among the passes.
std::optional<BlurChain> chain_of(const Frame& frame, const std::vector<Blit>& run, std::size_t first) {
    const double center = frame.arithmetic.pixel_center / 16.0;
    BlurChain chain{
        .first = first, .last = first + run.size() - 1, .source = run.front().source, .target = run.back().target};
    std::array<Mapping, 2> whole;  // from the blit's target to the chain's source
    for (const Blit& blit : run)
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const PixelRect& drawn = blit.drawn.front();
            const Mapping& step    = blit.mapping[axis];
            const int from = axis == 0 ? drawn.x0 : drawn.y0, to = axis == 0 ? drawn.x1 : drawn.y1;
            chain.variance[axis] += whole[axis].scale * whole[axis].scale * variance_of(step, from, to, center);
            whole[axis] = {whole[axis].scale * step.scale, whole[axis].at(step.start)};
        }
    const Target& source = frame.targets[static_cast<std::size_t>(chain.source.index)];
    for (const PixelRect& written : run.back().drawn) {
        const double x = (written.x0 + written.x1) / 2.0, y = (written.y0 + written.y1) / 2.0;
        for (const PixelRect& drawn : run.front().drawn) {
            const PixelRect read = read_by(run.front(), drawn, source);
            if (!holds(read, whole[0].at(x), whole[1].at(y))) continue;
            chain.areas.push_back({read, written});
            break;
        }
        chain.shift = {whole[0].at(x + center) - x - 0.5, whole[1].at(y + center) - y - 0.5};
    }
    const auto is_even = [](const Mapping& m) { return std::abs(m.scale - 1.0) < 1e-3; };
    const bool is_blur = run.size() > 1 && is_even(whole[0]) && is_even(whole[1]) && chain.variance[0] > 0.1 &&
                         chain.variance[1] > 0.1 && std::abs(chain.shift[0]) < 0.25 && std::abs(chain.shift[1]) < 0.25;
    if (!is_blur || chain.areas.size() != run.back().drawn.size()) return std::nullopt;
    return chain;
}

}  // namespace

std::vector<BlurChain> find_blur_chains(const Frame& frame) {
    std::vector<BlurChain> chains;
    for (std::size_t first = 0; first < frame.passes.size(); ++first) {
        std::vector<Blit> run;
        std::optional<BlurChain> longest;
        for (std::size_t i = first; i < frame.passes.size(); ++i) {
            const std::optional<Blit> blit = blit_of(frame, frame.passes[i]);
            if (!blit || (!run.empty() && blit->source != run.back().target)) break;
            run.push_back(*blit);
            if (const std::optional<BlurChain> chain = chain_of(frame, run, first)) longest = chain;
        }
        if (!longest) continue;
        first = longest->last;
        chains.push_back(*std::move(longest));
    }
    return chains;
}

}  // namespace pipeline::truth
