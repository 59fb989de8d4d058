// SPDX-License-Identifier: MIT
#include "tests/support/image_match.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "demo/image_file.h"

namespace test_support {
namespace {

using pipeline::ColorImage;

constexpr int kShifts[] = {24, 16, 8, 0};

int channel_difference(std::uint32_t a, std::uint32_t b, int shift) {
    return std::abs(static_cast<int>(a >> shift & 255) - static_cast<int>(b >> shift & 255));
}

}  // namespace

ImageMatch match_images(const ColorImage& got, const ColorImage& want) {
    ImageMatch match{
        .got_width = got.width, .got_height = got.height, .want_width = want.width, .want_height = want.height};
    if (!match.same_size()) return match;
    for (std::size_t i = 0; i < want.pixels.size(); ++i) {
        const std::uint32_t a = got.pixels[i], b = want.pixels[i];
        if (a == b) continue;
        ++match.differing;
        int greatest = 0;
        for (const int shift : kShifts) greatest = std::max(greatest, channel_difference(a, b, shift));
        if (greatest <= match.worst_difference) continue;
        match.worst_x          = static_cast<int>(i % static_cast<std::size_t>(want.width));
        match.worst_y          = static_cast<int>(i / static_cast<std::size_t>(want.width));
        match.worst_difference = greatest;
        match.worst_got        = a;
        match.worst_want       = b;
    }
    return match;
}

double mean_difference(const ColorImage& a, const ColorImage& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        for (const int shift : {0, 8, 16}) sum += channel_difference(a.pixels[i], b.pixels[i], shift);
    return sum / (3.0 * static_cast<double>(a.pixels.size()));
}

std::string describe(const ImageMatch& match) {
    char text[200] = "";
    if (!match.same_size()) {
        std::snprintf(text, sizeof text, "%dx%d pixels instead of %dx%d", match.got_width, match.got_height,
                      match.want_width, match.want_height);
    } else if (match.differing > 0) {
        std::snprintf(text, sizeof text, "%zu of %zu pixels differ, by at most %d, as at (%d, %d): %08x, not %08x",
                      match.differing,
                      static_cast<std::size_t>(match.want_width) * static_cast<std::size_t>(match.want_height),
                      match.worst_difference, match.worst_x, match.worst_y, match.worst_got, match.worst_want);
    }
    return text;
}

ColorImage difference_image(const ColorImage& got, const ColorImage& want) {
    ColorImage image = want;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        std::uint32_t pixel = 0xff000000;
        for (const int shift : {16, 8, 0}) {
            const int difference = channel_difference(got.pixels[i], want.pixels[i], shift);
            if (difference > 0) pixel |= static_cast<std::uint32_t>(64 + difference * 3 / 4) << shift;
        }
        image.pixels[i] = pixel;
    }
    return image;
}

std::string compare_pictures(const ColorImage& got, const ColorImage& want, const std::string& folder,
                             const std::string& name) {
    namespace fs           = std::filesystem;
    const std::string stem = folder + "/" + name;
    for (const char* kind : {".got.png", ".want.png", ".difference.png"}) fs::remove(stem + kind);
    const ImageMatch match = match_images(got, want);
    if (match.equal()) return "";
    fs::create_directories(folder);
    demo::write_image(stem + ".got.png", got, demo::Channels::Rgba);
    demo::write_image(stem + ".want.png", want, demo::Channels::Rgba);
    if (match.same_size())
        demo::write_image(stem + ".difference.png", difference_image(got, want), demo::Channels::Rgb);
    return name + ": " + describe(match) + "; see " + stem + ".*.png";
}

}  // namespace test_support
