// SPDX-License-Identifier: MIT
// Kernels: planes to depth, colours and texture coordinates, at every lane of a batch, by the rules of raster/primitives.h and
// raster/sampling_rules.h.
#pragma once

#include <array>
#include <cstdint>

#include "raster/fragment_batch.h"
#include "raster/triangle_setup.h"

namespace raster {

struct InterpolateKernels {
    void (*depth)(const SetUpTriangle& triangle, int depth_bits, FragmentBatch& batch);
    void (*color)(const std::array<Plane, 4>& planes, FragmentBatch& batch, BlockRows<std::uint32_t>& out);
    // batch.points: u, v; and lod, limited to lod_max, if that is greater than 0.
    void (*triangle_uv)(const TexturePlanes& planes, int lod_max, FragmentBatch& batch);
    void (*rectangle_uv)(const SetUpRectangle::Texture& texture, int lod_max, FragmentBatch& batch);
    void (*constant)(std::uint32_t value, FragmentBatch& batch, BlockRows<std::uint32_t>& out);
};
InterpolateKernels interpolate_kernels();  // for this processor

// Of a format with `bits` bits, from the 30 bits that are interpolated.
constexpr std::uint32_t to_depth_format(std::uint32_t depth, int bits) {
    return bits == 32 ? depth << 2 | depth >> 28 : depth >> (kDepthBits - bits);
}

// The level of detail of a rectangle, the same for all its pixels.
std::int32_t rectangle_lod(const SetUpRectangle::Texture& texture, int lod_max);

}  // namespace raster
