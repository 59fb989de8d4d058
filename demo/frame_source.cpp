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
#include "pipeline/validate/work.h"

namespace demo {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kDumpStart  = "nimbus7 frame ";
constexpr std::uintmax_t kMaxDumpBytes = std::uintmax_t{1} << 30;  // the largest texture takes half of it

bool starts_like_a_dump(const std::string& path) {
    std::error_code error;
    if (!fs::is_regular_file(path, error)) return false;
    std::ifstream file(path, std::ios::binary);
    std::string start(kDumpStart.size(), '\0');
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    return file && start == kDumpStart;
}

pipeline::Frame read_dump(const std::string& path) {
    std::error_code error;
    if (fs::file_size(path, error) > kMaxDumpBytes)
        throw std::runtime_error(path + ": is larger than a frame's text may be (1 GiB)");
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) throw std::runtime_error(path + ": cannot be read");
    try {
        return pipeline::parse_frame(text.view());
    } catch (const pipeline::ParseError& reason) {
        throw std::runtime_error(path + ":" + std::to_string(reason.line) + ":" + std::to_string(reason.column) + ": " +
                                 reason.what());
    }
}

}  // namespace

void FrameSource::require_valid(const pipeline::Frame& frame) const {
    std::vector<pipeline::Finding> findings = pipeline::validate(frame);
    std::string hint;
    if (findings.empty()) {
        const pipeline::Work work = pipeline::work_of(frame);
        findings                  = pipeline::check_work(work, limit_);
        if (findings.empty()) return;
        hint = "; render --limit " + std::to_string(pipeline::needed_limit(work)) + " draws it all the same";
    }
    std::string line = argument_ + ": " + findings.front().where + " " + findings.front().what;
    if (findings.size() > 1) line += " (the first of " + std::to_string(findings.size()) + " findings)";
    throw std::runtime_error(line + hint);
}

FrameSource::FrameSource(const std::string& scene, int limit)
    : argument_(scene), name_(fs::path(scene).stem()), limit_(limit) {
    if (starts_like_a_dump(scene)) {
        dumped_ = read_dump(scene);
        require_valid(*dumped_);
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
        refuse(options.precision != Precision::Exact, "--precision");
        refuse(options.mode.has_value(), "--mode");
        refuse(options.order.has_value(), "--order-free");
        if (size) throw std::runtime_error("--size: " + argument_ + " is a dumped frame and has its own size");
        if (index != 0) throw std::runtime_error("--frames: " + argument_ + " is a single dumped frame");
        return *dumped_;
    }
    pipeline::Frame frame = scene_frame(*scene_, size.value_or(default_size(*scene_)), index, options);
    require_valid(frame);
    return frame;
}

}  // namespace demo
