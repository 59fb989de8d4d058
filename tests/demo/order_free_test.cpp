// SPDX-License-Identifier: MIT
// A cloud drawn after all else is the cloud drawn in its place: no object behind it comes through its middle.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "demo/scene.h"
#include "pipeline/execute/execute.h"

namespace {

using pipeline::ColorImage;

ColorImage smoke(cloud::Order order, int frame) {
    demo::FrameOptions options;
    options.order = order;
    pipeline::Executor executor;
    pipeline::Execution execution;
    executor.execute(demo::scene_frame(*demo::load_scene("smoke"), {1280, 720}, frame, options), execution);
    return execution.output;
}

bool differ(std::uint32_t a, std::uint32_t b) {
    for (const int shift : {0, 8, 16})
        if (std::abs(static_cast<int>(a >> shift & 255) - static_cast<int>(b >> shift & 255)) > 24) return true;
    return false;
}

// Pixels that differ where none does some pixels further on, in all four directions: edges of what stands before the cloud
// may differ, and are longer than that.
int count_holes(const ColorImage& a, const ColorImage& b) {
    constexpr int kReach = 12;
    const auto differ_at = [&](int x, int y) {
        const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) + static_cast<std::size_t>(x);
        return differ(a.pixels[i], b.pixels[i]);
    };
    int holes = 0;
    for (int y = kReach; y < a.height - kReach; ++y)
        for (int x = kReach; x < a.width - kReach; ++x)
            holes += differ_at(x, y) && !differ_at(x - kReach, y) && !differ_at(x + kReach, y) &&
                     !differ_at(x, y - kReach) && !differ_at(x, y + kReach);
    return holes;
}

}  // namespace

TEST_CASE("nothing is seen through smoke that is drawn after the scene", "[scene]") {
    const int frame = GENERATE(40, 60, 80);
    CAPTURE(frame);
    CHECK(count_holes(smoke(cloud::Order::OrderFree, frame), smoke(cloud::Order::InOrder, frame)) == 0);
}
