// SPDX-License-Identifier: MIT
// Each rule of validate by a frame that breaks this rule alone: one change to a valid frame, and exactly the findings
// that it must give. Here those for what a frame holds; for what its passes do, validate_pass_test.cpp.
#include "pipeline/validate/validate.h"

#include "tests/support/random_frame.h"
#include "tests/support/valid_frame.h"

using namespace pipeline;
using namespace test_support;

TEST_CASE("the frame that the rules are tried on is valid") {
    CHECK(text_of(validate(valid_frame())).empty());
}

TEST_CASE("random frames are valid") {
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        INFO("seed " << seed);
        CHECK(text_of(validate(test_support::random_frame(seed))).empty());
    }
}

TEST_CASE("an invalid frame of any kind is no more than findings") {
    int with_findings = 0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        Frame frame = test_support::random_frame(seed);
        for (std::uint32_t i = 0; i < 20; ++i) test_support::mutate_field(frame, seed * 20 + i);
        with_findings += !validate(frame).empty();
    }
    CHECK(with_findings > 250);
}

TEST_CASE("validate: frame, targets, textures") {
    check_rules({
        {"no output", [](Frame& f) { f.output = {}; }, {{"frame: output", "must refer to a colour target"}}},
        {"output is depth", [](Frame& f) { f.output = {2}; }, {{"frame: output", "must be a colour target (got D24)"}}},
        {"output out of range",
         [](Frame& f) { f.output = {4}; },
         {{"frame: output", "must refer to one of the 4 targets, or be nothing, -1 (got 4)"}}},
        {"output below nothing",
         [](Frame& f) { f.output = {-2}; },
         {{"frame: output", "must refer to one of the 4 targets, or be nothing, -1 (got -2)"}}},
        {"no width",
         [](Frame& f) { f.targets[3].width = 0; },
         {{"target 3 'half': width", "must lie within 1..8192 (got 0)"}}},
        {"too high",
         [](Frame& f) { f.targets[3].height = 8193; },
         {{"target 3 'half': height", "must lie within 1..8192 (got 8193)"}}},
        {"no such format",
         [](Frame& f) { f.targets[3].format = static_cast<TargetFormat>(11); },
         {{"target 3 'half': format",
           "must be one of A8R8G8B8 X8R8G8B8 R5G6B5 A1R5G5B5 R6G6B6A6 PSMCT32 PSMCT24 PSMCT16 D16 D24 D32 (got #11)"}}},
        {"texture size",
         [](Frame& f) { f.textures[1].width = -1; },
         {{"texture 1 'odd': width", "must lie within 1..8192 (got -1)"}}},
        {"texture height",
         [](Frame& f) { f.textures[0].height = 100000; },
         {{"texture 0 'rock': height", "must lie within 1..8192 (got 100000)"}}},
        {"too many levels",
         [](Frame& f) { f.textures[0].levels = 4; },
         {{"texture 0 'rock': levels", "must lie within 1..3 for a texture of 4x2 (got 4)"}}},
        {"no level",
         [](Frame& f) { f.textures[0].levels = 0; },
         {{"texture 0 'rock': levels", "must lie within 1..3 for a texture of 4x2 (got 0)"}}},
        {"mips of an odd size",
         [](Frame& f) { f.textures[1].levels = 2, f.textures[1].texels.resize(48 + 8); },
         {{"texture 1 'odd': levels", "must be 1 unless width and height are powers of two (got 2)"}}},
        {"a texel missing",
         [](Frame& f) { f.textures[0].texels.pop_back(); },
         {{"texture 0 'rock': texels", "must hold 11 bytes (got 10)"}}},
        {"texels of a level missing",
         [](Frame& f) { f.textures[1].format = TextureFormat::A8; },
         {{"texture 1 'odd': texels", "must hold 12 bytes (got 48)"}}},
        {"camera not finite",
         [](Frame& f) { f.cameras[0].projection[1][2] = kNan; },
         {{"camera 0 'eye': projection", "must be finite"}}},
        {"vertex not finite",
         [](Frame& f) { f.vertices[1].normal.y = kInfinity; },
         {{"vertex 1: normal", "must be finite (got (0 inf 0))"}}},
        {"vertices not finite",
         [](Frame& f) { f.vertices[1].uv1.x = kNan, f.vertices[0].uv0.y = f.vertices[2].position.x = -kInfinity; },
         {{"vertex 0: uv0", "must be finite (got (0 -inf)); 2 more vertices are not finite"}}},
        {"index beyond the vertices",
         [](Frame& f) { f.indices[4] = 3; },
         {{"frame: indices[4]", "must be less than the number of vertices, 3 (got 3)"}}},
        {"indices beyond the vertices",
         [](Frame& f) { f.vertices.resize(1); },
         {{"frame: indices[1]", "must be less than the number of vertices, 1 (got 1); 3 more are not"}}},
    });
}

TEST_CASE("validate: the targets of a pass") {
    check_rules({
        {"neither target",
         [](Frame& f) { composite(f).color = {}; },
         {{"pass 1 'composite': color", "must refer to a target, or depth must"}}},
        {"colour is depth",
         [](Frame& f) { particles(f).color = {2}; },
         {{"pass 0 'particles': color", "must be a colour target (got D24)"}}},
        {"depth is colour",
         [](Frame& f) { particles(f).depth = {0}; },
         {{"pass 0 'particles': depth", "must be a depth target (got A8R8G8B8)"}}},
        {"depth out of range",
         [](Frame& f) { particles(f).depth = {9}; },
         {{"pass 0 'particles': depth", "must refer to one of the 4 targets, or be nothing, -1 (got 9)"}}},
        {"sizes differ",
         [](Frame& f) { particles(f).color = {3}; },
         {{"pass 0 'particles': depth", "must have the size of the colour target, 30x20 (got 60x40)"}}},
        {"colour cleared, not there",
         [](Frame& f) { particles(f).color = {}; },
         {{"pass 0 'particles': clear.color", "must be left out: the pass has no colour target"}}},
        {"depth cleared, not there",
         [](Frame& f) { composite(f).clear.depth = 0.0f; },
         {{"pass 1 'composite': clear.depth", "must be left out: the pass has no depth target"}}},
        {"cleared beyond 1",
         [](Frame& f) { particles(f).clear.depth = 1.5f; },
         {{"pass 0 'particles': clear.depth", "must lie within 0..1 (got 1.5)"}}},
        {"cleared below 0",
         [](Frame& f) { particles(f).clear.depth = -0.25f; },
         {{"pass 0 'particles': clear.depth", "must lie within 0..1 (got -0.25)"}}},
        {"cleared to nothing",
         [](Frame& f) { particles(f).clear.depth = kNan; },
         {{"pass 0 'particles': clear.depth", "must be finite (got nan)"}}},
        {"depth tested, not there",
         [](Frame& f) { composite(f).state.depth.func = CompareFunc::Less; },
         {{"pass 1 'composite': state.depth.func", "must be ALWAYS: the pass has no depth target (got LESS)"}}},
        {"depth written, not there",
         [](Frame& f) { composite(f).state.depth.write = true; },
         {{"pass 1 'composite': state.depth.write", "must be false: the pass has no depth target"}}},
    });
    check_valid({
        {"depth alone",
         [](Frame& f) {
             particles(f).color       = {};
             particles(f).clear.color = {};
         }},
        {"nothing cleared, nothing drawn",
         [](Frame& f) {
             particles(f).clear = {};
             particles(f).draws.clear();
         }},
    });
}

TEST_CASE("validate finds everything at once") {
    Frame frame                               = valid_frame();
    frame.output                              = {};
    frame.targets[3].width                    = 0;
    frame.indices[5]                          = 7;
    composite(frame).state.depth.write        = true;
    particles(frame).state.lighting.ambient.x = kNan;
    rectangle(frame).depth                    = 2.0f;
    CHECK(text_of(validate(frame)) ==
          "frame: output: must refer to a colour target\n"
          "target 3 'half': width: must lie within 1..8192 (got 0)\n"
          "frame: indices[5]: must be less than the number of vertices, 3 (got 7)\n"
          "pass 0 'particles': state.lighting.ambient: must be finite (got (nan 0 0))\n"
          "pass 1 'composite': state.depth.write: must be false: the pass has no depth target\n"
          "pass 1 'composite': draws[0].depth: must lie within 0..1 (got 2)\n");
}
