// SPDX-License-Identifier: MIT
// Frames of one rectangle with the counts of drawing it, and their costs.
#pragma once

#include <catch2/catch.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "pipeline/cost/cost.h"
#include "tests/support/small_frame.h"

namespace test_support {

using namespace pipeline;

inline const ChipRates& rates_of(std::string_view profile) {
    const ChipRates* rates = find_rates(profile);
    REQUIRE(rates != nullptr);
    return *rates;
}

inline PassCost first_cost(const Frame& frame, const PassCounts& counts, std::string_view profile) {
    return cost(frame, {counts}, rates_of(profile)).passes[0];
}

inline Frame frame_of_rectangle(int width, int height, std::optional<TargetFormat> depth = {}) {
    Frame frame           = small_frame(width, height, depth);
    frame.passes[0].draws = {rectangle({0, 0, width, height}, 0xffffffff)};
    return frame;
}

inline std::uint64_t area_of(int width, int height) {
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
}

// Opaque, without depth.
inline PassCounts replaced(std::uint64_t pixels) {
    return {.rectangles = 1, .covered = pixels, .depth_passed = pixels, .color_written = pixels, .bytes = pixels * 4};
}

// Binds one texture, size x size, to each of the first `stages`, one texel a pixel.
inline void bind_textures(Frame& frame, int stages, TextureFormat format, int width, int height, TextureFilter filter) {
    auto& draw = std::get<DrawRectangle>(frame.passes[0].draws[0]);
    for (int i = 0; i < stages; ++i) {
        const auto stage     = static_cast<std::size_t>(i);
        const auto bytes     = static_cast<std::size_t>(width * height * bytes_per_texel(format));
        draw.textures[stage] = bound(add_texture(frame, format, width, height, std::vector<std::uint8_t>(bytes)));
        frame.passes[0].state.stages[stage]        = kTextureOnly;
        frame.passes[0].state.stages[stage].filter = filter;
    }
}

inline PassCounts textured(std::uint64_t pixels, int stages, TextureFormat format, int taps) {
    PassCounts counts = replaced(pixels);
    counts.texels     = pixels * static_cast<std::uint64_t>(stages * taps);
    counts.bytes += counts.texels * static_cast<std::uint64_t>(bytes_per_texel(format));
    return counts;
}

inline std::vector<std::string_view> topics(const FrameCost& cost) {
    std::vector<std::string_view> names;
    for (const Evidence& evidence : cost.unknown) names.push_back(evidence.topic);
    return names;
}

// Millions of `amount` a second, from the most time to the least.
inline Range rate_of(double amount, const Range& ms) {
    return {amount / ms.most / 1e3, amount / ms.least / 1e3};
}

inline void check_range(const Range& range, double least, double most, double tolerance = 0.005) {
    CHECK(range.least == Approx(least).epsilon(tolerance));
    CHECK(range.most == Approx(most).epsilon(tolerance));
}

inline double clocks(double ms, const ChipRates& rates) {
    return ms * 1e3 * rates.clock.low;
}

}  // namespace test_support
