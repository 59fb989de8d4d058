// SPDX-License-Identifier: MIT
// Kernels: arithmetic on vertices, up to 64 at a time, as arrays of their coordinates. Single precision in the order
// that each formula is written in, and double where it says so; the same bits on every instruction set. Lanes from
// `count` on hold anything.
#pragma once

#include <array>
#include <cstdint>

#include "raster/primitives.h"

namespace raster {

inline constexpr int kVertexBlock = 64;

template <class Lane>
struct alignas(64) VertexLanes {
    Lane lanes[kVertexBlock];
    Lane& operator[](int i) { return lanes[i]; }
    const Lane& operator[](int i) const { return lanes[i]; }
};
struct Points3 {
    VertexLanes<float> x, y, z;
};
struct Points4 {
    VertexLanes<float> x, y, z, w;
};

// Column by column; a point p becomes (m0 x + m1 y) + (m2 z + m3), row by row.
using Matrix4 = std::array<std::array<float, 4>, 4>;

// From clip space to pixels, for a viewport of width x height pixels at (x, y):
//   x + (1 + cx / cw) * width / 2,  y + (1 - cy / cw) * height / 2,  cz / cw,  1 / cw
// kept within `band` pixels of the viewport, and 0..1. gx, gy: the band in half viewports.
struct WindowTransform {
    float x = 0, y = 0, width = 0, height = 0, band = 0;
    double gx = 1, gy = 1;
    float least_w = 0;  // greater than 0
    PixelGrid grid;
};

// What lies where, of a clip position c. The first bits are the sides of the viewport:
// w < least_w, z < 0, w < z, x < -w, x > w, y < -w, y > w.
enum PlaceFlags : std::uint32_t {
    kOutsideViewport = 0x7f,
    kOutsideBand     = 0x80,  // by w, by z, or |x| > gx * w, |y| > gy * w in double
    kNotFinite       = 0x100,
};

// x, y: snapped, of those without kOutsideBand and kNotFinite.
struct PlacedVertices {
    VertexLanes<std::int32_t> x, y;
    VertexLanes<std::uint32_t> flags;
};

// The factor (end - d) / span in double, as a float limited to 0..1, in 255ths: round(c * 255), half up. d: the
// distance from 0 in double if `by_distance`, else |z|. A span of 0 gives 0.
struct LinearFog {
    double end = 1, span = 1;
    bool by_distance = false;
};

// Directional lights and no highlights: round(c * 255), half up, of
//   c = emissive + ambient * light + diffuse * (sum of max(0, N.L) * colour)       limited to 0..1
// and of the alpha of `diffuse`. N: the normal times a matrix of three columns, (m0 x + m1 y) + m2 z, made of length 1
// in double if `normalize`. A NaN counts as 0.
struct DirectionalLighting {
    enum class Source : std::uint8_t { Constant, Color1, Color2 };
    struct Color {
        Source source = Source::Constant;
        std::array<float, 4> constant{};  // red, green, blue, alpha
    };
    struct Light {
        std::array<float, 3> to_light{}, color{};
    };
    static constexpr int kMaxLights = 8;

    std::array<std::array<float, 3>, 3> normal{};
    bool normalize = false;
    Color emissive, ambient, diffuse;
    std::array<float, 3> ambient_light{};
    std::array<Light, kMaxLights> lights;
    int light_count = 0;
};

struct VertexColors {
    VertexLanes<std::uint32_t> first, second;  // 0xAARRGGBB
};

struct VertexKernels {
    void (*transform)(const Matrix4& matrix, const Points3& in, int count, Points4& out);
    void (*place)(const WindowTransform& window, const Points4& clip, int count, PlacedVertices& out);
    // The window position: x, y, z, 1/w. Of those without kOutsideBand and kNotFinite.
    void (*to_window)(const WindowTransform& window, const Points4& clip, int count, Points4& out);
    void (*fog)(const LinearFog& fog, const Points4& camera, int count, VertexLanes<std::uint32_t>& out);
    void (*light)(const DirectionalLighting& lighting, const Points3& normals, const VertexColors& colors, int count,
                  VertexLanes<std::uint32_t>& out);
};
VertexKernels vertex_kernels();  // for this processor

}  // namespace raster
