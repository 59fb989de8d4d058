// SPDX-License-Identifier: MIT
#include "demo/chip_table.h"

#include <cstdio>
#include <cstdlib>

#include "pipeline/check/memory_map.h"
#include "pipeline/execute/execute.h"

namespace demo {
namespace {

using pipeline::ColorImage;
using pipeline::Execution;
using pipeline::Frame;

std::string number(double value, const char* format) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

double mean_difference(const ColorImage& a, const ColorImage& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        for (const int shift : {0, 8, 16})
            sum +=
                std::abs(static_cast<int>(a.pixels[i] >> shift & 255) - static_cast<int>(b.pixels[i] >> shift & 255));
    return sum / (3.0 * static_cast<double>(a.pixels.size()));
}

std::string memory_text(const Frame& frame, const pipeline::Profile& profile) {
    const pipeline::MemoryRegion region = pipeline::lay_out(frame, profile).regions.front();
    const auto mega                     = [](std::uint64_t bytes) { return static_cast<double>(bytes) / (1u << 20); };
    return number(mega(region.used), "%.2f") + " of " + number(mega(region.budget), "%.2f") + " MB";
}

std::string layers_text(const Execution& drawn) {
    double blended = 0.0;
    for (const pipeline::PassCounts& counts : drawn.counts) blended += static_cast<double>(counts.blended);
    return number(blended / (static_cast<double>(drawn.output.width) * drawn.output.height), "%.2f");
}

std::string row(const FrameSource& source, const ChipFrameOptions& options) {
    const pipeline::Profile& profile = *options.profile;
    std::string line                 = "| " + std::string(profile.name) + " | ";
    const ChipFrame chip             = make_chip_frame(source, options);
    if (!chip.legal.left.empty())
        return line + "cannot draw it: " + std::to_string(chip.legal.left.size()) + " findings | | | | | |\n";

    const Execution drawn = pipeline::execute(chip.legal.frame);
    const Size size       = {drawn.output.width, drawn.output.height};
    const Frame ideal =
        source.frame(source.is_dumped_frame() ? std::nullopt : std::optional(size), options.frame, options.changes);
    line += chip.reduction ? reduction_text(*chip.reduction)
                           : std::to_string(size.width) + 'x' + std::to_string(size.height);
    line += " | " + std::to_string(chip.legal.frame.passes.size()) + " (" + std::to_string(ideal.passes.size()) +
            ") | " + layers_text(drawn) + " | " + memory_text(chip.legal.frame, profile) + " | ";
    if (chip.cost)
        line += number(chip.cost->total.ms.least, "%.1f") + " to " + number(chip.cost->total.ms.most, "%.1f");
    return line + " | " + number(mean_difference(drawn.output, pipeline::execute(ideal).output), "%.2f") + " |\n";
}

}  // namespace

std::string chip_table(const ChipFrameOptions& options) {
    const FrameSource source(options.scene);
    std::string text =
        "| chip | picture | passes (scene's) | blended layers | memory | ms of 16.7 | difference |\n"
        "| --- | --- | ---: | ---: | ---: | ---: | ---: |\n";
    for (const pipeline::Profile& profile : pipeline::profiles()) {
        if (pipeline::find_rates(profile.name) == nullptr) continue;  // no chip
        ChipFrameOptions of_chip = options;
        of_chip.profile          = &profile;
        text += row(source, of_chip);
    }
    return text;
}

}  // namespace demo
