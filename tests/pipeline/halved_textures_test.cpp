// SPDX-License-Identifier: MIT
#include "pipeline/legalize/halved_textures.h"

#include <catch2/catch.hpp>

#include "pipeline/validate/validate.h"

using namespace pipeline;

namespace {

// Texels are the number of their level if there are several, else what `texel` says of their place.
template <class Texel>
Texture make_texture(TextureFormat format, int width, int height, int levels, Texel&& texel) {
    Texture texture{.name = "t", .format = format, .width = width, .height = height, .levels = levels, .texels = {}};
    for (int level = 0; level < levels; ++level)
        for (int y = 0; y < std::max(1, height >> level); ++y)
            for (int x = 0; x < std::max(1, width >> level); ++x)
                for (int c = 0; c < bytes_per_texel(format); ++c)
                    texture.texels.push_back(static_cast<std::uint8_t>(levels > 1 ? level : texel(x, y, c)));
    return texture;
}
Texture zeros(int width, int height, int levels = 1, TextureFormat format = TextureFormat::A8) {
    return make_texture(format, width, height, levels, [](int, int, int) { return 0; });
}
Texture halved(const Texture& texture, int times = 1) {
    Frame frame;
    frame.textures.push_back(texture);
    frame              = with_halved_textures(frame, times);
    const Texture& out = frame.textures[0];
    CHECK(out.name == texture.name);
    CHECK(out.format == texture.format);
    // Of the frame there is nothing else to find than that it has no output.
    CHECK(validate(frame).size() == validate(Frame{}).size());
    return out;
}
using Size = std::array<int, 3>;
Size size_of(const Texture& texture) {
    return {texture.width, texture.height, texture.levels};
}

}  // namespace

TEST_CASE("halved textures: levels are dropped from the largest on", "[legalize]") {
    const Texture texture = zeros(256, 128, 9, GENERATE(TextureFormat::A8, TextureFormat::A8R8G8B8));
    CHECK(halved(texture, 0) == texture);
    const Texture once = halved(texture);
    CHECK(size_of(once) == Size{128, 64, 8});
    CHECK(once.texels.front() == 1);
    CHECK(once.texels.back() == 8);
    const Texture twice = halved(texture, 2);
    CHECK(size_of(twice) == Size{64, 32, 7});
    CHECK(twice.texels.front() == 2);
    CHECK(halved(texture, 3) == twice);  // no smaller than 64
    CHECK(size_of(halved(zeros(1, 256, 9))) == Size{1, 128, 8});
    // The last level is not dropped; it has 128 texels, and is made smaller as one without levels.
    CHECK(size_of(halved(zeros(256, 256, 2), 2)) == Size{64, 64, 1});
}

TEST_CASE("halved textures: without levels texels are means, rounded half up", "[legalize]") {
    const Texture texture = make_texture(TextureFormat::A8, 128, 2, 1, [](int x, int y, int) {
        constexpr std::array<std::array<int, 8>, 2> kTexels{
            {{0, 1, 0, 2, 255, 255, 10, 20}, {0, 0, 0, 0, 255, 254, 30, 40}}};
        return kTexels[static_cast<std::size_t>(y)][static_cast<std::size_t>(x % 8)];
    });
    const Texture out     = halved(texture);
    CHECK(size_of(out) == Size{64, 1, 1});
    // Sums 1, 2, 1019, 100.
    CHECK(std::vector(out.texels.begin(), out.texels.begin() + 5) == std::vector<std::uint8_t>{0, 1, 255, 25, 0});
}

TEST_CASE("halved textures: each channel by itself", "[legalize]") {
    const Texture texture = make_texture(TextureFormat::A8R8G8B8, 128, 4, 1, [](int x, int y, int c) {
        return c == 0 ? x : c == 1 ? 10 * y : c == 2 ? (x + y) % 2 * 100 : 255;
    });
    const Texture out     = halved(texture);
    CHECK(size_of(out) == Size{64, 2, 1});
    // Columns 2 and 3 are 2.5; rows 2 and 3 are 25.
    const std::size_t at = 4 * (64 + 1);
    CHECK(std::vector(out.texels.begin() + at, out.texels.begin() + at + 4) ==
          std::vector<std::uint8_t>{3, 25, 50, 255});
}

TEST_CASE("halved textures: small ones and odd ones stay", "[legalize]") {
    for (const auto& [width, height] : {std::pair{64, 64}, {64, 1}, {2, 64}, {129, 128}, {128, 65}, {128, 1}}) {
        CAPTURE(width, height);
        const Texture texture = zeros(width, height);
        CHECK(halved(texture, 3) == texture);
    }
    CHECK(size_of(halved(zeros(66, 32), 3)) == Size{33, 16, 1});
    CHECK(size_of(halved(zeros(260, 4), 3)) == Size{65, 1, 1});  // 130x2 and then 65x1, which is odd
}
