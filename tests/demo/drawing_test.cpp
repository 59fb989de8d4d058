// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "demo/drawing.h"

namespace {

using namespace demo;

std::uint32_t at(const pipeline::ColorImage& image, int x, int y) {
    return image.pixels[static_cast<std::size_t>(y * image.width + x)];
}

}  // namespace

TEST_CASE("scales have round ticks", "[drawing]") {
    const DrawingScale linear{0.34, 1.06, 10.0, 82.0};
    CHECK(linear.px(0.34) == Approx(10.0));
    CHECK(linear.px(0.70) == Approx(46.0));
    const std::vector<double> ticks = linear.ticks();
    REQUIRE(ticks.size() == 7);
    CHECK(ticks.front() == Approx(0.4));
    CHECK(ticks.back() == Approx(1.0));
    CHECK(DrawingScale{0.0, 3.1, 0.0, 1.0}.ticks() == std::vector<double>{0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0});
    CHECK(DrawingScale{-0.2, 11.0, 0.0, 1.0}.ticks() == std::vector<double>{0.0, 2.0, 4.0, 6.0, 8.0, 10.0});

    const DrawingScale logarithmic{1.0, 100.0, 0.0, 50.0, true};
    CHECK(logarithmic.px(10.0) == Approx(25.0));
    CHECK(logarithmic.ticks() == std::vector<double>{1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0});
    CHECK(DrawingScale{1.0, 1000.0, 0.0, 1.0, true}.ticks() == std::vector<double>{1.0, 10.0, 100.0, 1000.0});
}

TEST_CASE("a drawing becomes SVG", "[drawing]") {
    Drawing drawing{30.0, 20.0, {}};
    drawing.items.emplace_back(DrawnLine{{{1.0, 2.0}, {3.0, 4.0}}, Ink::Muted, 1.2, true});
    drawing.items.emplace_back(DrawnLine{{{1.0, 2.0}, {3.0, 4.0}, {5.0, 6.0}}, Ink::Accent, 2.0});
    drawing.items.emplace_back(DrawnDot{{7.0, 8.0}});
    drawing.items.emplace_back(
        DrawnWords{{9.0, 10.0}, DrawnWords::Anchor::End, "a < b & \"c\"", 13.0, Ink::Title, true});
    CHECK(to_svg(drawing) ==
          "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 30 20\" "
          "font-family=\"system-ui, 'Segoe UI', 'DejaVu Sans', sans-serif\">\n"
          "<rect width=\"30\" height=\"20\" rx=\"6\" fill=\"#ffffff\"/>\n"
          "<line x1=\"1.0\" y1=\"2.0\" x2=\"3.0\" y2=\"4.0\" stroke=\"#9ca3af\" stroke-width=\"1.2\" "
          "stroke-dasharray=\"4 4\"/>\n"
          "<polyline fill=\"none\" stroke=\"#2563eb\" stroke-width=\"2\" stroke-linejoin=\"round\" "
          "points=\"1.0,2.0 3.0,4.0 5.0,6.0 \"/>\n"
          "<circle cx=\"7.0\" cy=\"8.0\" r=\"3.5\" fill=\"#2563eb\" stroke=\"#ffffff\" stroke-width=\"1.2\"/>\n"
          "<text x=\"9.0\" y=\"10.0\" text-anchor=\"end\" font-size=\"13\" font-weight=\"600\" "
          "fill=\"#111827\">a &lt; b &amp; &quot;c&quot;</text>\n"
          "</svg>\n");
}

TEST_CASE("a drawing becomes pixels", "[drawing]") {
    constexpr std::uint32_t kPaper = 0xffffffff, kGrid = 0xffe5e7eb, kBlue = 0xff2563eb, kTitle = 0xff111827;
    Drawing drawing{40.0, 30.0, {}};
    drawing.items.emplace_back(DrawnLine{{{5.0, 4.5}, {15.0, 4.5}}, Ink::Grid, 1.0});
    drawing.items.emplace_back(DrawnLine{{{20.0, 4.5}, {36.0, 4.5}}, Ink::Grid, 1.0, true});
    drawing.items.emplace_back(DrawnDot{{10.5, 15.5}, 4.0, Ink::Accent});
    // Letters end where the words do, and stand on their line: an I is 3 wide, in the middle of its 5.
    drawing.items.emplace_back(DrawnWords{{30.0, 27.0}, DrawnWords::Anchor::End, "I", 11.0, Ink::Title});
    drawing.items.emplace_back(DrawnWords{{2.0, 27.0}, DrawnWords::Anchor::Start, "I", 11.0, Ink::Title});
    drawing.items.emplace_back(DrawnWords{{16.5, 27.0}, DrawnWords::Anchor::Middle, "I", 11.0, Ink::Title});
    const pipeline::ColorImage image = to_image(drawing, 1);
    REQUIRE(image.width == 40);
    REQUIRE(image.height == 30);
    CHECK(at(image, 0, 0) == kPaper);
    CHECK(at(image, 10, 4) == kGrid);
    CHECK(at(image, 10, 3) == kPaper);
    CHECK(at(image, 10, 5) == kPaper);
    CHECK(at(image, 22, 4) == kGrid);
    CHECK(at(image, 26, 4) == kPaper);
    CHECK(at(image, 30, 4) == kGrid);
    CHECK(at(image, 10, 15) == kBlue);
    CHECK(at(image, 12, 15) == kBlue);
    CHECK(at(image, 10, 21) == kPaper);
    CHECK(at(image, 27, 26) == kTitle);
    CHECK(at(image, 27, 20) == kTitle);
    CHECK(at(image, 27, 27) == kPaper);
    CHECK(at(image, 27, 19) == kPaper);
    CHECK(at(image, 30, 26) == kPaper);
    CHECK(at(image, 4, 26) == kTitle);
    CHECK(at(image, 2, 26) == kPaper);
    CHECK(at(image, 16, 26) == kTitle);

    const pipeline::ColorImage twice = to_image(drawing, 2);
    CHECK(twice.width == 80);
    CHECK(at(twice, 20, 8) == kGrid);
    CHECK(at(twice, 20, 9) == kGrid);
    CHECK(at(twice, 20, 7) == kPaper);
    CHECK(at(twice, 54, 52) == kTitle);
}
