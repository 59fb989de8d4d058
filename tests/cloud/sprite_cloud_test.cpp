// SPDX-License-Identifier: MIT
#include "cloud/baselines/sprite_cloud.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "cloud/baselines/soft_disc.h"
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

AppendClouds sprites_of(std::vector<BakedCloud> clouds, SpriteOptions options = {}) {
    return [clouds = std::move(clouds), options](Frame& frame, const SceneTargets& scene, const View& view) {
        append_sprite_clouds(frame, scene, view, clouds, options);
    };
}

void mega_particles(Frame& frame, const SceneTargets& scene, const View& view) {
    append_mega_particles(frame, scene, view, std::span(&baked_cumulus(), 1));
}

Frame sprite_frame(const std::vector<BakedCloud>& clouds, const View& view, float depth = 1.0f) {
    return plain_scene(sprites_of(clouds), view, {0xff4060ff}, depth);
}

BakedCloud moved(float z, const std::string& name) {
    Cloud cloud = cumulus();
    cloud.name  = name;
    for (Particle& particle : cloud.particles) particle.center.z += z;
    return bake(cloud, Daylight{});
}

}  // namespace

TEST_CASE("sprites: frames are valid, from far away, near, inside, translucent", "[sprites]") {
    std::vector<BakedCloud> clouds{baked_cumulus(), moved(-150.0f, "behind")};
    clouds[1].cloud.opacity = 0.5f;
    const float z           = GENERATE(5000.0f, 170.0f, 45.0f, 18.5f, 0.0f);
    const Frame frame       = sprite_frame(clouds, look(Vec3(0.0f, 60.0f, z), Vec3(2.0f, 60.0f, -300.0f), 333, 211));
    REQUIRE(frame.passes.size() == 3);
    CHECK(frame.textures.size() == 1);
    for (const Finding& finding : validate(frame)) FAIL_CHECK(finding.where + ": " + finding.what);
}

TEST_CASE("sprites: the state of 2000", "[sprites]") {
    SceneTargets scene{
        .back_buffer = {0}, .depth = {1}, .camera = {0}, .fog = {.mode = FogMode::Linear, .end = 500.0f}};
    Frame frame;
    append_sprite_clouds(frame, scene, kFront, std::span(&baked_cumulus(), 1));
    REQUIRE(frame.passes.size() == 1);
    const Pass& pass = frame.passes[0];
    CHECK(pass.label == "cumulus: sprites, back to front");
    CHECK(pass.color == scene.back_buffer);
    CHECK(pass.depth == scene.depth);
    CHECK(pass.camera == scene.camera);
    CHECK(pass.state.blend == kAlphaOver);
    CHECK(pass.state.depth == DepthState{CompareFunc::LessEqual, false});
    CHECK(pass.state.fog == scene.fog);
    CHECK(frame.vertices.size() == 800);
    CHECK(frame.textures[0].format == TextureFormat::A8);
}

TEST_CASE("sprites: quads face the camera and lie back to front", "[sprites]") {
    const View view   = look(Vec3(120.0f, 90.0f, 70.0f), Vec3(0.0f, 55.0f, 0.0f));
    const Frame frame = sprite_frame({baked_cumulus()}, view);
    float last        = std::numeric_limits<float>::infinity();
    REQUIRE(frame.vertices.size() % 4 == 0);
    for (std::size_t quad = 0; quad < frame.vertices.size(); quad += 4) {
        float ahead[4];
        for (std::size_t corner = 0; corner < 4; ++corner)
            ahead[corner] = -(view.view * Vec4(frame.vertices[quad + corner].position, 1.0f)).z;
        for (const float each : ahead) CHECK(each == Approx(ahead[0]).margin(1e-3));
        CHECK(ahead[0] <= last + 1e-3f);
        last = ahead[0];
    }
}

TEST_CASE("sprites: puffs keep to their particles, above the base, with their light and glow", "[sprites]") {
    const SpriteCloud made = make_sprites(baked_cumulus(), {.count = 300, .opacity = 0.5f});
    REQUIRE(made.sprites.size() == 300);
    double mean = 0.0;
    for (const Sprite& sprite : made.sprites) {
        const float core = sprite.radius * kSoftDiscCore;
        CHECK(sprite.alpha == 0.5f);
        CHECK(sprite.center.y - core >= made.cloud.base_y - 0.1f * core);
        CHECK(sprite.cosine * sprite.cosine + sprite.sine * sprite.sine == Approx(1.0));
        const bool is_in_cloud = std::any_of(
            made.cloud.particles.begin(), made.cloud.particles.end(),
            [&](const Particle& particle) { return glm::length(sprite.center - particle.center) < particle.radius; });
        CHECK(is_in_cloud);
        mean += sprite.color.y / 300.0;
    }
    // Particles are white. The outside of a cloud is lighter than all of it, most of which lies in other particles.
    CHECK(mean > baked_cumulus().lit.mean_color.y);
    CHECK(mean < 0.95);

    BakedCloud glowing = baked_cumulus();
    for (Particle& particle : glowing.cloud.particles) particle.glow = Vec3(0.25f, 0.0f, 0.0f);
    const SpriteCloud with_glow = make_sprites(glowing, {.count = 300, .opacity = 0.5f});
    for (std::size_t i = 0; i < 300; ++i) {
        CHECK(with_glow.sprites[i].color.x == made.sprites[i].color.x + 0.25f);
        CHECK(with_glow.sprites[i].color.z == made.sprites[i].color.z);
    }
}

TEST_CASE("sprites: puffs are turned apart, and the disc is soft to its border", "[sprites]") {
    const std::vector<std::uint8_t>& disc = soft_disc_texels();
    REQUIRE(disc.size() == std::size_t{kSoftDiscSize} * kSoftDiscSize);
    double core = 0.0;
    for (std::size_t i = 0; i < disc.size(); ++i) {
        const std::size_t row = i / kSoftDiscSize, column = i % kSoftDiscSize;
        const bool is_border = std::min(row, column) == 0 || std::max(row, column) == kSoftDiscSize - 1;
        if (is_border) CHECK(disc[i] == 0);
        core += disc[i] >= 128;
    }
    CHECK(disc[disc.size() / 2 + kSoftDiscSize / 2] > 240);
    CHECK(core / static_cast<double>(disc.size()) == Approx(0.785398 * kSoftDiscCore * kSoftDiscCore).epsilon(0.15));
}

TEST_CASE("sprites: they cover what mega-particles cover, opaque in the middle, hidden by what is nearer",
          "[sprites]") {
    const AppendClouds sprites       = sprites_of({baked_cumulus()});
    const Vec3 eye                   = GENERATE(Vec3(0.0f, 58.0f, 170.0f), Vec3(150.0f, 80.0f, -60.0f));
    const View view                  = look(eye, Vec3(0.0f, 60.0f, 0.0f), 160, 120);
    const std::vector<float> covered = coverage(sprites, view), mega = coverage(mega_particles, view);
    CHECK(overlap(covered, mega) > 0.75);
    CHECK(covered[60 * 160 + 80] > 0.97f);
    CHECK(covered[5 * 160 + 5] == 0.0f);
    CHECK(execute(plain_scene(sprites, view, {0xff4060ff}, 0.9f)).output.pixels ==
          std::vector<std::uint32_t>(std::size_t{160} * 120, 0xff4060ffu));
}

TEST_CASE("sprites: every pixel of the cloud is blended many times over", "[sprites]") {
    const std::uint64_t mega    = blended_pixels(plain_scene(mega_particles, kFront, {0xff4060ff}));
    const std::uint64_t sprites = blended_pixels(sprite_frame({baked_cumulus()}, kFront));
    INFO(sprites << " of sprites, " << mega << " of mega-particles");
    CHECK(sprites > 5 * mega);
    // Twice as many take about twice as much.
    const std::uint64_t twice =
        blended_pixels(plain_scene(sprites_of({baked_cumulus()}, {.count = 400}), kFront, {0xff4060ff}));
    CHECK(static_cast<double>(twice) / static_cast<double>(sprites) == Approx(2.0).epsilon(0.1));
}

TEST_CASE("sprites: the same bytes with any number of threads, by the reference, and in any order of clouds",
          "[sprites]") {
    std::vector<BakedCloud> clouds{baked_cumulus(), moved(-60.0f, "behind"), moved(40.0f, "before")};
    const Frame frame        = sprite_frame(clouds, kFront);
    const ColorImage picture = execute(frame, {.threads = 1}).output;
    for (const int threads : {2, 5})
        CHECK(execute(frame, {.threads = threads, .tile_order_seed = 3}).output == picture);
    CHECK(execute(frame, {.backend = Backend::Reference}).output == picture);
    std::swap(clouds[0], clouds[2]);
    CHECK(execute(sprite_frame(clouds, kFront)).output == picture);
}

TEST_CASE("sprites: what is out of view, clear or empty gives no pass", "[sprites]") {
    const auto passes = [](const BakedCloud& baked, const View& view) {
        return sprite_frame({baked}, view).passes.size();
    };
    CHECK(passes(baked_cumulus(), kFront) == 2);
    CHECK(passes(baked_cumulus(), look(Vec3(0.0f, 58.0f, 170.0f), Vec3(0.0f, 60.0f, 300.0f))) == 1);
    CHECK(passes(baked_cumulus(), look(Vec3(0.0f, 58.0f, 170.0f), Vec3(300.0f, 60.0f, 0.0f))) == 1);
    CHECK(passes(bake(Cloud{}, Daylight{}), kFront) == 1);
    BakedCloud clear    = baked_cumulus();
    clear.cloud.opacity = 0.0f;
    CHECK(passes(clear, kFront) == 1);
}

TEST_CASE("sprites: a puff fades before the near plane cuts it", "[sprites]") {
    const Vec3 place  = make_sprites(baked_cumulus()).sprites[17].center;
    const View view   = look(place + Vec3(0.0f, 0.0f, 3.0f), place);
    const Frame frame = sprite_frame({baked_cumulus()}, view);
    int fading        = 0;
    for (std::size_t quad = 0; quad < frame.vertices.size(); quad += 4) {
        const Vertex &corner = frame.vertices[quad], &opposite = frame.vertices[quad + 2];
        const float radius   = glm::length(corner.position - opposite.position) / 2.8284271f;
        const float ahead    = -(view.view * Vec4(corner.position, 1.0f)).z - view.near_m;
        const float expected = 0.85f * std::clamp(ahead / radius, 0.0f, 1.0f) * 255.0f;
        CHECK(static_cast<float>(corner.diffuse.value >> 24) == Approx(expected).margin(0.6));
        fading += ahead < radius;
    }
    CHECK(fading > 0);
}

TEST_CASE("sprites: options that make no sense are refused", "[sprites]") {
    const SpriteOptions options =
        GENERATE(SpriteOptions{.count = 0}, SpriteOptions{.count = -3}, SpriteOptions{.count = 100'001},
                 SpriteOptions{.opacity = 1.5f}, SpriteOptions{.opacity = std::numeric_limits<float>::quiet_NaN()});
    CHECK_THROWS_AS(make_sprites(baked_cumulus(), options), std::invalid_argument);
}
