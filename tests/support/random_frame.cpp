// SPDX-License-Identifier: MIT
#include "tests/support/random_frame.h"

#include <algorithm>
#include <bit>

#include "tests/support/random.h"
#include "tests/support/random_geometry.h"
#include "tests/support/random_state.h"

namespace test_support {

using namespace pipeline;

namespace {

// Mostly unique; sometimes none, shared, or in need of quoting: the text form has to cope.
std::string random_name(Random& random, const char* kind, std::size_t index) {
    if (random.chance(10)) return {};
    if (random.chance(10)) return "same \"name\"\n";
    return kind + std::to_string(index);
}

int random_size(Random& random) {
    return random.chance(35) ? 1 << random.from(0, 7) : random.from(1, 150);
}

void add_targets(Frame& frame, Random& random) {
    const int colors = random.from(1, 3), depths = random.from(0, 2);
    for (int i = 0; i < colors; ++i) {
        Target target{.name = {}, .width = random_size(random), .height = random_size(random)};
        while (random.chance(40) || is_depth(target.format)) target.format = random.any<TargetFormat>();
        if (random.chance(75)) target.width = std::max(target.width, 32), target.height = std::max(target.height, 32);
        frame.targets.push_back(target);
    }
    for (int i = 0; i < depths; ++i) {
        Target depth = frame.targets[random.below(static_cast<std::size_t>(colors))];
        depth.format = random.one_of({TargetFormat::D16, TargetFormat::D24, TargetFormat::D32});
        frame.targets.push_back(depth);
    }
    for (std::size_t i = 0; i < frame.targets.size(); ++i) frame.targets[i].name = random_name(random, "target ", i);
    frame.output = {random.from(0, colors - 1)};
}

Texture random_texture(Random& random) {
    Texture texture{.name = {}, .format = random.any<TextureFormat>(), .texels = {}};
    texture.width              = random.chance(70) ? 1 << random.from(0, 6) : random.from(1, 70);
    texture.height             = random.chance(70) ? 1 << random.from(0, 6) : random.from(1, 70);
    const auto is_power_of_two = [](int size) { return std::has_single_bit(static_cast<unsigned>(size)); };
    if (is_power_of_two(texture.width) && is_power_of_two(texture.height) && random.chance(60)) {
        texture.levels = random.from(1, std::bit_width(static_cast<unsigned>(std::max(texture.width, texture.height))));
    }
    std::size_t bytes = 0;
    for (int level = 0; level < texture.levels; ++level) {
        bytes += static_cast<std::size_t>(std::max(1, texture.width >> level) * std::max(1, texture.height >> level) *
                                          bytes_per_texel(texture.format));
    }
    const bool is_noise = random.chance(60);
    const int slope     = random.from(1, 9);
    for (std::size_t i = 0; i < bytes; ++i) {
        texture.texels.push_back(
            static_cast<std::uint8_t>(is_noise ? random.bits() : static_cast<std::uint32_t>(i) * slope));
    }
    return texture;
}

struct Size {
    int width, height;
};
Size size_of(const Frame& frame, const TextureBinding& binding) {
    if (binding.texture) {
        const Texture& texture = frame.textures[static_cast<std::size_t>(binding.texture.index)];
        return {texture.width, texture.height};
    }
    if (binding.target) {
        const Target& target = frame.targets[static_cast<std::size_t>(binding.target.index)];
        return {target.width, target.height};
    }
    return {1, 1};
}

// Something that the stage can address, or nothing.
TextureBinding random_binding(const Frame& frame, const Pass& pass, const TextureStage& stage, Random& random) {
    const auto fits = [](TextureAddress address, int size) {
        return address == TextureAddress::Clamp || std::has_single_bit(static_cast<unsigned>(size));
    };
    for (int attempt = 0; attempt < 6; ++attempt) {
        TextureBinding binding;
        if (random.chance(65)) {
            binding.texture.index = static_cast<std::int32_t>(random.below(frame.textures.size()));
        } else {
            binding.target.index = static_cast<std::int32_t>(random.below(frame.targets.size()));
            if (binding.target == pass.color ||
                is_depth(frame.targets[static_cast<std::size_t>(binding.target.index)].format)) {
                continue;
            }
        }
        const Size size = size_of(frame, binding);
        if (fits(stage.address_u, size.width) && fits(stage.address_v, size.height)) return binding;
    }
    return {};
}

DrawRectangle random_rectangle(const Frame& frame, const TextureBindings& textures, Size target, Random& random) {
    DrawRectangle draw{.depth    = random.one_of({0.0f, 1.0f, random.real(0.0f, 1.0f)}),
                       .color    = {random.chance(50) ? 0xffffffff : random.bits()},
                       .uv       = {},
                       .textures = textures};
    const auto width = static_cast<float>(target.width), height = static_cast<float>(target.height);
    const Size texture = size_of(frame, textures[0]);
    switch (random.from(0, 5)) {
        case 0:  // the whole target
            draw.x1 = width, draw.y1 = height;
            break;
        case 1: {  // a texel a pixel, two texels a pixel, or two pixels a texel; centred or half a pixel off
            const float scale = random.one_of({1.0f, 0.5f, 2.0f}), shift = random.one_of({0.0f, -0.5f});
            draw.x0 = shift, draw.y0 = shift;
            draw.x1 = static_cast<float>(texture.width) * scale + shift;
            draw.y1 = static_cast<float>(texture.height) * scale + shift;
            break;
        }
        case 2:  // far beyond the target
            draw.x0 = random.real(-16384.0f, 0.0f), draw.y0 = random.real(-16384.0f, 0.0f);
            draw.x1 = random.real(width, 16384.0f), draw.y1 = random.real(height, 16384.0f);
            break;
        case 3:  // no width
            draw.x0 = draw.x1 = random.real(0.0f, width);
            draw.y1           = height;
            break;
        default:
            draw.x0 = random.real(-20.0f, width), draw.y0 = random.real(-20.0f, height);
            draw.x1 = draw.x0 + random.real(0.0f, width), draw.y1 = draw.y0 + random.real(0.0f, height);
            break;
    }
    for (UvRect& uv : draw.uv) {
        if (random.chance(40)) {
            uv = {random.real(-2.0f, 2.0f), random.real(-2.0f, 2.0f), random.real(-2.0f, 3.0f),
                  random.real(-2.0f, 3.0f)};
        }
        if (random.chance(15)) std::swap(uv.u0, uv.u1);
        if (random.chance(15)) std::swap(uv.v0, uv.v1);
        if (random.chance(5)) uv.u1 = uv.u0;
    }
    return draw;
}

// From the other colour targets that can be copied, whole or halved.
void add_copies(const Frame& frame, Pass& pass, Random& random) {
    const Target& to = frame.targets[static_cast<std::size_t>(pass.color.index)];
    for (std::int32_t i = 0; i < std::ssize(frame.targets); ++i) {
        const Target& from = frame.targets[static_cast<std::size_t>(i)];
        if (is_depth(from.format) || i == pass.color.index) continue;
        const bool is_16_bit = bytes_per_pixel(from.format) == 2;
        CopyRectangle copy{.source = {i}, .halve = !is_16_bit && random.chance(60)};
        const int step  = copy.halve ? 2 : 1;
        const int width = std::min(from.width / step, to.width), height = std::min(from.height / step, to.height);
        if (width == 0 || height == 0) continue;
        const int w = random.from(1, width), h = random.from(1, height);
        copy.from.x0 = random.from(0, from.width / step - w) * step;
        copy.from.y0 = random.from(0, from.height / step - h) * step;
        copy.from.x1 = copy.from.x0 + w * step;
        copy.from.y1 = copy.from.y0 + h * step;
        copy.x       = random.from(0, to.width - w);
        copy.y       = random.from(0, to.height - h);
        pass.draws.emplace_back(copy);
    }
}

Pass random_pass(Frame& frame, Random& random) {
    Pass pass;
    std::vector<std::int32_t> colors, depths;
    for (std::size_t i = 0; i < frame.targets.size(); ++i) {
        (is_depth(frame.targets[i].format) ? depths : colors).push_back(static_cast<std::int32_t>(i));
    }
    pass.color.index    = random.chance(60) ? frame.output.index : colors[random.below(colors.size())];
    const Target target = frame.targets[static_cast<std::size_t>(pass.color.index)];
    for (const std::int32_t depth : depths) {
        const Target& candidate = frame.targets[static_cast<std::size_t>(depth)];
        if (candidate.width == target.width && candidate.height == target.height && random.chance(80)) {
            pass.depth.index = depth;
        }
    }
    if (pass.depth && random.chance(10)) pass.color = {};
    pass.camera.index = static_cast<std::int32_t>(random.below(frame.cameras.size()));
    const auto color  = pass.color ? std::optional(target.format) : std::nullopt;
    pass.state =
        random_state(frame.arithmetic, random, target.width, target.height, color, static_cast<bool>(pass.depth));
    if (pass.color && random.chance(50)) pass.clear.color = Argb{random.bits()};
    if (pass.depth && random.chance(80))
        pass.clear.depth = random.one_of({1.0f, 1.0f, 1.0f, 0.0f, random.real(0.0f, 1.0f)});

    if (pass.color && random.chance(10)) {
        add_copies(frame, pass, random);
        PipelineState limits;
        limits.viewport = pass.state.viewport;
        limits.scissor  = pass.state.scissor;
        if (!pass.draws.empty()) pass.state = limits;
        return pass;
    }
    const int draws = random.chance(5) ? 0 : random.from(1, 5);
    for (int i = 0; i < draws; ++i) {
        TextureBindings textures;
        for (std::size_t stage = 0; stage < textures.size(); ++stage) {
            if (random.chance(85)) textures[stage] = random_binding(frame, pass, pass.state.stages[stage], random);
        }
        if (random.chance(60)) {
            DrawTriangles triangles =
                append_triangles(frame, frame.cameras[static_cast<std::size_t>(pass.camera.index)], random);
            if (random.chance(40)) triangles.world = random_matrix(random);
            triangles.textures = textures;
            pass.draws.emplace_back(triangles);
        } else {
            pass.draws.emplace_back(random_rectangle(frame, textures, {target.width, target.height}, random));
        }
    }
    return pass;
}

}  // namespace

Frame random_frame(std::uint32_t seed) {
    Random random(seed);
    Frame frame;
    frame.arithmetic = random_arithmetic(random);
    add_targets(frame, random);
    const auto textures = static_cast<std::size_t>(random.from(1, 4));
    for (std::size_t i = 0; i < textures; ++i) {
        frame.textures.push_back(random_texture(random));
        frame.textures.back().name = random_name(random, "texture ", i);
    }
    const auto cameras = static_cast<std::size_t>(random.from(1, 2));
    for (std::size_t i = 0; i < cameras; ++i) {
        frame.cameras.push_back(random_camera(random));
        frame.cameras.back().name = random_name(random, "camera ", i);
    }
    const auto passes = static_cast<std::size_t>(random.from(1, 6));
    for (std::size_t i = 0; i < passes; ++i) {
        frame.passes.push_back(random_pass(frame, random));
        frame.passes.back().label = random_name(random, "pass ", i);
    }
    return frame;
}

}  // namespace test_support
