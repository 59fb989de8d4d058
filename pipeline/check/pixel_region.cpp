// SPDX-License-Identifier: MIT
#include "pipeline/check/pixel_region.h"

#include <algorithm>

namespace pipeline {

namespace {

// Above and below the hole, then left and right of it.
void append_outside(const PixelRect& rect, const PixelRect& hole, std::vector<PixelRect>& parts) {
    const PixelRect inner = common_part(rect, hole);
    if (!has_pixels(inner)) {
        parts.push_back(rect);
        return;
    }
    for (const PixelRect& part :
         {PixelRect{rect.x0, rect.y0, rect.x1, inner.y0}, PixelRect{rect.x0, inner.y1, rect.x1, rect.y1},
          PixelRect{rect.x0, inner.y0, inner.x0, inner.y1}, PixelRect{inner.x1, inner.y0, rect.x1, inner.y1}})
        if (has_pixels(part)) parts.push_back(part);
}

std::vector<PixelRect> outside(const std::vector<PixelRect>& rects, const PixelRect& hole) {
    std::vector<PixelRect> parts;
    for (const PixelRect& rect : rects) append_outside(rect, hole, parts);
    return parts;
}

// Are they one rectangle together?
bool can_join(const PixelRect& a, const PixelRect& b) {
    const bool in_rows    = a.y0 == b.y0 && a.y1 == b.y1 && (a.x1 == b.x0 || b.x1 == a.x0);
    const bool in_columns = a.x0 == b.x0 && a.x1 == b.x1 && (a.y1 == b.y0 || b.y1 == a.y0);
    return in_rows || in_columns;
}

PixelRect around(const PixelRect& a, const PixelRect& b) {
    return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

}  // namespace

PixelRect common_part(const PixelRect& a, const PixelRect& b) {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

void PixelRegion::append(const PixelRect& rect) {
    if (!has_pixels(rect)) return;
    std::erase_if(parts_, [&](const PixelRect& part) { return contains(rect, part); });
    std::vector<PixelRect> added{rect};
    for (const PixelRect& part : parts_) added = outside(added, part);
    parts_.insert(parts_.end(), added.begin(), added.end());
}

void PixelRegion::add(const PixelRect& rect) {
    append(rect);
    join_neighbours();
}

void PixelRegion::add(const PixelRegion& other) {
    for (const PixelRect& part : other.parts_) append(part);
    join_neighbours();
}

void PixelRegion::remove(const PixelRect& rect) {
    parts_ = outside(parts_, rect);
    join_neighbours();
}

void PixelRegion::remove(const PixelRegion& other) {
    for (const PixelRect& part : other.parts_) parts_ = outside(parts_, part);
    join_neighbours();
}

std::int64_t PixelRegion::pixels() const {
    std::int64_t count = 0;
    for (const PixelRect& part : parts_) count += std::int64_t{part.x1 - part.x0} * (part.y1 - part.y0);
    return count;
}

PixelRect PixelRegion::bounds() const {
    PixelRect bounds = parts_.empty() ? PixelRect{} : parts_[0];
    for (const PixelRect& part : parts_) bounds = around(bounds, part);
    return bounds;
}

// What is joined may join others in turn.
void PixelRegion::join_neighbours() {
    for (std::size_t i = 0; i < parts_.size();) {
        const auto other = std::find_if(parts_.begin() + static_cast<std::ptrdiff_t>(i) + 1, parts_.end(),
                                        [&](const PixelRect& part) { return can_join(parts_[i], part); });
        if (other == parts_.end()) {
            ++i;
            continue;
        }
        parts_[i] = around(parts_[i], *other);
        parts_.erase(other);
        i = 0;
    }
}

PixelRegion PixelRegion::common_with(const PixelRegion& other) const {
    PixelRegion common;
    for (const PixelRect& one : parts_)
        for (const PixelRect& another : other.parts_)
            if (const PixelRect part = common_part(one, another); has_pixels(part)) common.parts_.push_back(part);
    common.join_neighbours();
    return common;
}

PixelRegion without(PixelRegion a, const PixelRegion& b) {
    a.remove(b);
    return a;
}

bool meet(const PixelRegion& a, const PixelRegion& b, std::int32_t dx, std::int32_t dy) {
    return std::any_of(a.parts().begin(), a.parts().end(), [&](const PixelRect& one) {
        return std::any_of(b.parts().begin(), b.parts().end(), [&](const PixelRect& other) {
            return has_pixels(common_part(one, {other.x0 + dx, other.y0 + dy, other.x1 + dx, other.y1 + dy}));
        });
    });
}

}  // namespace pipeline
