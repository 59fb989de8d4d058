// SPDX-License-Identifier: MIT
// The rules of window vertices, and of indices that name vertices of either kind.
#include <cmath>
#include <limits>

#include "tests/support/one_pass_frame.h"
#include "tests/support/validate_rules.h"

using namespace pipeline;
using test_support::Rule, test_support::text_of;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// Four window vertices and three others; indices of a window triangle, of one with a camera, and one that no draw uses.
Frame valid_frame() {
    Frame frame           = test_support::one_pass_frame(4, 4);
    frame.passes[0].label = "window";
    frame.window_vertices.resize(4);
    frame.vertices.resize(3);
    frame.indices         = {3, 1, 2, 2, 1, 0, 3};
    frame.passes[0].draws = {DrawWindowTriangles{.index_count = 3, .textures = {}},
                             DrawTriangles{.first_index = 3, .index_count = 3, .textures = {}}};
    return frame;
}
WindowVertex& vertex(Frame& frame) {
    return frame.window_vertices[2];
}
DrawWindowTriangles& triangles(Frame& frame) {
    return std::get<DrawWindowTriangles>(frame.passes[0].draws[0]);
}

void check_valid(const std::vector<std::pair<const char*, std::function<void(Frame&)>>>& changes) {
    for (const auto& [name, change] : changes) {
        INFO(name);
        Frame frame = valid_frame();
        change(frame);
        CHECK(text_of(validate(frame)).empty());
    }
}

}  // namespace

TEST_CASE("validate: the frame with window triangles is valid") {
    CHECK(text_of(validate(valid_frame())).empty());
}

TEST_CASE("validate: window vertices") {
    test_support::check_rules(
        &valid_frame, {
                          {"too far right",
                           [](Frame& f) { vertex(f).x = 16384.5f; },
                           {{"window vertex 2: x", "must lie within 16384 pixels of 0 (got 16384.5)"}}},
                          {"too far left",
                           [](Frame& f) { vertex(f).x = -16385.0f; },
                           {{"window vertex 2: x", "must lie within 16384 pixels of 0 (got -16385)"}}},
                          {"too far up",
                           [](Frame& f) { vertex(f).y = -16385.0f; },
                           {{"window vertex 2: y", "must lie within 16384 pixels of 0 (got -16385)"}}},
                          {"before the near plane",
                           [](Frame& f) { vertex(f).z = -0.25f; },
                           {{"window vertex 2: z", "must lie within 0..1 (got -0.25)"}}},
                          {"beyond the far plane",
                           [](Frame& f) { vertex(f).z = 1.25f; },
                           {{"window vertex 2: z", "must lie within 0..1 (got 1.25)"}}},
                          {"rhw zero",
                           [](Frame& f) { vertex(f).rhw = 0.0f; },
                           {{"window vertex 2: rhw", "must be greater than 0 (got 0)"}}},
                          {"coordinates too large",
                           [](Frame& f) { vertex(f).uv0.y = 0x1p40f; },
                           {{"window vertex 2", "must have texture coordinates that times rhw are below 2^40"}}},
                          {"coordinates too large by rhw",
                           [](Frame& f) { vertex(f).uv1.x = -0x1p20f, vertex(f).rhw = 0x1p20f; },
                           {{"window vertex 2", "must have texture coordinates that times rhw are below 2^40"}}},
                          {"divisor too large",
                           [](Frame& f) { vertex(f).uv1.z = 0x1p41f; },
                           {{"window vertex 2", "must have texture coordinates that times rhw are below 2^40"}}},
                          {"no number",
                           [](Frame& f) { vertex(f).uv0.z = kNan; },
                           {{"window vertex 2: uv0", "must be finite (got (0 0 nan))"}}},
                          {"several that are no numbers",
                           [](Frame& f) { f.window_vertices[1].y = kNan, f.window_vertices[3].z = kNan; },
                           {{"window vertex 1: y", "must be finite (got nan); 1 more vertices are not finite"}}},
                          {"the first of several stands for all",
                           [](Frame& f) { f.window_vertices[1].z = 2.0f, f.window_vertices[3].rhw = -1.0f; },
                           {{"window vertex 1: z", "must lie within 0..1 (got 2)"}}},
                      });
    check_valid({
        {"at the limits", [](Frame& f) { vertex(f) = {.x = -16384, .y = 16384, .z = 1, .rhw = 0x1p-100f}; }},
        {"coordinates just in range", [](Frame& f) { vertex(f).uv0 = Vec3(std::nextafter(0x1p40f, 0.0f)); }},
        {"coordinates made small by rhw", [](Frame& f) { vertex(f).uv0.x = 0x1p60f, vertex(f).rhw = 0x1p-30f; }},
        {"a divisor of zero, or below", [](Frame& f) { vertex(f).uv0.z = 0.0f, vertex(f).uv1.z = -1.0f; }},
    });
}

TEST_CASE("validate: indices name vertices of the kind that their draws take") {
    test_support::check_rules(
        &valid_frame,
        {
            {"beyond the window vertices",
             [](Frame& f) { f.indices[1] = 4; },
             {{"frame: indices[1]", "must be less than the number of window vertices, 4 (got 4)"}}},
            {"beyond the window vertices, but not beyond the others",
             [](Frame& f) { f.window_vertices.resize(2), f.indices = {2, 1, 0, 2, 1, 0, 0}; },
             {{"frame: indices[0]", "must be less than the number of window vertices, 2 (got 2)"}}},
            {"a window vertex's index in triangles with a camera",
             [](Frame& f) { f.indices[4] = 3; },
             {{"frame: indices[4]", "must be less than the number of vertices, 3 (got 3)"}}},
            {"beyond both, unused",
             [](Frame& f) { f.indices[6] = 4; },
             {{"frame: indices[6]", "must be less than the number of vertices, 3 (got 4)"}}},
            {"of two draws of both kinds",
             [](Frame& f) {
                 std::get<DrawTriangles>(f.passes[0].draws[1]).first_index = 0;
                 f.indices[3] = f.indices[4] = f.indices[5] = 3;  // unused now
             },
             {{"frame: indices[0]", "must be less than the number of vertices, 3 (got 3)"}}},
            {"not whole triangles",
             [](Frame& f) { triangles(f).index_count = 2; },
             {{"pass 0 'window': draws[0].index_count", "must be a multiple of 3 (got 2)"}}},
            {"beyond the indices",
             [](Frame& f) { triangles(f).first_index = 5; },
             {{"pass 0 'window': draws[0]", "must use indices below 7 (got 5..7)"}}},
            {"bindings",
             [](Frame& f) { triangles(f).textures[0].target = {0}; },
             {{"pass 0 'window': draws[0].textures[0].target", "must not be the target that the pass draws to"}}},
        });
    check_valid({
        {"no camera, with window triangles alone",
         [](Frame& f) { f.passes[0].draws.pop_back(), f.passes[0].camera = {}; }},
        {"no vertices, with window triangles alone",
         [](Frame& f) { f.passes[0].draws.pop_back(), f.vertices.clear(); }},
        {"indices that both kinds have, of two draws",
         [](Frame& f) { f.indices[0] = 0, std::get<DrawTriangles>(f.passes[0].draws[1]).first_index = 0; }},
    });
}
