// SPDX-License-Identifier: MIT
// A frame that a chip may draw, changes to it, and what check finds in it then: exactly the findings that a change must give, or
// none where the chip has what is asked or where nothing comes of it.
#pragma once

#include <catch2/catch.hpp>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/check/check.h"
#include "pipeline/profile/profile.h"
#include "pipeline/validate/validate.h"

namespace test_support {

namespace check_frame {

using namespace pipeline;

inline const Profile& profile(std::string_view name) {
    const Profile* found = find_profile(name);
    REQUIRE(found != nullptr);
    return *found;
}

// Targets: 0 "picture", which keeps alpha, and 1 "depth", 64x32. Textures: 0 "noise", one level, and 1 "mips". Pass 0
// "draw" has a rectangle with "noise" and a triangle, and a state that all chips have.
inline Frame frame_for(const Profile& chip) {
    Frame frame;
    frame.output     = {0};
    frame.arithmetic = chip.arithmetic;
    frame.targets    = {{"picture", chip.formats.with_alpha, 64, 32}, {"depth", TargetFormat::D24, 64, 32}};
    frame.cameras.resize(1);
    frame.vertices.resize(3);
    frame.indices                 = {0, 1, 2};
    frame.textures                = {{"noise", TextureFormat::A8R8G8B8, 8, 8, 1, {}},
                                     {"mips", TextureFormat::L8, 4, 2, 3, std::vector<std::uint8_t>(8 + 2 + 1)}};
    frame.textures[0].texels      = std::vector<std::uint8_t>(8 * 8 * 4);
    Pass& pass                    = frame.passes.emplace_back();
    pass.label                    = "draw";
    pass.color                    = {0};
    pass.depth                    = {1};
    pass.camera                   = {0};
    pass.state.depth              = {.func = CompareFunc::GreaterEqual, .write = true};
    pass.state.stages[0].color_op = TextureOp::Modulate;
    pass.state.stages[0].alpha_op = TextureOp::Modulate;
    DrawRectangle rectangle       = {.x1 = 8.0f, .y1 = 8.0f};
    rectangle.textures[0].texture = {0};
    pass.draws                    = {rectangle, DrawTriangles{.index_count = 3}};
    if (chip.states.transforms) return frame;
    pass.draws[1] = DrawWindowTriangles{.index_count = 3};
    frame.window_vertices.resize(3);
    frame.vertices.clear();
    frame.cameras.clear();
    pass.camera = {};
    return frame;
}

inline Pass& pass(Frame& frame) {
    return frame.passes[0];
}
inline PipelineState& state(Frame& frame) {
    return frame.passes[0].state;
}
inline TextureStage& stage(Frame& frame) {
    return state(frame).stages[0];
}
inline DrawRectangle& rectangle(Frame& frame) {
    return std::get<DrawRectangle>(pass(frame).draws[0]);
}
inline void drop_triangles(Frame& frame) {
    pass(frame).draws.pop_back();
}
inline TargetId add_target(Frame& frame, const char* name, TargetFormat format, int width = 64, int height = 32) {
    frame.targets.push_back({name, format, width, height});
    return {static_cast<std::int32_t>(frame.targets.size()) - 1};
}
inline void set_size(Texture& texture, int width, int height) {
    texture.width  = width;
    texture.height = height;
    texture.texels.resize(static_cast<std::size_t>(width * height * bytes_per_texel(texture.format)));
}
inline void set_size(Frame& frame, int width, int height) {
    for (Target& target : frame.targets) {
        target.width  = width;
        target.height = height;
    }
}
inline Pass& add_copy(Frame& frame, TargetId from, TargetId to, const CopyRectangle& copy) {
    Pass& added                                    = frame.passes.emplace_back();
    added.label                                    = "copy";
    added.color                                    = to;
    added.draws                                    = {copy};
    std::get<CopyRectangle>(added.draws[0]).source = from;
    return added;
}

// A line for each finding: where | rule | uses | has.
inline std::string text_of(const std::vector<ChipFinding>& findings) {
    std::string text;
    for (const ChipFinding& finding : findings)
        text += finding.where + " | " + std::string(finding.rule) + " | " + finding.uses + " | " + finding.has + "\n";
    return text;
}

using Change = std::function<void(Frame&)>;

inline std::string found(std::string_view chip, const Change& change) {
    Frame frame = frame_for(profile(chip));
    change(frame);
    const std::vector<ChipFinding> findings = check(frame, profile(chip));
    for (const ChipFinding& finding : findings) CHECK(find_evidence(profile(chip), finding.rule) != nullptr);
    return text_of(findings);
}

// On a chip that refuses, what it says; on one that does not, the frame being valid, nothing.
inline void check_refused(std::string_view chip, const Change& change, const std::string& findings) {
    INFO(chip);
    CHECK(found(chip, change) == findings);
}
inline void check_allowed(std::string_view chip, const Change& change) {
    INFO(chip);
    Frame frame = frame_for(profile(chip));
    change(frame);
    for (const Finding& finding : validate(frame)) FAIL_CHECK(finding.where << ": " << finding.what);
    CHECK(text_of(check(frame, profile(chip))) == "");
}

}  // namespace check_frame

}  // namespace test_support
