// SPDX-License-Identifier: MIT
#include "tests/extremes/coordinates.h"

#include <algorithm>
#include <cmath>

#include "raster/fill_pass.h"
#include "raster/reference_texture.h"

namespace extremes {

namespace {

constexpr int kWidth = 256, kHeight = 16, kTexels = 256;

// The texel of a level of `size` texels, as the rules have it.
int texel_at(std::int64_t i, raster::Address address) {
    const auto n = std::int64_t{kTexels};
    switch (address) {
        case raster::Address::Wrap:
            return static_cast<int>(((i % n) + n) % n);
        case raster::Address::Mirror: {
            const std::int64_t m = ((i % (2 * n)) + 2 * n) % (2 * n);
            return static_cast<int>(m < n ? m : 2 * n - 1 - m);
        }
        case raster::Address::Clamp:
            break;
    }
    return static_cast<int>(std::clamp(i, std::int64_t{0}, n - 1));
}

}  // namespace

PositionError position_error(int exponent, Depths depths, raster::Address address) {
    PositionError error;
    // Each texel holds its place: u in red, v in green.
    std::vector<std::uint32_t> texels(kTexels * kTexels);
    for (std::uint32_t i = 0; i < texels.size(); ++i) texels[i] = 0xff000000 | (i % kTexels) << 16 | (i / kTexels) << 8;
    raster::Image color(kWidth, kHeight);
    raster::PassFill pass{.color = &color, .scissor = color.bounds(), .draws = {}};
    raster::Draw& draw                  = pass.draws.emplace_back();
    draw.state.stage_count              = 1;
    draw.state.stages[0].color.a.source = draw.state.stages[0].alpha.a.source = raster::CombineArg::Source::Texel;
    raster::Sampler& sampler                                                  = draw.state.samplers[0];
    sampler.levels.push_back({texels.data(), kTexels, kTexels, kTexels});
    sampler.address_u = sampler.address_v = address;

    for (const float sign : {1.0f, -1.0f}) {
        // In textures, not in texels. t lies on the other side, and goes on by a third of a texel to the pixel.
        const float farthest = sign * std::exp2(static_cast<float>(exponent)) / kTexels;
        const auto s_at      = [&](float x) { return farthest - sign * (1.001f - x / kTexels); };
        const auto t_at      = [&](float y) { return -farthest + sign * (0.501f - y / 3.0f / kTexels); };
        draw.vertices.clear();
        for (const auto& [x, y] : {std::pair{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}}) {
            raster::Vertex vertex;
            vertex.x   = x * kWidth;
            vertex.y   = y * kHeight;
            vertex.rhw = depths == Depths::OneToFour && x > 0.0f ? 0.25f : 1.0f;
            // No power of two.
            if (depths == Depths::OneToFour) vertex.rhw *= 0.7f;
            vertex.uv[0] = {.s = s_at(vertex.x), .t = t_at(vertex.y)};
            draw.vertices.push_back(vertex);
        }
        draw.triangles = {{0, 1, 2}, {0, 2, 3}};
        raster::fill_pass(pass);
        for (const raster::TriangleCorners& corners : draw.triangles) {
            raster::Triangle triangle                = raster::triangle_of(draw, corners);
            const raster::reference::Corners snapped = raster::reference::snap_clockwise(pass.grid, triangle);
            const raster::reference::TriangleTexture texture(snapped, triangle, 0, sampler);
            for (int y = 0; y < kHeight; ++y)
                for (int x = 0; x < kWidth; ++x) {
                    if (!raster::reference::covers(snapped, x, y)) continue;
                    // Homogeneous, in double, from the floats of the corners.
                    const auto area = [&](double ax, double ay, double bx, double by) { return ax * by - bx * ay; };
                    std::array<double, 3> dx, dy;
                    for (std::size_t i = 0; i < 3; ++i) {
                        dx[i] = triangle[i].x - (x + 0.5);
                        dy[i] = triangle[i].y - (y + 0.5);
                    }
                    double s = 0.0, t = 0.0, q = 0.0;
                    for (std::size_t i = 0; i < 3; ++i) {
                        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
                        const double weight = area(dx[j], dy[j], dx[k], dy[k]) * triangle[i].rhw;
                        s += weight * triangle[i].uv[0].s;
                        t += weight * triangle[i].uv[0].t;
                        q += weight;
                    }
                    const raster::reference::TexturePoint point = texture.at(x, y);
                    const double u = s / q * kTexels, v = t / q * kTexels;
                    for (const double off : {point.u / 256.0 - u, point.v / 256.0 - v}) {
                        error.texels = std::max(error.texels, std::abs(off));
                        error.ahead  = std::max(error.ahead, off);
                    }
                    ++error.pixels;
                    const std::uint32_t argb = color.row(y)[x];
                    const double bound       = position_bound(exponent, depths);
                    const auto is_allowed    = [&](std::uint32_t texel, double position) {
                        const auto last = static_cast<std::int64_t>(std::floor(position + bound - 1.0 / 256.0));
                        for (auto i = static_cast<std::int64_t>(std::floor(position - bound)); i <= last; ++i)
                            if (texel_at(i, address) == static_cast<int>(texel)) return true;
                        return false;
                    };
                    error.wrong_texels += !is_allowed(argb >> 16 & 255, u) || !is_allowed(argb >> 8 & 255, v);
                }
        }
    }
    return error;
}

std::vector<Row> coordinate_rows() {
    std::vector<Row> rows;
    for (const auto& [depths, what] :
         {std::pair{Depths::Equal, "texture coordinates"}, {Depths::OneToFour, "texture coordinates, w from 1 to 4"}})
        for (const int exponent : {12, 16, 20, kLastExponent}) {
            PositionError worst;
            for (const raster::Address address :
                 {raster::Address::Wrap, raster::Address::Mirror, raster::Address::Clamp}) {
                const PositionError error = position_error(exponent, depths, address);
                worst.texels              = std::max(worst.texels, error.texels);
                worst.wrong_texels += error.wrong_texels;
            }
            rows.push_back(
                {what, "within 2^" + std::to_string(exponent) + " texels; wrap, mirror, clamp",
                 ceil_text(position_bound(exponent, depths), 4) + " texels", ceil_text(worst.texels, 4) + " texels",
                 exponent == kLastExponent ? "2^22 texels: from there on to 2^24 and beyond, the last one is read"
                                           : ""});
        }
    return rows;
}

}  // namespace extremes
