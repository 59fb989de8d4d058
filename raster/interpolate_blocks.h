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
    void (*floor_color)(const std::array<Plane, 4>& planes, FragmentBatch& batch, BlockRows<std::uint32_t>& out);
    // u, v at the listed lanes; and lod, limited to lod_max, if that is greater than 0.
    void (*triangle_uv)(const TexturePlanes& planes, int lod_max, const FragmentBatch& batch, PackedPoints& packed);
    void (*rectangle_uv)(const SetUpRectangle::Texture& texture, int lod_max, FragmentBatch& batch);
    void (*constant)(std::uint32_t value, FragmentBatch& batch, BlockRows<std::uint32_t>& out);
};
InterpolateKernels interpolate_kernels();  // for this processor

// The level of detail of a rectangle, the same for all its pixels.
std::int32_t rectangle_lod(const SetUpRectangle::Texture& texture, int lod_max);

}  // namespace raster
