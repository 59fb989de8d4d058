// SPDX-License-Identifier: MIT
// Triangles and sprites as the Graphics Synthesizer fills them, for tests: from registers to local memory. What the chip does to
// a pixel is written from its description; how it interpolates is not known, and stands here as raster/primitives.h and
// raster/sampling_rules.h say, in words of its own.
#pragma once

#include <array>
#include <cstdint>

#include "tests/support/gs_local_memory.h"

namespace test_support {

// Bits `shift` and up of a register's value.
constexpr std::uint32_t bits_at(std::uint64_t value, int shift, int width) {
    return static_cast<std::uint32_t>(value >> shift & ((std::uint64_t{1} << width) - 1));
}

struct GsVertex {
    std::int64_t x = 0, y = 0;  // 1/16 pixel of the window
    std::uint32_t z = 0, fog = 255;
    std::array<int, 4> rgba{};
    float s = 0, t = 0, q = 1;
    std::uint32_t u = 0, v = 0;  // 1/16 texel
};

// What draws read. registers: by address. texels: memory as it was at the last TEXFLUSH, which is what textures are read from.
struct GsDrawing {
    const std::array<std::uint64_t, 128>& registers;
    const std::array<std::uint32_t, 256>& palette;
    const GsLocalMemory& texels;
    GsLocalMemory& memory;
};

void gs_triangle(const GsDrawing& drawing, std::array<GsVertex, 3> corners);
void gs_sprite(const GsDrawing& drawing, const GsVertex& first, const GsVertex& second);

// 0xAARRGGBB of a pixel of a frame buffer.
std::uint32_t gs_argb(std::uint32_t format, std::uint32_t pixel);

}  // namespace test_support
