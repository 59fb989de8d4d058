// SPDX-License-Identifier: MIT
// Frames before and after a rewrite: as text, and drawn.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "pipeline/check/check.h"
#include "pipeline/frame/frame_text.h"
#include "pipeline/legalize/legalize.h"
#include "pipeline/validate/validate.h"
#include "tests/support/small_frame.h"

namespace test_support {

inline void require_valid(const pipeline::Frame& frame) {
    const std::vector<pipeline::Finding> findings = pipeline::validate(frame);
    if (!findings.empty()) FAIL(findings[0].where << ' ' << findings[0].what);
}

// Notes are there if something has changed.
inline pipeline::Frame rewritten(const pipeline::Frame& frame, pipeline::Rewrite rewrite, std::string_view profile) {
    const pipeline::Profile* chip = pipeline::find_profile(profile);
    REQUIRE(chip != nullptr);
    require_valid(frame);
    pipeline::RewriteNotes notes;
    pipeline::Frame result = rewrite(frame, *chip, notes);
    CHECK(notes.empty() == (result == frame));
    require_valid(result);
    return result;
}

inline pipeline::RewriteNotes notes_of(const pipeline::Frame& frame, pipeline::Rewrite rewrite,
                                       std::string_view profile) {
    pipeline::RewriteNotes notes;
    rewrite(frame, *pipeline::find_profile(profile), notes);
    return notes;
}

// Does check find something at a place that ends so, or by that rule?
inline bool is_found(const pipeline::Frame& frame, std::string_view profile, std::string_view place_or_rule) {
    const std::vector<pipeline::ChipFinding> found = pipeline::check(frame, *pipeline::find_profile(profile));
    return std::any_of(found.begin(), found.end(), [&](const pipeline::ChipFinding& finding) {
        return finding.rule == place_or_rule || finding.where.ends_with(place_or_rule);
    });
}

// Without the first line, and with target 0 for output.
inline pipeline::Frame parsed(std::string_view text) {
    pipeline::Frame frame = pipeline::parse_frame("nimbus7 frame 1\n" + std::string(text));
    frame.output          = {0};
    return frame;
}

// `after` as a frame's text is written, so that what differs is shown.
inline void check_rewrite(pipeline::Rewrite rewrite, std::string_view profile, std::string_view before,
                          std::string_view after) {
    CHECK(pipeline::to_text(rewritten(parsed(before), rewrite, profile)) == pipeline::to_text(parsed(after)));
}
inline void check_left_alone(pipeline::Rewrite rewrite, std::string_view profile, std::string_view text) {
    check_rewrite(rewrite, profile, text, text);
}

// The last pixels of the frame's output.
inline std::vector<std::uint32_t> pixels_of(const pipeline::Frame& frame) {
    return pipeline::execute(frame).output.pixels;
}

// How many of the output's pixels differ.
inline std::ptrdiff_t differing_pixels(const pipeline::Frame& a, const pipeline::Frame& b) {
    const std::vector<std::uint32_t> of_a = pixels_of(a), of_b = pixels_of(b);
    REQUIRE(of_a.size() == of_b.size());
    std::ptrdiff_t count = 0;
    for (std::size_t i = 0; i < of_a.size(); ++i) count += of_a[i] != of_b[i];
    return count;
}

// The first pass after which the colour targets of two frames with as many passes differ; -1 if none.
inline std::ptrdiff_t differing_pass(const pipeline::Frame& a, const pipeline::Frame& b) {
    const std::vector<pipeline::ColorImage> of_a = draw(a).passes, of_b = draw(b).passes;
    REQUIRE(of_a.size() == of_b.size());
    const auto pass = std::mismatch(of_a.begin(), of_a.end(), of_b.begin()).first;
    return pass == of_a.end() ? -1 : pass - of_a.begin();
}

// Leaves out draws that `keep` refuses.
template <class Keep>
void keep_draws(pipeline::Frame& frame, Keep keep) {
    for (pipeline::Pass& pass : frame.passes)
        std::erase_if(pass.draws, [&](const pipeline::Draw& draw) { return !keep(draw); });
}
inline bool is_triangles(const pipeline::Draw& draw) {
    return std::holds_alternative<pipeline::DrawTriangles>(draw);
}

}  // namespace test_support
