// SPDX-License-Identifier: MIT
// Every program of raster/special_programs.h draws what the kernel for all programs and the reference draw: images and
// counts, of random triangles and rectangles, on every instruction set.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <vector>

#include "raster/fill_pass.h"
#include "raster/fill_plan.h"
#include "raster/reference.h"
#include "raster/special_programs.h"
#include "raster/triangle_setup.h"
#include "tests/raster/special_state.h"
#include "tests/support/random.h"
#include "tests/support/simd_targets.h"

namespace {

using namespace raster;
using special_state::SpecialState;
using test_support::Random;

constexpr int kWidth = 150, kHeight = 70;  // three tiles by three, the last of them cut off

struct Targets {
    Image color{kWidth, kHeight}, depth{kWidth, kHeight};
    FillCounts counts;

    bool operator==(const Targets& other) const {
        const auto same = [](const Image& a, const Image& b) {
            for (int y = 0; y < kHeight; ++y)
                if (!std::equal(a.row(y), a.row(y) + kWidth, b.row(y))) return false;
            return true;
        };
        return same(color, other.color) && same(depth, other.depth) && counts == other.counts;
    }
};

// The same from a seed.
Targets random_targets(std::uint32_t seed) {
    Targets targets;
    Random random(seed);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            targets.color.row(y)[x] = random.bits();
            targets.depth.row(y)[x] = random.bits() >> 8;
        }
    return targets;
}

Vertex random_vertex(Random& random, float x, float y, float size) {
    Vertex v;
    v.x        = x + random.real(-size, size);
    v.y        = y + random.real(-size, size);
    v.z        = random.real(0.0f, 1.0f);
    v.rhw      = random.real(0.1f, 2.0f);
    v.diffuse  = random.bits();
    v.specular = random.bits();
    for (TexCoord& uv : v.uv)
        uv = {random.real(-2.0f, 3.0f), random.real(-2.0f, 3.0f), random.chance(50) ? 1.0f : random.real(0.5f, 1.5f)};
    return v;
}

// Of a few pixels and of the whole target; some have one colour.
void add_triangles(Random& random, Draw& draw) {
    for (int i = 0; i < 30; ++i) {
        const float size = random.one_of({3.0f, 12.0f, 40.0f, 150.0f});
        const float x = random.real(0.0f, kWidth), y = random.real(0.0f, kHeight);
        const auto first = static_cast<std::uint32_t>(draw.vertices.size());
        for (int k = 0; k < 3; ++k) draw.vertices.push_back(random_vertex(random, x, y, size));
        if (random.chance(30))
            for (std::uint32_t k = 1; k < 3; ++k) {
                draw.vertices[first + k].diffuse  = draw.vertices[first].diffuse;
                draw.vertices[first + k].specular = draw.vertices[first].specular;
            }
        draw.triangles.push_back({first, first + 1, first + 2});
    }
}

// Some read 1, 2 or 1/2 texels to the pixel.
void add_rectangles(Random& random, Draw& draw) {
    for (int i = 0; i < 30; ++i) {
        Rectangle r;
        const bool aligned = random.chance(50);
        const auto place   = [&](float least, float most) {
            return aligned ? static_cast<float>(random.from(static_cast<int>(least), static_cast<int>(most)))
                             : random.real(least, most);
        };
        r.x0    = place(-20.0f, kWidth);
        r.y0    = place(-20.0f, kHeight);
        r.x1    = r.x0 + place(1.0f, random.one_of({5.0f, 30.0f, 150.0f}));
        r.y1    = r.y0 + place(1.0f, random.one_of({5.0f, 30.0f, 70.0f}));
        r.z     = random.real(0.0f, 1.0f);
        r.color = random.bits();
        for (int k = 0; k < kMaxTextures; ++k) {
            const std::vector<TextureLevel>& levels = draw.state.samplers[k].levels;
            const float size                        = levels.empty() ? 1.0f : static_cast<float>(levels[0].width);
            const float step                        = random.one_of({0.5f, 1.0f, 2.0f, random.real(0.0f, 3.0f)});
            const float u = random.real(-0.3f, 1.0f), v = random.real(-0.3f, 1.0f);
            r.uv[k].u0 = aligned ? static_cast<float>(static_cast<int>(u * size)) / size : u;
            r.uv[k].v0 = aligned ? static_cast<float>(static_cast<int>(v * size)) / size : v;
            r.uv[k].u1 = r.uv[k].u0 + (r.x1 - r.x0) * step / size;
            r.uv[k].v1 = r.uv[k].v0 + (r.y1 - r.y0) * step / size;
        }
        draw.rectangles.push_back(r);
    }
}

// Each primitive of the pass in each tile, by these kernels.
void fill(const PassFill& pass, const FillPlan& plan, const FillTarget& target, FillCounts& counts) {
    const auto for_each_tile = [&](auto use) {
        for (int y = 0; y < kHeight; y += kTileHeight)
            for (int x = 0; x < kWidth; x += kTileWidth)
                use(intersect({x, y, x + kTileWidth, y + kTileHeight}, {0, 0, kWidth, kHeight}));
    };
    for (const Draw& draw : pass.draws) {
        std::vector<SetUpTriangle> triangles(draw.triangles.size());
        std::vector<TexturePlanes> textures(kMaxTextures * triangles.size());
        for (std::size_t i = 0; i < triangles.size(); ++i) triangles[i].textures = textures.data() + kMaxTextures * i;
        triangles.resize(set_up_triangles({draw.vertices, draw.triangles, draw.flat}, plan.needs, pass.grid,
                                          pass.scissor, triangles.data()));
        for (const SetUpTriangle& triangle : triangles)
            for_each_tile([&](const Rect& tile) {
                plan.kernel.triangle(plan, triangle, tile, target, {&counts, nullptr});
            });
        for (const Rectangle& each : draw.rectangles) {
            SetUpRectangle rectangle;
            if (!set_up_rectangle(each, plan.needs, pass.grid, pass.scissor, rectangle)) continue;
            for_each_tile([&](const Rect& tile) {
                plan.kernel.rectangle(plan, rectangle, tile, target, {&counts, nullptr});
            });
        }
    }
}

template <std::size_t kCount>
void check_programs(const std::array<FillProgram, kCount>& programs, bool FillKernel::*is_special,
                    void (*add_primitives)(Random&, Draw&)) {
    for (std::size_t index = 0; index < kCount; ++index)
        for (std::uint32_t round = 0; round < 6; ++round) {
            const std::uint32_t seed = 100 * static_cast<std::uint32_t>(index) + round;
            CAPTURE(index, round);
            Random random(seed);
            const SpecialState special(programs[index], seed);
            Targets wanted = random_targets(seed);
            PassFill pass{.color      = special.has_color() ? &wanted.color : nullptr,
                          .depth      = &wanted.depth,
                          .depth_bits = special.depth_bits(),
                          .format     = special.format,
                          .scissor    = {random.from(0, 20), random.from(0, 9), kWidth - random.from(0, 20), kHeight},
                          .draws      = {{.state = special.state}}};
            add_primitives(random, pass.draws[0]);
            wanted.counts = reference_fill_pass(pass);
            CHECK(wanted.counts.covered > 1000);
            CHECK(wanted.counts.color_written > 0);
            test_support::for_each_simd_target([&](const std::string& target) {
                for (const bool general : {false, true}) {
                    const FillPlan plan = special.plan(general);
                    REQUIRE(plan.program == programs[index]);
                    const bool has_special = target != "SCALAR";  // not worth compiling
                    REQUIRE(plan.kernel.*is_special == (has_special && !general));
                    Targets got = random_targets(seed);
                    fill(pass, plan, {special.has_color() ? &got.color : nullptr, &got.depth}, got.counts);
                    INFO((general ? "general" : "special") << " kernel");
                    CHECK(got == wanted);
                }
                Targets uncounted = random_targets(seed);
                uncounted.counts  = wanted.counts;
                PassFill again    = pass;
                again.color       = special.has_color() ? &uncounted.color : nullptr;
                again.depth       = &uncounted.depth;
                PassFiller().fill({&again, 1}, {}, {.counts = false});
                INFO("nothing counted");
                CHECK(uncounted == wanted);
            });
        }
}

}  // namespace

TEST_CASE("special kernels draw triangles like the general one and the reference", "[raster][agreement]") {
    check_programs(kTrianglePrograms, &FillKernel::special_triangle, &add_triangles);
}

TEST_CASE("special kernels draw rectangles like the general one and the reference", "[raster][agreement]") {
    check_programs(kRectanglePrograms, &FillKernel::special_rectangle, &add_rectangles);
}
