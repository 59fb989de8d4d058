// SPDX-License-Identifier: MIT
// Where the oracle reads textures and what it makes of the texels: copies, averages, levels and indices known without
// it, and perspective against double precision.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "raster/reference.h"
#include "tests/raster/reference_scene.h"

using namespace raster;
using namespace reference_scene;

namespace {

Rectangle textured(float width, float height, Rectangle::UvRect uv = {}) {
    Rectangle r = rectangle(0, 0, width, height);
    r.uv[0]     = uv;
    return r;
}

std::uint32_t hash(int x, int y) {
    return static_cast<std::uint32_t>(x) * 2654435761u ^ static_cast<std::uint32_t>(y) * 2246822519u;
}

// Levels of one colour each, from size x size down to one texel: level L has L in every channel.
void add_numbered_levels(Texture& texture, int size) {
    for (int level = 1; size >> level > 0; ++level)
        texture.add_level(size >> level, size >> level,
                          [level](int, int) { return static_cast<std::uint32_t>(level) * 0x01010101u; });
}

Vertex corner(float x, float y, float w, float s, float t) {
    Vertex v = vertex(x, y);
    v.rhw    = 1.0f / w;
    v.uv[0]  = {s, t, 1.0f};
    return v;
}

// A quad lying in space, s and t from 0 to 1 over it, w = 1 + ws s + wt t, which fills about 160 x 200 pixels.
struct QuadInSpace {
    double ws, wt;

    Vertex at(float s, float t) const {
        const double w     = 1 + ws * s + wt * t;
        const auto snapped = [](double pixels) { return static_cast<float>(std::nearbyint(pixels * 16) / 16); };
        return corner(snapped((20 + 160 * ws * s) / w), snapped((10 + 8 * ws * s + 260 * wt * t) / w),
                      static_cast<float>(w), s, t);
    }
    std::array<Triangle, 2> triangles() const {
        return {Triangle{at(0, 0), at(1, 0), at(1, 1)}, Triangle{at(0, 0), at(1, 1), at(0, 1)}};
    }
};

// s and t of a triangle at a point, in double precision.
std::array<double, 2> exact_texture_point(const Triangle& triangle, double x, double y) {
    double s = 0, t = 0, q = 0;
    for (int i = 0; i < 3; ++i) {
        const Vertex &a = triangle[(i + 1) % 3], &b = triangle[(i + 2) % 3];
        const double weight = (double{a.x} - x) * (double{b.y} - y) - (double{a.y} - y) * (double{b.x} - x);
        s += weight * triangle[i].rhw * triangle[i].uv[0].s;
        t += weight * triangle[i].rhw * triangle[i].uv[0].t;
        q += weight * triangle[i].rhw;
    }
    return {s / q, t / q};
}

}  // namespace

TEST_CASE("A one to one blit copies a texture bit for bit", "[reference]") {
    const bool linear = GENERATE(false, true);
    const int wide = GENERATE(1, 37, 64), high = GENERATE(1, 19);
    const MipFilter mip = GENERATE(MipFilter::None, MipFilter::Point, MipFilter::Linear);
    Texture texture(wide, high, hash);
    texture.sampler.linear    = linear;
    texture.sampler.mip       = mip;
    texture.sampler.address_u = texture.sampler.address_v = Address::Clamp;
    // Anywhere on the target: shifted by whole pixels, over a block's edge.
    Canvas canvas(wide + 13, high + 5);
    Rectangle r             = rectangle(13, 5, static_cast<float>(wide) + 13, static_cast<float>(high) + 5);
    const FillCounts counts = canvas.draw(texture_only(texture), r);
    int wrong               = 0;
    for (int y = 0; y < high; ++y)
        for (int x = 0; x < wide; ++x) wrong += canvas.at(x + 13, y + 5) != hash(x, y);
    CHECK(wrong == 0);
    const int texels = (linear ? 4 : 1) * (mip == MipFilter::Linear ? 2 : 1);
    CHECK(counts.texels == static_cast<std::uint64_t>(wide * high * texels));
}

TEST_CASE("A linear blit to half the size averages two by two texels", "[reference]") {
    Texture texture(32, 16, hash);
    texture.sampler.linear = true;
    Canvas canvas(16, 8);
    canvas.draw(texture_only(texture), textured(16, 8));
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 16; ++x) {
            for (int c = 0; c < 4; ++c) {
                const int sum = channel(hash(2 * x, 2 * y), c) + channel(hash(2 * x + 1, 2 * y), c) +
                                channel(hash(2 * x, 2 * y + 1), c) + channel(hash(2 * x + 1, 2 * y + 1), c);
                CHECK(channel(canvas.at(x, y), c) == (sum + 2) >> 2);
            }
        }
    }
}

TEST_CASE("Linear weights are 256ths, and the result is rounded once", "[reference]") {
    // Sixteen pixels to a texel: the centres fall on odd 32nds.
    Texture texture(2, 1, [](int x, int) { return x == 0 ? 0x00ff1020u : 0xff00f0dfu; });
    texture.sampler.linear    = true;
    texture.sampler.address_u = Address::Clamp;
    Canvas canvas(32, 1);
    canvas.draw(texture_only(texture), textured(32, 1));
    for (int x = 0; x < 32; ++x) {
        const double weight = std::clamp((x + 0.5) / 16 - 0.5, 0.0, 1.0);
        for (int c = 0; c < 4; ++c) {
            const double exact = (1 - weight) * channel(0x00ff1020, c) + weight * channel(0xff00f0df, c);
            CHECK(channel(canvas.at(x, 0), c) == static_cast<int>(std::floor(exact + 0.5)));
        }
    }
}

TEST_CASE("A constant texture stays constant under every filter", "[reference]") {
    const bool linear       = GENERATE(false, true);
    const MipFilter mip     = GENERATE(MipFilter::None, MipFilter::Point, MipFilter::Linear);
    const Address address   = GENERATE(Address::Wrap, Address::Clamp, Address::Mirror);
    const std::uint32_t one = GENERATE(0u, 0xffffffffu, 0x01fe807fu);
    const auto constant     = [one](int, int) { return one; };
    Texture texture(16, 8, constant);
    texture.add_level(8, 4, constant);
    texture.add_level(4, 2, constant);
    texture.sampler.linear    = linear;
    texture.sampler.mip       = mip;
    texture.sampler.address_u = texture.sampler.address_v = address;

    Canvas canvas(48, 40);
    canvas.draw(texture_only(texture), textured(48, 40, {-1.3f, 7.9f, 4.1f, -2.2f}));
    canvas.draw(texture_only(texture),
                {{corner(2, 3, 1, -3, 0), corner(47, 9, 30, 5, 9), corner(11, 39, 4, 0.1f, -7)}});
    for (int y = 0; y < 40; ++y) CHECK(std::count(canvas.color.row(y), canvas.color.row(y) + 48, one) == 48);
}

TEST_CASE("No levels: white, and no texels counted", "[reference]") {
    FillState state;
    state.stage_count              = 1;
    state.stages[0].color.a.source = state.stages[0].alpha.a.source = CombineArg::Source::Texel;
    Canvas canvas(4, 4);
    CHECK(canvas.draw(state, rectangle(0, 0, 4, 4, 0x12345678)) == FillCounts{16, 16, 16, 0, 16});
    CHECK(canvas.at(3, 3) == kWhite);
}

TEST_CASE("Texture indices outside the texture", "[reference]") {
    const auto [address, expected] = GENERATE(table<Address, std::array<int, 20>>(
        {{Address::Wrap, {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3}},
         {Address::Mirror, {0, 1, 2, 3, 3, 2, 1, 0, 0, 1, 2, 3, 3, 2, 1, 0, 0, 1, 2, 3}},
         {Address::Clamp, {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3}}}));
    const auto& index              = expected;  // of texels -8 to 11
    Texture across(4, 1, [](int x, int) { return static_cast<std::uint32_t>(x * 80); });
    Texture down(1, 4, [](int, int y) { return static_cast<std::uint32_t>(y * 80); });
    across.sampler.address_u = down.sampler.address_v = address;
    const bool linear                                 = GENERATE(false, true);
    across.sampler.linear = down.sampler.linear = linear;

    const auto check = [&](int i, std::uint32_t texel) {
        CAPTURE(i);
        CHECK(texel == static_cast<std::uint32_t>(80 * index[i]));
    };
    Canvas canvas(20, 20);
    canvas.draw(texture_only(across), textured(20, 20, {-2, 0, 3, 1}));
    for (int i = 0; i < 20; ++i) check(i, canvas.at(i, i % 7));
    canvas.draw(texture_only(down), textured(20, 20, {0, -2, 1, 3}));
    for (int i = 0; i < 20; ++i) check(i, canvas.at(i % 7, i));

    // Half a texel further on, linear reads the mean of two neighbours.
    across.sampler.linear = true;
    canvas.draw(texture_only(across), textured(20, 20, {-2 + 0.125f, 0, 3 + 0.125f, 1}));
    for (int i = 0; i < 19; ++i) CHECK(canvas.at(i, 0) == static_cast<std::uint32_t>(40 * (index[i] + index[i + 1])));

    // The same from a triangle, whose texels' centres are not met exactly: read a quarter of a texel off them.
    across.sampler.linear = false;
    const float nudge     = 0.0625f;
    canvas.draw(texture_only(across),
                {{corner(0, 0, 1, -2 + nudge, 0), corner(64, 0, 1, 14 + nudge, 0), corner(0, 64, 1, -2 + nudge, 0)}});
    for (int i = 0; i < 20; ++i) check(i, canvas.at(i, 3));
}

TEST_CASE("Known scales read known levels", "[reference]") {
    constexpr int kSize = 256;
    Texture texture(kSize, kSize, [](int, int) { return 0u; });
    add_numbered_levels(texture, kSize);
    Canvas canvas(16, 16);
    // The rectangle shows `across` x `down` texels to a pixel.
    const auto level_of = [&](MipFilter mip, float across, float down) {
        texture.sampler.mip = mip;
        canvas.draw(texture_only(texture), textured(16, 16, {0, 0, across * 16 / kSize, down * 16 / kSize}));
        return canvas.at(5, 5) & 255;
    };
    for (int level = 0; level <= 8; ++level) {
        const auto scale = static_cast<float>(1 << level);
        CHECK(level_of(MipFilter::Point, scale, scale) == static_cast<unsigned>(level));
        CHECK(level_of(MipFilter::Point, 1, scale) == static_cast<unsigned>(level));
        CHECK(level_of(MipFilter::Point, -scale, 0.5f) == static_cast<unsigned>(level));
        CHECK(level_of(MipFilter::Linear, scale, scale) == static_cast<unsigned>(level));
    }
    CHECK(level_of(MipFilter::None, 64, 64) == 0);
    CHECK(level_of(MipFilter::Point, 1.0f / 64, 1.0f / 64) == 0);
    CHECK(level_of(MipFilter::Point, 4096, 1) == 8);  // there are no more
    // 1.5 squared is 2 * (1 + 1/8): a level of (1 + 1/8) / 2, which rounds to 1. 1.25 squared is 1 + 9/16: 9/32, to 0.
    CHECK(level_of(MipFilter::Point, 1.5f, 1) == 1);
    CHECK(level_of(MipFilter::Point, 1.25f, 1) == 0);

    SECTION("between two levels, Linear mixes them") {
        Texture two(4, 4, [](int, int) { return 0u; });
        two.add_level(2, 2, [](int, int) { return 0xffffffffu; });
        two.sampler.mip = MipFilter::Linear;
        // A level of 9/16 and of 9/32, as above.
        canvas.draw(texture_only(two), textured(16, 16, {0, 0, 6, 4}));
        CHECK(canvas.at(3, 3) == ((255 * 144 + 128) >> 8) * 0x01010101u);
        canvas.draw(texture_only(two), textured(16, 16, {0, 0, 5, 4}));
        CHECK(canvas.at(3, 3) == ((255 * 72 + 128) >> 8) * 0x01010101u);
    }
    SECTION("triangles read them too, at any w") {
        texture.sampler.mip = MipFilter::Point;
        for (float w : {0.25f, 1.0f, 1000.0f}) {
            for (int level = 0; level <= 8; ++level) {
                const float span = static_cast<float>(64 << level) / kSize;
                canvas.draw(texture_only(texture),
                            {{corner(0, 0, w, 0, 0), corner(64, 0, w, span, 0), corner(0, 64, w, 0, span)}});
                CHECK((canvas.at(5, 9) & 255) == static_cast<unsigned>(level));
            }
        }
    }
}

TEST_CASE("A level is read at its own scale", "[reference]") {
    Texture texture(16, 16, [](int, int) { return 0u; });
    texture.add_level(8, 8, hash);
    texture.sampler.mip    = MipFilter::Point;
    texture.sampler.linear = GENERATE(false, true);
    Canvas canvas(8, 8);
    canvas.draw(texture_only(texture), textured(8, 8));
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) CHECK(canvas.at(x, y) == hash(x, y));
}

TEST_CASE("Perspective is right to 1/64 of a texel", "[reference]") {
    // Blue rises and falls by 255 from texel to texel, which shows a coordinate to a fraction of one; green grows by 3,
    // which shows the texel. The same for v in alpha and red.
    constexpr int kSize = 64;
    const auto wave     = [](int i) { return i % 2 * 255; };
    Texture texture(kSize, kSize, [&](int x, int y) {
        return static_cast<std::uint32_t>(wave(y) << 24 | y * 3 << 16 | x * 3 << 8 | wave(x));
    });
    texture.sampler.linear    = true;
    texture.sampler.address_u = texture.sampler.address_v = Address::Clamp;

    const QuadInSpace quad = GENERATE(QuadInSpace{5, 2}, QuadInSpace{300, 40});
    CAPTURE(quad.ws);
    Canvas canvas(160, 200);
    std::array<double, 4> worst{};
    int pixels = 0;
    for (const Triangle& triangle : quad.triangles()) {
        canvas.draw({}, rectangle(0, 0, 160, 200, 0x00ffff00));  // green and red of no texel
        canvas.draw(texture_only(texture), {triangle});
        for (int y = 0; y < 200; ++y) {
            for (int x = 0; x < 160; ++x) {
                if (canvas.at(x, y) == 0x00ffff00) continue;
                ++pixels;
                const auto [s, t]   = exact_texture_point(triangle, x + 0.5, y + 0.5);
                const auto expected = [&](double coordinate) {
                    const double texel = std::clamp(coordinate * kSize - 0.5, 0.0, kSize - 1.0);
                    const int i        = std::min(static_cast<int>(texel), kSize - 2);
                    return std::pair{wave(i) + (wave(i + 1) - wave(i)) * (texel - i), 3 * texel};
                };
                const auto [blue, green] = expected(s);
                const auto [alpha, red]  = expected(t);
                const std::uint32_t seen = canvas.at(x, y);
                worst[0]                 = std::max(worst[0], std::abs(channel(seen, 0) - blue));
                worst[1]                 = std::max(worst[1], std::abs(channel(seen, 1) - green));
                worst[2]                 = std::max(worst[2], std::abs(channel(seen, 2) - red));
                worst[3]                 = std::max(worst[3], std::abs(channel(seen, 3) - alpha));
            }
        }
    }
    CHECK(pixels > 10000);
    CHECK(worst[0] <= 255.0 / 64 + 0.5);
    CHECK(worst[3] <= 255.0 / 64 + 0.5);
    CHECK(worst[1] <= 0.6);
    CHECK(worst[2] <= 0.6);
}

TEST_CASE("The level follows perspective from pixel to pixel", "[reference]") {
    // Each level is 24 brighter than the one before, and Linear mixes them: the colour shows the level.
    constexpr int kSize = 1024;
    Texture texture(kSize, kSize, [](int, int) { return 0u; });
    for (int level = 1; kSize >> level > 0; ++level)
        texture.add_level(kSize >> level, kSize >> level,
                          [level](int, int) { return static_cast<std::uint32_t>(24 * level); });
    texture.sampler.mip    = MipFilter::Linear;
    const QuadInSpace quad = GENERATE(QuadInSpace{5, 2}, QuadInSpace{60, 20});
    CAPTURE(quad.ws);

    Canvas canvas(160, 200);
    double worst = 0, least = 255, greatest = 0;
    for (const Triangle& triangle : quad.triangles()) {
        canvas.draw({}, rectangle(0, 0, 160, 200));
        canvas.draw(texture_only(texture), {triangle});
        for (int y = 0; y < 200; ++y) {
            for (int x = 0; x < 160; ++x) {
                if (canvas.at(x, y) == kWhite) continue;
                const auto texels_a_pixel_along = [&](double dx, double dy) {
                    const auto a = exact_texture_point(triangle, x + 0.5 - dx, y + 0.5 - dy);
                    const auto b = exact_texture_point(triangle, x + 0.5 + dx, y + 0.5 + dy);
                    return std::hypot(b[0] - a[0], b[1] - a[1]) * kSize / (2 * (dx + dy));
                };
                const double rho     = std::max(texels_a_pixel_along(1e-3, 0), texels_a_pixel_along(0, 1e-3));
                const double rho2    = std::max(rho * rho, 1.0);
                // The logarithm that is linear between powers of two.
                int exponent         = 0;
                const double above   = std::frexp(rho2, &exponent) * 2 - 1;
                const double level   = std::min((exponent - 1 + above) / 2, 10.0);
                const int brightness = channel(canvas.at(x, y), 0);
                worst                = std::max(worst, std::abs(brightness - 24 * level));
                least                = std::min(least, level);
                greatest             = std::max(greatest, level);
            }
        }
    }
    CHECK(worst < 0.5 + 24 * 2.0 / 256);  // a byte's rounding, and a 256th of a level lost on the way
    CHECK(greatest > least + 2);
}

TEST_CASE("Both textures are read, each with its own coordinates", "[reference]") {
    Texture first(4, 1, [](int x, int) { return static_cast<std::uint32_t>(x + 1); });
    Texture second(1, 4, [](int, int y) { return static_cast<std::uint32_t>((y + 1) << 8); });
    first.sampler.linear      = true;  // one to one, so exact
    first.sampler.texel_bytes = 2;
    FillState state           = texture_only(first);
    state.samplers[1]         = second.sampler;
    state.stage_count         = 2;
    state.stages[1]           = {
                  {CombineOp::Add, {CombineArg::Source::Texel}, {CombineArg::Source::Current}},
                  {CombineOp::Select, {CombineArg::Source::Current}, {}},
    };
    Canvas canvas(4, 4);
    Rectangle r             = textured(4, 4);
    r.uv[1]                 = {0, 1, 1, 0};  // upside down
    const FillCounts counts = canvas.draw(state, r);
    CHECK(counts.texels == 16 * 5);
    CHECK(counts.texel_bytes == 16 * (4 * 2 + 1 * 4));
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) CHECK(canvas.at(x, y) == static_cast<std::uint32_t>((4 - y) << 8 | (x + 1)));
}
