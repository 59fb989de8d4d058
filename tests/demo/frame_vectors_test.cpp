// SPDX-License-Identifier: MIT
// What holds for every frame of demo/frames: its text, and its drawing by the kernels and by the scalar reference, with
// its own arithmetic and with that of every chip.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "demo/embedded_texts.h"
#include "demo/vectors/chip_limits.h"
#include "demo/vectors/vector_frames.h"
#include "pipeline/frame/frame_text.h"
#include "pipeline/profile/profile.h"
#include "pipeline/validate/validate.h"
#include "tests/support/frame_agreement.h"

namespace demo {
namespace {

using namespace pipeline;

template <class Check>
void for_each_frame(Check&& check) {
    for (const EmbeddedText& text : embedded_frames()) {
        INFO(text.name);
        check(text, parse_frame(text.text));
    }
}

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        lines.push_back(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return lines;
}

}  // namespace

TEST_CASE("small frames are valid, and survive their text") {
    CHECK(embedded_frames().size() >= 100);
    for_each_frame([](const EmbeddedText&, const Frame& frame) {
        for (const Finding& finding : validate(frame)) FAIL_CHECK(finding.where << " " << finding.what);
        CHECK(diff(frame, parse_frame(to_text(frame))) == std::vector<std::string>{});
        CHECK(parse_frame(to_text(frame)) == frame);
    });
}

TEST_CASE("small frames say at their head what they show, and what the answer is") {
    for_each_frame([](const EmbeddedText& text, const Frame& frame) {
        const std::vector<std::string_view> lines = lines_of(text.text);
        REQUIRE(lines.size() > 3);
        CHECK(lines[0] == "nimbus7 frame 1");
        CHECK(lines[1].starts_with("// "));
        // Without arithmetic of its own a frame can be put into any profile: its answer is that of the ideal one.
        const std::string_view head = frame.arithmetic == Arithmetic{} ? "// Ideal answer" : "// Answer";
        std::size_t comment_lines = 1, answers = 0;
        while (lines[comment_lines].starts_with("//")) answers += lines[comment_lines++].starts_with(head);
        CHECK(answers == 1);
        CHECK(comment_lines <= 5);
        for (const std::string_view line : lines) CHECK(line.size() <= 120);
    });
}

TEST_CASE("small frames show something") {
    for_each_frame([](const EmbeddedText&, const Frame& frame) {
        const ColorImage output = execute(frame).output;
        CHECK(output.width <= 64);
        CHECK(output.height <= 64);
        CHECK(std::set(output.pixels.begin(), output.pixels.end()).size() > 1);
    });
}

TEST_CASE("small frames named after a chip compute as it does, the others leave that open") {
    std::map<std::string_view, int> own;
    for_each_frame([&](const EmbeddedText& text, const Frame& frame) {
        const Profile* owner = owner_of(text.name);
        CHECK(frame.arithmetic == (owner != nullptr ? owner->arithmetic : Arithmetic{}));
        if (owner == nullptr) return;
        ++own[owner->name];
        CHECK(what_is_missing(frame, *owner) == "");
    });
    for (const Profile& profile : profiles()) {
        INFO(profile.name);
        CHECK(own[profile.name] >= (profile.arithmetic == Arithmetic{} ? 0 : 3));
    }
}

TEST_CASE("small frames look the same by kernels and by the reference, in every profile that takes them") {
    std::uint32_t seed = 0;
    std::map<std::string_view, int> taken;
    for_each_frame([&](const EmbeddedText& text, const Frame& frame) {
        test_support::check_kernels(frame, test_support::draw_reference(frame), ++seed, 1);
        if (owner_of(text.name) != nullptr) return;
        for (const Profile& profile : profiles()) {
            INFO(profile.name);
            const Frame dressed = put_on_chip(frame, profile);
            if (!what_is_missing(dressed, profile).empty()) continue;
            CHECK(validate(dressed).empty());
            ++taken[profile.name];
            test_support::check_kernels(dressed, test_support::draw_reference(dressed), ++seed, 1);
        }
    });
    for (const Profile& profile : profiles()) {
        INFO(profile.name);
        CHECK(taken[profile.name] >= 30);
    }
}

}  // namespace demo
