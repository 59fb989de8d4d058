// SPDX-License-Identifier: MIT
#include "cloud/baselines/slice_cloud.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "cloud/mega_particles/cloud_draw.h"
#include "cloud/particle_mesh.h"
#include "pipeline/validate/validate.h"
#include "tests/cloud/coverage.h"
#include "tests/cloud/cumulus.h"

using namespace cloud;
using namespace pipeline;

namespace {

const View kFront = look(Vec3(0.0f, 58.0f, 170.0f), Vec3(0.0f, 60.0f, 0.0f), 160, 120);

const BakedCloud& baked_cumulus() {
    static const BakedCloud baked = bake(cumulus(), Daylight{});
    return baked;
}

const SliceVolume& volume_of_cumulus() {
    static const SliceVolume volume = make_slices(baked_cumulus());
    return volume;
}

SliceVolume moved(float z, const std::string& name) {
    Cloud cloud = cumulus();
    cloud.name  = name;
    for (Particle& particle : cloud.particles) particle.center.z += z;
    return make_slices(bake(cloud, Daylight{}), {.size = 24});
}

AppendClouds slices_of(std::vector<SliceVolume> volumes) {
    return [volumes = std::move(volumes)](Frame& frame, const SceneTargets& scene, const View& view) {
        append_slice_clouds(frame, scene, view, volumes);
    };
}

void mega_particles(Frame& frame, const SceneTargets& scene, const View& view) {
    append_mega_particles(frame, scene, view, std::span(&baked_cumulus(), 1));
}

Frame slice_frame(const std::vector<SliceVolume>& volumes, const View& view, float depth = 1.0f) {
    return plain_scene(slices_of(volumes), view, {0xff4060ff}, depth);
}

// A ball of 10 m about (1, 2, 3), its rim sharp within a cell and without noise: that is finer than the cells.
Cloud ball() {
    Cloud cloud;
    cloud.name           = "ball";
    cloud.particles      = {{.center = Vec3(1.0f, 2.0f, 3.0f), .radius = 10.0f}};
    cloud.blur_m         = 0.0f;
    cloud.lumpiness      = 0.0f;
    cloud.fractal.cycles = 1024.0f;
    return cloud;
}

// B, G, R, A of a cell in the stack across `axis`.
const std::uint8_t* texel(const SliceVolume& volume, int axis, const int (&cell)[3]) {
    const int u = cell[(axis + 1) % 3], v = cell[(axis + 2) % 3];
    return &volume.stacks[static_cast<std::size_t>(axis)][volume.slice_bytes() * static_cast<std::size_t>(cell[axis]) +
                                                          4 * static_cast<std::size_t>(v * volume.size + u)];
}

}  // namespace

TEST_CASE("slices: frames are valid, from far away, near, inside, translucent", "[slices]") {
    std::vector<SliceVolume> volumes{volume_of_cumulus(), moved(-150.0f, "behind")};
    volumes[1].cloud.opacity = 0.5f;
    const float z            = GENERATE(5000.0f, 170.0f, 45.0f, 18.5f, 0.0f);
    const Frame frame        = slice_frame(volumes, look(Vec3(0.0f, 60.0f, z), Vec3(2.0f, 60.0f, -300.0f), 333, 211));
    REQUIRE(frame.passes.size() == 3);
    for (const Finding& finding : validate(frame)) FAIL_CHECK(finding.where + ": " + finding.what);
}

TEST_CASE("slices: the state of 1999", "[slices]") {
    const SceneTargets scene{
        .back_buffer = {0}, .depth = {1}, .camera = {0}, .fog = {.mode = FogMode::Linear, .end = 500.0f}};
    Frame frame;
    append_slice_clouds(frame, scene, kFront, std::span(&baked_cumulus(), 1), {.size = 16});
    REQUIRE(frame.passes.size() == 1);
    const Pass& pass = frame.passes[0];
    CHECK(pass.label == "cumulus: slices across z, back to front");
    CHECK(pass.color == scene.back_buffer);
    CHECK(pass.depth == scene.depth);
    CHECK(pass.camera == scene.camera);
    CHECK(pass.state.blend == kAlphaOver);
    CHECK(pass.state.depth == DepthState{CompareFunc::LessEqual, false});
    CHECK(pass.state.fog == scene.fog);
    CHECK(pass.draws.size() == frame.textures.size());
    CHECK(pass.draws.size() <= 16);
    for (const Texture& texture : frame.textures) CHECK(texture.texels.size() == std::size_t{16} * 16 * 4);
}

TEST_CASE("slices: across the axis of sight, back to front, from all sides and from inside", "[slices]") {
    const SliceVolume& volume = volume_of_cumulus();
    const Vec3 middle         = (volume.low + volume.high) * 0.5f;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-150.0f, -5.0f, 5.0f, 150.0f}) {
            Vec3 eye = middle + Vec3(1.0f, 1.5f, 2.0f);
            eye[axis] += side;
            const Frame frame = slice_frame({volume}, look(eye, middle));
            INFO("axis " << axis << ", " << side << " m aside");
            REQUIRE(frame.passes.size() == 2);
            CHECK(frame.passes[1].label == std::string("cumulus: slices across ") + "xyz"[axis] + ", back to front");
            float last = std::numeric_limits<float>::infinity();
            for (std::size_t quad = 0; quad < frame.vertices.size(); quad += 4) {
                const float distance = std::abs(frame.vertices[quad].position[axis] - eye[axis]);
                for (std::size_t corner = 1; corner < 4; ++corner)
                    CHECK(frame.vertices[quad + corner].position[axis] == frame.vertices[quad].position[axis]);
                CHECK(distance <= last);
                last = distance;
            }
        }
}

TEST_CASE("slices: every stack lets through what the volume does", "[slices]") {
    const SliceVolume volume = make_slices(bake(ball(), Daylight{}), {.size = 32, .coverage = 0.5f});
    // The line through the middle is 2 R long, over which the optical depth is 2 * 0.5; a cell's width is unsure.
    const Vec3 step          = (volume.high - volume.low) / 32.0f;
    for (int axis = 0; axis < 3; ++axis) {
        double depth = 0.0;
        int cell[3];
        for (int i = 0; i < 3; ++i)
            cell[i] = static_cast<int>((volume.cloud.particles[0].center[i] - volume.low[i]) / step[i]);
        for (cell[axis] = 0; cell[axis] < 32; ++cell[axis])
            depth -= std::log(1.0 - texel(volume, axis, cell)[3] / 255.0);
        CHECK(depth == Approx(1.0).epsilon(0.06));
    }
}

TEST_CASE("slices: the three stacks hold the same volume, clear at the border, in the light of the surface",
          "[slices]") {
    BakedCloud baked              = bake(ball(), Daylight{});
    baked.cloud.particles[0].glow = Vec3(0.0f, 0.04f, 0.0f);
    const SliceVolume volume      = make_slices(baked, {.size = 24});
    for (const std::vector<std::uint8_t>& stack : volume.stacks) CHECK(stack.size() == std::size_t{24} * 24 * 24 * 4);
    const Vec3 step = (volume.high - volume.low) / 24.0f;
    for (int z = 0; z < 24; ++z)
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 24; ++x) {
                const int cell[3] = {x, y, z};
                for (int axis = 0; axis < 3; ++axis) {
                    const std::uint8_t* here  = texel(volume, axis, cell);
                    const std::uint8_t* first = texel(volume, 0, cell);
                    REQUIRE((here[0] == first[0] && here[1] == first[1] && here[2] == first[2]));
                    const int u = cell[(axis + 1) % 3], v = cell[(axis + 2) % 3];
                    if (u == 0 || v == 0 || u == 23 || v == 23) REQUIRE(here[3] == 0);
                    const PixelRect& part =
                        volume.visible[static_cast<std::size_t>(axis)][static_cast<std::size_t>(cell[axis])];
                    if (here[3] > 0) REQUIRE((u > part.x0 && u + 1 < part.x1 && v > part.y0 && v + 1 < part.y1));
                }
            }
    // Up, from the middle: the vertex of the coarse sphere nearest to that.
    int cell[3] = {0, 21, 0};
    for (int i : {0, 2}) cell[i] = static_cast<int>((volume.cloud.particles[0].center[i] - volume.low[i]) / step[i]);
    const Vec3 place = volume.low + (Vec3(cell[0], cell[1], cell[2]) + 0.5f) * step - Vec3(1.0f, 2.0f, 3.0f);
    float most       = -1e9f;
    Vec3 light(0.0f);
    for (std::uint32_t v = 0; v < icosphere_vertices(2); ++v)
        if (const float along = glm::dot(icosphere().directions[v], place); along > most)
            most = along, light = baked.lit.vertices[v].light;
    const std::uint32_t expected = to_argb(light + Vec3(0.0f, 0.04f, 0.0f), 0.0f).value;
    const std::uint8_t* top      = texel(volume, 0, cell);
    CHECK((static_cast<std::uint32_t>(top[2]) << 16 | static_cast<std::uint32_t>(top[1]) << 8 | top[0]) == expected);
}

TEST_CASE("slices: ellipsoids and a flat base", "[slices]") {
    Cloud cloud              = ball();
    cloud.particles[0].shape = Mat3(2.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 0.5f);
    cloud.base_y             = 0.0f;
    BakedCloud baked         = bake(cloud, Daylight{});
    baked.lit.low            = Vec3(-20.0f, -10.0f, -10.0f);
    baked.lit.high           = Vec3(22.0f, 14.0f, 16.0f);
    const SliceVolume volume = make_slices(baked, {.size = 64});
    const auto is_solid      = [&](Vec3 point) {
        const Vec3 place  = (point - volume.low) / (volume.high - volume.low) * 64.0f;
        const int cell[3] = {static_cast<int>(place.x), static_cast<int>(place.y), static_cast<int>(place.z)};
        return texel(volume, 0, cell)[3] > 60;
    };
    CHECK(is_solid(Vec3(1.0f, 2.0f, 3.0f)));
    CHECK(is_solid(Vec3(18.5f, 2.0f, 3.0f)));
    CHECK(is_solid(Vec3(-16.5f, 2.0f, 3.0f)));
    CHECK_FALSE(is_solid(Vec3(1.0f, 2.0f, 10.5f)));
    CHECK_FALSE(is_solid(Vec3(1.0f, 2.0f, -4.5f)));
    CHECK(is_solid(Vec3(1.0f, 9.5f, 3.0f)));
    CHECK(is_solid(Vec3(1.0f, -0.3f, 3.0f)));
    CHECK_FALSE(is_solid(Vec3(1.0f, -2.5f, 3.0f)));
}

TEST_CASE("slices: they cover what mega-particles cover, opaque in the middle, hidden by what is nearer", "[slices]") {
    const AppendClouds slices        = slices_of({volume_of_cumulus()});
    const Vec3 eye                   = GENERATE(Vec3(0.0f, 58.0f, 170.0f), Vec3(150.0f, 80.0f, -60.0f));
    const View view                  = look(eye, Vec3(0.0f, 60.0f, 0.0f), 160, 120);
    const std::vector<float> covered = coverage(slices, view), mega = coverage(mega_particles, view);
    CHECK(overlap(covered, mega) > 0.8);
    CHECK(covered[60 * 160 + 80] > 0.97f);
    CHECK(covered[5 * 160 + 5] == 0.0f);
    CHECK(execute(plain_scene(slices, view, {0xff4060ff}, 0.9f)).output.pixels ==
          std::vector<std::uint32_t>(std::size_t{160} * 120, 0xff4060ffu));
}

TEST_CASE("slices: every pixel of the cloud is blended many times over, more often with more slices", "[slices]") {
    const auto mega = static_cast<double>(blended_pixels(plain_scene(mega_particles, kFront, {0xff4060ff})));
    double last     = 0.0;
    for (const int size : {16, 32, 64}) {
        const SliceVolume volume = make_slices(baked_cumulus(), {.size = size});
        const auto slices        = static_cast<double>(blended_pixels(slice_frame({volume}, kFront)));
        INFO(size << " slices: " << slices << " of slices, " << mega << " of mega-particles");
        CHECK(slices > 1.4 * last);
        last = slices;
    }
    CHECK(last > 10.0 * mega);
}

TEST_CASE("slices: the same bytes with any number of threads, by the reference, and in any order of clouds",
          "[slices]") {
    std::vector<SliceVolume> volumes{moved(0.0f, "middle"), moved(-60.0f, "behind"), moved(40.0f, "before")};
    const Frame frame        = slice_frame(volumes, kFront);
    const ColorImage picture = execute(frame, {.threads = 1}).output;
    for (const int threads : {2, 5})
        CHECK(execute(frame, {.threads = threads, .tile_order_seed = 3}).output == picture);
    CHECK(execute(frame, {.backend = Backend::Reference}).output == picture);
    std::swap(volumes[0], volumes[2]);
    CHECK(execute(slice_frame(volumes, kFront)).output == picture);
}

TEST_CASE("slices: what is out of view, clear or empty gives no pass", "[slices]") {
    const auto passes = [](const SliceVolume& volume, const View& view) {
        return slice_frame({volume}, view).passes.size();
    };
    const SliceVolume volume = moved(0.0f, "cloud");
    CHECK(passes(volume, kFront) == 2);
    CHECK(passes(volume, look(Vec3(0.0f, 58.0f, 170.0f), Vec3(0.0f, 60.0f, 300.0f))) == 1);
    CHECK(passes(volume, look(Vec3(0.0f, 58.0f, 170.0f), Vec3(300.0f, 60.0f, 0.0f))) == 1);
    CHECK(passes(make_slices(bake(Cloud{}, Daylight{})), kFront) == 1);
    SliceVolume clear   = volume;
    clear.cloud.opacity = 0.0f;
    CHECK(passes(clear, kFront) == 1);
}

TEST_CASE("slices: options that make no sense are refused", "[slices]") {
    const SliceOptions options =
        GENERATE(SliceOptions{.size = 3}, SliceOptions{.size = 257}, SliceOptions{.coverage = 0.0f},
                 SliceOptions{.coverage = std::numeric_limits<float>::quiet_NaN()});
    CHECK_THROWS_AS(make_slices(baked_cumulus(), options), std::invalid_argument);
}
