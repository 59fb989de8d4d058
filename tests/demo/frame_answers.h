// SPDX-License-Identifier: MIT
// Answers to the frames of demo/frames, worked out by hand from the rules in pipeline/frame/ and from what is known of
// the chips: colours of pixels that stand side by side, and how many pixels of the output have a colour.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "demo/embedded_texts.h"
#include "pipeline/frame/frame_text.h"
#include "tests/support/small_frame.h"

namespace demo {

struct Run {
    int x = 0, y = 0;
    std::vector<std::uint32_t> colors;
};
struct ColorCount {
    std::uint32_t color = 0;
    int pixels          = 0;
};
struct FrameAnswer {
    std::string_view name;
    std::vector<Run> runs;
    std::vector<ColorCount> counts;
};

// Opaque greys of these bytes.
inline std::vector<std::uint32_t> greys(std::initializer_list<std::uint32_t> bytes) {
    std::vector<std::uint32_t> colors;
    for (const std::uint32_t byte : bytes) colors.push_back(0xff000000 | byte * 0x010101);
    return colors;
}

inline std::string hex(std::uint32_t color) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (int shift = 28; shift >= 0; shift -= 4) text += kDigits[color >> shift & 15];
    return text;
}

// Draws the frame as it stands in its file.
inline void check_answer(const FrameAnswer& answer) {
    INFO(answer.name);
    const auto text = find_text(embedded_frames(), answer.name);
    REQUIRE(text.has_value());
    const pipeline::ColorImage output = test_support::draw_on_both(pipeline::parse_frame(text->text)).execution.output;
    for (const Run& run : answer.runs) {
        int x = run.x;
        for (const std::uint32_t color : run.colors) {
            INFO("pixel (" << x << ", " << run.y << ")");
            REQUIRE(x < output.width);
            REQUIRE(run.y < output.height);
            CHECK(hex(output.pixels[static_cast<std::size_t>(run.y * output.width + x)]) == hex(color));
            ++x;
        }
    }
    for (const ColorCount& expected : answer.counts) {
        INFO("pixels of " << hex(expected.color));
        CHECK(std::count(output.pixels.begin(), output.pixels.end(), expected.color) == expected.pixels);
    }
}

}  // namespace demo
