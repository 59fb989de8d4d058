// SPDX-License-Identifier: MIT
#include "demo/pass_statistics.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string_view>

#include "demo/text_table.h"

namespace demo {
namespace {

using pipeline::PassCounts;

// heading: of the table's column; none for the counts that the table leaves out.
struct Count {
    std::string_view name, heading;
    std::uint64_t PassCounts::*value;
};
constexpr std::array kCounts{
    Count{"vertices", "", &PassCounts::vertices},
    Count{"triangles_in", "", &PassCounts::triangles_in},
    Count{"triangles_drawn", "triangles", &PassCounts::triangles_drawn},
    Count{"rectangles", "rects", &PassCounts::rectangles},
    Count{"copies", "", &PassCounts::copies},
    Count{"covered", "covered", &PassCounts::covered},
    Count{"depth_tested", "z-tested", &PassCounts::depth_tested},
    Count{"depth_passed", "z-passed", &PassCounts::depth_passed},
    Count{"depth_written", "", &PassCounts::depth_written},
    Count{"color_written", "written", &PassCounts::color_written},
    Count{"blended", "blended", &PassCounts::blended},
    Count{"cleared", "", &PassCounts::cleared},
    Count{"texels", "texels", &PassCounts::texels},
    Count{"bytes", "bytes", &PassCounts::bytes},
};
static_assert(sizeof(PassCounts) == kCounts.size() * sizeof(std::uint64_t), "a count is not listed");

TextRow row_of(const std::string& number, const PassStatistics& pass) {
    TextRow row{number, pass.label};
    for (const Count& count : kCounts) {
        if (!count.heading.empty()) row.push_back(with_separators(pass.counts.*count.value));
    }
    row.push_back(with_separators(pass.kernels.general));
    char milliseconds[32];
    std::snprintf(milliseconds, sizeof milliseconds, "%.2f", pass.milliseconds);
    row.push_back(milliseconds);
    return row;
}

}  // namespace

std::string to_table(const std::vector<PassStatistics>& passes) {
    TextRow headings{"", "pass"};
    for (const Count& count : kCounts) {
        if (!count.heading.empty()) headings.emplace_back(count.heading);
    }
    headings.push_back("general");
    headings.push_back("ms");

    std::vector<TextRow> rows{headings};
    PassStatistics total{.label = "total", .counts = {}, .kernels = {}};
    for (std::size_t i = 0; i < passes.size(); ++i) {
        rows.push_back(row_of(std::to_string(i), passes[i]));
        for (const Count& count : kCounts) total.counts.*count.value += passes[i].counts.*count.value;
        total.kernels.general += passes[i].kernels.general;
        total.milliseconds += passes[i].milliseconds;
    }
    rows.push_back(row_of("", total));

    return text_table(rows, "rlr");
}

nlohmann::ordered_json to_json(const PassStatistics& pass) {
    nlohmann::ordered_json object;
    object["label"] = pass.label;
    for (const Count& count : kCounts) object[std::string(count.name)] = pass.counts.*count.value;
    object["special_kernel"] = pass.kernels.special;
    object["general_kernel"] = pass.kernels.general;
    object["milliseconds"]   = pass.milliseconds;
    return object;
}

}  // namespace demo
