// SPDX-License-Identifier: MIT
// The vertices that a range of indices uses: all of an interval, or, where indices are few and far apart, a list of
// them. Place i of the vertices is `first + i` of Frame::vertices, or `listed[i]`.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace pipeline {

class VertexList {
  public:
    void set(std::span<const std::uint32_t> indices);  // keeps the memory it had

    std::uint32_t size() const { return size_; }
    std::uint32_t vertex(std::uint32_t place) const { return listed_.empty() ? first_ + place : listed_[place]; }

    // For each index of the range, the place of its vertex.
    std::uint32_t corner(std::size_t i) const { return corners_[i] - base_; }
    std::size_t corner_count() const { return corners_.size(); }

  private:
    void list_by_table(std::span<const std::uint32_t> indices, std::uint32_t least, std::size_t interval);
    void list_by_sorting(std::span<const std::uint32_t> indices);

    std::uint32_t first_ = 0, size_ = 0, base_ = 0;
    std::span<const std::uint32_t> corners_;
    std::vector<std::uint32_t> listed_, listed_corners_, table_;
};

}  // namespace pipeline
