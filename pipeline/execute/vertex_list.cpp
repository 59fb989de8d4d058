// SPDX-License-Identifier: MIT
#include "pipeline/execute/vertex_list.h"

#include <algorithm>

namespace pipeline {

void VertexList::set(std::span<const std::uint32_t> indices) {
    listed_.clear();
    corners_ = indices;
    first_ = size_ = base_ = 0;
    if (indices.empty()) return;
    std::uint32_t least = indices[0], greatest = indices[0];
    for (const std::uint32_t index : indices) {
        least    = std::min(least, index);
        greatest = std::max(greatest, index);
    }
    const std::uint64_t interval = std::uint64_t{greatest} - least + 1;
    if (interval <= indices.size()) {
        first_ = base_ = least;
        size_          = static_cast<std::uint32_t>(interval);
        return;
    }
    if (interval <= 16 * indices.size())
        list_by_table(indices, least, interval);
    else
        list_by_sorting(indices);
    corners_ = listed_corners_;
    size_    = static_cast<std::uint32_t>(listed_.size());
}

// In the order of first use.
void VertexList::list_by_table(std::span<const std::uint32_t> indices, std::uint32_t least, std::size_t interval) {
    constexpr std::uint32_t kUnused = 0xffffffff;
    table_.assign(interval, kUnused);
    listed_corners_.resize(indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        std::uint32_t& place = table_[indices[i] - least];
        if (place == kUnused) {
            place = static_cast<std::uint32_t>(listed_.size());
            listed_.push_back(indices[i]);
        }
        listed_corners_[i] = place;
    }
}

// Few indices far apart must not cost time and memory for all that lies between them.
void VertexList::list_by_sorting(std::span<const std::uint32_t> indices) {
    listed_.assign(indices.begin(), indices.end());
    std::sort(listed_.begin(), listed_.end());
    listed_.erase(std::unique(listed_.begin(), listed_.end()), listed_.end());
    listed_corners_.resize(indices.size());
    std::transform(indices.begin(), indices.end(), listed_corners_.begin(), [&](std::uint32_t index) {
        return static_cast<std::uint32_t>(std::lower_bound(listed_.begin(), listed_.end(), index) - listed_.begin());
    });
}

}  // namespace pipeline
