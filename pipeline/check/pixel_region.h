// SPDX-License-Identifier: MIT
// Sets of pixels, kept as rectangles that do not overlap. As a set, a PixelRect without width or height is empty, so that
// {}, which means "the whole target" in a state, has no pixels here.
#pragma once

#include <vector>

#include "pipeline/frame/pipeline_state.h"

namespace pipeline {

constexpr bool has_pixels(const PixelRect& rect) {
    return rect.x0 < rect.x1 && rect.y0 < rect.y1;
}
constexpr bool contains(const PixelRect& outer, const PixelRect& inner) {
    return !has_pixels(inner) ||
           (outer.x0 <= inner.x0 && outer.y0 <= inner.y0 && outer.x1 >= inner.x1 && outer.y1 >= inner.y1);
}
PixelRect common_part(const PixelRect& a, const PixelRect& b);

class PixelRegion {
  public:
    PixelRegion() = default;
    explicit PixelRegion(const PixelRect& rect) { add(rect); }

    void add(const PixelRect& rect);
    void add(const PixelRegion& other);
    void remove(const PixelRect& rect);
    void remove(const PixelRegion& other);

    PixelRegion common_with(const PixelRegion& other) const;

    const std::vector<PixelRect>& parts() const { return parts_; }
    bool empty() const { return parts_.empty(); }
    std::int64_t pixels() const;
    PixelRect bounds() const;  // {} of the empty region

  private:
    void append(const PixelRect& rect);
    void join_neighbours();

    std::vector<PixelRect> parts_;
};

inline PixelRegion common_part(const PixelRegion& a, const PixelRegion& b) {
    return a.common_with(b);
}
PixelRegion without(PixelRegion a, const PixelRegion& b);

// Would they have a pixel in common, were b moved by (dx, dy)?
bool meet(const PixelRegion& a, const PixelRegion& b, std::int32_t dx = 0, std::int32_t dy = 0);

}  // namespace pipeline
