// SPDX-License-Identifier: MIT
#include "pipeline/truth/draw_pass.h"

#include <tbb/parallel_for.h>

#include <cmath>

#include "pipeline/truth/coverage.h"

namespace pipeline::truth {
namespace {

template <class Of, class List>
auto* find(Id<Of> id, List& list) {
    return id ? &list[static_cast<std::size_t>(id.index)] : nullptr;
}

struct PassDrawing {
    const Frame& frame;
    const Pass& pass;
    const SampleGrid& grid;
    std::vector<Samples>& targets;
    PixelRect area;

    Samples* color() const { return find(pass.color, targets); }
    Samples* depth() const { return find(pass.depth, targets); }
    TargetFormat format() const {
        return pass.color ? find(pass.color, frame.targets)->format : TargetFormat::A8R8G8B8;
    }
    FragmentSetup setup(const TextureBindings& bindings, bool can_have_fog) const {
        FragmentSetup out{.arithmetic = frame.arithmetic,
                          .state      = pass.state,
                          .format     = format(),
                          .color      = color(),
                          .depth      = depth(),
                          .has_fog    = can_have_fog && pass.state.fog.mode != FogMode::None,
                          .textures   = {}};
        for (std::size_t i = 0; i < bindings.size(); ++i)
            out.textures[i] = {find(bindings[i].texture, frame.textures), find(bindings[i].target, targets)};
        return out;
    }

    // Of `pixels`, with the place in the targets.
    template <class Visit>
    void visit_row(int row, int first_pixel, int end_pixel, Visit visit) const {
        const int n            = grid.per_axis;
        const Samples& samples = color() ? *color() : *depth();
        for (int column = first_pixel * n; column < end_pixel * n; ++column) visit(column, samples.at(column, row));
    }
    void clear() const;
    void draw(const std::vector<WindowTriangle>& triangles, const FragmentSetup& setup) const;
    void draw(const DrawRectangle& rectangle, const FragmentSetup& setup) const;
    void copy(const CopyRectangle& copy) const;
};

void PassDrawing::clear() const {
    if (!pass.clear.color && !pass.clear.depth) return;
    Color value = to_color(pass.clear.color.value_or(Argb{0}));
    if (!has_alpha(format())) value.a = missing_alpha(format());
    for (int row = area.y0 * grid.per_axis; row < area.y1 * grid.per_axis; ++row)
        visit_row(row, area.x0, area.x1, [&](int, std::size_t at) {
            if (pass.clear.color) color()->color[at] = value;
            if (pass.clear.depth) depth()->depth[at] = *pass.clear.depth;
        });
}

// The pixels that may have samples between two positions.
std::pair<int, int> pixels_around(double from, double to, int least, int end) {
    const auto within = [&](double v) { return static_cast<int>(std::clamp(v, double(least), double(end))); };
    return {within(std::floor(from) - 1.0), within(std::floor(to) + 2.0)};
}

void PassDrawing::draw(const std::vector<WindowTriangle>& triangles, const FragmentSetup& setup) const {
    std::vector<CoveredTriangle> covered;
    std::vector<std::vector<std::uint32_t>> of_row(static_cast<std::size_t>(std::max(area.y1, 0)));
    for (const WindowTriangle& triangle : triangles) {
        const auto [first, end] =
            pixels_around(std::min({triangle[0].y, triangle[1].y, triangle[2].y}),
                          std::max({triangle[0].y, triangle[1].y, triangle[2].y}), area.y0, area.y1);
        for (int y = first; y < end; ++y)
            of_row[static_cast<std::size_t>(y)].push_back(static_cast<std::uint32_t>(covered.size()));
        covered.emplace_back(triangle);
    }
    tbb::parallel_for(area.y0, area.y1, [&](int pixel_row) {
        for (const std::uint32_t index : of_row[static_cast<std::size_t>(pixel_row)]) {
            const CoveredTriangle& triangle = covered[index];
            const auto [first, end]         = pixels_around(triangle.left, triangle.right, area.x0, area.x1);
            for (int row = pixel_row * grid.per_axis; row < (pixel_row + 1) * grid.per_axis; ++row) {
                const double y = grid.position(row);
                if (y < triangle.top || y > triangle.bottom) continue;
                visit_row(row, first, end, [&](int column, std::size_t at) {
                    const double x = grid.position(column);
                    if (!triangle.covers(x, y)) return;
                    const double center_x = grid.pixel_position(column / grid.per_axis);
                    draw_fragment(setup, triangle.at(x, y, center_x, grid.pixel_position(pixel_row), setup), at);
                });
            }
        }
    });
}

void PassDrawing::draw(const DrawRectangle& rectangle, const FragmentSetup& setup) const {
    const auto [top, bottom] = pixels_around(rectangle.y0, rectangle.y1, area.y0, area.y1);
    const auto [left, right] = pixels_around(rectangle.x0, rectangle.x1, area.x0, area.x1);
    tbb::parallel_for(top * grid.per_axis, bottom * grid.per_axis, [&, first = left, end = right](int row) {
        const double y = grid.position(row);
        visit_row(row, first, end, [&](int column, std::size_t at) {
            const double x = grid.position(column);
            if (!covers(rectangle, x, y)) return;
            draw_fragment(setup,
                          fragment_at(rectangle, x, y, grid.pixel_position(column / grid.per_axis),
                                      grid.pixel_position(row / grid.per_axis)),
                          at);
        });
    });
}

// Halving reads the corner that four pixels share: their mean.
void PassDrawing::copy(const CopyRectangle& copy) const {
    const Samples& source = *find(copy.source, targets);
    const int scale       = copy.halve ? 2 : 1;
    const int width = (copy.from.x1 - copy.from.x0) / scale, height = (copy.from.y1 - copy.from.y0) / scale;
    Samples& target = *color();
    for (int row = 0; row < height * grid.per_axis; ++row)
        for (int column = 0; column < width * grid.per_axis; ++column) {
            const Color from = read_linear(source, TextureAddress::Clamp, TextureAddress::Clamp,
                                           copy.from.x0 + scale * (column / grid.per_axis + 0.5),
                                           copy.from.y0 + scale * (row / grid.per_axis + 0.5),
                                           scale * grid.offset(column), scale * grid.offset(row));
            Color& to        = target.color[target.at(copy.x * grid.per_axis + column, copy.y * grid.per_axis + row)];
            Color moved      = from;
            if (copy.channels == CopyChannels::AlphaToColor) moved = Color(glm::dvec3(from.a), to.a);
            if (copy.channels == CopyChannels::GreenToAlpha) moved = Color(glm::dvec3(to), from.g);
            if (!has_alpha(format())) moved.a = to.a;
            to = moved;
        }
}

PixelRect resolved(const PixelRect& rect, const Frame& frame, const Pass& pass) {
    if (rect != PixelRect{}) return rect;
    const Target& target = frame.targets[static_cast<std::size_t>((pass.color ? pass.color : pass.depth).index)];
    return {0, 0, target.width, target.height};
}

}  // namespace

PixelRect viewport_of(const Frame& frame, const Pass& pass) {
    return resolved(pass.state.viewport, frame, pass);
}

PixelRect drawn_area(const Frame& frame, const Pass& pass) {
    const PixelRect both = intersected(viewport_of(frame, pass), resolved(pass.state.scissor, frame, pass));
    return both.x0 < both.x1 && both.y0 < both.y1 ? both : PixelRect{};
}

void draw_pass(const Frame& frame, const Pass& pass, const SampleGrid& grid, std::vector<Samples>& targets) {
    const PassDrawing drawing{frame, pass, grid, targets, drawn_area(frame, pass)};
    drawing.clear();
    for (const Draw& draw : pass.draws) {
        if (const auto* triangles = std::get_if<DrawTriangles>(&draw))
            drawing.draw(window_triangles(frame, pass, *triangles, viewport_of(frame, pass)),
                         drawing.setup(triangles->textures, true));
        if (const auto* triangles = std::get_if<DrawWindowTriangles>(&draw))
            drawing.draw(window_triangles(frame, pass, *triangles), drawing.setup(triangles->textures, true));
        if (const auto* rectangle = std::get_if<DrawRectangle>(&draw))
            drawing.draw(*rectangle, drawing.setup(rectangle->textures, false));
        if (const auto* copy = std::get_if<CopyRectangle>(&draw)) drawing.copy(*copy);
    }
}

}  // namespace pipeline::truth
