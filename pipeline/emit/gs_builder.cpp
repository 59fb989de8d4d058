// SPDX-License-Identifier: MIT
#include "pipeline/emit/gs_builder.h"

#include <utility>

namespace pipeline {

void GsBuilder::group(std::string label) {
    stream_.groups.push_back({std::move(label), {}});
    held_.clear();
}

void GsBuilder::step(std::string what) {
    stream_.groups.back().steps.push_back({std::move(what), {}, {}});
}

void GsBuilder::write(GsReg reg, std::uint64_t value) {
    stream_.groups.back().steps.back().writes.push_back({reg, value});
    held_[reg] = value;
}

void GsBuilder::set(GsReg reg, std::uint64_t value) {
    const auto held = held_.find(reg);
    if (held == held_.end() || held->second != value) write(reg, value);
}

void GsBuilder::image(std::vector<std::uint8_t> bytes) {
    bytes.resize((bytes.size() + 15) / 16 * 16);
    stream_.groups.back().steps.back().image = std::move(bytes);
}

}  // namespace pipeline
