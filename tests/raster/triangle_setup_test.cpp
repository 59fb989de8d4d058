// SPDX-License-Identifier: MIT
// Triangle setup against the formulas of raster/primitives.h in integers of 128 bits, on every instruction set.
#include "raster/triangle_setup.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/random.h"
#include "tests/support/simd_targets.h"

namespace {

using namespace raster;
using test_support::Random;
using Wide = __int128;

struct Corner {
    std::int64_t x, y;
    std::int64_t value;
};

// The rules' plane, modulo 2^64.
Plane expected_plane(const PixelGrid& grid, const std::array<Corner, 3>& c, int fraction) {
    const std::int64_t x1 = c[1].x - c[0].x, y1 = c[1].y - c[0].y, x2 = c[2].x - c[0].x, y2 = c[2].y - c[0].y;
    const Wide area = Wide{x1} * y2 - Wide{x2} * y1;
    const Wide d1 = c[1].value - c[0].value, d2 = c[2].value - c[0].value, one = Wide{1} << fraction;
    const auto gx = static_cast<std::uint64_t>((d1 * y2 - d2 * y1) * one / area);
    const auto gy = static_cast<std::uint64_t>((d2 * x1 - d1 * x2) * one / area);
    return {.origin = (static_cast<std::uint64_t>(c[0].value) << fraction) +
                      gx * static_cast<std::uint64_t>(grid.center - c[0].x) +
                      gy * static_cast<std::uint64_t>(grid.center - c[0].y),
            .dx = gx * 16,
            .dy = gy * 16};
}

bool same(const Plane& a, const Plane& b) {
    return a.origin == b.origin && a.dx == b.dx && a.dy == b.dy;
}

float random_coordinate(Random& random, int kind) {
    switch (kind % 4) {
        case 0:
            return random.real(-16384.0f, 16384.0f);
        case 1:
            return random.one_of({-16384.0f, 16384.0f, 0.0f, 16383.9375f, -16383.9375f});
        case 2:
            return static_cast<float>(random.from(-40, 40)) / 32.0f;  // ties of snapping
        default:
            return random.real(0.0f, 64.0f);
    }
}

float random_texture(Random& random) {
    return random.chance(15) ? 0.0f : std::ldexp(random.real(-1.0f, 1.0f), random.from(-40, 30));
}

Vertex random_vertex(Random& random, int kind) {
    Vertex v;
    v.x              = random_coordinate(random, kind);
    v.y              = random_coordinate(random, kind);
    v.z              = random.chance(30) ? random.one_of({0.0f, 1.0f, 0x1p-31f}) : random.real(0.0f, 1.0f);
    v.rhw            = std::ldexp(random.real(1.0f, 2.0f), random.from(-8, 8));
    const auto bytes = [&] {
        return static_cast<std::uint32_t>(random.chance(30) ? random.from(0, 1) * 0xff : random.from(0, 255)) *
                   0x01010101u ^
               static_cast<std::uint32_t>(random.from(0, 0xffffff));
    };
    v.diffuse  = bytes();
    v.specular = bytes();
    for (TexCoord& uv : v.uv) uv = {random_texture(random), random_texture(random), random.real(0.0f, 2.0f)};
    return v;
}

std::int64_t texture_integer(float value, int exponent) {
    return std::llrint(std::ldexp(static_cast<double>(value), exponent));
}

// The largest exponent up to a limit that keeps all three below 2^29.
int exponent_of(std::initializer_list<float> values, int limit) {
    int e = limit;
    for (const float value : values)
        while (std::ldexp(std::abs(static_cast<double>(value)), e) >= 0x1p29) --e;
    return e;
}

class Expected {
  public:
    Expected(const Triangle& triangle, const PixelGrid& grid) : grid_(grid) {
        for (std::size_t i = 0; i < 3; ++i) {
            v_[i]                 = &triangle[i];
            const Subpixel placed = snap_to_subpixels(grid, v_[i]->x, v_[i]->y);
            corners_[i]           = {placed.x, placed.y, 0};
        }
        area_ = (corners_[1].x - corners_[0].x) * (corners_[2].y - corners_[0].y) -
                (corners_[2].x - corners_[0].x) * (corners_[1].y - corners_[0].y);
        if (area_ >= 0) return;
        std::swap(v_[1], v_[2]);
        std::swap(corners_[1], corners_[2]);
    }
    bool has_area() const { return area_ != 0; }
    const Vertex& vertex(std::size_t i) const { return *v_[i]; }
    template <class Value>
    Plane plane(int fraction, const Value& value) const {
        std::array<Corner, 3> corners = corners_;
        for (std::size_t i = 0; i < 3; ++i) corners[i].value = value(*v_[i]);
        return expected_plane(grid_, corners, fraction);
    }
    Plane color(std::uint32_t Vertex::*color, std::size_t channel, int fraction) const {
        return plane(fraction, [&](const Vertex& v) { return std::int64_t{v.*color >> (8 * channel) & 255}; });
    }
    // An edge's function at a pixel, times 16, and whether a pixel on it is in.
    std::int64_t edge(std::size_t i, std::int64_t x, std::int64_t y) const {
        const Corner &a = corners_[i], &b = corners_[(i + 1) % 3];
        return (b.x - a.x) * (16 * y + grid_.center - a.y) - (b.y - a.y) * (16 * x + grid_.center - a.x);
    }
    bool is_top_left(std::size_t i) const {
        const Corner &a = corners_[i], &b = corners_[(i + 1) % 3];
        return b.y < a.y || (b.y == a.y && b.x > a.x);
    }

  private:
    PixelGrid grid_;
    std::array<const Vertex*, 3> v_{};
    std::array<Corner, 3> corners_{};
    std::int64_t area_ = 0;
};

bool textures_agree(const Expected& expected, std::size_t i, const TexturePlanes& got, int width) {
    const auto s    = [&](const Vertex& v) { return v.uv[i].s * v.rhw; };
    const auto t    = [&](const Vertex& v) { return v.uv[i].t * v.rhw; };
    const auto q    = [&](const Vertex& v) { return v.uv[i].q * v.rhw; };
    const Vertex &a = expected.vertex(0), &b = expected.vertex(1), &c = expected.vertex(2);
    const int e      = exponent_of({s(a), s(b), s(c), t(a), t(b), t(c)}, 60);
    const int eq     = exponent_of({q(a), q(b), q(c)}, 90);
    const auto plane = [&](const auto& value, int exponent) {
        return expected.plane(12, [&](const Vertex& v) { return texture_integer(value(v), exponent); });
    };
    return same(got.s, plane(s, e)) && same(got.t, plane(t, e)) && same(got.q, plane(q, eq)) &&
           got.scale_u == static_cast<float>(std::ldexp(static_cast<double>(width), eq - e)) &&
           got.qx == static_cast<float>(static_cast<double>(static_cast<std::int64_t>(got.q.dx)) / 4096.0) &&
           got.ty == static_cast<float>(static_cast<double>(static_cast<std::int64_t>(got.t.dy)) / 4096.0);
}

}  // namespace

TEST_CASE("setup gives the planes and edges of the rules, exactly", "[raster][setup]") {
    const Rect scissor{0, 0, 8192, 8192};
    test_support::for_each_simd_target([&] {
        Random random(11);
        int drawn = 0;
        for (int round = 0; round < 20000; ++round) {
            const int kind = random.from(0, 3);
            const Triangle triangle{random_vertex(random, kind), random_vertex(random, kind),
                                    random_vertex(random, kind)};
            const PixelGrid grid{.center = random.from(0, 15), .truncate = random.chance(50)};
            SetupNeeds needs{.depth = true, .diffuse = true, .specular = random.chance(50), .fog = random.chance(50)};
            needs.floor_colors = random.chance(50);
            needs.depth_cut    = random.one_of({0, 6, 14});
            needs.texture      = {true, true};
            needs.lod          = {true, true};
            needs.width        = {64, 8192};
            needs.height       = {32, 1};
            const TriangleCorners corners{0, 1, 2};
            std::array<TexturePlanes, kMaxTextures> textures;
            SetUpTriangle got;
            got.textures = textures.data();
            const Expected expected(triangle, grid);
            if (set_up_triangles({triangle, {&corners, 1}, false}, needs, grid, scissor, &got) == 0) continue;
            ++drawn;
            REQUIRE(expected.has_area());
            for (std::size_t i = 0; i < 3; ++i)
                for (const auto& [x, y] : {std::pair{0, 0}, std::pair{8191, 0}, std::pair{17, 8191}}) {
                    const std::int64_t e = expected.edge(i, x, y);
                    REQUIRE((got.edges[i].at(x, y) >= 0) == (e > 0 || (e == 0 && expected.is_top_left(i))));
                }
            const auto depth = [&](const Vertex& v) { return depth_value(v.z) >> needs.depth_cut << needs.depth_cut; };
            REQUIRE(same(got.depth, expected.plane(12, [&](const Vertex& v) { return std::int64_t{depth(v)}; })));
            const auto [least, greatest] = std::minmax({depth(triangle[0]), depth(triangle[1]), depth(triangle[2])});
            REQUIRE(static_cast<std::uint32_t>(got.depth_min) == least);
            REQUIRE(static_cast<std::uint32_t>(got.depth_max) == greatest);
            const int fraction = needs.floor_colors ? 31 : 23;
            for (std::size_t channel = 0; channel < 4; ++channel) {
                if (got.diffuse_varies)
                    REQUIRE(same(got.diffuse[channel], expected.color(&Vertex::diffuse, channel, fraction)));
                if (got.specular_varies && (needs.specular || channel == 3))
                    REQUIRE(same(got.specular[channel], expected.color(&Vertex::specular, channel, fraction)));
            }
            REQUIRE(textures_agree(expected, 0, got.textures[0], 64));
            REQUIRE(textures_agree(expected, 1, got.textures[1], 8192));
        }
        CHECK(drawn > 5000);
    });
}

TEST_CASE("what does not vary is flat, and flat draws take the first corner's colours", "[raster][setup]") {
    Triangle t;
    t[1].x = t[2].y = 20.0f;
    t[0].diffuse    = 0x11223344;
    t[0].specular = t[1].specular = t[2].specular = 0x80ffffff;
    const TriangleCorners corners{0, 1, 2};
    const auto set_up = [&](bool flat, const SetupNeeds& needs) {
        SetUpTriangle out;
        REQUIRE(set_up_triangles({t, {&corners, 1}, flat}, needs, {}, {0, 0, 64, 64}, &out) == 1);
        return out;
    };
    const SetupNeeds all{.diffuse = true, .specular = true}, fog{.fog = true};
    CHECK(set_up(false, all).diffuse_varies);
    CHECK(!set_up(false, all).specular_varies);
    CHECK(!set_up(true, all).diffuse_varies);
    CHECK(set_up(true, all).flat_diffuse == 0x11223344);
    t[1].specular = 0x80000000;
    CHECK(set_up(false, all).specular_varies);
    CHECK(!set_up(false, fog).specular_varies);
    t[1].specular = 0x81ffffff;
    CHECK(set_up(false, fog).specular_varies);
    CHECK(!set_up(false, {}).specular_varies);
}

TEST_CASE("triangles without area or pixels are left out, the others keep their order", "[raster][setup]") {
    std::vector<Vertex> vertices(6);
    const float places[6][2] = {{0, 0}, {9, 0}, {0, 9}, {4.5f, 0}, {70, 70}, {90, 70}};
    for (std::size_t i = 0; i < 6; ++i) {
        vertices[i].x       = places[i][0];
        vertices[i].y       = places[i][1];
        vertices[i].diffuse = static_cast<std::uint32_t>(i);
    }
    const std::vector<TriangleCorners> corners{{1, 0, 2}, {0, 1, 3}, {4, 5, 4}, {2, 0, 1}, {4, 5, 5}};
    std::array<SetUpTriangle, 5> out;
    REQUIRE(set_up_triangles({vertices, corners, true}, {.diffuse = true}, {}, {0, 0, 64, 64}, out.data()) == 2);
    CHECK(out[0].flat_diffuse == 1);
    CHECK(out[1].flat_diffuse == 2);
    CHECK(out[0].bounds == Rect{0, 0, 9, 9});
}
