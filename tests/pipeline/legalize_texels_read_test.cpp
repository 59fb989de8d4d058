// SPDX-License-Identifier: MIT
#include "pipeline/legalize/texels_read.h"

#include <glm/gtc/matrix_transform.hpp>

#include "pipeline/legalize/pixel_center.h"
#include "tests/support/garbage.h"
#include "tests/support/random.h"
#include "tests/support/rewritten.h"

using namespace pipeline;
using namespace test_support;

namespace {

// Pass 1 shows target 1, of 32x32, which pass 0 fills, in a picture of 32x32.
Frame showing(TextureFilter filter) {
    Frame frame = small_frame(32, 32);
    frame.targets.push_back({.name = "shown", .width = 32, .height = 32});
    std::vector<std::uint8_t> texels;
    Random random(7);
    for (int i = 0; i < 32 * 32 * 4; ++i) texels.push_back(static_cast<std::uint8_t>(random.bits() >> 24));
    DrawRectangle fill           = rectangle({0, 0, 32, 32}, 0xffffffff);
    fill.textures[0]             = bound(add_texture(frame, TextureFormat::A8R8G8B8, 32, 32, texels));
    frame.passes[0].color        = {1};
    frame.passes[0].state.stages = {kTextureOnly};
    frame.passes[0].draws        = {fill};
    Pass& show                   = frame.passes.emplace_back();
    show.color                   = {0};
    show.camera                  = {0};
    show.state.stages            = {kTextureOnly};
    TextureStage& stage          = show.state.stages[0];
    stage.filter                 = filter;
    stage.address_u = stage.address_v = TextureAddress::Clamp;
    return frame;
}

void show_rectangle(Frame& frame, float x0, float y0, float x1, float y1, const UvRect& uv) {
    DrawRectangle draw{.x0 = x0, .y0 = y0, .x1 = x1, .y1 = y1};
    draw.uv[0]              = uv;
    draw.textures[0].target = {1};
    frame.passes[1].draws   = {draw};
}

PixelRect read_for(const Frame& frame, const PixelRect& at) {
    return texels_read(frame, frame.passes[1], frame.passes[1].draws[0], 0, at);
}

// A perspective, and coordinates that show the texel at its own place in the window.
const Mat4 kProjection = glm::perspectiveRH_ZO(1.0f, 1.0f, 0.5f, 50.0f);
Mat4 own_coordinates(const Mat4& projection) {
    Mat4 transform(0.0f);
    for (glm::length_t column = 0; column < 4; ++column) {
        const float w        = projection[column][3];
        transform[column][0] = 0.5f * (projection[column][0] + w);
        transform[column][1] = 0.5f * (w - projection[column][1]);
        transform[column][2] = w;
    }
    return transform;
}

// Two triangles over all of the window, and beyond it, leaning into the depth.
void show_triangles(Frame& frame) {
    DrawTriangles draw = add_quad(frame, 0xffffffff);
    for (std::size_t i = 0; i < 4; ++i) {
        Vertex& vertex  = frame.vertices[i];
        vertex.position = vertex.position * Vec3(9.0f, 9.0f, 0.0f) + Vec3(0.0f, 0.0f, i < 2 ? -9.0f : -5.0f);
        vertex.uv0      = Vec2(i == 1 || i == 2 ? 0.75f : 0.25f, i < 2 ? 0.5f : 0.625f);
    }
    draw.textures[0].target     = {1};
    frame.passes[1].draws       = {draw};
    frame.cameras[0].projection = kProjection;
}

// Are the pixels the same whatever the texels beside it hold? And are they not if those in it change?
void check_read(const Frame& frame, const PixelRect& at) {
    const PixelRegion read(read_for(frame, at));
    Frame limited                   = frame;
    limited.passes[1].state.scissor = at;
    const auto spoilt               = [&](const PixelRegion& region) {
        Frame other = limited;
        insert_passes(other, 1, garbage_passes(other, {1}, region));
        return differing_pixels(other, limited);
    };
    CHECK(spoilt(without(whole_of(frame, {1}), read)) == 0);
    CHECK(spoilt(read) > 0);
}

}  // namespace

TEST_CASE("texels that a rectangle reads, worked out by hand", "[legalize]") {
    Frame frame = showing(TextureFilter::Point);
    show_rectangle(frame, 0, 0, 32, 32, {});
    CHECK(read_for(frame, {3, 5, 9, 20}) == PixelRect{3, 5, 9, 20});
    CHECK(read_for(frame, {}) == PixelRect{});
    frame = showing(TextureFilter::Linear);
    // One to one: the texels beside have no weight, but a coordinate may be off by a bit.
    show_rectangle(frame, 0, 0, 32, 32, {});
    CHECK(read_for(frame, {3, 5, 9, 20}) == PixelRect{2, 4, 10, 21});
    CHECK(read_for(frame, {0, 0, 32, 32}) == PixelRect{0, 0, 32, 32});
    // Half a texel right and down; half as large; twice as large.
    show_rectangle(frame, -0.5f, -0.5f, 31.5f, 31.5f, {});
    CHECK(read_for(frame, {3, 5, 9, 20}) == PixelRect{3, 5, 10, 21});
    show_rectangle(frame, 0, 0, 16, 16, {});
    CHECK(read_for(frame, {3, 5, 9, 12}) == PixelRect{6, 10, 18, 24});
    show_rectangle(frame, 0, 0, 64, 64, {});
    CHECK(read_for(frame, {4, 6, 10, 20}) == PixelRect{1, 2, 6, 11});
    // No more than the rectangle covers; beyond the texture, its edge; turned over, the other side.
    show_rectangle(frame, 4, 4, 8, 8, {0, 0, 0.125f, 0.125f});
    CHECK(read_for(frame, {0, 0, 6, 32}) == PixelRect{0, 0, 3, 5});
    CHECK(read_for(frame, {20, 0, 32, 32}) == PixelRect{});
    show_rectangle(frame, 0, 0, 32, 32, {2, 0, 3, 1});
    CHECK(read_for(frame, {3, 5, 9, 20}) == PixelRect{31, 4, 32, 21});
    show_rectangle(frame, 0, 0, 32, 32, {1, 0, 0, 1});
    CHECK(read_for(frame, {3, 5, 9, 20}) == PixelRect{22, 4, 30, 21});
    // What wraps around is all.
    show_rectangle(frame, 0, 0, 32, 32, {0.5f, 0, 1.5f, 1});
    frame.passes[1].state.stages[0].address_u = TextureAddress::Wrap;
    CHECK(read_for(frame, {3, 5, 9, 20}) == PixelRect{18, 4, 26, 21});
    CHECK(read_for(frame, {3, 5, 17, 20}) == PixelRect{0, 4, 32, 21});
}

TEST_CASE("triangles whose coordinates are the window's own read the same place", "[legalize]") {
    Frame frame = showing(TextureFilter::Point);
    show_triangles(frame);
    TextureStage& stage = frame.passes[1].state.stages[0];
    stage.coords        = CoordSource::CameraPosition;
    stage.transform     = own_coordinates(kProjection);
    CHECK(read_for(frame, {3, 5, 9, 20}) == PixelRect{3, 5, 9, 20});
    check_read(frame, {3, 5, 9, 20});
    const Frame moved = rewritten(frame, &move_to_pixel_centers, "gamecube");
    CHECK(read_for(moved, {3, 5, 9, 20}) == PixelRect{3, 5, 9, 20});
    check_read(moved, {3, 5, 9, 20});
    // Linearly, one more around; and in a part of the window another place.
    stage.filter = TextureFilter::Linear;
    CHECK(read_for(frame, {3, 5, 9, 20}) == PixelRect{2, 4, 10, 21});
    stage.filter                   = TextureFilter::Point;
    frame.passes[1].state.viewport = {8, 8, 24, 24};
    CHECK(read_for(frame, {9, 9, 12, 12}) == PixelRect{0, 0, 32, 32});
    // Another place everywhere; any other transform may read all.
    frame.passes[1].state.viewport = {};
    stage.transform[2][0] -= 0.125f;  // of -z, so 4 texels to the right
    CHECK(read_for(frame, {3, 5, 9, 20}) == PixelRect{7, 5, 13, 20});
    check_read(frame, {3, 5, 9, 20});
    stage.transform[0][0] *= 1.25f;
    CHECK(read_for(frame, {3, 5, 9, 20}) == PixelRect{0, 0, 32, 32});
}

TEST_CASE("triangles with coordinates of their own read what these span", "[legalize]") {
    Frame frame = showing(TextureFilter::Point);
    show_triangles(frame);
    CHECK(read_for(frame, {3, 5, 9, 20}) == PixelRect{7, 15, 25, 21});
    check_read(frame, {0, 0, 32, 32});
    frame.passes[1].state.stages[0].filter = TextureFilter::Linear;
    CHECK(read_for(frame, {3, 5, 9, 20}) == PixelRect{7, 15, 25, 21});
    check_read(frame, {0, 0, 32, 32});
    frame.passes[1].state.stages[0].coords = CoordSource::Vertex1;
    CHECK(read_for(frame, {3, 5, 9, 20}) == PixelRect{0, 0, 1, 1});
}

TEST_CASE("rectangles at random read no other texels", "[legalize]") {
    for (std::uint32_t seed = 1; seed <= 300; ++seed) {
        INFO("seed " << seed);
        Random random(seed);
        Frame frame         = showing(random.one_of({TextureFilter::Point, TextureFilter::Linear}));
        frame.arithmetic    = find_profile(random.one_of<std::string_view>({"ideal", "gamecube", "ps2"}))->arithmetic;
        TextureStage& stage = frame.passes[1].state.stages[0];
        stage.address_u     = random.any<TextureAddress>();
        stage.address_v     = random.any<TextureAddress>();
        const float x = random.real(-20.0f, 20.0f), y = random.real(-20.0f, 20.0f);
        const UvRect uv = {random.real(-1.0f, 1.0f), random.real(-1.0f, 1.0f), random.real(-1.0f, 2.0f),
                           random.real(-1.0f, 2.0f)};
        show_rectangle(frame, x, y, x + random.real(1.0f, 50.0f), y + random.real(1.0f, 50.0f), uv);
        const int left = random.from(0, 30), top = random.from(0, 30);
        const PixelRect at{left, top, random.from(left + 1, 32), random.from(top + 1, 32)};
        const PixelRegion read(read_for(frame, at));
        frame.passes[1].state.scissor = at;
        Frame spoilt                  = frame;
        insert_passes(spoilt, 1, garbage_passes(spoilt, {1}, without(whole_of(frame, {1}), read)));
        REQUIRE(differing_pixels(spoilt, frame) == 0);
    }
}
