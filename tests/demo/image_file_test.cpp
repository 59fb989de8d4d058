// SPDX-License-Identifier: MIT
// Image files: every kind of sample is read to the exact byte, what is written reads back, and bad files have their
// reason.
#include "demo/image_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "tests/support/child_process.h"
#include "tests/support/png_bytes.h"

namespace {

using demo::Channels;
using pipeline::ColorImage;
using tests::png_bytes;
using tests::ScratchDirectory;
using namespace std::string_literals;

// A file's text as what read_image makes of it.
ColorImage read_bytes(const std::string& bytes) {
    const ScratchDirectory directory;
    tests::write_file(directory / "image.png", bytes);
    return demo::read_image(directory / "image.png");
}

std::vector<std::uint32_t> pixels_of(const std::string& bytes) {
    return read_bytes(bytes).pixels;
}

using Pixels = std::vector<std::uint32_t>;

std::string reason_of(const std::string& path) {
    try {
        demo::read_image(path);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

// Colours under every alpha, 0 as well: straight alpha keeps them all.
ColorImage all_alphas() {
    ColorImage image{.width = 256, .height = 2, .pixels = {}};
    for (std::uint32_t i = 0; i < 512; ++i)
        image.pixels.push_back(i % 256 << 24 | (0x10345a + i * 0x0b0703) % 0xffffff);
    return image;
}

}  // namespace

TEST_CASE("every kind of PNG is read", "[image]") {
    CHECK(pixels_of(png_bytes(3, 1, {0, 8}, {"\x00\x7f\xff"s})) == Pixels{0xff000000, 0xff7f7f7f, 0xffffffff});
    CHECK(pixels_of(png_bytes(2, 2, {2, 8}, {"\x01\x02\x03\xff\xfe\xfd"s, "\x04\x05\x06\x07\x08\x09"s})) ==
          Pixels{0xff010203, 0xfffffefd, 0xff040506, 0xff070809});
    CHECK(pixels_of(png_bytes(2, 1, {4, 8}, {"\x40\x80\x50\x00"s})) == Pixels{0x80404040, 0x00505050});
    CHECK(pixels_of(png_bytes(2, 1, {6, 8}, {"\x01\x02\x03\x04\xff\x80\x40\x00"s})) == Pixels{0x04010203, 0x00ff8040});
    CHECK(pixels_of(png_bytes(3, 1, {3, 8}, {"\x01\x00\x01"s}, "\x0a\x0b\x0c\xf0\xf1\xf2"s)) ==
          Pixels{0xfff0f1f2, 0xff0a0b0c, 0xfff0f1f2});
    CHECK(pixels_of(png_bytes(2, 1, {3, 8}, {"\x01\x00"s}, "\x0a\x0b\x0c\xf0\xf1\xf2"s, "\x20\x90"s)) ==
          Pixels{0x90f0f1f2, 0x200a0b0c});
    CHECK(pixels_of(png_bytes(8, 1, {0, 1}, {"\xa5"s})) ==
          Pixels{0xffffffff, 0xff000000, 0xffffffff, 0xff000000, 0xff000000, 0xffffffff, 0xff000000, 0xffffffff});
    // 16 bits go to the nearest byte: 128.5 of 257 is a half that no word reaches.
    CHECK(pixels_of(png_bytes(4, 1, {0, 16}, {"\x00\x80\x00\x81\xff\x7e\xff\x7f"s})) ==
          Pixels{0xff000000, 0xff010101, 0xfffefefe, 0xffffffff});
}

TEST_CASE("all words of 16 bits become the nearest byte", "[image]") {
    std::vector<std::string> rows(256);
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 256; ++x) {
            rows[static_cast<std::size_t>(y)] += static_cast<char>(y);
            rows[static_cast<std::size_t>(y)] += static_cast<char>(x);
        }
    }
    // A stored block holds 65535 bytes: two halves of the picture.
    for (const std::size_t half : {0, 128}) {
        for (std::size_t part = half; part < half + 128; part += 64) {
            const std::vector<std::string> some(rows.begin() + static_cast<std::ptrdiff_t>(part),
                                                rows.begin() + static_cast<std::ptrdiff_t>(part) + 64);
            const Pixels pixels = pixels_of(png_bytes(256, 64, {0, 16}, some));
            REQUIRE(pixels.size() == 256 * 64);
            std::size_t wrong = 0;
            for (std::size_t i = 0; i < pixels.size(); ++i) {
                const std::uint64_t word = part * 256 + i;
                wrong += (pixels[i] & 255) != (word * 255 * 2 + 65535) / (65535 * 2);
            }
            CHECK(wrong == 0);
        }
    }
}

TEST_CASE("a height map keeps the precision of its file", "[image]") {
    const ScratchDirectory directory;
    tests::write_file(directory / "words.png", png_bytes(2, 1, {0, 16}, {"\x12\x34\xff\xff"s}));
    const demo::HeightMap words = demo::read_height_map(directory / "words.png");
    CHECK(words.width == 2);
    CHECK(words.height == 1);
    CHECK(words.heights == std::vector<float>{0x1234 / 65535.0f, 1.0f});

    // Portable float map: little-endian floats, rows from the bottom.
    const auto float_map = [&](float value) {
        std::string file = "Pf\n1 1\n-1.0\n";
        file.append(reinterpret_cast<const char*>(&value), sizeof value);
        tests::write_file(directory / "floats.pfm", file);
        return demo::read_height_map(directory / "floats.pfm");
    };
    CHECK(float_map(0.123456789f).heights == std::vector<float>{0.123456789f});
    CHECK_THROWS_WITH(float_map(1.5f), Catch::Contains("floats.pfm: heights must lie in 0..1 (pixel 0, 0 is 1.5"));
    CHECK_THROWS_WITH(float_map(-0.25f), Catch::Contains("heights must lie in 0..1"));
    CHECK_THROWS_WITH(float_map(std::numeric_limits<float>::quiet_NaN()), Catch::Contains("heights must lie in 0..1"));
}

TEST_CASE("what is written reads back, alpha straight", "[image]") {
    const std::string name = GENERATE("a.png", "a.tga", "a.tif", "a.bmp", "A.PNG");
    const ScratchDirectory directory;
    const ColorImage image = all_alphas();
    demo::write_image(directory / name, image, Channels::Rgba);
    CHECK(demo::read_image(directory / name) == image);

    ColorImage opaque = image;
    for (std::uint32_t& pixel : opaque.pixels) pixel |= 0xff000000;
    demo::write_image(directory / name, image, Channels::Rgb);
    CHECK(demo::read_image(directory / name) == opaque);
    CHECK(directory.files() == std::vector<std::string>{name});
}

TEST_CASE("OpenEXR holds colour times alpha, and gives it back as it was", "[image]") {
    const ScratchDirectory directory;
    ColorImage image{.width = 3, .height = 1, .pixels = {0x80c86432, 0xff010203, 0x40ff8000}};
    demo::write_image(directory / "a.exr", image, Channels::Rgba);
    CHECK(demo::read_image(directory / "a.exr") == image);
}

TEST_CASE("the same picture makes the same PNG", "[image]") {
    const ScratchDirectory directory;
    demo::write_image(directory / "a.png", all_alphas(), Channels::Rgba);
    demo::write_image(directory / "b.png", all_alphas(), Channels::Rgba);
    CHECK(tests::read_file(directory / "a.png") == tests::read_file(directory / "b.png"));
}

TEST_CASE("a file that is no image has its reason in one line", "[image]") {
    const ScratchDirectory directory;
    CHECK_THAT(reason_of(directory / "none.png"), Catch::EndsWith("none.png: no such file"));
    CHECK_THAT(reason_of(directory.path()), Catch::EndsWith(": is a directory"));
    CHECK_THAT(reason_of("/dev/zero"), Catch::EndsWith("/dev/zero: is not a regular file"));
    const std::string whole = png_bytes(64, 64, {0, 8}, std::vector<std::string>(64, std::string(64, 'x')));
    const std::string bytes = GENERATE_COPY(""s, "some text\n"s, std::string(1000, '\0'), whole.substr(0, 20));
    tests::write_file(directory / "bad.png", bytes);
    const std::string reason = reason_of(directory / "bad.png");
    CHECK_THAT(reason, Catch::StartsWith(directory / "bad.png: "));
    CHECK(reason.find('\n') == std::string::npos);
}

TEST_CASE("an image too large is refused by its header alone", "[image]") {
    const ScratchDirectory directory;
    const auto [width, height] = GENERATE(std::pair(16385, 1), std::pair(1, 16385), std::pair(16384, 16384));
    tests::write_file(directory / "large.png", png_bytes(width, height, {0, 8}, {}));
    CHECK_THAT(reason_of(directory / "large.png"), Catch::Contains("large.png: the image is too large: "));
}

TEST_CASE("an image file keeps what it replaces in place", "[image]") {
    const ScratchDirectory directory;
    const ColorImage image{.width = 1, .height = 1, .pixels = {0xff123456}};
    tests::write_file(directory / "real.png", "older");
    REQUIRE(chmod((directory / "real.png").c_str(), 0640) == 0);
    REQUIRE(symlink("real.png", (directory / "link.png").c_str()) == 0);
    demo::write_image(directory / "link.png", image, Channels::Rgb);
    CHECK(demo::read_image(directory / "real.png") == image);
    struct stat status {};
    REQUIRE(lstat((directory / "link.png").c_str(), &status) == 0);
    CHECK(S_ISLNK(status.st_mode));
    REQUIRE(stat((directory / "real.png").c_str(), &status) == 0);
    CHECK((status.st_mode & 0777) == 0640);

    CHECK_THROWS_WITH(demo::write_image(directory / "real.unknown", image, Channels::Rgb),
                      Catch::Contains("extension '.unknown'"));
    CHECK_THROWS_WITH(demo::write_image(directory / "a.png", {}, Channels::Rgb), Catch::Contains("image of 0x0"));
    CHECK(directory.files() == std::vector<std::string>{"link.png", "real.png"});
}
