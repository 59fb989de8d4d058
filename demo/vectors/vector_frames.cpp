// SPDX-License-Identifier: MIT
#include "demo/vectors/vector_frames.h"

#include <sstream>
#include <stdexcept>

#include "demo/vectors/chip_limits.h"
#include "pipeline/frame/frame_text.h"
#include "pipeline/validate/validate.h"

namespace demo {

using namespace pipeline;

namespace {

constexpr std::string_view kIdealAnswer = "Ideal answer";

// The lines of comment before the first that is none, after "nimbus7 frame 1".
std::string head_comment(std::string_view text, bool with_ideal_answer) {
    std::istringstream lines{std::string(text)};
    std::string line, comment;
    std::getline(lines, line);
    while (std::getline(lines, line) && line.starts_with("//")) {
        const std::size_t start = line.find_first_not_of("/ ");
        if (start == std::string::npos) continue;
        // The answer comes last.
        if (!with_ideal_answer && line.compare(start, kIdealAnswer.size(), kIdealAnswer) == 0) break;
        if (!comment.empty()) comment += ' ';
        comment += line.substr(start);
    }
    return comment;
}

Frame parse(const EmbeddedText& text) {
    try {
        return parse_frame(text.text);
    } catch (const ParseError& error) {
        throw std::runtime_error("demo/frames/" + std::string(text.name) + ".frame:" + std::to_string(error.line) +
                                 ":" + std::to_string(error.column) + ": " + error.what());
    }
}

VectorFrame read(const EmbeddedText& text, const Profile& profile, bool is_own) {
    const Frame as_written = parse(text);
    VectorFrame out{.name    = std::string(text.name),
                    .what    = {},
                    .frame   = is_own ? as_written : put_on_chip(as_written, profile),
                    .why_not = {}};
    out.what    = head_comment(text.text, out.frame == as_written);
    out.why_not = what_is_missing(out.frame, profile);
    if (!out.why_not.empty()) return out;
    for (const Finding& finding : validate(out.frame))
        throw std::logic_error("demo/frames/" + out.name + ".frame, as " + std::string(profile.name) + ": " +
                               finding.where + " " + finding.what);
    return out;
}

}  // namespace

const Profile* owner_of(std::string_view frame_name) {
    return find_profile(frame_name.substr(0, frame_name.find('_')));
}

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
