// SPDX-License-Identifier: MIT
#include "pipeline/check/frame_buffer.h"

#include <algorithm>

#include "pipeline/check/needed_pixels.h"
#include "pipeline/check/target_use.h"

namespace pipeline {

namespace {

// Targets that lie at the same pixels: those that passes draw to together, directly or through others. All have one
// size, as the targets of a pass do.
struct Group {
    std::vector<std::size_t> members;
    std::int32_t width = 0, height = 0;
    bool has_color = false, has_depth = false;
    BufferSpot spot;
};

// The first pass in which targets at spots that lie (dx, dy) apart need the same pixel; nothing if none does.
std::optional<std::size_t> first_meeting(const std::vector<PixelRegion>& one, const std::vector<PixelRegion>& other,
                                         std::int32_t dx = 0, std::int32_t dy = 0) {
    for (std::size_t pass = 0; pass < one.size(); ++pass)
        if (meet(one[pass], other[pass], dx, dy)) return pass;
    return {};
}

class Placement {
  public:
    Placement(const Frame& frame, const std::vector<bool>& is_in_buffer, std::int32_t width, std::int32_t step)
        : frame_(frame), needed_(frame.targets.size()), width_(width), step_(step) {
        for (std::size_t i = 0; i < needed_.size(); ++i)
            if (is_in_buffer[i]) needed_[i] = needed_pixels(frame, {static_cast<std::int32_t>(i)});
        make_groups(is_in_buffer);
        // The largest first: what is small finds room beside it.
        std::stable_sort(groups_.begin(), groups_.end(), [](const Group& a, const Group& b) {
            return std::int64_t{a.width} * a.height > std::int64_t{b.width} * b.height;
        });
        for (std::size_t i = 0; i < groups_.size(); ++i) groups_[i].spot = first_free_spot(i);
    }

    BufferPlaces places() const {
        BufferPlaces out;
        out.spots.resize(frame_.targets.size());
        for (const Group& group : groups_) {
            for (const std::size_t member : group.members) out.spots[member] = group.spot;
            out.rows = std::max(out.rows, group.spot.y + group.height);
            add_clashes(group, out.clashes);
        }
        std::sort(out.clashes.begin(), out.clashes.end(), [](const MemoryClash& a, const MemoryClash& b) {
            return std::pair(a.one.index, a.other.index) < std::pair(b.one.index, b.other.index);
        });
        return out;
    }

  private:
    bool is_depth_target(std::size_t index) const { return is_depth(frame_.targets[index].format); }

    void make_groups(const std::vector<bool>& is_in_buffer) {
        std::vector<std::size_t> group_of(frame_.targets.size());
        for (std::size_t i = 0; i < group_of.size(); ++i) group_of[i] = i;
        for (const Pass& pass : frame_.passes) {
            if (!uses_depth(pass) || find_target(frame_, pass.color) == nullptr ||
                find_target(frame_, pass.depth) == nullptr)
                continue;
            const std::size_t color = static_cast<std::size_t>(pass.color.index),
                              depth = static_cast<std::size_t>(pass.depth.index);
            if (!is_in_buffer[color] || !is_in_buffer[depth]) continue;
            std::replace(group_of.begin(), group_of.end(), std::size_t{group_of[depth]}, std::size_t{group_of[color]});
        }
        for (std::size_t i = 0; i < group_of.size(); ++i) {
            Group group;
            for (std::size_t member = 0; member < group_of.size(); ++member)
                if (group_of[member] == i && is_in_buffer[member]) join(group, member);
            if (!group.members.empty()) groups_.push_back(group);
        }
    }

    void join(Group& group, std::size_t member) const {
        const Target& target = frame_.targets[member];
        group.members.push_back(member);
        group.width     = std::max(group.width, target.width);
        group.height    = std::max(group.height, target.height);
        group.has_color = group.has_color || !is_depth(target.format);
        group.has_depth = group.has_depth || is_depth(target.format);
    }

    // Do two groups need the same pixel at one time, if the one lies at `spot`?
    bool would_clash(const Group& group, const BufferSpot& spot, const Group& other) const {
        for (const std::size_t one : group.members)
            for (const std::size_t another : other.members)
                if (is_depth_target(one) == is_depth_target(another) &&
                    first_meeting(needed_[one], needed_[another], other.spot.x - spot.x, other.spot.y - spot.y))
                    return true;
        return false;
    }

    bool is_free(std::size_t index, const BufferSpot& spot) const {
        const Group& group = groups_[index];
        if (spot.x > 0 && spot.x + group.width > width_) return false;
        for (std::size_t i = 0; i < index; ++i) {
            const Group& other  = groups_[i];
            const bool is_apart = spot.x >= other.spot.x + other.width || other.spot.x >= spot.x + group.width ||
                                  spot.y >= other.spot.y + other.height || other.spot.y >= spot.y + group.height;
            if (!is_apart && would_clash(group, spot, other)) return false;
        }
        return true;
    }

    // Of the corners that the groups before it leave, the topmost and then leftmost one with room.
    BufferSpot first_free_spot(std::size_t index) const {
        std::vector<std::int32_t> xs{0}, ys{0};
        for (std::size_t i = 0; i < index; ++i) {
            xs.push_back(stepped(groups_[i].spot.x + groups_[i].width));
            ys.push_back(stepped(groups_[i].spot.y + groups_[i].height));
        }
        std::sort(xs.begin(), xs.end());
        std::sort(ys.begin(), ys.end());
        for (const std::int32_t y : ys)
            for (const std::int32_t x : xs)
                if (is_free(index, {x, y})) return {x, y};
        return {0, ys.back()};  // below all others there is always room
    }

    std::int32_t stepped(std::int32_t pixel) const { return (pixel + step_ - 1) / step_ * step_; }

    void add_clashes(const Group& group, std::vector<MemoryClash>& clashes) const {
        for (std::size_t i = 0; i < group.members.size(); ++i) {
            for (std::size_t k = i + 1; k < group.members.size(); ++k) {
                const std::size_t one = group.members[i], other = group.members[k];
                if (is_depth_target(one) != is_depth_target(other)) continue;
                if (const auto pass = first_meeting(needed_[one], needed_[other]))
                    clashes.push_back({{static_cast<std::int32_t>(one)}, {static_cast<std::int32_t>(other)}, *pass});
            }
        }
    }

    const Frame& frame_;
    std::vector<std::vector<PixelRegion>> needed_;
    std::int32_t width_, step_;
    std::vector<Group> groups_;
};

}  // namespace

BufferPlaces place_targets(const Frame& frame, const std::vector<bool>& is_in_buffer, std::int32_t width,
                           std::int32_t step) {
    return Placement(frame, is_in_buffer, width, step).places();
}

}  // namespace pipeline
