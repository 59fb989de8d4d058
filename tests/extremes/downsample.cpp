// SPDX-License-Identifier: MIT
#include "tests/extremes/downsample.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "pipeline/execute/execute.h"
#include "tests/support/one_pass_frame.h"

namespace extremes {

using namespace pipeline;

namespace {

int half(int size) {
    return (size + 1) / 2;
}

// So that `pixels` pixels span twice as many texels of `size`. The nearest float above: texels are read by the floor of
// their 256ths, and half a texel's corner must not fall short of its own.
float span(int pixels, int size) {
    const auto exact = 2.0 * pixels / size;
    auto above       = static_cast<float>(exact);
    if (above < exact) above = std::nextafter(above, 4.0f);
    return above;
}

void append_target(Frame& frame, int width, int height) {
    frame.targets.push_back({.name = "level", .width = width, .height = height});
}

// Shows what is bound, of width x height texels, on a target of out_width x out_height, `times` texels to the pixel.
void append_blit(Frame& frame, const TextureBinding& from, int target, UvRect uv, TextureFilter filter) {
    const Target& into   = frame.targets[static_cast<std::size_t>(target)];
    Pass& pass           = frame.passes.emplace_back();
    pass.color           = {target};
    pass.state.stages[0] = {.color_op  = TextureOp::SelectArg1,
                            .alpha_op  = TextureOp::SelectArg1,
                            .filter    = filter,
                            .address_u = TextureAddress::Clamp,
                            .address_v = TextureAddress::Clamp};
    DrawRectangle draw;
    draw.x1          = static_cast<float>(into.width);
    draw.y1          = static_cast<float>(into.height);
    draw.uv[0]       = uv;
    draw.textures[0] = from;
    pass.draws       = {draw};
}

}  // namespace

int halvings(int width, int height) {
    int count = 0;
    for (; width > 1 || height > 1; ++count) width = half(width), height = half(height);
    return count;
}

Frame downsample_frame(FilterRule filter, int width, int height, const std::vector<std::uint8_t>& texels) {
    Frame frame;
    frame.arithmetic.filter = filter;
    frame.textures          = {{.name = "top", .width = width, .height = height, .texels = texels}};
    append_target(frame, width, height);
    append_blit(frame, {.texture = {0}, .target = {}}, 0, {}, TextureFilter::Point);
    for (int level = 0; width > 1 || height > 1; ++level) {
        append_target(frame, half(width), half(height));
        append_blit(frame, {.texture = {}, .target = {level}}, level + 1,
                    {.u1 = span(half(width), width), .v1 = span(half(height), height)}, TextureFilter::Linear);
        width = half(width), height = half(height);
    }
    frame.output = {static_cast<std::int32_t>(frame.targets.size()) - 1};
    return frame;
}

std::uint64_t changed_constants(FilterRule filter, int width, int height) {
    std::uint64_t changed = 0;
    for (const std::uint32_t byte : {0u, 1u, 127u, 128u, 254u, 255u}) {
        const std::vector<std::uint8_t> texels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4,
                                               static_cast<std::uint8_t>(byte));
        const ColorImage image = execute(downsample_frame(filter, width, height, texels)).output;
        changed += image.pixels != std::vector<std::uint32_t>{byte * 0x01010101u};
    }
    return changed;
}

Energy energy_drift(FilterRule filter, int width, int height, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<std::uint8_t> texels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    for (std::uint8_t& byte : texels) byte = static_cast<std::uint8_t>(random() >> 24);
    const ColorImage image = execute(downsample_frame(filter, width, height, texels)).output;

    Energy energy{.least = 1e9, .greatest = -1e9, .halvings = halvings(width, height)};
    for (int channel = 0; channel < 4; ++channel) {
        int w = width, h = height;
        std::vector<double> level(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
        for (std::size_t i = 0; i < level.size(); ++i) level[i] = texels[4 * i + static_cast<std::size_t>(channel)];
        while (w > 1 || h > 1) {
            const auto at = [&](int x, int y) {
                return level[static_cast<std::size_t>(std::min(y, h - 1)) * static_cast<std::size_t>(w) +
                             static_cast<std::size_t>(std::min(x, w - 1))];
            };
            std::vector<double> next;
            for (int y = 0; y < h; y += 2)
                for (int x = 0; x < w; x += 2)
                    next.push_back((at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1)) / 4.0);
            level = std::move(next);
            w = half(w), h = half(h);
        }
        const double drift = (image.pixels[0] >> 8 * channel & 255) - level[0];
        energy.least       = std::min(energy.least, drift);
        energy.greatest    = std::max(energy.greatest, drift);
    }
    return energy;
}

HalvingError halving_error(FilterRule filter) {
    switch (filter) {
        case FilterRule::Reference8:  // half up, once
        case FilterRule::GsNearest4:
            return {-0.25, 0.5};
        case FilterRule::Nv2aHalfUp8:  // half up, of halves in a row and of halves again
            return {0.0, 1.0};
        case FilterRule::FlipperFloor7:  // floored once
            return {-0.75, 0.0};
        case FilterRule::GsFloor4:  // floored, of halves in a row and of halves again
            return {-1.0, 0.0};
    }
    return {};
}

std::vector<Row> downsample_rows() {
    std::vector<Row> rows;
    for (std::size_t i = 0; i < EnumNames<FilterRule>::names.size(); ++i) {
        const auto filter     = static_cast<FilterRule>(i);
        std::uint64_t changed = 0;
        Energy energy;
        for (const auto& [width, height] : kChains) {
            changed += changed_constants(filter, width, height);
            const Energy found = energy_drift(filter, width, height, 1);
            energy.least       = std::min(energy.least, found.least);
            energy.greatest    = std::max(energy.greatest, found.greatest);
        }
        const HalvingError error = halving_error(filter);
        rows.push_back(
            {"halved to 1x1, " + std::string(EnumNames<FilterRule>::names[i]), "odd sizes, 1x1 to 4,097 by 3",
             "constants stay; -" + ceil_text(-error.least, 2) + " to +" + ceil_text(error.greatest, 2) + " a halving",
             count_text(changed) + " constants changed; -" + ceil_text(-energy.least, 2) + " to +" +
                 ceil_text(energy.greatest, 2),
             error.least < -0.5     ? "darkens"
             : error.greatest > 0.5 ? "brightens"
                                    : "brightens by a quarter of that on average"});
    }
    return rows;
}

}  // namespace extremes
