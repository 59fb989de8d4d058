// SPDX-License-Identifier: MIT
#include "pipeline/execute/clip.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

using namespace pipeline;

namespace {

constexpr ClipVolume kGuard{.gx = 3.0, .gy = 2.0};

class Random {
  public:
    explicit Random(std::uint32_t seed) : bits_(seed) {}
    float in(float least, float greatest) {
        return static_cast<float>(least + (greatest - least) * (static_cast<double>(bits_()) / 4294967296.0));
    }

  private:
    std::mt19937 bits_;
};

ClipVertex vertex_at(const Vec4& position) {
    ClipVertex vertex;
    vertex.position = position;
    return vertex;
}

ClipVertex random_vertex(Random& random, float size) {
    ClipVertex vertex = vertex_at({random.in(-size, size), random.in(-size, size), random.in(-size, size), 0.0f});
    vertex.position.w = random.in(-size, size);
    vertex.diffuse    = {random.in(0, 1), random.in(0, 1), random.in(0, 1), random.in(0, 1)};
    vertex.specular   = {random.in(0, 1), random.in(0, 1), random.in(0, 1)};
    vertex.fog        = random.in(0, 1);
    vertex.uv[1]      = {random.in(-9, 9), random.in(-9, 9), random.in(-9, 9)};
    return vertex;
}

// Twice the area in the x, y plane; w is 1.
double area(const ClippedPolygon& polygon) {
    double sum = 0.0;
    for (int i = 0; i < polygon.count; ++i) {
        const Vec4 &a = polygon.corners[i].position, &b = polygon.corners[(i + 1) % polygon.count].position;
        sum += double{a.x} * b.y - double{b.x} * a.y;
    }
    return sum;
}

// The corners on the edge whose ends have uv[0].x = 0, each once.
std::vector<ClipVertex> on_marked_edge(const ClippedPolygon& polygon) {
    std::vector<ClipVertex> corners;
    for (int i = 0; i < polygon.count; ++i) {
        const ClipVertex& corner = polygon.corners[i];
        const bool known         = std::find(corners.begin(), corners.end(), corner) != corners.end();
        if (corner.uv[0].x == 0.0f && !known) corners.push_back(corner);
    }
    return corners;
}

}  // namespace

TEST_CASE("outcodes name the planes a position is beyond", "[clip]") {
    CHECK(outcode(kGuard, {0, 0, 0.5f, 1}) == 0);
    CHECK(outcode(kGuard, {3, -2, 0, 1}) == 0);  // on the planes is inside
    CHECK(outcode(kGuard, {0, 0, 1, 1}) == 0);
    CHECK(outcode(kGuard, {0, 0, -0.1f, 1}) == 0b0000010);
    CHECK(outcode(kGuard, {0, 0, 1.1f, 1}) == 0b0000100);
    CHECK(outcode(kGuard, {-3.1f, 0, 0, 1}) == 0b0001000);
    CHECK(outcode(kGuard, {3.1f, 0, 0, 1}) == 0b0010000);
    CHECK(outcode(kGuard, {0, -2.1f, 0, 1}) == 0b0100000);
    CHECK(outcode(kGuard, {0, 2.1f, 0, 1}) == 0b1000000);
    CHECK(outcode(kGuard, {0, 0, 0, 0}) == 0b0000001);
    CHECK(outcode(kGuard, {3e38f, 3e38f, 3e38f, 3e38f}) == 0);
}

TEST_CASE("a triangle inside stays as it is, one outside leaves nothing", "[clip]") {
    const std::array<ClipVertex, 3> inside{vertex_at({0, 0, 0, 1}), vertex_at({1, 0, 0.5f, 1}),
                                           vertex_at({0, 3, 1, 2})};
    const ClippedPolygon same = clip_triangle(kGuard, inside);
    REQUIRE(same.count == 3);
    for (int i = 0; i < 3; ++i) CHECK(same.corners[i] == inside[i]);

    CHECK(
        clip_triangle(kGuard, {vertex_at({0, 0, -1, 1}), vertex_at({1, 0, -2, 1}), vertex_at({0, 1, -1, -1})}).count ==
        0);
    // Beyond no single plane, and still outside: past the corner between left and top.
    CHECK(
        clip_triangle(kGuard, {vertex_at({-10, 1, 0, 1}), vertex_at({-2, 9, 0, 1}), vertex_at({-10, 9, 0, 1})}).count ==
        0);
}

TEST_CASE("a cut mixes every attribute by the distances of the ends", "[clip]") {
    ClipVertex front = vertex_at({0, 0, 0.75f, 1}), back = vertex_at({1, -1, -0.25f, 2});
    front.diffuse                = {1, 0, 0, 1};
    back.diffuse                 = {0, 1, 0, 0};
    front.specular               = {0, 0, 0.5f};
    back.specular                = {0, 0, 1};
    front.fog                    = 0.25f;
    back.fog                     = 1;
    back.uv[1]                   = {4, 8, -3};
    const ClippedPolygon polygon = clip_triangle(kGuard, {front, back, front});
    REQUIRE(polygon.count >= 3);
    const ClipVertex& made = polygon.corners[1];  // at 3/4 of the way back
    CHECK(made.position == Vec4(0.75f, -0.75f, 0, 1.75f));
    CHECK(made.diffuse == Vec4(0.25f, 0.75f, 0, 0.25f));
    CHECK(made.specular == Vec3(0, 0, 0.875f));
    CHECK(made.fog == 0.8125f);
    CHECK(made.uv[0] == Vec3(0, 0, 1));
    CHECK(made.uv[1] == Vec3(3, 6, -2));
}

TEST_CASE("the parts before and behind the near plane make up the triangle", "[clip]") {
    Random random(3);
    int crossing = 0;
    for (int round = 0; round < 2000; ++round) {
        std::array<ClipVertex, 3> front, back;
        for (int i = 0; i < 3; ++i) {
            front[i] = vertex_at({random.in(-2, 2), random.in(-2, 2), random.in(-1, 1), 1});
            back[i]  = front[i];
            back[i].position.z *= -1;
        }
        const ClippedPolygon a = clip_triangle(kGuard, front), b = clip_triangle(kGuard, back);
        crossing += a.count > 0 && b.count > 0;
        ClippedPolygon whole;
        for (const ClipVertex& corner : front) whole.corners[whole.count++] = corner;
        REQUIRE(area(a) + area(b) == Approx(area(whole)).margin(1e-5));
        REQUIRE(area(a) * area(whole) >= -1e-9);  // turns the same way
    }
    CHECK(crossing > 1000);
}

TEST_CASE("a triangle that covers the guard band leaves just the band", "[clip]") {
    for (const float size : {100.0f, 1e6f, 1e15f}) {
        const ClippedPolygon band = clip_triangle(
            kGuard,
            {vertex_at({-size, -size, 0.5f, 1}), vertex_at({0, size, 0.5f, 1}), vertex_at({size, -size, 0.5f, 1})});
        CHECK(area(band) == Approx(-2.0 * 6.0 * 4.0).epsilon(size < 1e7f ? 1e-5 : 0.5));
    }
}

TEST_CASE("two triangles that share an edge get the same bits on it", "[clip]") {
    Random random(11);
    int cut = 0;
    for (int round = 0; round < 20000; ++round) {
        const float size = round % 2 ? 2.0f : 1e20f;
        ClipVertex a = random_vertex(random, size), b = random_vertex(random, size);
        ClipVertex c = random_vertex(random, size), d = random_vertex(random, size);
        a.uv[0] = b.uv[0] = {0, 0, 1};
        c.uv[0] = d.uv[0] = {1, 0, 1};

        const std::vector<ClipVertex> one = on_marked_edge(clip_triangle(kGuard, {a, b, c}));
        for (const std::array<ClipVertex, 3>& other : {std::array{b, a, d}, std::array{a, b, d}, std::array{d, b, a}}) {
            const std::vector<ClipVertex> two = on_marked_edge(clip_triangle(kGuard, other));
            REQUIRE(two.size() == one.size());
            REQUIRE(std::is_permutation(one.begin(), one.end(), two.begin()));
        }
        for (const ClipVertex& corner : one) cut += corner != a && corner != b;
    }
    CHECK(cut > 1000);
}

TEST_CASE("what is left of a triangle lies in the volume, whatever its size", "[clip]") {
    Random random(5);
    int left = 0;
    for (int round = 0; round < 20000; ++round) {
        const float size             = std::ldexp(1.0f, round % 250 - 125);
        const ClippedPolygon polygon = clip_triangle(
            kGuard, {random_vertex(random, size), random_vertex(random, size), random_vertex(random, size)});
        left += polygon.count > 0;
        for (int i = 0; i < polygon.count; ++i) {
            const Vec4& p      = polygon.corners[i].position;
            const double slack = 1e-6 * size;
            REQUIRE(p.w >= kLeastW);
            for (const double distance : plane_distances(kGuard, p)) REQUIRE(distance >= -slack);
        }
    }
    CHECK(left > 1000);
}
