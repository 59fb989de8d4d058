// SPDX-License-Identifier: MIT
#include "pipeline/truth/texture.h"

#include <cmath>

namespace pipeline::truth {
namespace {

// Keeps texels within what an int counts.
double limited(double texels) {
    return texels > -0x1p22 ? std::min(texels, 0x1p22) : -0x1p22;
}

int address(TextureAddress mode, int i, int n) {
    switch (mode) {
        case TextureAddress::Wrap:
            return ((i % n) + n) % n;
        case TextureAddress::Clamp:
            return std::clamp(i, 0, n - 1);
        case TextureAddress::Mirror: {
            const int m = ((i % (2 * n)) + 2 * n) % (2 * n);
            return m < n ? m : 2 * n - 1 - m;
        }
    }
    return 0;
}

struct Level {
    const std::uint8_t* texels = nullptr;
    int width = 0, height = 0;
};
Level level_of(const Texture& texture, int level) {
    const std::uint8_t* texels = texture.texels.data();
    for (int i = 0; i < level; ++i)
        texels += std::ptrdiff_t{std::max(1, texture.width >> i)} * std::max(1, texture.height >> i) *
                  bytes_per_texel(texture.format);
    return {texels, std::max(1, texture.width >> level), std::max(1, texture.height >> level)};
}

Color texel(const Texture& texture, const Level& level, const TextureStage& stage, int i, int j) {
    const int x = address(stage.address_u, i, level.width), y = address(stage.address_v, j, level.height);
    const std::uint8_t* bytes = level.texels + (std::ptrdiff_t{y} * level.width + x) * bytes_per_texel(texture.format);
    switch (texture.format) {
        case TextureFormat::A8:
            return {0.0, 0.0, 0.0, bytes[0] / 255.0};
        case TextureFormat::L8:
            return Color(glm::dvec3(bytes[0] / 255.0), 1.0);
        case TextureFormat::A8R8G8B8:
            return {bytes[2] / 255.0, bytes[1] / 255.0, bytes[0] / 255.0, bytes[3] / 255.0};
    }
    return Color(1.0);
}

int whole(double v) {
    return static_cast<int>(std::floor(v));
}

Color read_level(const Texture& texture, const TextureStage& stage, int index, double u, double v) {
    const Level level = level_of(texture, index);
    const double x = limited(u * texture.width) / (1 << index), y = limited(v * texture.height) / (1 << index);
    if (stage.filter == TextureFilter::Point) return texel(texture, level, stage, whole(x), whole(y));
    const int i = whole(x - 0.5), j = whole(y - 0.5);
    const double fx = x - 0.5 - i, fy = y - 0.5 - j;
    const auto at = [&](int right, int below) { return texel(texture, level, stage, i + right, j + below); };
    return (1.0 - fy) * ((1.0 - fx) * at(0, 0) + fx * at(1, 0)) + fy * ((1.0 - fx) * at(0, 1) + fx * at(1, 1));
}

double level_of_detail(const Texture& texture, const TexturePoint& p) {
    const double w = texture.width, h = texture.height;
    const double rho2 = std::max(p.ux * w * p.ux * w + p.vx * h * p.vx * h, p.uy * w * p.uy * w + p.vy * h * p.vy * h);
    const double lod  = 0.5 * std::log2(rho2);
    return lod > 0.0 ? std::min(lod, texture.levels - 1.0) : 0.0;
}

Color read_texture(const Texture& texture, const TextureStage& stage, const TexturePoint& p) {
    const double lod = stage.mip_filter == MipFilter::None ? 0.0 : level_of_detail(texture, p);
    if (stage.mip_filter != MipFilter::Linear) return read_level(texture, stage, whole(lod + 0.5), p.u, p.v);
    const int finer = whole(lod);
    const double f  = lod - finer;
    if (f == 0.0) return read_level(texture, stage, finer, p.u, p.v);
    return (1.0 - f) * read_level(texture, stage, finer, p.u, p.v) +
           f * read_level(texture, stage, finer + 1, p.u, p.v);
}

Color nearest_sample(const Samples& target, const TextureStage& stage, const TexturePoint& p) {
    // The pixel first, then the sample in it, so that wrapping takes whole pixels.
    const double x = limited(p.u * target.width), y = limited(p.v * target.height);
    const int i = whole(x), j = whole(y), n = target.per_axis;
    const auto sample = [&](double inside) { return std::clamp(whole(inside * n), 0, n - 1); };
    return target.color[target.at(address(stage.address_u, i, target.width) * n + sample(x - i),
                                  address(stage.address_v, j, target.height) * n + sample(y - j))];
}

// One axis of what lies `from` (in pixels) off the middle of a pixel: two samples and the second's weight.
struct Between {
    int first = 0, second = 0;
    double weight = 0.0;
};
Between samples_at(int pixel, double from, int per_axis, int count) {
    const double at      = (pixel + 0.5 + from) * per_axis - 0.5;
    const double nearest = std::nearbyint(at);
    // A whole number but for rounding is whole.
    const double first   = std::abs(at - nearest) < 1e-6 ? nearest : std::floor(at);
    const auto within    = [&](double i) { return static_cast<int>(std::clamp(i, 0.0, count - 1.0)); };
    return {within(first), within(first + 1.0), std::abs(at - nearest) < 1e-6 ? 0.0 : at - first};
}

Color between_samples(const Samples& target, const Between& x, const Between& y) {
    const auto row = [&](int j) {
        const Color& left = target.color[target.at(x.first, j)];
        return x.weight == 0.0 ? left : (1.0 - x.weight) * left + x.weight * target.color[target.at(x.second, j)];
    };
    return y.weight == 0.0 ? row(y.first) : (1.0 - y.weight) * row(y.first) + y.weight * row(y.second);
}

}  // namespace

Color read_linear(const Samples& target, TextureAddress address_u, TextureAddress address_v, double u, double v,
                  double from_u, double from_v) {
    const double x = limited(u) - 0.5, y = limited(v) - 0.5;
    const int i = whole(x), j = whole(y);
    const double fx = x - i, fy = y - j;
    Color sum(0.0);
    for (int k = 0; k < 4; ++k) {
        const int right = k & 1, below = k >> 1;
        const double weight = (right ? fx : 1.0 - fx) * (below ? fy : 1.0 - fy);
        if (weight == 0.0) continue;
        const Between across =
            samples_at(address(address_u, i + right, target.width), from_u, target.per_axis, target.columns());
        const Between down =
            samples_at(address(address_v, j + below, target.height), from_v, target.per_axis, target.rows());
        sum += weight * between_samples(target, across, down);
    }
    return sum;
}

Color read(const BoundTexture& bound, const TextureStage& stage, const TexturePoint& p) {
    if (bound.texture) return read_texture(*bound.texture, stage, p);
    if (!bound.target) return Color(1.0);
    if (stage.filter == TextureFilter::Point) return nearest_sample(*bound.target, stage, p);
    const double w = bound.target->width, h = bound.target->height;
    return read_linear(*bound.target, stage.address_u, stage.address_v, p.center_u * w, p.center_v * h,
                       limited((p.u - p.center_u) * w), limited((p.v - p.center_v) * h));
}

}  // namespace pipeline::truth
