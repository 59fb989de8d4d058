// SPDX-License-Identifier: MIT
// Colour modes, order-free composite, translucency, lights and shapes, judged by the pictures they make.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "cloud/bounds.h"
#include "cloud/mega_particles/displacement.h"
#include "cloud/mega_particles/draw_particles.h"
#include "cloud/mega_particles/mega_particles.h"
#include "cloud/merge.h"
#include "pipeline/execute/execute.h"
#include "pipeline/validate/validate.h"
#include "tests/cloud/cumulus.h"
#include "tests/cloud/walled_scene.h"

using namespace cloud;
using namespace pipeline;

namespace {

constexpr std::uint32_t kSkyBlue = 0xff4060c0;
const View kFront                = look(Vec3(0.0f, 58.0f, 170.0f), Vec3(0.0f, 60.0f, 0.0f));

// A sky of one colour; a wall of another fills the columns below wall_x, at the given value of the depth buffer.
struct Stage {
    std::uint32_t sky  = kSkyBlue;
    int wall_x         = 0;
    float wall_depth   = 0.5f;
    std::uint32_t wall = 0xffa02000;
};

Frame frame_of(const std::vector<BakedCloud>& clouds, const View& view, const Stage& stage = {}) {
    const Wall wall{static_cast<float>(stage.wall_x), static_cast<float>(view.height), stage.wall_depth, {stage.wall}};
    Frame frame = walled_scene(view, {stage.sky}, wall);
    append_mega_particles(frame, kWalledTargets, view, clouds);
    return frame;
}

ColorImage picture(const Cloud& cloud, const View& view = kFront, const Stage& stage = {}) {
    return execute(frame_of({bake(cloud, Daylight{})}, view, stage)).output;
}

int channel(std::uint32_t color, int shift) {
    return static_cast<int>(color >> shift & 255);
}
int difference(std::uint32_t a, std::uint32_t b) {
    int most = 0;
    for (int shift : {0, 8, 16}) most = std::max(most, std::abs(channel(a, shift) - channel(b, shift)));
    return most;
}
int greatest_difference(const ColorImage& a, const ColorImage& b) {
    int most = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) most = std::max(most, difference(a.pixels[i], b.pixels[i]));
    return most;
}
std::size_t pixels_unlike(const ColorImage& image, std::uint32_t color) {
    return static_cast<std::size_t>(std::count_if(image.pixels.begin(), image.pixels.end(),
                                                  [&](std::uint32_t p) { return difference(p, color) > 0; }));
}

// Everywhere of one colour, its own light.
Cloud glowing(Vec3 color) {
    Cloud cloud = cumulus();
    for (Particle& particle : cloud.particles) particle.color = Vec3(0.0f), particle.glow = color;
    return cloud;
}

Particle ball(Vec3 center, float radius) {
    return {.center = center, .radius = radius};
}

}  // namespace

TEST_CASE("frames of all modes, details and orders are valid, from outside and inside", "[cloud]") {
    Cloud cloud  = cumulus();
    cloud.mode   = GENERATE(Mode::Skirt, Mode::Article, Mode::Premultiplied, Mode::Black);
    cloud.detail = GENERATE(Detail::Fractal, Detail::Displacement, Detail::None);
    cloud.order  = GENERATE(Order::InOrder, Order::OrderFree);
    if (GENERATE(false, true)) {
        cloud.opacity         = 0.7f;
        cloud.dissolve        = 0.2f;
        cloud.tint            = Vec3(0.9f, 0.8f, 0.7f);
        cloud.box_turn        = Turn(0.6f, 0.8f);
        cloud.second_box_turn = Turn(0.8f, -0.6f);
        cloud.lights          = {{.center = Vec3(0.0f, 60.0f, 0.0f), .color = Vec3(1.0f), .range = 30.0f}};
    }
    const float z   = GENERATE(170.0f, 24.0f, 3.0f);
    const View view = look(Vec3(0.0f, 60.0f, z), Vec3(2.0f, 60.0f, -300.0f), 160, 90);
    for (const Finding& finding : validate(frame_of({bake(cloud, Daylight{})}, view)))
        FAIL_CHECK(finding.where + ": " + finding.what);
}

// With K = S the rim a K + (1 - a) S is S; the article's weights come to 1 as well; on black a^2 K + (1 - a) S misses a (1
// - a) K, a quarter of it where a is a half.
TEST_CASE("a cloud of the sky's own colour shows a halo in black mode alone", "[cloud]") {
    Cloud cloud = glowing(Vec3(0x40 / 255.0f, 0x60 / 255.0f, 0xc0 / 255.0f));
    cloud.mode  = GENERATE(Mode::Skirt, Mode::Article, Mode::Premultiplied, Mode::Black);
    if (cloud.mode == Mode::Article) {  // lit by the pipeline's lights, which know no glow
        for (Particle& particle : cloud.particles) particle.color = particle.glow;
        BakedCloud baked = bake(cloud, Daylight{.sun = Vec3(0.0f), .sky = Vec3(1.0f), .bounce = Vec3(1.0f)});
        for (LitVertex& vertex : baked.lit.vertices.edit()) vertex.occlusion = 1.0f;
        const ColorImage image = execute(frame_of({baked}, kFront)).output;
        for (std::uint32_t pixel : image.pixels) CHECK(difference(pixel, kSkyBlue) <= 3);
        return;
    }
    const ColorImage image = picture(cloud);
    int darkest            = 255;
    for (std::uint32_t pixel : image.pixels) darkest = std::min(darkest, channel(pixel, 0));
    if (cloud.mode == Mode::Black) {
        CHECK(darkest < 0xc0 - 30);
        CHECK(darkest > 0xc0 - 60);
    } else {
        CHECK(darkest >= 0xc0 - 3);
    }
}

TEST_CASE("the order-free composite keeps the rim off what is nearer, and on what is behind", "[cloud]") {
    Cloud cloud = glowing(Vec3(1.0f));
    cloud.order = Order::OrderFree;
    // 0.9915 lies 59 m ahead, the cloud's front 150 m.
    const Stage near{.wall_x = 160, .wall_depth = 0.9915f};
    const auto left_half_unlike_wall = [&](const ColorImage& image) {
        std::size_t count = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < near.wall_x; ++x)
                count += difference(image.pixels[static_cast<std::size_t>(y * image.width + x)], near.wall) > 0;
        return count;
    };
    CHECK(left_half_unlike_wall(picture(cloud, kFront, near)) == 0);
    Cloud in_order = cloud;
    in_order.order = Order::InOrder;
    CHECK(left_half_unlike_wall(picture(in_order, kFront, near)) > 100);
    // With nothing before it, both are the same picture, but for the rim beyond 2.5 sigma.
    CHECK(greatest_difference(picture(cloud), picture(in_order)) <= 8);
    // From inside the mask is everywhere.
    const View inside = look(Vec3(0.0f, 60.0f, 0.0f), Vec3(2.0f, 60.0f, -300.0f));
    CHECK(pixels_unlike(picture(cloud, inside), 0xffffffff) == 0);
}

TEST_CASE("a second box takes from the rim and leaves what is opaque", "[cloud]") {
    Cloud once            = glowing(Vec3(1.0f));
    Cloud twice           = once;
    twice.second_box_turn = Turn(0.8f, 0.6f);
    const ColorImage a = picture(once), b = picture(twice);
    CHECK(greatest_difference(a, b) > 10);
    const std::size_t middle = static_cast<std::size_t>(b.height / 2 * b.width + b.width / 2);
    CHECK(b.pixels[middle] == a.pixels[middle]);
    CHECK(difference(b.pixels[middle], 0xffffffff) == 0);
    // One blended layer, as before.
    const Frame frame = frame_of({bake(twice, Daylight{})}, kFront);
    int blended       = 0;
    for (const Pass& pass : frame.passes) blended += !(pass.state.blend == kReplace);
    CHECK(blended == 1);
}

TEST_CASE("a box that has turned all the way round is where it was", "[cloud]") {
    Cloud cloud     = cumulus();
    cloud.box_turn  = Turn(1.0f, 0.0f);
    Cloud turned    = cloud;
    turned.box_turn = Turn(0.0f, 1.0f);
    CHECK(greatest_difference(picture(cloud), picture(cloud)) == 0);
    CHECK(greatest_difference(picture(cloud), picture(turned)) > 5);
}

TEST_CASE("dissolving ends with the scene as it was", "[cloud]") {
    Cloud cloud             = cumulus();
    cloud.mode              = GENERATE(Mode::Skirt, Mode::Premultiplied, Mode::Black);
    cloud.detail            = GENERATE(Detail::Fractal, Detail::Displacement, Detail::None);
    const std::size_t whole = pixels_unlike(picture(cloud), kSkyBlue);
    cloud.dissolve          = 1.0f;
    CHECK(pixels_unlike(picture(cloud), kSkyBlue) == 0);
    CHECK(whole > 2000);
}

TEST_CASE("a tinted cloud is drawn in one channel and gets its colour at the end", "[cloud]") {
    Cloud cloud       = cumulus();
    cloud.mode        = GENERATE(Mode::Skirt, Mode::Premultiplied, Mode::Black);
    cloud.tint        = Vec3(1.0f, 0.5f, 0.25f);
    const Frame frame = frame_of({bake(cloud, Daylight{})}, kFront);
    Executor executor;
    Execution execution;
    std::size_t colored = 0, drawn = 0;
    executor.execute(frame, execution, {}, [&](const FinishedPass& pass) {
        if (pass.pass.label.find("alpha 1") == std::string::npos) return;
        const ColorImage image = pass.read_color();
        for (std::uint32_t pixel : image.pixels) {
            drawn += pixel >> 24 == 255;
            colored += pixel >> 24 == 255 &&
                       (channel(pixel, 0) != channel(pixel, 8) || channel(pixel, 0) != channel(pixel, 16));
        }
    });
    CHECK(drawn > 2000);
    CHECK(colored == 0);
    const std::uint32_t middle = execution.output.pixels[static_cast<std::size_t>(
        execution.output.height / 2 * execution.output.width + execution.output.width / 2)];
    CHECK(channel(middle, 16) == Approx(2 * channel(middle, 8)).margin(2));
    CHECK(channel(middle, 16) == Approx(4 * channel(middle, 0)).margin(4));
}

TEST_CASE("inner lights and glow have known answers", "[cloud]") {
    Cloud cloud;
    cloud.lights = {{.center = Vec3(0.0f, 0.0f, 0.0f), .color = Vec3(2.0f, 1.0f, 0.5f), .range = 10.0f}};
    const Particle particle{.color = Vec3(0.5f), .glow = Vec3(0.125f)};
    const LitVertex facing{.position = Vec3(5.0f, 0.0f, 0.0f), .normal = Vec3(-1.0f, 0.0f, 0.0f), .light = Vec3(0.25f)};
    // (1 - 1/4)^2 (0.7 + 0.3) = 0.5625
    CHECK(color_of(cloud, particle, facing).x == Approx(0.5 * (0.25 + 2.0 * 0.5625) + 0.125));
    CHECK(color_of(cloud, particle, facing).z == Approx(0.5 * (0.25 + 0.5 * 0.5625) + 0.125));
    LitVertex away = facing;
    away.normal    = Vec3(1.0f, 0.0f, 0.0f);
    CHECK(color_of(cloud, particle, away).x == Approx(0.5 * (0.25 + 2.0 * 0.5625 * 0.4) + 0.125));
    LitVertex far = facing;
    far.position  = Vec3(10.0f, 0.0f, 0.0f);
    CHECK(color_of(cloud, particle, far).x == Approx(0.5 * 0.25 + 0.125));
}

TEST_CASE("a ball given as a stretched one is lit as the ball it is", "[cloud]") {
    Cloud balls, stretched;
    for (const Vec3 center : {Vec3(0.0f), Vec3(6.0f, 3.0f, 1.0f), Vec3(-5.0f, 4.0f, -2.0f)}) {
        balls.particles.push_back(ball(center, 4.0f));
        Particle half = ball(center, 2.0f);
        half.shape    = Mat3(2.0f);
        stretched.particles.push_back(half);
    }
    balls.absorption     = 1.0f;
    stretched.absorption = 0.5f;  // it counts in radii of the largest particle
    const LitParticles a = light_particles(balls, Daylight{}), b = light_particles(stretched, Daylight{});
    REQUIRE(a.vertices.size() == b.vertices.size());
    float shadow = 1.0f;
    for (std::size_t i = 0; i < a.vertices.size(); ++i) {
        CHECK(glm::length(a.vertices[i].position - b.vertices[i].position) < 1e-4f);
        // Where a surface dives into another is told in radii, which differ; the sun's share does not.
        CHECK(a.vertices[i].light.x == Approx(b.vertices[i].light.x).margin(0.06));
        shadow = std::min(shadow, a.vertices[i].light.x);
    }
    CHECK(shadow < 0.4f);
    CHECK(greatest_radius(stretched.particles[0]) == 4.0f);
}

TEST_CASE("a flat particle casts a thin shadow from above and a long one from the side", "[cloud]") {
    Cloud cloud;
    cloud.lumpiness          = 0.0f;
    cloud.particles          = {ball(Vec3(0.0f), 4.0f), ball(Vec3(0.0f, -12.0f, 0.0f), 1.0f),
                                ball(Vec3(-16.0f, 0.0f, 0.0f), 1.0f)};
    cloud.particles[0].shape = Mat3(2.0f, 0, 0, 0, 0.25f, 0, 0, 0, 2.0f);
    // Of the vertex that faces the sun.
    const auto lit_share     = [&](std::size_t particle, Vec3 to_sun) {
        const Daylight light{.to_sun = to_sun, .sun = Vec3(0.5f), .sky = Vec3(0.0f), .bounce = Vec3(0.0f)};
        const std::vector<LitVertex> lit = light_particles(cloud, light).vertices.all();
        const std::size_t count          = lit.size() / cloud.particles.size();
        const auto first                 = lit.begin() + static_cast<std::ptrdiff_t>(particle * count);
        return std::max_element(first, first + static_cast<std::ptrdiff_t>(count),
                                    [&](const LitVertex& a, const LitVertex& b) {
                                    return glm::dot(a.normal, to_sun) < glm::dot(b.normal, to_sun);
                                })
            ->light.x;
    };
    const float below = lit_share(1, Vec3(0.0f, 1.0f, 0.0f)), beside = lit_share(2, Vec3(1.0f, 0.0f, 0.0f));
    // 0.85 exp(-2.14 chord / 8), chords of 2 and 16 m, and 0.15 of the floor.
    CHECK(below == Approx(0.5 * (0.85 * 0.5857 + 0.15)).margin(0.01));
    CHECK(beside == Approx(0.5 * (0.85 * 0.0138 + 0.15)).margin(0.01));
}

TEST_CASE("what a ray looks at: a surface, or the point nearest to one", "[cloud]") {
    std::vector<Particle> particles{ball(Vec3(0.0f, 0.0f, -10.0f), 2.0f), ball(Vec3(0.0f, 0.0f, -20.0f), 4.0f)};
    CHECK(point_looked_at(particles, Vec3(0.0f), Vec3(0.0f, 0.0f, -1.0f)).z == Approx(-8.0f));
    CHECK(point_looked_at(particles, Vec3(0.0f, 3.0f, 0.0f), Vec3(0.0f, 0.0f, -1.0f)).z ==
          Approx(-20.0 + std::sqrt(7.0)));
    CHECK(point_looked_at(particles, Vec3(0.0f, 4.5f, 0.0f), Vec3(0.0f, 0.0f, -1.0f)).z == Approx(-20.0f));
    particles[0].shape = Mat3(1.0f, 0, 0, 0, 1.0f, 0, 0, 0, 2.0f);
    CHECK(point_looked_at(particles, Vec3(0.0f), Vec3(0.0f, 0.0f, -1.0f)).z == Approx(-6.0f));
}

TEST_CASE("displacement moves alpha alone, and stays away at 0", "[cloud]") {
    Cloud still            = glowing(Vec3(1.0f));
    still.detail           = Detail::None;
    Cloud displaced        = still;
    displaced.detail       = Detail::Displacement;
    displaced.displacement = 0.0f;
    CHECK(greatest_difference(picture(still), picture(displaced)) <= 1);
    displaced.displacement = 1.5f;
    CHECK(greatest_difference(picture(still), picture(displaced)) > 30);
    // White on black: every pixel is a grey, whatever the displacement.
    for (std::uint32_t pixel : picture(displaced, kFront, {.sky = 0xff000000}).pixels)
        CHECK((channel(pixel, 0) == channel(pixel, 8) && channel(pixel, 0) == channel(pixel, 16)));
}

TEST_CASE("inside a particle no pixel of the scene is seen, and coming in is gradual", "[cloud]") {
    Cloud cloud               = glowing(Vec3(0.5f, 0.25f, 1.0f));
    cloud.order               = GENERATE(Order::InOrder, Order::OrderFree);
    const std::uint32_t color = 0xff8040ff;
    // A core ends at z = 18; the picture fills with its colour from some metres before.
    const auto shown          = [&](float z) {
        return pixels_unlike(picture(cloud, look(Vec3(0.0f, 60.0f, z), Vec3(0.0f, 60.0f, -300.0f), 160, 90)), color);
    };
    CHECK(shown(10.0f) == 0);
    CHECK(shown(0.0f) == 0);
    CHECK(shown(170.0f) > 10000);
}

TEST_CASE("clouds that reach into each other become one", "[cloud]") {
    const auto at = [](float x, float blur) {
        Cloud cloud     = glowing(Vec3(1.0f));
        cloud.particles = {ball(Vec3(x, 60.0f, 0.0f), 10.0f)};
        cloud.blur_m    = blur;
        return bake(cloud, Daylight{});
    };
    CHECK(merge_touching({at(0, 1), at(15, 1), at(60, 1)}).size() == 2);
    CHECK(merge_touching({at(0, 1), at(30, 1), at(15, 1)}).size() == 1);  // the third joins the others
    CHECK(merge_touching({at(0, 1), at(15, 2)}).size() == 2);             // drawn differently: layers
    const std::vector<BakedCloud> merged = merge_touching({at(0, 1), at(15, 1)});
    CHECK(merged[0].cloud.particles.size() == 2);
    const BakedCloud left = at(0, 1), right = at(15, 1);
    const std::size_t count = left.lit.vertices.size();
    CHECK(merged[0].lit.vertices.size() == 2 * count);
    // In the order of their places; copies of them are theirs.
    for (const std::size_t i : {std::size_t{0}, std::size_t{5}, count - 1}) {
        CHECK(merged[0].lit.vertices[i].position == left.lit.vertices[i].position);
        CHECK(merged[0].lit.vertices[count + i].position == right.lit.vertices[i].position);
        CHECK(merged[0].lit.vertices.all()[count + i].position == right.lit.vertices[i].position);
    }
    CHECK(merged[0].lit.high.x > 24.0f);
    // The one with the most particles leads, whatever the order.
    BakedCloud small = at(0, 1), large = at(15, 1);
    small.cloud.name = std::string(1, 'a'), large.cloud.name = std::string(1, 'b');
    large.cloud.particles.push_back(ball(Vec3(20.0f, 60.0f, 0.0f), 10.0f));
    large                = bake(large.cloud, Daylight{});
    const ColorImage one = execute(frame_of(merge_touching({small, large}), kFront)).output;
    CHECK(merge_touching({small, large})[0].cloud.name == "b");
    CHECK(greatest_difference(one, execute(frame_of(merge_touching({large, small}), kFront)).output) == 0);
}
