// SPDX-License-Identifier: MIT
#include "tests/extremes/sizes.h"

#include <new>
#include <stdexcept>

#include "pipeline/execute/execute.h"
#include "pipeline/validate/validate.h"
#include "tests/support/one_pass_frame.h"

namespace extremes {

using namespace pipeline;

Hits size_hits(int width, int height) {
    Frame frame = counting_frame(width, height, {});
    for (const auto& [x, y] : {std::pair{-1.0f, 1.0f}, {1.0f, 1.0f}, {1.0f, -1.0f}, {-1.0f, -1.0f}})
        frame.vertices.emplace_back().position = {x, y, 0.5f};
    frame.indices = {0, 1, 2, 0, 2, 3};
    count_with(frame);
    // The second pass of these has nothing to draw but the rectangle.
    DrawRectangle all;
    all.x1                 = static_cast<float>(width);
    all.y1                 = static_cast<float>(height);
    frame.passes[1].draws  = {all};
    const ColorImage image = execute(frame).output;
    Hits hits{.pixels = image.pixels.size()};
    for (const std::uint32_t pixel : image.pixels) hits.wrong += pixel != 0x00010100;
    return hits;
}

bool is_refused(int width, int height) {
    Frame frame                         = test_support::one_pass_frame(width, height);
    const std::vector<Finding> findings = validate(frame);
    if (findings.empty() || findings[0].what.find("must lie within 1..8192") == std::string::npos) return false;
    try {
        execute(frame);
    } catch (const std::invalid_argument&) {
        return true;
    } catch (const std::bad_alloc&) {
    }
    return false;
}

std::vector<Row> size_rows() {
    Hits hits;
    for (const auto& [width, height] : kSizes) hits += size_hits(width, height);
    std::uint64_t drawn = 0;
    for (const auto& [width, height] : kTooLarge) drawn += !is_refused(width, height);
    return {{"targets of any size", "1x1, 1x8,192, 8,192x1, odd, 8,192x8,192", "each pixel once",
             count_text(hits.wrong) + " wrong of " + count_text(hits.pixels), "8,192"},
            {"targets larger than that", "8,193 to 2^31 - 1", "refused before memory is taken",
             count_text(drawn) + " drawn of " + std::to_string(kTooLarge.size()), ""}};
}

}  // namespace extremes
