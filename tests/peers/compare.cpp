// SPDX-License-Identifier: MIT
#include "tests/peers/compare.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

namespace peers {

using namespace pipeline;

namespace {

constexpr int kShifts[] = {0, 8, 16, 24};

int channel(std::uint32_t color, int shift) {
    return static_cast<int>(color >> shift & 255);
}

int greatest_difference(std::uint32_t a, std::uint32_t b) {
    int greatest = 0;
    for (const int shift : kShifts) greatest = std::max(greatest, std::abs(channel(a, shift) - channel(b, shift)));
    return greatest;
}

template <class Choose>
std::uint32_t each_channel(std::uint32_t a, std::uint32_t b, Choose&& choose) {
    std::uint32_t result = 0;
    for (const int shift : kShifts)
        result |= static_cast<std::uint32_t>(choose(channel(a, shift), channel(b, shift))) << shift;
    return result;
}

// A worse one replaces the worst so far; a failed one any that is within its bound.
void consider(const Difference& difference, bool has_failed, Comparison& comparison) {
    const bool first_failure = has_failed && comparison.failed == 1;
    const bool same_kind     = has_failed == (comparison.failed > 0);
    if (first_failure || (same_kind && difference.units > comparison.worst.units)) comparison.worst = difference;
}

}  // namespace

void Envelope::include(const ColorImage& picture) {
    assert(picture.pixels.size() == least_.size());
    for (std::size_t i = 0; i < least_.size(); ++i) {
        if (picture.pixels[i] == least_[i] && picture.pixels[i] == greatest_[i]) continue;
        least_[i]    = each_channel(least_[i], picture.pixels[i], [](int a, int b) { return std::min(a, b); });
        greatest_[i] = each_channel(greatest_[i], picture.pixels[i], [](int a, int b) { return std::max(a, b); });
    }
}

bool Envelope::contains(std::size_t pixel, std::uint32_t value, int tolerance) const {
    return std::all_of(std::begin(kShifts), std::end(kShifts), [&](int shift) {
        return channel(value, shift) >= channel(least_[pixel], shift) - tolerance &&
               channel(value, shift) <= channel(greatest_[pixel], shift) + tolerance;
    });
}

double Comparison::mean() const {
    return pixels == edge ? 0.0 : sum / static_cast<double>(4 * (pixels - edge));
}

bool leans(const Comparison& comparison) {
    constexpr double kMostMean = 0.05;
    return std::abs(comparison.mean()) > kMostMean + comparison.explained_mean;
}

bool is_suspect(const Comparison& comparison) {
    constexpr std::uint64_t kEnoughPixels = 10000, kPixelsPerEdge = 500;
    const auto edges       = static_cast<double>(comparison.pixels / kPixelsPerEdge);
    const double by_chance = 3.0 * std::sqrt(edges);
    return comparison.pixels >= kEnoughPixels &&
           (leans(comparison) || static_cast<double>(comparison.edge) > edges + by_chance);
}

void Comparison::add(const Comparison& other) {
    const bool worse_kind = (other.failed > 0) != (failed > 0) ? other.failed > 0 : other.worst.units > worst.units;
    if (worse_kind) worst = other.worst;
    pixels += other.pixels;
    differing += other.differing;
    edge += other.edge;
    failed += other.failed;
    sum += other.sum;
}

Comparison compare(const ColorImage& ours, const ColorImage& peers, const Limits& limits) {
    assert(ours.width == peers.width && ours.height == peers.height);
    Comparison result{.pixels = ours.pixels.size()};
    if (ours.pixels == peers.pixels) return result;
    const std::vector<int> allowed = limits.by_rounding();

    std::vector<std::size_t> beyond;
    const auto difference_at = [&](std::size_t i) {
        const auto width = static_cast<std::size_t>(ours.width);
        return Difference{.x     = static_cast<int>(i % width),
                          .y     = static_cast<int>(i / width),
                          .ours  = ours.pixels[i],
                          .peers = peers.pixels[i],
                          .units = greatest_difference(ours.pixels[i], peers.pixels[i])};
    };
    const auto add = [&](const Difference& difference, bool has_failed) {
        for (const int shift : kShifts)
            result.sum += channel(difference.peers, shift) - channel(difference.ours, shift);
        consider(difference, has_failed, result);
    };
    for (std::size_t i = 0; i < ours.pixels.size(); ++i) {
        if (ours.pixels[i] == peers.pixels[i]) continue;
        ++result.differing;
        const Difference difference = difference_at(i);
        if (difference.units <= allowed[i] || difference.units <= limits.with_perspective(difference.x, difference.y))
            add(difference, false);
        else
            beyond.push_back(i);
    }
    if (beyond.empty()) return result;

    const Envelope envelope = limits.envelope();
    for (const std::size_t i : beyond) {
        const Difference difference = difference_at(i);
        const bool moves =
            envelope.changes(i) && envelope.contains(i, peers.pixels[i], limits.of_nudged(difference.x, difference.y));
        const bool is_near = difference.units <= limits.at_edge(difference.x, difference.y);
        if (moves || is_near || limits.is_excused(difference.x, difference.y)) {
            ++result.edge;
        } else {
            ++result.failed;
            add(difference, true);
        }
    }
    return result;
}

}  // namespace peers
