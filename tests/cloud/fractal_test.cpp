// SPDX-License-Identifier: MIT
#include "cloud/fractal.h"

#include <catch2/catch.hpp>
#include <numeric>

using namespace cloud;

namespace {

// The texel of a face that lies on a point of the box's lattice: on the faces of axis a, u runs along a+1, v along a+2.
std::uint8_t texel_at(const FractalFaces& faces, int face, std::array<int, 3> point, int size, std::size_t offset) {
    const std::size_t u = static_cast<std::size_t>((face / 2 + 1) % 3),
                      v = static_cast<std::size_t>((face / 2 + 2) % 3);
    return faces[static_cast<std::size_t>(face)][offset + static_cast<std::size_t>(point[v] * size + point[u])];
}

double mean(const FractalFaces& faces, std::size_t texels) {
    double sum = 0.0;
    for (const auto& face : faces) sum = std::accumulate(face.begin(), face.begin() + static_cast<long>(texels), sum);
    return sum / (static_cast<double>(texels) * kBoxFaces);
}

}  // namespace

TEST_CASE("faces that share an edge have the same bytes along it, in every mip level") {
    Fractal fractal{.face_size = 64, .cycles = 7.0f};
    fractal.noise = GENERATE(Noise::Fbm, Noise::Billow);
    const FractalFaces faces =
        make_fractal(fractal, Vec3(104.0f, 56.0f, 68.0f), GENERATE(FractalCode::Half, FractalCode::Factor));
    std::size_t offset = 0;
    int edges_compared = 0;
    for (int size = 64; size >= 1; offset += static_cast<std::size_t>(size * size), size /= 2)
        for (int a = 0; a < kBoxFaces; ++a)
            for (int b = a + 1; b < kBoxFaces; ++b) {
                if (a / 2 == b / 2) continue;
                const int along = 3 - a / 2 - b / 2;
                std::array<int, 3> point{};
                point[static_cast<std::size_t>(a / 2)] = a % 2 == 0 ? size - 1 : 0;
                point[static_cast<std::size_t>(b / 2)] = b % 2 == 0 ? size - 1 : 0;
                for (int i = 0; i < size; ++i) {
                    point[static_cast<std::size_t>(along)] = i;
                    REQUIRE(texel_at(faces, a, point, size, offset) == texel_at(faces, b, point, size, offset));
                }
                ++edges_compared;
            }
    CHECK(edges_compared == 12 * fractal_levels(64));
    for (const auto& face : faces) CHECK(face.size() == offset);
}

TEST_CASE("the fractal is spread evenly: mean one half, and half of the multiplying texels are 1") {
    Fractal fractal;
    fractal.noise            = GENERATE(Noise::Fbm, Noise::Billow);
    const std::size_t texels = 256 * 256;
    const FractalFaces half  = make_fractal(fractal, Vec3(2.0f, 1.0f, 1.0f), FractalCode::Half);
    CHECK(mean(half, texels) == Approx(63.5).margin(0.5));
    for (const auto& face : half)
        for (std::uint8_t texel : face) REQUIRE(texel <= 127);

    const FractalFaces factor = make_fractal(fractal, Vec3(2.0f, 1.0f, 1.0f), FractalCode::Factor);
    std::size_t ones = 0, low = 255;
    for (const auto& face : factor)
        for (std::size_t i = 0; i < texels; ++i) ones += face[i] == 255, low = std::min<std::size_t>(low, face[i]);
    CHECK(static_cast<double>(ones) / (6.0 * texels) == Approx(0.5).margin(0.01));
    CHECK(low == 153);  // 0.6
}

TEST_CASE("a fractal of one texel, and one without any variation, are mid grey") {
    CHECK(make_fractal({.face_size = 1}, Vec3(1.0f), FractalCode::Half)[0] == std::vector<std::uint8_t>{64});
    CHECK(make_fractal({.face_size = 2, .cycles = 1e-30f}, Vec3(1.0f), FractalCode::Half)[3] ==
          std::vector<std::uint8_t>{64, 64, 64, 64, 64});
}
