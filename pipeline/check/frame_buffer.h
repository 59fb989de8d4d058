// SPDX-License-Identifier: MIT
// Places in a frame buffer of a fixed width, which has colour and depth for each pixel: a colour target and its depth target
// lie at the same pixels, and targets may lie at one place if no pixel is needed for two of them at one time.
#pragma once

#include <optional>

#include "pipeline/check/memory_map.h"

namespace pipeline {

struct BufferSpot {
    std::int32_t x = 0, y = 0;
};

// spots: of each target of the frame, nothing for one that is not in the buffer. rows: down to the last one in use; a
// frame that has no room gets more than there are. A target that is wider than the buffer begins at its left edge.
struct BufferPlaces {
    std::vector<std::optional<BufferSpot>> spots;
    std::int32_t rows = 0;
    std::vector<MemoryClash> clashes;
};

// step: spots are at multiples of it.
BufferPlaces place_targets(const Frame& frame, const std::vector<bool>& is_in_buffer, std::int32_t width,
                           std::int32_t step);

}  // namespace pipeline
