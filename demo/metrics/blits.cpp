// SPDX-License-Identifier: MIT
#include "demo/metrics/blits.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace demo {
namespace {

// A destination pixel between two texels.
struct Tap {
    int low, high;
    double share;  // of the high one
};

std::vector<Tap> taps(int from, int to, double start, double end, double u_start, double u_end, int size) {
    std::vector<Tap> all;
    for (int x = from; x < to; ++x) {
        const double u     = u_start + (x + 0.5 - start) / (end - start) * (u_end - u_start);
        const double texel = u * size - 0.5, low = std::floor(texel);
        const auto clamped = [&](double at) { return static_cast<int>(std::clamp(at, 0.0, size - 1.0)); };
        all.push_back({clamped(low), clamped(low + 1.0), texel - low});
    }
    return all;
}

}  // namespace

bool is_blit(const pipeline::Pass& pass) {
    if (pass.draws.size() != 1 || !std::holds_alternative<pipeline::DrawRectangle>(pass.draws.front())) return false;
    const auto& rectangle = std::get<pipeline::DrawRectangle>(pass.draws.front());
    return rectangle.textures[0].target && !rectangle.textures[1].target && !rectangle.textures[1].texture &&
           pass.state.stages[0].filter == pipeline::TextureFilter::Linear &&
           pass.state.stages[0].color_op == pipeline::TextureOp::SelectArg1 &&
           pass.state.blend == pipeline::BlendState{};
}

void blit(const pipeline::Pass& pass, const DeepPlane& source, DeepPlane& into) {
    const auto& rectangle     = std::get<pipeline::DrawRectangle>(pass.draws.front());
    const pipeline::UvRect uv = rectangle.uv[0];
    pipeline::PixelRect area  = pass.state.scissor;
    if (area == pipeline::PixelRect{}) area = {0, 0, into.width, into.height};
    const int x0 = std::max(area.x0, 0), y0 = std::max(area.y0, 0);
    const int x1 = std::min(area.x1, into.width), y1 = std::min(area.y1, into.height);
    const std::vector<Tap> across = taps(x0, x1, static_cast<double>(rectangle.x0), static_cast<double>(rectangle.x1),
                                         static_cast<double>(uv.u0), static_cast<double>(uv.u1), source.width);
    const std::vector<Tap> down   = taps(y0, y1, static_cast<double>(rectangle.y0), static_cast<double>(rectangle.y1),
                                         static_cast<double>(uv.v0), static_cast<double>(uv.v1), source.height);
    for (int y = y0; y < y1; ++y) {
        const Tap v = down[static_cast<std::size_t>(y - y0)];
        for (int x = x0; x < x1; ++x) {
            const Tap u         = across[static_cast<std::size_t>(x - x0)];
            const double top    = source.at(u.low, v.low) * (1.0 - u.share) + source.at(u.high, v.low) * u.share;
            const double bottom = source.at(u.low, v.high) * (1.0 - u.share) + source.at(u.high, v.high) * u.share;
            into.at(x, y)       = top * (1.0 - v.share) + bottom * v.share;
        }
    }
}

double scale_of(const pipeline::Pass& pass, const pipeline::Frame& frame) {
    const auto& rectangle = std::get<pipeline::DrawRectangle>(pass.draws.front());
    const int width       = frame.targets[static_cast<std::size_t>(rectangle.textures[0].target.index)].width;
    const double texels   = static_cast<double>(rectangle.uv[0].u1 - rectangle.uv[0].u0) * width;
    return static_cast<double>(rectangle.x1 - rectangle.x0) / texels;
}

std::vector<double> blit_columns(const pipeline::Pass& pass, const std::vector<double>& source, double scale,
                                 int width) {
    const auto& rectangle = std::get<pipeline::DrawRectangle>(pass.draws.front());
    const double start    = static_cast<double>(rectangle.x0);
    const auto size       = static_cast<int>(source.size());
    std::vector<double> columns;
    for (const Tap tap : taps(0, width, start, start + scale * size, 0.0, 1.0, size))
        columns.push_back(source[static_cast<std::size_t>(tap.low)] * (1.0 - tap.share) +
                          source[static_cast<std::size_t>(tap.high)] * tap.share);
    return columns;
}

void blit_all(const pipeline::Frame& frame, std::span<const pipeline::Pass> passes, std::vector<DeepPlane>& images) {
    images.resize(frame.targets.size());
    for (const pipeline::Pass& pass : passes) {
        const auto& rectangle = std::get<pipeline::DrawRectangle>(pass.draws.front());
        const auto from       = static_cast<std::size_t>(rectangle.textures[0].target.index);
        const auto to         = static_cast<std::size_t>(pass.color.index);
        blit(pass, images[from], images[to]);
    }
}

std::vector<DeepPlane> empty_images(const pipeline::Frame& frame) {
    std::vector<DeepPlane> images;
    for (const pipeline::Target& target : frame.targets) images.emplace_back(target.width, target.height, 0.0);
    return images;
}

}  // namespace demo
