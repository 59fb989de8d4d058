// SPDX-License-Identifier: MIT
#include "raster/reference.h"

#include <algorithm>
#include <optional>

#include "raster/reference_color.h"
#include "raster/reference_plane.h"
#include "raster/reference_texture.h"

namespace raster {

namespace {

using namespace reference;

// Whether the texel of sampler i comes from its levels.
bool reads_levels(const FillState& state, int i) {
    return reads(state, i, CombineArg::Source::Texel) && !state.samplers[i].levels.empty();
}

// What the primitives give at a covered pixel. depth: kDepthBits bits. points: where a texture is read.
struct Fragment {
    int x = 0, y = 0;
    std::uint32_t depth = 0, diffuse = 0, specular = 0;
    std::array<TexturePoint, kMaxTextures> points;
};

// What a fragment may still write.
struct Writes {
    bool depth               = false;
    std::uint32_t color_mask = 0;
};

// What is left of it after the alpha test has failed. Keep, which drops the fragment, leaves nothing.
Writes writes_in_spite(AlphaFail fail, const Writes& writes) {
    switch (fail) {
        case AlphaFail::Keep:
            return {};
        case AlphaFail::ColorOnly:
            return {false, writes.color_mask};
        case AlphaFail::DepthOnly:
            return {writes.depth, 0};
        case AlphaFail::RgbOnly:
            return {false, writes.color_mask & 0x00ffffff};
    }
    return {};
}

// The steps of fill_state.h, in their order.
void shade(const PassFill& pass, const FillState& state, const Fragment& fragment, FillCounts& counts) {
    ++counts.covered;
    FragmentColors colors{fragment.diffuse, fragment.specular, {}};
    for (int i = 0; i < kMaxTextures; ++i) {
        colors.texels[i] = 0xffffffff;
        if (!reads_levels(state, i)) continue;
        colors.texels[i]           = sample(state.samplers[i], fragment.points[i]);
        const std::uint64_t texels = static_cast<std::uint64_t>(texels_read(state.samplers[i]));
        counts.texels += texels;
        counts.texel_bytes += texels * static_cast<std::uint64_t>(state.samplers[i].texel_bytes);
    }
    const std::uint32_t source = combined_color(state, colors);

    Writes writes{state.depth_write, state.blend.write_mask};
    if (!passes(state.alpha_func, source >> 24, state.alpha_reference)) {
        if (state.alpha_fail == AlphaFail::Keep) return;
        writes = writes_in_spite(state.alpha_fail, writes);
    }
    if (state.dest_alpha_test != DestAlphaTest::Off) {
        ++counts.dest_alpha_tested;
        const bool top_bit = (pass.color->row(fragment.y)[fragment.x] & 0x80000000) != 0;
        if (top_bit != (state.dest_alpha_test == DestAlphaTest::One)) return;
    }
    ++counts.alpha_passed;

    const std::uint32_t depth = pass.depth ? depth_in_format(fragment.depth, pass.depth_bits) : 0;
    if (pass.depth && !passes(state.depth_func, depth, pass.depth->row(fragment.y)[fragment.x])) return;
    ++counts.depth_passed;

    if (pass.depth && writes.depth) {
        pass.depth->row(fragment.y)[fragment.x] = depth;
        ++counts.depth_written;
    }
    if (pass.color && writes.color_mask != 0) {
        Blend blend          = state.blend;
        blend.write_mask     = writes.color_mask;
        std::uint32_t& there = pass.color->row(fragment.y)[fragment.x];
        there                = blended_color(blend, pass.format, source, there, fragment.x, fragment.y);
        ++counts.color_written;
    }
}

// The four channels of a colour of the vertices, as planes.
class ColorOverTriangle {
  public:
    ColorOverTriangle(const Corners& corners, const std::array<std::uint32_t, 3>& colors, bool floor) : floor_(floor) {
        for (int c = 0; c < 4; ++c) {
            const auto byte = [&](int i) { return std::int64_t{(colors[i] >> (8 * c)) & 255}; };
            planes_[c]      = make_plane(corners, {byte(0), byte(1), byte(2)}, floor ? 31 : 23, 16);
        }
    }

    std::uint32_t at(int x, int y) const {
        std::uint32_t color = 0;
        for (int c = 0; c < 4; ++c) {
            color |= static_cast<std::uint32_t>(floor_ ? floored(c, x, y) : nearest(c, x, y)) << (8 * c);
        }
        return color;
    }

  private:
    int nearest(int channel, int x, int y) const {
        return ((static_cast<std::int16_t>(planes_[channel].value(x, y)) + 64) >> 7) & 255;
    }
    int floored(int channel, int x, int y) const {
        return std::clamp((static_cast<std::int32_t>(planes_[channel].value(x, y)) + 128) >> 15, 0, 255);
    }

    std::array<Plane, 4> planes_;
    bool floor_;
};

// Rounded outwards, so that every pixel sampled inside is within; keeps the walk short, and decides nothing.
Rect pixels_around(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) {
    return {static_cast<int>(x0 >> 4), static_cast<int>(y0 >> 4), static_cast<int>(x1 >> 4) + 1,
            static_cast<int>(y1 >> 4) + 1};
}

void draw(const PassFill& pass, const FillState& state, Triangle triangle, FillCounts& counts) {
    const Corners corners = snap_clockwise(pass.grid, triangle);
    if (corners.d == 0) return;

    std::array<std::int64_t, 3> z = {depth_at_vertex(triangle[0].z), depth_at_vertex(triangle[1].z),
                                     depth_at_vertex(triangle[2].z)};
    if (state.whole_depth && pass.depth_bits < kDepthBits)
        for (std::int64_t& depth : z) depth -= depth % (1 << (kDepthBits - pass.depth_bits));
    const Plane depth              = make_plane(corners, z, 12, 12);
    const auto [nearest, farthest] = std::minmax({z[0], z[1], z[2]});
    const ColorOverTriangle diffuse(corners, {triangle[0].diffuse, triangle[1].diffuse, triangle[2].diffuse},
                                    state.floor_colors);
    const ColorOverTriangle specular(corners, {triangle[0].specular, triangle[1].specular, triangle[2].specular},
                                     state.floor_colors);
    std::array<std::optional<TriangleTexture>, kMaxTextures> textures;
    for (int i = 0; i < kMaxTextures; ++i)
        if (reads_levels(state, i)) textures[i].emplace(corners, triangle, i, state.samplers[i]);

    const auto [x0, x1] = std::minmax({corners.x[0], corners.x[1], corners.x[2]});
    const auto [y0, y1] = std::minmax({corners.y[0], corners.y[1], corners.y[2]});
    const Rect walk     = intersect(pass.scissor, pixels_around(x0, y0, x1, y1));
    for (int y = walk.y0; y < walk.y1; ++y) {
        for (int x = walk.x0; x < walk.x1; ++x) {
            if (!covers(corners, x, y)) continue;
            const std::int64_t value = static_cast<std::int32_t>(depth.value(x, y));
            Fragment fragment{x,
                              y,
                              static_cast<std::uint32_t>(std::clamp(value, nearest, farthest)),
                              diffuse.at(x, y),
                              specular.at(x, y),
                              {}};
            for (int i = 0; i < kMaxTextures; ++i)
                if (textures[i]) fragment.points[i] = textures[i]->at(x, y);
            shade(pass, state, fragment, counts);
        }
    }
}

void draw(const PassFill& pass, const FillState& state, const Rectangle& rectangle, FillCounts& counts) {
    const std::int64_t x0 = snap(pass.grid, rectangle.x0), y0 = snap(pass.grid, rectangle.y0);
    const std::int64_t x1 = snap(pass.grid, rectangle.x1), y1 = snap(pass.grid, rectangle.y1);
    if (x0 >= x1 || y0 >= y1) return;

    std::array<std::optional<RectangleTexture>, kMaxTextures> textures;
    for (int i = 0; i < kMaxTextures; ++i)
        if (reads_levels(state, i)) textures[i].emplace(pass.grid, rectangle, i, state.samplers[i]);

    const auto depth = static_cast<std::uint32_t>(depth_at_vertex(rectangle.z));
    const Rect walk  = intersect(pass.scissor, pixels_around(x0, y0, x1, y1));
    for (int y = walk.y0; y < walk.y1; ++y) {
        for (int x = walk.x0; x < walk.x1; ++x) {
            const int px = 16 * x + pass.grid.center, py = 16 * y + pass.grid.center;
            if (px < x0 || px >= x1 || py < y0 || py >= y1) continue;
            Fragment fragment{x, y, depth, rectangle.color, Vertex{}.specular, {}};
            for (int i = 0; i < kMaxTextures; ++i)
                if (textures[i]) fragment.points[i] = textures[i]->at(x, y);
            shade(pass, state, fragment, counts);
        }
    }
}

}  // namespace

std::uint32_t reference_stored(const ColorFormat& format, std::uint32_t argb) {
    return reference::stored_color(format, argb);
}

FillCounts reference_fill_pass(const PassFill& pass) {
    if (pass.clear_color) fill_rect(*pass.color, pass.scissor, *pass.clear_color);
    if (pass.clear_depth) fill_rect(*pass.depth, pass.scissor, *pass.clear_depth);
    FillCounts counts;
    for (const Draw& each : pass.draws) {
        for (const TriangleCorners& corners : each.triangles)
            draw(pass, each.state, triangle_of(each, corners), counts);
        for (const Rectangle& rectangle : each.rectangles) draw(pass, each.state, rectangle, counts);
    }
    return counts;
}

}  // namespace raster
