// SPDX-License-Identifier: MIT
#include "demo/vectors/vector_frames.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "pipeline/frame/frame_text.h"
#include "pipeline/validate/validate.h"

namespace demo {

using namespace pipeline;

namespace {

// The profile that the name begins with, or null.
const Profile* owner_of(std::string_view name) {
    for (const Profile& profile : profiles())
        if (name.starts_with(std::string(profile.name) + "_")) return &profile;
    return nullptr;
}

// The lines of comment before the first that is none, after "nimbus7 frame 1".
std::string head_comment(std::string_view text) {
    std::istringstream lines{std::string(text)};
    std::string line, comment;
    std::getline(lines, line);
    while (std::getline(lines, line) && line.starts_with("//")) {
        const std::size_t start = line.find_first_not_of("/ ");
        if (start == std::string::npos) continue;
        if (!comment.empty()) comment += ' ';
        comment += line.substr(start);
    }
    return comment;
}

template <class T>
bool is_among(const T& value, const std::vector<T>& values) {
    return std::find(values.begin(), values.end(), value) != values.end();
}

// What the profile's chip has not. A8R8G8B8 stands for four whole bytes, and every chip has those somewhere.
std::string what_is_missing(const Frame& frame, const Profile& profile) {
    const std::string chip(profile.name);
    for (const Target& target : frame.targets) {
        const auto& formats = is_depth(target.format) ? profile.depth_formats : profile.color_formats;
        if (target.format != TargetFormat::A8R8G8B8 && !is_among(target.format, formats))
            return chip + " has no target of " + std::string(enum_name(target.format));
    }
    for (const Pass& pass : frame.passes) {
        if (pass.depth && !is_among(pass.state.depth.func, profile.depth_funcs))
            return chip + " has no depth function " + std::string(enum_name(pass.state.depth.func));
    }
    const std::vector<Finding> findings = validate(frame);
    return findings.empty() ? "" : findings.front().where + " " + findings.front().what;
}

VectorFrame read(const EmbeddedText& text, const Profile& profile, bool is_own) {
    VectorFrame out{.name = std::string(text.name), .what = head_comment(text.text), .frame = {}, .why_not = {}};
    try {
        out.frame = parse_frame(text.text);
    } catch (const ParseError& error) {
        throw std::runtime_error("demo/frames/" + out.name + ".frame:" + std::to_string(error.line) + ":" +
                                 std::to_string(error.column) + ": " + error.what());
    }
    if (!is_own) out.frame.arithmetic = profile.arithmetic;
    out.why_not = what_is_missing(out.frame, profile);
    return out;
}

}  // namespace

std::vector<VectorFrame> vector_frames(const Profile& profile, std::span<const EmbeddedText> texts) {
    std::vector<VectorFrame> out;
    for (const EmbeddedText& text : texts) {
        const Profile* owner = owner_of(text.name);
        if (owner == nullptr || owner == &profile) out.push_back(read(text, profile, owner != nullptr));
    }
    return out;
}

std::string text_of(const VectorFrame& frame) {
    std::string text = to_text(frame.frame);
    if (!frame.what.empty()) text.insert(text.find('\n') + 1, "// " + frame.what + "\n");
    return text;
}

}  // namespace demo
