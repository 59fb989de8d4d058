// SPDX-License-Identifier: MIT
// How a pixel reads a texture: from coordinates to a colour of four bytes. W, H: the size of level 0 in texels. Every
// float operation below is one IEEE single-precision operation, in the order written; nothing is fused or estimated.
//
// Coordinates of a triangle. With Si = s * rhw, Ti = t * rhw, Qi = q * rhw (each one float product) at the vertices and
//   e  = the largest integer <= 60 with max(|Si|, |Ti|) * 2^e  <  2^29   (60 if all are 0)
//   eq = the largest integer <= 90 with max(|Qi|) * 2^eq < 2^29          (90 if all are 0)
// the vertex integers are Si * 2^e, Ti * 2^e, Qi * 2^eq, rounded to nearest, ties to even; primitives.h says how they
// become s, t, q at a pixel. q is then raised to at least 1. With ku = float(2^(eq-e) * W), kv = float(2^(eq-e) * H):
//   r = 1 / float(q)         u = float(s) * r         v = float(t) * r
//   U = floor(clamp((u * ku) * 256))                  V = floor(clamp((v * kv) * 256))        clamp to -2^30 .. 2^30
// in 1/256 texel of level 0.
// Coordinates of a rectangle. In double, with Xi, Yi the snapped corners and w = float u -> double u * W:
//   du = (w1 - w0) * 2^36 / (X1 - X0)                 step = du, kept within -2^62 .. 2^62, to nearest, ties to even
//   origin = w0 * 2^32 + (C - X0) / 16 * du           kept and rounded likewise
//   plane(x) = origin + x * step (modulo 2^64)
//   U = value >> 8 (arithmetic), value being r(plane(xb), 16) + (x - xb) * r(step, 16) modulo 2^32 (r: primitives.h)
// and V from v, H, y in the same way, with plane(y) itself in place of the block: V = r(plane(y), 16) >> 8, the shift
// again of 32 bits.
//
// Level of detail, in 1/256 level, only where the sampler uses mips. Triangle: sx = float of the step of s divided by
// 2^12 (computed in double), sy of step_y, and so on; all at the pixel:
//   ux = ((sx - u * qx) * r) * ku    vx = ((tx - v * qx) * r) * kv    uy = ((sy - u * qy) * r) * ku    vy likewise
// Rectangle: ux = float(step_u / 2^32), vy = float(step_v / 2^32), both divisions in double, and vx = uy = 0.
//   rho2 = max(ux * ux + vx * vx, uy * uy + vy * vy)
//   lod  = (bits(rho2) - bits(1.0f)) >> 16 (arithmetic), at least 0, at most 256 * (levels - 1)
// bits() being the float's bit pattern as an integer: a logarithm that is linear between powers of two.
// Mip Point reads level (lod + 128) >> 8. Mip Linear reads a = level lod >> 8 and b = the next (or the last again) and
// mixes each channel with f = lod & 255. Mip None reads level 0.
//
// Within level L, with (u, v) = (U >> L, V >> L), arithmetic:
//   Point   the texel (u >> 8, v >> 8).
//   Linear  u -= 128, v -= 128; i = u >> 8, fu = u & 255, likewise j, fv. Of the texels at i, i+1 and j, j+1, each
//           channel is weighed by `rule`:
//     Single8   (((256-fv) * ((256-fu) * t00 + fu * t10) + fv * ((256-fu) * t01 + fu * t11)) + 2^15) >> 16
//     Single4   with fu, fv >> 4 for fu, fv: (((16-fv) * ((16-fu) * t00 + fu * t10) + fv * (...)) + 2^7) >> 8
//     Single7   with fu, fv >> 1: ((128-fv) * ((128-fu) * t00 + fu * t10) + fv * (...)) >> 14
//     Cascade8  along u, then along v: a, b, f -> ((256-f) * a + f * b + 128) >> 8
//     Cascade4  along u, then along v, with fu, fv >> 4: a, b, f -> ((16-f) * a + f * b) >> 4
// Levels a, b are mixed to (a * (256 - f) + b * f + 128) >> 8 by Single8 and Cascade8, and by the others, with f >> 4, to
// (a * (16 - f) + b * f) >> 4.
// Texel indices outside a level of size n (per axis): Wrap i & (n-1); Mirror m = i & (2n-1), then m if m < n, else 2n-1-m;
// Clamp to 0..n-1. Wrap and Mirror need n to be a power of two.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace raster {

enum class Address : std::uint8_t { Wrap, Clamp, Mirror };
enum class MipFilter : std::uint8_t { None, Point, Linear };
enum class FilterRule : std::uint8_t { Single8, Single4, Single7, Cascade8, Cascade4 };

// Texels are 0xAARRGGBB. `stride` in texels. The memory outlives the fill.
struct TextureLevel {
    const std::uint32_t* texels = nullptr;
    int width = 0, height = 0;
    std::ptrdiff_t stride = 0;
};

// No levels: every texel is white. At most 14, from 8192 texels down to 1.
// alpha_quads: none, or the same levels of a texture that has nothing but alpha, as in raster/alpha_quads.h; it is quicker
// to read where it serves. Where all that reads the texture is served by it, the levels have no texels.
struct Sampler {
    std::vector<TextureLevel> levels, alpha_quads;
    bool linear       = false;
    FilterRule rule   = FilterRule::Single8;
    MipFilter mip     = MipFilter::None;
    Address address_u = Address::Wrap;
    Address address_v = Address::Wrap;
    int texel_bytes   = 4;  // of a texel in the format that is modelled, for counting
};

}  // namespace raster
