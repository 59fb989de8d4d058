// SPDX-License-Identifier: MIT
#include "pipeline/legalize/texels_read.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "pipeline/check/needed_pixels.h"
#include "pipeline/legalize/window_map.h"

namespace pipeline {

namespace {

constexpr double kSlack = 1.0 / 16.0;  // texels; more than coordinates are off by

// Along one axis: texture coordinates times the texture's size.
struct Span {
    double low = 0.0, high = 0.0;
};

struct Texels {
    std::int32_t first = 0, end = 0;
};

// Of a filter with one texel around each coordinate, or two.
Texels texels_of(const Span& span, TextureFilter filter, TextureAddress address, std::int32_t size) {
    const bool is_linear = filter == TextureFilter::Linear;
    const double low     = std::floor(span.low - kSlack - (is_linear ? 0.5 : 0.0)),
                 high    = std::floor(span.high + kSlack + (is_linear ? 0.5 : 0.0));
    const double last    = size - 1;
    if (address != TextureAddress::Clamp && !(low >= 0.0 && high <= last)) return {0, size};
    if (!(low <= high)) return {0, size};  // not a number
    return {static_cast<std::int32_t>(std::clamp(low, 0.0, last)),
            static_cast<std::int32_t>(std::clamp(high, 0.0, last)) + 1};
}

// Coordinates at the sample points of pixels first..end - 1 of a rectangle from `start` to `stop`.
Span coordinates_at(float start, float stop, float from, float to, std::int32_t first, std::int32_t end,
                    std::int32_t size, double center) {
    const double step = (double{to} - from) / (double{stop} - start);
    const auto at     = [&](double pixel) { return (from + (pixel + center - start) * step) * size; };
    const double a = at(first), b = at(end - 1);
    return {std::min(a, b), std::max(a, b)};
}

struct SpanPair {
    Span u, v;
};

std::optional<SpanPair> spans_of(const Frame& frame, const DrawRectangle& draw, std::size_t stage, const Target& target,
                                 const PixelRect& at) {
    const PixelRect pixels = common_part(at, covered_pixels(frame.arithmetic, draw));
    if (!has_pixels(pixels)) return {};
    const UvRect& uv    = draw.uv[stage];
    const double center = frame.arithmetic.pixel_center / 16.0;
    return SpanPair{coordinates_at(draw.x0, draw.x1, uv.u0, uv.u1, pixels.x0, pixels.x1, target.width, center),
                    coordinates_at(draw.y0, draw.y1, uv.v0, uv.v1, pixels.y0, pixels.y1, target.height, center)};
}

// Interpolation stays within what the corners span.
std::optional<SpanPair> spans_of(const Frame& frame, const DrawTriangles& draw, const Vec2 Vertex::*uv,
                                 const Target& target) {
    if (draw.index_count == 0) return {};
    constexpr double kFar = 1e9;
    SpanPair spans{{kFar, -kFar}, {kFar, -kFar}};
    const auto widen = [](Span& span, double value) { span = {std::min(span.low, value), std::max(span.high, value)}; };
    for (std::uint32_t i = 0; i < draw.index_count; ++i) {
        const Vec2& at = frame.vertices[frame.indices[draw.first_index + i]].*uv;
        widen(spans.u, double{at.x} * target.width);
        widen(spans.v, double{at.y} * target.height);
    }
    return spans;
}

glm::dvec4 row_of(const Mat4& matrix, glm::length_t row) {
    return {matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row]};
}

// With camera coordinates p, window x = X + (1 + cx.p / cw.p) W/2 and texel s = S tx.p / tq.p, rows of two matrices. If
// cw = k tq and S k tx - W/2 cx = c tq, then s = x + c/k - X - W/2 everywhere. Gives that shift; W is negative along y.
std::optional<double> shift_of(const glm::dvec4& cx, const glm::dvec4& cw, const glm::dvec4& tx, const glm::dvec4& tq,
                               double start, double width, double size) {
    constexpr double kEqual = 1e-5;
    const auto factor       = [&](const glm::dvec4& of, double scale) -> std::optional<double> {
        const double ratio    = glm::dot(of, tq) / glm::dot(tq, tq);
        const glm::dvec4 rest = of - ratio * tq;
        return glm::dot(rest, rest) <= kEqual * kEqual * scale ? std::optional(ratio) : std::nullopt;
    };
    if (!(glm::dot(tq, tq) > 0.0)) return {};
    const std::optional<double> k = factor(cw, glm::dot(cw, cw));
    if (!k || *k == 0.0) return {};
    const glm::dvec4 scaled       = width / 2.0 * cx;
    const std::optional<double> c = factor(size * *k * tx - scaled, glm::dot(scaled, scaled));
    if (!c) return {};
    return *c / *k - start - width / 2.0;
}

// Of triangles that show the texel at their own place in the window.
std::optional<SpanPair> own_place(const Frame& frame, const Pass& pass, const TextureStage& stage, const Target& target,
                                  const PixelRect& at) {
    const Mat4& projection = frame.cameras[static_cast<std::size_t>(pass.camera.index)].projection;
    const PixelRect window = viewport_of(frame, pass);
    const glm::dvec4 w = row_of(projection, 3), q = row_of(stage.transform, 2);
    const std::optional<double> dx = shift_of(row_of(projection, 0), w, row_of(stage.transform, 0), q, window.x0,
                                              window.x1 - window.x0, target.width);
    const std::optional<double> dy = shift_of(row_of(projection, 1), w, row_of(stage.transform, 1), q, window.y1,
                                              window.y0 - window.y1, target.height);
    if (!dx || !dy) return {};
    const double center = frame.arithmetic.pixel_center / 16.0;
    return SpanPair{{at.x0 + center + *dx, at.x1 - 1 + center + *dx}, {at.y0 + center + *dy, at.y1 - 1 + center + *dy}};
}

PixelRect whole_of(const Target& target) {
    return {0, 0, target.width, target.height};
}

}  // namespace

PixelRect texels_read(const Frame& frame, const Pass& pass, const Draw& draw, std::size_t stage, const PixelRect& at) {
    const Target& target      = frame.targets[static_cast<std::size_t>(textures_of(draw)[stage].target.index)];
    const TextureStage& state = pass.state.stages[stage];
    std::optional<SpanPair> spans;
    if (!has_pixels(at)) return {};
    if (const auto* rectangle = std::get_if<DrawRectangle>(&draw)) {
        spans = spans_of(frame, *rectangle, stage, target, at);
        if (!spans) return {};
    }
    if (const auto* triangles = std::get_if<DrawTriangles>(&draw)) {
        if (triangles->index_count == 0) return {};
        const bool is_own = state.coords == CoordSource::CameraPosition;
        spans             = is_own ? own_place(frame, pass, state, target, at)
                                   : spans_of(frame, *triangles, state.coords == CoordSource::Vertex0 ? &Vertex::uv0 : &Vertex::uv1,
                                              target);
    }
    if (!spans) return whole_of(target);
    const Texels u = texels_of(spans->u, state.filter, state.address_u, target.width),
                 v = texels_of(spans->v, state.filter, state.address_v, target.height);
    return {u.first, v.first, u.end, v.end};
}

}  // namespace pipeline
