// SPDX-License-Identifier: MIT
#include "tests/support/gs_fill.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

namespace test_support {

namespace {

using Rgba = std::array<int, 4>;

// Addresses of the registers that a fill reads.
enum Address {
    kPrim     = 0x00,
    kTex0     = 0x06,
    kClamp    = 0x08,
    kTex1     = 0x14,
    kTexA     = 0x3b,
    kFogCol   = 0x3d,
    kScissor  = 0x40,
    kAlpha    = 0x42,
    kDimx     = 0x44,
    kDthe     = 0x45,
    kColClamp = 0x46,
    kTest     = 0x47,
    kPabe     = 0x49,
    kFba      = 0x4a,
    kFrame    = 0x4c,
    kZbuf     = 0x4e
};

int byte_of(int value) {
    return std::min(std::max(value, 0), 255);
}

Rgba unpacked(std::uint32_t format, std::uint32_t pixel, int low_alpha, int high_alpha) {
    const auto part = [&](int shift, int width) { return static_cast<int>(bits_at(pixel, shift, width)); };
    if (gs_bits_of(format) == 16)
        return {part(0, 5) * 8, part(5, 5) * 8, part(10, 5) * 8, part(15, 1) != 0 ? high_alpha : low_alpha};
    return {part(0, 8), part(8, 8), part(16, 8), gs_bits_of(format) == 24 ? low_alpha : part(24, 8)};
}

// Red lowest, as FBMSK is, to a pixel.
std::uint32_t packed(std::uint32_t format, std::uint32_t abgr) {
    if (gs_bits_of(format) != 16) return abgr;
    return bits_at(abgr, 3, 5) | bits_at(abgr, 11, 5) << 5 | bits_at(abgr, 19, 5) << 10 | bits_at(abgr, 31, 1) << 15;
}

// -- texture

int wrapped(int i, std::uint32_t mode, std::uint32_t log2_size, std::uint32_t least, std::uint32_t greatest) {
    const int size = 1 << log2_size, low = static_cast<int>(least), high = static_cast<int>(greatest);
    if (mode == 0) return i & (size - 1);
    if (mode == 1) return std::min(std::max(i, 0), size - 1);
    if (mode == 2) return std::min(std::max(i, low), high);
    return (i & low) | high;
}

Rgba texel(const GsDrawing& d, int i, int j) {
    const std::uint64_t tex0 = d.registers[kTex0], clamp = d.registers[kClamp], texa = d.registers[kTexA];
    const GsBuffer buffer{bits_at(tex0, 20, 6), bits_at(tex0, 0, 14), bits_at(tex0, 14, 6)};
    const int x = wrapped(i, bits_at(clamp, 0, 2), bits_at(tex0, 26, 4), bits_at(clamp, 4, 10), bits_at(clamp, 14, 10));
    const int y =
        wrapped(j, bits_at(clamp, 2, 2), bits_at(tex0, 30, 4), bits_at(clamp, 24, 10), bits_at(clamp, 34, 10));
    const std::uint32_t value = d.texels.read(buffer, x, y);
    if (gs_bits_of(buffer.format) == 8) return unpacked(kCt32, d.palette[value], 0, 0);
    return unpacked(buffer.format, value, static_cast<int>(bits_at(texa, 0, 8)),
                    static_cast<int>(bits_at(texa, 32, 8)));
}

// u, v in 1/256 texel.
Rgba sampled(const GsDrawing& d, std::int32_t u, std::int32_t v) {
    const bool linear = bits_at(d.registers[kTex1], 5, 1) != 0;
    if (!linear) return texel(d, u >> 8, v >> 8);
    const std::int32_t u4 = (u >> 4) - 8, v4 = (v >> 4) - 8;  // sixteenths, from the middle of a texel
    const int i = u4 >> 4, j = v4 >> 4, fu = u4 & 15, fv = v4 & 15;
    const Rgba a = texel(d, i, j), b = texel(d, i + 1, j), e = texel(d, i, j + 1), f = texel(d, i + 1, j + 1);
    Rgba result{};
    for (int c = 0; c < 4; ++c) {
        const int above = a[c] + (((b[c] - a[c]) * fu) >> 4), below = e[c] + (((f[c] - e[c]) * fu) >> 4);
        result[c] = above + (((below - above) * fv) >> 4);
    }
    return result;
}

// TFX and TCC: tables of colour and alpha.
Rgba textured(std::uint64_t tex0, const Rgba& t, const Rgba& f) {
    const bool has_alpha     = bits_at(tex0, 34, 1) != 0;
    const std::uint32_t kind = bits_at(tex0, 35, 2);
    Rgba result              = f;
    for (int c = 0; c < 3; ++c) {
        const int product = (t[c] * f[c]) >> 7;
        result[c]         = kind == 1 ? t[c] : byte_of(kind == 0 ? product : product + f[3]);
    }
    if (!has_alpha) return result;
    if (kind == 0) result[3] = byte_of((t[3] * f[3]) >> 7);
    if (kind == 1 || kind == 3) result[3] = t[3];
    if (kind == 2) result[3] = byte_of(t[3] + f[3]);
    return result;
}

// -- pixels

bool alpha_passes(std::uint32_t func, int a, int b) {
    const bool results[8] = {false, true, a<b, a <= b, a == b, a >= b, a> b, a != b};
    return results[func];
}
bool depth_passes(std::uint32_t func, std::uint32_t z, std::uint32_t there) {
    return func == 1 || (func == 2 && z >= there) || (func == 3 && z > there);
}

// A colour on its way into the frame buffer: ALPHA, DIMX, COLCLAMP, FBA.
Rgba blended(const GsDrawing& d, const Rgba& s, const Rgba& there, bool dithers, int x, int y) {
    const std::uint64_t alpha = d.registers[kAlpha];
    const bool on        = bits_at(d.registers[kPrim], 6, 1) != 0 && !((d.registers[kPabe] & 1) != 0 && s[3] < 128);
    const int factors[3] = {s[3], there[3], static_cast<int>(bits_at(alpha, 32, 8))};
    int offset           = 0;
    if (dithers) {
        offset = static_cast<int>(bits_at(d.registers[kDimx], 16 * (y & 3) + 4 * (x & 3), 3));
        if (offset > 3) offset -= 8;
    }
    Rgba result = s;
    for (int c = 0; c < 3; ++c) {
        const int choice[3] = {s[c], there[c], 0};
        int value           = s[c];
        if (on)
            value =
                (((choice[bits_at(alpha, 0, 2)] - choice[bits_at(alpha, 2, 2)]) * factors[bits_at(alpha, 4, 2)]) >> 7) +
                choice[bits_at(alpha, 6, 2)];
        value += offset;
        result[c] = (d.registers[kColClamp] & 1) != 0 ? byte_of(value) : value & 255;
    }
    if ((d.registers[kFba] & 1) != 0) result[3] |= 128;
    return result;
}

// A fragment from its colour on: fog is done.
void put(const GsDrawing& d, int x, int y, const Rgba& s, std::uint32_t z) {
    const std::uint64_t frame = d.registers[kFrame], zbuf = d.registers[kZbuf], test = d.registers[kTest];
    const GsBuffer color{bits_at(frame, 24, 6), bits_at(frame, 0, 9) * 32, bits_at(frame, 16, 6)};
    const GsBuffer depth{bits_at(zbuf, 24, 4) | 0x30, bits_at(zbuf, 0, 9) * 32, color.width64};
    const int bits     = gs_bits_of(color.format);
    std::uint32_t kept = bits_at(frame, 32, 32);
    bool writes_color = true, writes_depth = bits_at(zbuf, 32, 1) == 0;
    if (bits_at(test, 0, 1) != 0 && !alpha_passes(bits_at(test, 1, 3), s[3], static_cast<int>(bits_at(test, 4, 8)))) {
        const std::uint32_t fail = bits_at(test, 12, 2);
        if (fail == 0) return;
        if (fail != 2) writes_depth = false;
        if (fail == 2) writes_color = false;
        if (fail == 3 && bits == 32) kept |= 0xff000000;
    }
    const std::uint32_t pixel = d.memory.read(color, x, y);
    const Rgba there          = unpacked(color.format, pixel, bits == 24 ? 128 : 0, 128);
    if (bits_at(test, 14, 1) != 0) {
        if (bits == 24) return;
        if ((there[3] >= 128) != (bits_at(test, 15, 1) != 0)) return;
    }
    const int depth_bits = gs_bits_of(depth.format);
    if (depth_bits < 32) z = std::min(z, (1u << depth_bits) - 1);
    if (!depth_passes(bits_at(test, 17, 2), z, d.memory.read(depth, x, y))) return;
    if (writes_depth) d.memory.write(depth, x, y, z);
    if (!writes_color) return;
    const bool dithers        = bits == 16 && (d.registers[kDthe] & 1) != 0;
    const Rgba out            = blended(d, s, there, dithers, x, y);
    const auto channel        = [&](int c) { return static_cast<std::uint32_t>(out[c]) << (8 * c); };
    const std::uint32_t mask  = packed(color.format, kept);
    const std::uint32_t value = packed(color.format, channel(0) | channel(1) | channel(2) | channel(3));
    d.memory.write(color, x, y, (pixel & mask) | (value & ~mask));
}

struct Bounds {
    int x0, y0, x1, y1;  // the last are included
};
Bounds scissored(const GsDrawing& d, std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) {
    const std::uint64_t s = d.registers[kScissor];
    const auto last  = [](std::int64_t a, std::uint32_t b) { return static_cast<int>(std::min(a, std::int64_t{b})); };
    const auto first = [](std::int64_t a, std::uint32_t b) { return static_cast<int>(std::max(a, std::int64_t{b})); };
    return {first(x0, bits_at(s, 0, 11)), first(y0, bits_at(s, 32, 11)), last(x1, bits_at(s, 16, 11)),
            last(y1, bits_at(s, 48, 11))};
}

bool is_on(const GsDrawing& d, int bit) {
    return bits_at(d.registers[kPrim], bit, 1) != 0;
}

// -- triangles

// A value over a triangle, see raster/primitives.h.
class Slope {
  public:
    Slope(const std::array<GsVertex, 3>& p, std::int64_t area, const std::array<std::int64_t, 3>& v, int fraction,
          int shift)
        : x_(p[0].x), y_(p[0].y), shift_(shift) {
        const std::int64_t across = ((v[1] - v[0]) * (p[2].y - p[0].y) - (v[2] - v[0]) * (p[1].y - p[0].y)) *
                                    (std::int64_t{1} << fraction) / area;
        const std::int64_t down = ((v[2] - v[0]) * (p[1].x - p[0].x) - (v[1] - v[0]) * (p[2].x - p[0].x)) *
                                  (std::int64_t{1} << fraction) / area;
        across_ = static_cast<std::uint64_t>(across);
        down_   = static_cast<std::uint64_t>(down);
        start_  = static_cast<std::uint64_t>(v[0]) << fraction;
    }
    // Blocks of 16 pixels begin with the plane's value and go on by steps of their own.
    std::int32_t at(int x, int y) const {
        const int block           = x & ~15;
        const std::uint64_t begin = start_ + across_ * static_cast<std::uint64_t>(16 * block - x_) +
                                    down_ * static_cast<std::uint64_t>(16 * y - y_);
        return static_cast<std::int32_t>(whole(begin) + static_cast<std::uint32_t>(x - block) * whole(16 * across_));
    }

  private:
    std::uint32_t whole(std::uint64_t value) const {
        const std::uint64_t half = std::uint64_t{1} << (shift_ - 1);
        return static_cast<std::uint32_t>(static_cast<std::int64_t>(value + half) >> shift_);
    }
    std::int64_t x_, y_;
    int shift_;
    std::uint64_t start_ = 0, across_ = 0, down_ = 0;
};

// The largest power of two, up to `limit`, by which all of them stay below 2^29.
int exponent_for(float a, float b, float c, int limit) {
    const float largest = std::max({std::fabs(a), std::fabs(b), std::fabs(c)});
    int e               = limit;
    while (std::ldexp(static_cast<double>(largest), e) >= 536870912.0) --e;
    return e;
}

class TexelsOfTriangle {
  public:
    TexelsOfTriangle(const std::array<GsVertex, 3>& p, std::int64_t area, std::uint64_t tex0)
        : exponent_(std::min(exponent_for(p[0].s, p[1].s, p[2].s, 60), exponent_for(p[0].t, p[1].t, p[2].t, 60))),
          exponent_q_(exponent_for(p[0].q, p[1].q, p[2].q, 90)),
          s_(p, area, integers(p, &GsVertex::s, exponent_), 12, 12),
          t_(p, area, integers(p, &GsVertex::t, exponent_), 12, 12),
          q_(p, area, integers(p, &GsVertex::q, exponent_q_), 12, 12),
          width_(scale(bits_at(tex0, 26, 4))),
          height_(scale(bits_at(tex0, 30, 4))) {}

    struct Point {
        std::int32_t u, v;
    };
    Point at(int x, int y) const {
        const float q = static_cast<float>(std::max(q_.at(x, y), 1)), r = 1.0f / q;
        const float u = static_cast<float>(s_.at(x, y)) * r, v = static_cast<float>(t_.at(x, y)) * r;
        return {in_256(u * width_), in_256(v * height_)};
    }

  private:
    static std::array<std::int64_t, 3> integers(const std::array<GsVertex, 3>& p, float GsVertex::*value, int e) {
        const auto integer = [&](int i) { return std::llrint(std::ldexp(static_cast<double>(p[i].*value), e)); };
        return {integer(0), integer(1), integer(2)};
    }
    float scale(std::uint32_t log2_size) const {
        return static_cast<float>(std::ldexp(1.0, exponent_q_ - exponent_ + static_cast<int>(log2_size)));
    }
    static std::int32_t in_256(float texels) {
        const float value = texels * 256.0f;
        return static_cast<std::int32_t>(std::floor(std::min(std::max(value, -1073741824.0f), 1073741824.0f)));
    }
    int exponent_, exponent_q_;
    Slope s_, t_, q_;
    float width_, height_;
};

Rgba fogged(const GsDrawing& d, Rgba color, int f) {
    for (int c = 0; c < 3; ++c) {
        const int fog = static_cast<int>(bits_at(d.registers[kFogCol], 8 * c, 8));
        color[c]      = (f * color[c] + (256 - f) * fog) >> 8;
    }
    return color;
}

// Whether the sample point is right of an edge that goes from a to b clockwise, or on one that is a top or left edge.
bool is_inside(const GsVertex& a, const GsVertex& b, std::int64_t x, std::int64_t y) {
    const std::int64_t side = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
    const bool owns_edge    = b.y < a.y || (b.y == a.y && b.x > a.x);
    return side > 0 || (side == 0 && owns_edge);
}

}  // namespace

std::uint32_t gs_argb(std::uint32_t format, std::uint32_t pixel) {
    const Rgba c = unpacked(format, pixel, gs_bits_of(format) == 24 ? 128 : 0, 128);
    return static_cast<std::uint32_t>(c[3] << 24 | c[0] << 16 | c[1] << 8 | c[2]);
}

void gs_triangle(const GsDrawing& d, std::array<GsVertex, 3> p) {
    const Rgba last   = p[2].rgba;  // IIP 0 takes its colour
    std::int64_t area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
    if (area == 0) return;
    if (area < 0) {
        std::swap(p[1], p[2]);
        area = -area;
    }
    const int unit  = std::max(0, 30 - gs_bits_of(bits_at(d.registers[kZbuf], 24, 4) | 0x30));
    const bool z32  = gs_bits_of(bits_at(d.registers[kZbuf], 24, 4) | 0x30) == 32;
    const auto fine = [&](const GsVertex& v) { return z32 ? std::int64_t{v.z >> 2} : std::int64_t{v.z} << unit; };
    const Slope z(p, area, {fine(p[0]), fine(p[1]), fine(p[2])}, 12, 12);
    const auto [z_least, z_most] = std::minmax({fine(p[0]), fine(p[1]), fine(p[2])});
    const auto colour_slope = [&](int c) { return Slope(p, area, {p[0].rgba[c], p[1].rgba[c], p[2].rgba[c]}, 31, 16); };
    const std::array<Slope, 4> colors{colour_slope(0), colour_slope(1), colour_slope(2), colour_slope(3)};
    const Slope fog(p, area, {p[0].fog, p[1].fog, p[2].fog}, 31, 16);
    const auto floored = [](std::int32_t value) { return byte_of((value + 128) >> 15); };
    std::optional<TexelsOfTriangle> texels;
    if (is_on(d, 4)) texels.emplace(p, area, d.registers[kTex0]);

    const auto [x0, x1] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [y0, y1] = std::minmax({p[0].y, p[1].y, p[2].y});
    const Bounds b      = scissored(d, x0 >> 4, y0 >> 4, (x1 >> 4) + 1, (y1 >> 4) + 1);
    for (int y = b.y0; y <= b.y1; ++y) {
        for (int x = b.x0; x <= b.x1; ++x) {
            if (!is_inside(p[0], p[1], 16 * x, 16 * y) || !is_inside(p[1], p[2], 16 * x, 16 * y) ||
                !is_inside(p[2], p[0], 16 * x, 16 * y))
                continue;
            Rgba color = last;
            if (is_on(d, 3))
                for (int c = 0; c < 4; ++c) color[c] = floored(colors[c].at(x, y));
            if (texels) {
                const TexelsOfTriangle::Point point = texels->at(x, y);
                color                               = textured(d.registers[kTex0], sampled(d, point.u, point.v), color);
            }
            if (is_on(d, 5)) color = fogged(d, color, floored(fog.at(x, y)));
            const std::int64_t depth = std::min(std::max(std::int64_t{z.at(x, y)}, z_least), z_most);
            const auto units         = static_cast<std::uint32_t>(z32 ? depth * 4 + (depth >> 28) : depth >> unit);
            put(d, x, y, color, units);
        }
    }
}

namespace {

// Where the pixels of a sprite read along one axis, in 1/256 texel, see raster/sampling_rules.h.
class TexelsOfSprite {
  public:
    TexelsOfSprite(std::int64_t x0, std::int64_t x1, double w0, double w1, bool in_blocks) : in_blocks_(in_blocks) {
        const double slope = (w1 - w0) * 68719476736.0 / static_cast<double>(x1 - x0);
        step_              = static_cast<std::uint64_t>(std::llrint(slope));
        start_ = static_cast<std::uint64_t>(std::llrint(w0 * 4294967296.0 + static_cast<double>(-x0) / 16.0 * slope));
    }
    std::int32_t at(int pixel) const {
        const int block           = in_blocks_ ? pixel & ~15 : pixel;
        const std::uint32_t value = whole(start_ + static_cast<std::uint64_t>(block) * step_) +
                                    static_cast<std::uint32_t>(pixel - block) * whole(step_);
        return static_cast<std::int32_t>(value) >> 8;
    }

  private:
    static std::uint32_t whole(std::uint64_t value) {
        return static_cast<std::uint32_t>(static_cast<std::int64_t>(value + 32768) >> 16);
    }
    bool in_blocks_;
    std::uint64_t start_ = 0, step_ = 0;
};

}  // namespace

void gs_sprite(const GsDrawing& d, const GsVertex& first, const GsVertex& second) {
    const std::uint64_t tex0 = d.registers[kTex0];
    const auto texels_of     = [&](std::uint32_t uv, float st, float q, int log2_at) {
        return is_on(d, 8) ? uv / 16.0
                               : std::ldexp(double{st} / double{q}, static_cast<int>(bits_at(tex0, log2_at, 4)));
    };
    std::int64_t x0 = first.x, x1 = second.x, y0 = first.y, y1 = second.y;
    if (x0 == x1 || y0 == y1) return;
    double u0 = texels_of(first.u, first.s, first.q, 26), u1 = texels_of(second.u, second.s, second.q, 26);
    double v0 = texels_of(first.v, first.t, first.q, 30), v1 = texels_of(second.v, second.t, second.q, 30);
    if (x0 > x1) std::swap(x0, x1), std::swap(u0, u1);
    if (y0 > y1) std::swap(y0, y1), std::swap(v0, v1);
    std::optional<TexelsOfSprite> across, down;
    if (is_on(d, 4)) across.emplace(x0, x1, u0, u1, true), down.emplace(y0, y1, v0, v1, false);
    // The left and top edges are the sprite's, the others are not.
    const Bounds b = scissored(d, (x0 + 15) >> 4, (y0 + 15) >> 4, ((x1 + 15) >> 4) - 1, ((y1 + 15) >> 4) - 1);
    for (int y = b.y0; y <= b.y1; ++y) {
        for (int x = b.x0; x <= b.x1; ++x) {
            Rgba color = second.rgba;
            if (across) color = textured(tex0, sampled(d, across->at(x), down->at(y)), color);
            if (is_on(d, 5)) color = fogged(d, color, static_cast<int>(second.fog));
            put(d, x, y, color, second.z);
        }
    }
}

}  // namespace test_support
