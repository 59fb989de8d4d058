// SPDX-License-Identifier: MIT
#include "tests/support/gx_shading.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

namespace test_support {

using namespace pipeline;

namespace {

double clamp1(double x) {
    return std::clamp(x, 0.0, 1.0);
}

}  // namespace

RealColor run_tev(const GxRegisters& r, const std::array<RealColor, 2>& ras, const std::array<RealColor, 2>& texels) {
    std::array<RealColor, 4> registers{};
    for (const auto& [id, bytes] : r.tev_color)
        for (std::size_t i = 0; i < 4; ++i) registers[static_cast<std::size_t>(id)][i] = bytes[i] / 255.0;
    registers[0] = {-5.0, -5.0, -5.0, -5.0};  // nobody may read it before it is written
    for (int index = 0; index < r.tev_stages; ++index) {
        const GxTevStageRead& stage = r.tev[static_cast<std::size_t>(index)];
        const int map = stage.order[1], channel = stage.order[2];
        const RealColor poison{-7.0, -7.0, -7.0, -7.0};
        const RealColor texel     = map == 0xff ? poison : texels[static_cast<std::size_t>(map)];
        const RealColor of_vertex = channel == 4 ? ras[0] : channel == 5 ? ras[1] : poison;
        const auto color_in       = [&](int code, std::size_t i) -> double {
            if (code < 8) return registers[static_cast<std::size_t>(code / 2)][code % 2 == 0 ? i : 3];
            const double values[] = {texel[i], texel[3], of_vertex[i], of_vertex[3], 1.0, 0.5, -9.0, 0.0};
            return values[code - 8];
        };
        const auto alpha_in = [&](int code) -> double {
            if (code < 4) return registers[static_cast<std::size_t>(code)][3];
            const double values[] = {texel[3], of_vertex[3], 1.0, 0.0};
            return values[code - 4];
        };
        const auto unit = [](const std::array<double, 4>& in, const std::array<int, 5>& op) {
            constexpr double kBias[] = {0.0, 0.5, -0.5}, kScale[] = {1.0, 2.0, 4.0, 0.5};
            const double lerp = in[0] * (1.0 - in[2]) + in[1] * in[2];
            const double out  = (in[3] + kBias[op[1]] + (op[0] == 0 ? lerp : -lerp)) * kScale[op[2]];
            return op[3] != 0 ? clamp1(out) : out;
        };
        std::array<double, 4> next{};
        for (std::size_t i = 0; i < 3; ++i) {
            std::array<double, 4> in{};
            for (std::size_t k = 0; k < 4; ++k) in[k] = color_in(stage.color_in[k], i);
            next[i] = unit(in, stage.color_op);
        }
        std::array<double, 4> in{};
        for (std::size_t k = 0; k < 4; ++k) in[k] = alpha_in(stage.alpha_in[k]);
        next[3]          = unit(in, stage.alpha_op);
        RealColor& color = registers[static_cast<std::size_t>(stage.color_op[4])];
        std::copy(next.begin(), next.begin() + 3, color.begin());
        registers[static_cast<std::size_t>(stage.alpha_op[4])][3] = next[3];
    }
    return registers[0];
}

int coordinate_of(const GxRegisters& r, int map) {
    for (int i = 0; i < r.tev_stages; ++i)
        if (r.tev[static_cast<std::size_t>(i)].order[1] == map) return r.tev[static_cast<std::size_t>(i)].order[0];
    return -1;
}

std::array<double, 4> clip(const GxRegisters& r, const GxVertexRead& vertex) {
    const std::array<double, 12>& m = r.matrices.at(0);
    std::array<double, 4> eye{0.0, 0.0, 0.0, 1.0}, out{};
    for (std::size_t row = 0; row < 3; ++row)
        eye[row] = m[4 * row] * vertex.position[0] + m[4 * row + 1] * vertex.position[1] +
                   m[4 * row + 2] * vertex.position[2] + m[4 * row + 3];
    const std::array<double, 16>& p = r.projection;
    // The chip keeps six numbers of the matrix; the others must be what it takes them to be.
    if (r.projection_type == 0)
        CHECK((p[1] == 0 && p[3] == 0 && p[4] == 0 && p[7] == 0 && p[14] == -1 && p[15] == 0));
    else
        CHECK((p[1] == 0 && p[2] == 0 && p[4] == 0 && p[6] == 0 && p[14] == 0 && p[15] == 1));
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t k = 0; k < 4; ++k) out[row] += p[4 * row + k] * eye[k];
    return out;
}

double window_depth(const GxRegisters& r, const GxVertexRead& vertex) {
    const std::array<double, 4> c = clip(r, vertex);
    CHECK(r.viewport[4] == 0.0);
    CHECK(r.viewport[5] == 1.0);
    return 1.0 + c[2] / c[3];
}

namespace {

std::array<double, 2> window(const GxRegisters& r, const GxVertexRead& vertex) {
    const std::array<double, 4> c = clip(r, vertex);
    return {r.viewport[0] + (1.0 + c[0] / c[3]) * r.viewport[2] / 2.0,
            r.viewport[1] + (1.0 - c[1] / c[3]) * r.viewport[3] / 2.0};
}

}  // namespace

std::array<double, 4> window_rect(const GxEvent& event) {
    REQUIRE(event.vertices.size() == 4);
    std::array<std::array<double, 2>, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) corners[i] = window(event.registers, event.vertices[i]);
    const auto rounded = [](double x) { return std::round(x * 1024.0) / 1024.0; };
    return {rounded(corners[0][0]), rounded(corners[0][1]), rounded(corners[2][0]), rounded(corners[2][1])};
}

std::array<double, 3> generated(const GxRegisters& r, int coordinate, const GxVertexRead& vertex) {
    REQUIRE(coordinate < r.texgens);
    const std::array<int, 3>& how = r.texgen.at(coordinate);
    if (how[0] == 1) {  // 2x4, of which the identity is all that is used
        CHECK(how[2] == 60);
        const std::array<double, 2>& st = vertex.tex.at(static_cast<std::size_t>(how[1] - 4));
        return {st[0], st[1], 1.0};
    }
    CHECK(how[1] == 0);  // positions
    const std::array<double, 12>& m = r.matrices.at(how[2]);
    std::array<double, 3> out{};
    for (std::size_t row = 0; row < 3; ++row)
        out[row] = m[4 * row] * vertex.position[0] + m[4 * row + 1] * vertex.position[1] +
                   m[4 * row + 2] * vertex.position[2] + m[4 * row + 3];
    return out;
}

std::array<int, 4> lit(const GxRegisters& r, const GxVertexRead& vertex) {
    const std::array<int, 6>& control = r.channel.at(0);
    const auto transformed            = [&](const std::array<double, 12>& m, const std::array<double, 3>& v, double w) {
        std::array<double, 3> out{};
        for (std::size_t row = 0; row < 3; ++row)
            out[row] = m[4 * row] * v[0] + m[4 * row + 1] * v[1] + m[4 * row + 2] * v[2] + m[4 * row + 3] * w;
        return out;
    };
    const auto dot = [](const auto& a, const auto& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    const std::array<double, 3> eye    = transformed(r.matrices.at(0), vertex.position, 1.0),
                                normal = transformed(r.matrices.at(1000), vertex.normal, 0.0);
    CHECK(control[1] == 0);
    CHECK(control[4] == 2);
    CHECK(control[5] == 1);
    std::array<double, 3> sum{};
    for (std::size_t i = 0; i < 3; ++i) sum[i] = r.ambient.at(4)[i];
    for (const auto& [bit, light] : r.lights) {
        if ((control[3] & bit) == 0) continue;
        std::array<double, 3> path{};
        for (std::size_t i = 0; i < 3; ++i) path[i] = light.position[i] - eye[i];
        const double d = std::sqrt(dot(path, path));
        CHECK(light.a == std::array<double, 3>{1.0, 0.0, 0.0});
        const double share = std::max(0.0, dot(normal, path) / d / std::sqrt(dot(normal, normal))) /
                             (light.k[0] + light.k[1] * d + light.k[2] * d * d);
        for (std::size_t i = 0; i < 3; ++i) sum[i] += share * light.color[i];
    }
    std::array<int, 4> out{};
    for (std::size_t i = 0; i < 3; ++i) {
        const int l = static_cast<int>(std::clamp(sum[i], 0.0, 255.0));
        const int m = control[2] == 1 ? vertex.color0[i] : r.material.at(4)[i];
        out[i]      = m * (l + (l >> 7)) >> 8;
    }
    out[3] = r.channel.at(2)[2] == 1 ? vertex.color0[3] : r.material.at(4)[3];
    return out;
}

double chip_fog(const GxRegisters& r, double depth) {
    const auto type    = static_cast<int>(r.fog[0]);
    const double start = r.fog[1], end = r.fog[2], near = r.fog[3], far = r.fog[4];
    const double eye = type >= 8 ? near + depth * (far - near) : far * near / (far - depth * (far - near));
    const double f   = clamp1((eye - start) / (end - start));
    switch (type & 7) {
        case 2:
            return 1.0 - f;
        case 4:
            return std::exp2(-8.0 * f);
        case 5:
            return std::exp2(-8.0 * f * f);
    }
    return 1.0;
}

std::size_t differing_texels(const Texture& texture, const std::vector<std::uint8_t>& data, std::size_t start) {
    const bool is_color   = texture.format == TextureFormat::A8R8G8B8;
    std::size_t differing = 0, texel = 0;
    for (int level = 0; level < texture.levels; ++level) {
        const auto width             = static_cast<std::size_t>(std::max(1, texture.width >> level)),
                   height            = static_cast<std::size_t>(std::max(1, texture.height >> level));
        const std::size_t tile_width = is_color ? 4 : 8, tile_bytes = is_color ? 64 : 32;
        const std::size_t tiles = (width + tile_width - 1) / tile_width;
        for (std::size_t y = 0; y < height; ++y) {
            for (std::size_t x = 0; x < width; ++x, ++texel) {
                const std::size_t tile = start + (y / 4 * tiles + x / tile_width) * tile_bytes;
                const std::size_t in   = y % 4 * tile_width + x % tile_width;
                if (!is_color) {
                    differing += data.at(tile + in) != texture.texels[texel];
                    continue;
                }
                const std::uint8_t* bgra = &texture.texels[4 * texel];
                differing += data.at(tile + 2 * in) != bgra[3] || data.at(tile + 2 * in + 1) != bgra[2] ||
                             data.at(tile + 32 + 2 * in) != bgra[1] || data.at(tile + 32 + 2 * in + 1) != bgra[0];
            }
        }
        start += tiles * ((height + 3) / 4) * tile_bytes;
    }
    return differing;
}

}  // namespace test_support
