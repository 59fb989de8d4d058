// SPDX-License-Identifier: MIT
#include "demo/frame_source.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "pipeline/frame/frame_text.h"
#include "pipeline/validate/validate.h"

namespace demo {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kDumpStart = "nimbus7 frame ";

bool starts_like_a_dump(const std::string& path) {
    std::error_code error;
    if (!fs::is_regular_file(path, error)) return false;
    std::ifstream file(path, std::ios::binary);
    std::string start(kDumpStart.size(), '\0');
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    return file && start == kDumpStart;
}

pipeline::Frame read_dump(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) throw std::runtime_error(path + ": cannot be read");
    try {
        return pipeline::parse_frame(text.view());
    } catch (const pipeline::ParseError& error) {
        throw std::runtime_error(path + ":" + std::to_string(error.line) + ":" + std::to_string(error.column) + ": " +
                                 error.what());
    }
}

void require_valid(const std::string& source, const pipeline::Frame& frame) {
    const std::vector<pipeline::Finding> findings = pipeline::validate(frame);
    if (findings.empty()) return;
    std::string line = source + ": " + findings.front().where + " " + findings.front().what;
    if (findings.size() > 1) line += " (the first of " + std::to_string(findings.size()) + " findings)";
    throw std::runtime_error(line);
}

}  // namespace

FrameSource::FrameSource(const std::string& scene) : argument_(scene), name_(fs::path(scene).stem()) {
    if (starts_like_a_dump(scene)) {
        dumped_ = read_dump(scene);
        require_valid(scene, *dumped_);
    } else {
        scene_ = load_scene(scene);
    }
}

pipeline::Frame FrameSource::frame(std::optional<Size> size, int index, const FrameOptions& options) const {
    if (dumped_) {
        const auto refuse = [&](bool is_given, const char* option) {
            if (is_given) throw std::runtime_error(std::string(option) + ": " + argument_ + " is a dumped frame");
        };
        refuse(options.technique != Technique::MegaParticles, "--technique");
        refuse(options.mode.has_value(), "--mode");
        refuse(options.order.has_value(), "--order-free");
        if (size) throw std::runtime_error("--size: " + argument_ + " is a dumped frame and has its own size");
        if (index != 0) throw std::runtime_error("--frames: " + argument_ + " is a single dumped frame");
        return *dumped_;
    }
    pipeline::Frame frame = scene_frame(*scene_, size.value_or(default_size(*scene_)), index, options);
    require_valid(argument_, frame);
    return frame;
}

}  // namespace demo
