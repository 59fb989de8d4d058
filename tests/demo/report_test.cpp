// SPDX-License-Identifier: MIT
// Arguments, tables and the contact sheet: what the render command is put together from.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "demo/arguments.h"
#include "demo/contact_sheet.h"
#include "demo/label_font.h"
#include "demo/pass_pictures.h"
#include "demo/pass_statistics.h"

namespace {

using demo::numbered_path;
using pipeline::ColorImage;

ColorImage plain(int width, int height, std::uint32_t color) {
    return {.width  = width,
            .height = height,
            .pixels = std::vector<std::uint32_t>(static_cast<std::size_t>(width * height), color)};
}

std::size_t count_pixels(const ColorImage& image, std::uint32_t color) {
    return static_cast<std::size_t>(std::count(image.pixels.begin(), image.pixels.end(), color));
}

}  // namespace

TEST_CASE("a frame's number takes the place of the last run of #", "[arguments]") {
    CHECK(numbered_path("f.####.png", 7) == "f.0007.png");
    CHECK(numbered_path("f.#.png", 123) == "f.123.png");
    CHECK(numbered_path("f.##.png", 123) == "f.123.png");
    CHECK(numbered_path("a##b###", 5) == "a##b005");
    CHECK(numbered_path("dir.##/f.png", 5) == "dir.##/f.png");
    CHECK(numbered_path("f.png", 5) == "f.png");
    CHECK(demo::has_frame_number("d/f.#"));
    CHECK_FALSE(demo::has_frame_number("d#/f"));
}

TEST_CASE("sizes and ranges are read", "[arguments]") {
    CHECK(demo::parse_size("8192x1").width == 8192);
    CHECK(demo::parse_size("8192x1").height == 1);
    CHECK(demo::parse_frames("3-17") == demo::FrameRange{3, 17});
    CHECK(demo::parse_frames("5") == demo::FrameRange{5, 5});
    CHECK_THROWS_WITH(demo::parse_size("0x0"), Catch::StartsWith("--size 0x0: "));
    CHECK_THROWS_WITH(demo::parse_frames("5-3"), Catch::StartsWith("--frames 5-3: "));
    CHECK_THROWS_WITH(demo::parse_number("--threads", "1e3", 0, 9), Catch::StartsWith("--threads 1e3: "));
}

TEST_CASE("a label becomes a plain file name", "[arguments]") {
    CHECK(demo::file_name_of("blur_2.x-y") == "blur_2.x-y");
    CHECK(demo::file_name_of("../../etc passwd") == "..-..-etc-passwd");
    CHECK(demo::file_name_of("a \t/ b") == "a-b");
}

TEST_CASE("the table of passes lines up and sums", "[statistics]") {
    const std::vector<demo::PassStatistics> passes = {
        {"sky", {.covered = 1234567, .bytes = 8}, {.special = 1234560, .general = 7}, 1.5},
        {"a longer label", {.covered = 33, .texels = 1000}, {}, 0.25},
    };
    CHECK(
        demo::to_table(passes) ==
        "   pass            triangles  rects    covered  z-tested  z-passed  written  blended  texels  bytes  general    ms\n"
        "0  sky                     0      0  1,234,567         0         0        0        0       0      8        7  1.50\n"
        "1  a longer label          0      0         33         0         0        0        0   1,000      0        0  0.25\n"
        "   total                   0      0  1,234,600         0         0        0        0   1,000      8        7  1.75\n");
}

TEST_CASE("the JSON of a pass has its counts by name", "[statistics]") {
    const nlohmann::ordered_json object =
        demo::to_json({"sky", {.depth_written = 5, .color_written = 6}, {.special = 7, .general = 8}, 1.5});
    CHECK(object["label"] == "sky");
    CHECK(object["depth_written"] == 5);
    CHECK(object["color_written"] == 6);
    CHECK(object["milliseconds"] == 1.5);
    CHECK(object["special_kernel"] == 7);
    CHECK(object["general_kernel"] == 8);
    CHECK(object.size() == 18);
}

TEST_CASE("every printable character has a glyph of its own", "[contact sheet]") {
    std::set<std::vector<std::uint32_t>> seen;
    for (char c = ' '; c <= '~'; ++c) {
        ColorImage image = plain(demo::kGlyphAdvance, demo::kGlyphHeight, 0);
        demo::draw_label(image, std::string(1, c), 0, 0, 1);
        INFO(c);
        CHECK(seen.insert(image.pixels).second);
        CHECK((count_pixels(image, 1) == 0) == (c == ' '));
        for (int y = 0; y < image.height; ++y) {
            CHECK(image.pixels[static_cast<std::size_t>(y * image.width + demo::kGlyphWidth)] == 0);
        }
    }
    ColorImage other = plain(5, 7, 0), question = plain(5, 7, 0);
    demo::draw_label(other, "\x80", 0, 0, 1);
    demo::draw_label(question, "?", 0, 0, 1);
    CHECK(other == question);
}

TEST_CASE("a label outside its picture is cut off", "[contact sheet]") {
    ColorImage image = plain(4, 4, 0);
    demo::draw_label(image, "HHH", -7, -2, 1);
    demo::draw_label(image, "H", 100, 100, 1);
    CHECK(count_pixels(image, 1) > 0);
}

TEST_CASE("the contact sheet shows each pass whole", "[contact sheet]") {
    constexpr std::uint32_t kRed = 0xffff0000, kGrey = 0xff808080;
    demo::ContactSheet sheet;
    // Larger than its place, smaller, thin, and depth alone.
    sheet.add("large", plain(1000, 500, kRed), plain(1000, 500, kGrey));
    const ColorImage one = sheet.draw();
    CHECK(count_pixels(one, kRed) == count_pixels(one, kGrey));
    CHECK(count_pixels(one, kRed) == 208 * 104);
    sheet.add("small", plain(50, 30, 0x12ff0000), plain(50, 30, kGrey));
    const ColorImage two = sheet.draw();
    CHECK(count_pixels(two, kRed) == 208 * 104 + 200 * 120);
    sheet.add("thin", plain(5000, 1, kRed), plain(5000, 1, kGrey));
    sheet.add("depth", {}, {});
    const ColorImage four = sheet.draw();
    CHECK(count_pixels(four, kRed) == 208 * 104 + 200 * 120 + 208);
    CHECK(four.width > one.width);
    for (const std::uint32_t pixel : four.pixels) REQUIRE(pixel >> 24 == 255);

    // Averages are exact: columns of 0 and 3 give 1.5, a half, which goes up.
    ColorImage stripes = plain(416, 2, 0xff000000);
    for (std::size_t i = 0; i < stripes.pixels.size(); i += 2) stripes.pixels[i] = 0xff000003;
    demo::ContactSheet averages;
    averages.add("", stripes, {});
    CHECK(count_pixels(averages.draw(), 0xff000002) == 208);
}

TEST_CASE("a contact sheet of very many passes stays a picture", "[contact sheet]") {
    demo::ContactSheet sheet;
    for (int i = 0; i < 1000; ++i) sheet.add("pass", plain(2, 2, 0xffff0000), plain(2, 2, 0xff808080));
    const ColorImage image = sheet.draw();
    CHECK(image.width < 16384);
    CHECK(image.height < 16384);
}
