// SPDX-License-Identifier: MIT
// Tables of frames that differ from a known one in one thing, each with all the counts of its first pass.
#pragma once

#include <string>
#include <vector>

#include "tests/support/small_frame.h"

namespace test_support {

// Names each field, so that a new one is not forgotten here.
inline std::string text_of(const pipeline::PassCounts& counts) {
    const auto& [vertices, triangles_in, triangles_drawn, rectangles, copies, covered, depth_tested, depth_passed,
                 depth_written, color_written, blended, cleared, texels, bytes] = counts;
    std::string text;
    for (const auto& [name, value] : {std::pair{"vertices", vertices},
                                      {"triangles_in", triangles_in},
                                      {"triangles_drawn", triangles_drawn},
                                      {"rectangles", rectangles},
                                      {"copies", copies},
                                      {"covered", covered},
                                      {"depth_tested", depth_tested},
                                      {"depth_passed", depth_passed},
                                      {"depth_written", depth_written},
                                      {"color_written", color_written},
                                      {"blended", blended},
                                      {"cleared", cleared},
                                      {"texels", texels},
                                      {"bytes", bytes}})
        text += std::string(name) + ' ' + std::to_string(value) + '\n';
    return text;
}

struct CountRow {
    const char* name;
    void (*change)(pipeline::Frame&);
    pipeline::PassCounts expected;
};

inline void check_rows(const pipeline::Frame& base, const std::vector<CountRow>& rows) {
    for (const CountRow& row : rows) {
        INFO(row.name);
        pipeline::Frame frame = base;
        row.change(frame);
        const std::vector<pipeline::PassCounts> counts = draw_on_both(frame).execution.counts;
        REQUIRE(counts.size() == frame.passes.size());
        CHECK(text_of(counts[0]) == text_of(row.expected));
    }
}

}  // namespace test_support
