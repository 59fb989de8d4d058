// SPDX-License-Identifier: MIT
#include "demo/tradeoff/picture_error.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace demo {
namespace {

struct RealPlane {
    int width, height;
    std::vector<double> values;
    double at(int x, int y) const { return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + x]; }
};

RealPlane luma_of(const RealPicture& picture) {
    RealPlane luma{picture.width, picture.height, {}};
    luma.values.reserve(picture.pixels.size());
    for (const auto& [red, green, blue] : picture.pixels)
        luma.values.push_back(0.299 * red + 0.587 * green + 0.114 * blue);
    return luma;
}

RealPlane product(const RealPlane& a, const RealPlane& b) {
    RealPlane out = a;
    for (std::size_t i = 0; i < out.values.size(); ++i) out.values[i] *= b.values[i];
    return out;
}

std::array<double, kSsimWindow> window_weights() {
    std::array<double, kSsimWindow> weights{};
    double sum = 0.0;
    for (int i = 0; i < kSsimWindow; ++i) {
        const double distance                = i - kSsimWindow / 2;
        weights[static_cast<std::size_t>(i)] = std::exp(-distance * distance / (2.0 * 1.5 * 1.5));
        sum += weights[static_cast<std::size_t>(i)];
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

// The weighted mean of each window, at its top left corner: narrower by the window's border.
RealPlane window_means(const RealPlane& plane) {
    static const std::array<double, kSsimWindow> weights = window_weights();
    const auto along                                     = [](const RealPlane& from, int dx, int dy) {
        RealPlane to{from.width - dx * (kSsimWindow - 1), from.height - dy * (kSsimWindow - 1), {}};
        to.values.reserve(from.values.size());
        for (int y = 0; y < to.height; ++y)
            for (int x = 0; x < to.width; ++x) {
                double mean = 0.0;
                for (int i = 0; i < kSsimWindow; ++i)
                    mean += weights[static_cast<std::size_t>(i)] * from.at(x + i * dx, y + i * dy);
                to.values.push_back(mean);
            }
        return to;
    };
    return along(along(plane, 1, 0), 0, 1);
}

double mean_ssim(const RealPlane& a, const RealPlane& b) {
    constexpr double kC1 = 0.01 * 255.0 * 0.01 * 255.0, kC2 = 0.03 * 255.0 * 0.03 * 255.0;
    const RealPlane mean_a = window_means(a), mean_b = window_means(b);
    const RealPlane aa = window_means(product(a, a)), bb = window_means(product(b, b)),
                    ab = window_means(product(a, b));
    double sum         = 0.0;
    for (std::size_t i = 0; i < mean_a.values.size(); ++i) {
        const double ma = mean_a.values[i], mb = mean_b.values[i];
        const double variance_a = aa.values[i] - ma * ma, variance_b = bb.values[i] - mb * mb;
        const double covariance = ab.values[i] - ma * mb;
        sum += (2.0 * ma * mb + kC1) * (2.0 * covariance + kC2) /
               ((ma * ma + mb * mb + kC1) * (variance_a + variance_b + kC2));
    }
    return sum / static_cast<double>(mean_a.values.size());
}

}  // namespace

RealPicture to_real(const pipeline::ColorImage& image) {
    RealPicture picture{image.width, image.height, {}};
    picture.pixels.reserve(image.pixels.size());
    for (const std::uint32_t pixel : image.pixels)
        picture.pixels.push_back({static_cast<double>(pixel >> 16 & 255), static_cast<double>(pixel >> 8 & 255),
                                  static_cast<double>(pixel & 255)});
    return picture;
}

PictureError error_between(const RealPicture& a, const RealPicture& b) {
    assert(a.width == b.width && a.height == b.height && a.width >= kSsimWindow && a.height >= kSsimWindow);
    PictureError error;
    double squares = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const double difference = std::abs(a.pixels[i][c] - b.pixels[i][c]);
            error.max               = std::max(error.max, difference);
            squares += difference * difference;
        }
    error.rms     = std::sqrt(squares / (3.0 * static_cast<double>(a.pixels.size())));
    error.psnr_db = 20.0 * std::log10(255.0 / error.rms);
    error.ssim    = mean_ssim(luma_of(a), luma_of(b));
    return error;
}

}  // namespace demo
