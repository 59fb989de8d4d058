// SPDX-License-Identifier: MIT
// Triangles that are in window space already: known answers, and kernels against the reference on random ones.
#include "pipeline/frame/frame_text.h"
#include "pipeline/validate/validate.h"
#include "tests/support/random_frame.h"
#include "tests/support/random_window.h"
#include "tests/support/small_frame.h"

using namespace pipeline;
using namespace test_support;

namespace {

DrawWindowTriangles add_window_triangle(Frame& frame, const std::array<WindowVertex, 3>& corners) {
    const DrawWindowTriangles draw{
        .first_index = static_cast<std::uint32_t>(frame.indices.size()), .index_count = 3, .textures = {}};
    for (const WindowVertex& corner : corners) {
        frame.indices.push_back(static_cast<std::uint32_t>(frame.window_vertices.size()));
        frame.window_vertices.push_back(corner);
    }
    return draw;
}

// Pixels (0, 0), (1, 0), (0, 1) of 3x3: their centres lie on or left of the line from (2.5, 0) to (0, 2.5).
constexpr std::array<WindowVertex, 3> kCorner{WindowVertex{.x = 0, .y = 0, .diffuse = {0xff102030}},
                                              WindowVertex{.x = 2.25, .y = 0, .diffuse = {0xff102030}},
                                              WindowVertex{.x = 0, .y = 2.25, .diffuse = {0xff102030}}};

Frame corner_frame(const std::array<WindowVertex, 3>& corners = kCorner) {
    Frame frame           = small_frame(3, 3);
    frame.passes[0].draws = {add_window_triangle(frame, corners)};
    return frame;
}

// Random frames with window triangles among each pass's draws, whose textures they take.
Frame random_window_frame(std::uint32_t seed) {
    Random random(seed + 1000);
    Frame frame = random_frame(seed);
    for (Pass& pass : frame.passes) {
        if (pass.draws.empty() || std::holds_alternative<CopyRectangle>(pass.draws[0])) continue;
        const Target target = frame.targets[static_cast<std::size_t>(pass.color ? pass.color.index : pass.depth.index)];
        for (int i = random.from(1, 3); i > 0; --i) {
            DrawWindowTriangles draw = append_window_triangles(frame, target.width, target.height, random);
            draw.textures            = textures_of(pass.draws[random.below(pass.draws.size())]);
            const auto place         = static_cast<std::ptrdiff_t>(random.below(pass.draws.size() + 1));
            pass.draws.insert(pass.draws.begin() + place, draw);
        }
    }
    return frame;
}

}  // namespace

TEST_CASE("a window triangle covers the pixels that its coordinates name, whatever the camera", "[execute]") {
    Frame frame                    = corner_frame();
    frame.cameras[0].projection    = Mat4(0.0f);
    constexpr std::uint32_t kColor = 0xff102030;
    const std::vector<std::uint32_t> want{kColor, kColor, 0, kColor, 0, 0, 0, 0, 0};
    CHECK(pixels_on_both(frame) == want);
    frame.passes[0].camera = {};
    CHECK(pixels_on_both(frame) == want);
    // Nor is it lit.
    frame.passes[0].state.lighting.enabled = true;
    CHECK(pixels_on_both(frame) == want);
}

TEST_CASE("window triangles are culled by the way that they turn", "[execute]") {
    Frame frame                = corner_frame();  // clockwise
    frame.passes[0].state.cull = CullMode::CounterClockwise;
    CHECK(pixels_on_both(frame)[0] == 0xff102030);
    frame.passes[0].state.cull = CullMode::Clockwise;
    CHECK(pixels_on_both(frame)[0] == 0);
    std::swap(frame.indices[1], frame.indices[2]);
    CHECK(pixels_on_both(frame)[0] == 0xff102030);
}

TEST_CASE("window triangles have the colours of their vertices, or flat that of the first", "[execute]") {
    std::array<WindowVertex, 3> corners = kCorner;
    corners[0].diffuse                  = {0xff400000};
    Frame frame                         = corner_frame(corners);
    // At (0.5, 0.5) the first corner has 1 - 1 / 2.25 = 5/9: red 0x10 + 5/9 * 0x30 = 42.7, green 4/9 * 0x20, blue 4/9 * 0x30.
    CHECK(pixels_on_both(frame)[0] == 0xff2b0e15);
    frame.passes[0].state.shade = ShadeMode::Flat;
    CHECK(pixels_on_both(frame)[0] == 0xff400000);
}

TEST_CASE("window triangles are fogged by the alpha of specular, where the pass has fog", "[execute]") {
    std::array<WindowVertex, 3> corners = kCorner;
    for (WindowVertex& corner : corners) corner.specular = {0x33ffffff};  // a fifth
    Frame frame = corner_frame(corners);
    CHECK(pixels_on_both(frame)[0] == 0xff102030);
    // The curve's numbers mean nothing here.
    frame.passes[0].state.fog = {.mode = FogMode::Exp, .color = {0xff6400c8}, .density = 0.0f};
    // 0x10 / 5 + 100 * 4/5 = 83.2; 0x20 / 5 = 6.4; 0x30 / 5 + 200 * 4/5 = 169.6
    CHECK(pixels_on_both(frame)[0] == 0xff5306aa);
}

TEST_CASE("window triangles add their specular, where the pass adds it", "[execute]") {
    std::array<WindowVertex, 3> corners = kCorner;
    for (WindowVertex& corner : corners) corner.specular = {0x00010203};
    Frame frame = corner_frame(corners);
    CHECK(pixels_on_both(frame)[0] == 0xff102030);
    frame.passes[0].state.lighting.specular_enable = true;
    CHECK(pixels_on_both(frame)[0] == 0xff112233);
}

TEST_CASE("window triangles read textures at (s/q, t/q), in perspective by 1/w", "[execute]") {
    // From u = 0 at the left to u = 1 at the right of four pixels, over four texels.
    const auto row = [](float rhw_right, float q_right) {
        Frame frame          = small_frame(4, 1);
        const TextureId ramp = add_texture(frame, TextureFormat::L8, 4, 1, {10, 20, 30, 40});
        const auto corner    = [&](float x, float y) {
            const float u = x / 4.0f, q = x > 0.0f ? q_right : 1.0f;
            return WindowVertex{.x = x, .y = y, .rhw = x > 0.0f ? rhw_right : 1.0f, .uv0 = {u * q, 0.5f * q, q}};
        };
        Pass& pass           = frame.passes[0];
        pass.state.stages[0] = kTextureOnly;
        pass.draws           = {add_window_triangle(frame, {corner(0, 0), corner(4, 0), corner(4, 1)}),
                                add_window_triangle(frame, {corner(0, 0), corner(4, 1), corner(0, 1)})};
        for (Draw& draw : pass.draws) (*bindings_of(draw))[0] = bound(ramp);
        return pixels_on_both(frame);
    };
    const auto greys = [](std::array<std::uint32_t, 4> values) {
        std::vector<std::uint32_t> colors;
        for (const std::uint32_t value : values) colors.push_back(0xff000000 | value * 0x010101);
        return colors;
    };
    CHECK(row(1.0f, 1.0f) == greys({10, 20, 30, 40}));
    // rhw 1/3 at the right: u = (x/4 / 3) / (1 - x/4 + x/4 / 3), at x = 0.5 .. 3.5: 1/22, 1/6, 5/14, 7/10.
    CHECK(row(1.0f / 3.0f, 1.0f) == greys({10, 10, 20, 30}));
    // q does the same as rhw, which scales all of (s, t, q): 3 undoes a third.
    CHECK(row(1.0f / 3.0f, 3.0f) == greys({10, 20, 30, 40}));
    CHECK(row(1.0f, 1.0f / 3.0f) == greys({10, 10, 20, 30}));
}

TEST_CASE("the viewport limits window triangles and moves none", "[execute]") {
    Frame frame                    = corner_frame();
    frame.passes[0].state.viewport = {1, 0, 3, 3};
    CHECK(pixels_on_both(frame) == std::vector<std::uint32_t>{0, 0xff102030, 0, 0, 0, 0, 0, 0, 0});
    frame.passes[0].state.scissor = {0, 1, 3, 3};
    CHECK(pixels_on_both(frame) == std::vector<std::uint32_t>(9));
}

TEST_CASE("window triangles meet the depth buffer by their z", "[execute]") {
    Frame frame                         = small_frame(3, 3, TargetFormat::D16);
    Pass& pass                          = frame.passes[0];
    pass.clear.depth                    = 0.5f;
    pass.state.depth                    = {.func = CompareFunc::Less, .write = true};
    std::array<WindowVertex, 3> corners = kCorner;
    for (WindowVertex& corner : corners) corner.z = 0.25f;
    pass.draws = {add_window_triangle(frame, corners)};
    CHECK(pixels_on_both(frame)[0] == 0xff102030);
    for (WindowVertex& vertex : frame.window_vertices) vertex.z = 0.75f;
    CHECK(pixels_on_both(frame)[0] == 0);
}

TEST_CASE("counts: window triangles before and after culling, and no vertices", "[execute][counts]") {
    Frame frame                        = corner_frame();
    std::array<WindowVertex, 3> turned = kCorner;
    std::swap(turned[1], turned[2]);
    frame.passes[0].draws.push_back(add_window_triangle(frame, turned));
    frame.passes[0].draws.push_back(add_window_triangle(frame, {kCorner[0], kCorner[1], kCorner[1]}));  // no area
    frame.passes[0].state.cull = CullMode::CounterClockwise;
    const PassCounts counts    = draw_on_both(frame).execution.counts[0];
    CHECK(counts.vertices == 0);
    CHECK(counts.triangles_in == 3);
    CHECK(counts.triangles_drawn == 1);
    CHECK(counts.covered == 3);
}

TEST_CASE("kernels and reference agree on random window triangles", "[agreement]") {
    std::uint64_t drawn = 0;
    for (std::uint32_t seed = 0; seed < 150; ++seed) {
        INFO("seed " << seed);
        const Frame frame = random_window_frame(seed);
        const Drawn want  = draw_reference(frame);
        check_kernels(frame, want, seed, 1);
        for (std::size_t i = 0; i < frame.passes.size(); ++i)
            for (const Draw& draw : frame.passes[i].draws)
                if (std::holds_alternative<DrawWindowTriangles>(draw)) drawn += want.execution.counts[i].covered > 0;
    }
    CHECK(drawn > 300);
}

TEST_CASE("window triangles survive their text to the bit", "[text]") {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        INFO("seed " << seed);
        const Frame frame = random_window_frame(seed);
        CHECK(parse_frame(to_text(frame)) == frame);
    }
    Frame frame = corner_frame();
    frame.window_vertices.resize(1);
    frame.window_vertices[0] = {.x = 1, .y = 2, .z = 0.5, .rhw = 0.25, .specular = {0x80010203}, .uv1 = {1, 2, 3}};
    const std::string text   = to_text(frame);
    INFO(text);
    CHECK(text.find("window_triangles { index_count 3 }") != std::string::npos);
    CHECK(text.find("{ x 1 y 2 z 0.5 rhw 0.25 specular 0x80010203 uv1 (1 2 3) }") != std::string::npos);
}
