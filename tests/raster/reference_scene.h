// SPDX-License-Identifier: MIT
// Small scenes for the tests of the oracle: a pass onto one image, textures in memory, and states that do one thing.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "raster/reference.h"

namespace reference_scene {

inline constexpr std::uint32_t kWhite = 0xffffffff;

// Texels of one or more levels, and the sampler that reads them. Not copied: the sampler points into it.
class Texture {
  public:
    Texture(int width, int height, const std::function<std::uint32_t(int, int)>& color) {
        add_level(width, height, color);
    }
    Texture(const Texture&)            = delete;
    Texture& operator=(const Texture&) = delete;

    // Rows are kPadding texels longer than the level, filled with a colour that no test expects.
    void add_level(int width, int height, const std::function<std::uint32_t(int, int)>& color) {
        constexpr int kPadding = 3;
        std::vector<std::uint32_t> texels(static_cast<std::size_t>((width + kPadding) * height), 0x5ca1ab1e);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) texels[static_cast<std::size_t>(y * (width + kPadding) + x)] = color(x, y);
        memory_.push_back(std::move(texels));
        sampler.levels.push_back({memory_.back().data(), width, height, width + kPadding});
    }

    raster::Sampler sampler;

  private:
    std::vector<std::vector<std::uint32_t>> memory_;
};

inline raster::FillState texture_only(const Texture& texture) {
    using raster::CombineArg;
    raster::FillState state;
    state.stage_count       = 1;
    state.stages[0].color.a = {.source = CombineArg::Source::Texel};
    state.stages[0].alpha.a = {.source = CombineArg::Source::Texel};
    state.samplers[0]       = texture.sampler;
    return state;
}

// Adds up what is drawn.
inline raster::FillState additive() {
    raster::FillState state;
    state.blend.dest = raster::kOne;
    return state;
}

inline raster::Vertex vertex(float x, float y, std::uint32_t diffuse = kWhite, float z = 0.0f) {
    raster::Vertex v;
    v.x       = x;
    v.y       = y;
    v.z       = z;
    v.diffuse = diffuse;
    return v;
}

inline raster::Triangle triangle(std::array<std::array<float, 2>, 3> corners, std::uint32_t color = kWhite) {
    return {vertex(corners[0][0], corners[0][1], color), vertex(corners[1][0], corners[1][1], color),
            vertex(corners[2][0], corners[2][1], color)};
}

// With vertices of their own.
inline void add_triangles(raster::Draw& draw, const std::vector<raster::Triangle>& triangles) {
    for (const raster::Triangle& each : triangles) {
        const auto first = static_cast<std::uint32_t>(draw.vertices.size());
        draw.vertices.insert(draw.vertices.end(), each.begin(), each.end());
        draw.triangles.push_back({first, first + 1, first + 2});
    }
}

inline raster::Rectangle rectangle(float x0, float y0, float x1, float y1, std::uint32_t color = kWhite,
                                   float z = 0.0f) {
    raster::Rectangle r;
    r.x0    = x0;
    r.y0    = y0;
    r.x1    = x1;
    r.y1    = y1;
    r.z     = z;
    r.color = color;
    return r;
}

// A target with everything drawn onto the whole of it.
struct Canvas {
    Canvas(int width, int height) : color(width, height), depth(width, height) {}

    raster::FillCounts draw(const raster::FillState& state, const std::vector<raster::Triangle>& triangles,
                            const std::vector<raster::Rectangle>& rectangles = {}, int depth_bits = 24) {
        raster::PassFill pass;
        pass.color      = &color;
        pass.depth      = &depth;
        pass.depth_bits = depth_bits;
        pass.format     = format;
        pass.grid       = grid;
        pass.scissor    = color.bounds();
        raster::Draw draw{.state = state, .rectangles = rectangles};
        add_triangles(draw, triangles);
        pass.draws = {draw};
        return raster::reference_fill_pass(pass);
    }
    raster::FillCounts draw(const raster::FillState& state, const raster::Rectangle& rectangle, int depth_bits = 24) {
        return draw(state, {}, {rectangle}, depth_bits);
    }
    std::uint32_t at(int x, int y) const { return color.row(y)[x]; }

    raster::Image color, depth;
    raster::ColorFormat format;
    raster::PixelGrid grid;
};

// One pixel with `state`, drawn by a rectangle of a colour over `dest`.
inline std::uint32_t pixel(const raster::FillState& state, std::uint32_t color, std::uint32_t dest = 0,
                           const raster::ColorFormat& format = {}) {
    Canvas canvas(1, 1);
    canvas.format          = format;
    canvas.color.row(0)[0] = dest;
    canvas.draw(state, rectangle(0, 0, 1, 1, color));
    return canvas.at(0, 0);
}

// The byte in every channel.
constexpr std::uint32_t grey(int byte) {
    return static_cast<std::uint32_t>(byte) * 0x01010101u;
}

inline int channel(std::uint32_t color, int c) {
    return static_cast<int>((color >> (8 * c)) & 255);
}

// Colours with many zeros and ones among their bytes.
inline std::uint32_t random_color(std::mt19937& random) {
    std::uint32_t color = 0;
    for (int c = 0; c < 4; ++c) {
        const auto draw          = static_cast<std::uint32_t>(random());
        const std::uint32_t byte = draw % 8 == 0 ? 0 : draw % 8 == 1 ? 255 : (draw >> 8) & 255;
        color |= byte << (8 * c);
    }
    return color;
}

}  // namespace reference_scene
