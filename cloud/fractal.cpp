// SPDX-License-Identifier: MIT
#include "cloud/fractal.h"

#include <algorithm>
#include <map>

#include "cloud/noise.h"
#include "cloud/wide_loops.h"

namespace cloud {
namespace {

using LatticePoint = std::array<int, 3>;

// The point of a cube of size^3 points that a texel of a face lies on; border texels share theirs with other faces.
LatticePoint lattice_point(int face, int column, int row, int size) {
    const int axis = face / 2;
    LatticePoint point{};
    point[static_cast<std::size_t>(axis)]           = face % 2 == 0 ? size - 1 : 0;
    point[static_cast<std::size_t>((axis + 1) % 3)] = column;
    point[static_cast<std::size_t>((axis + 2) % 3)] = row;
    return point;
}

// Raw noise of all faces, one after the other.
std::vector<float> evaluate_noise(const Fractal& fractal, Vec3 box_size, const ForEach& for_each) {
    const int size      = fractal.face_size;
    const float longest = std::max({box_size.x, box_size.y, box_size.z, 1e-6f});
    const Vec3 scale    = box_size / longest * (fractal.cycles / static_cast<float>(std::max(size - 1, 1)));
    std::array<std::vector<float>, 3> coordinates;
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < size; ++i)
            coordinates[static_cast<std::size_t>(axis)].push_back(static_cast<float>(i) * scale[axis]);
    const NoiseLattice lattice(coordinates, fractal.octaves);

    const auto points = static_cast<std::size_t>(size);
    std::vector<float> values(kBoxFaces * points * points);
    for_each(kBoxFaces * points, [&](std::size_t i) {
        const int face = static_cast<int>(i / points), row = static_cast<int>(i % points);
        const LatticePoint start = lattice_point(face, 0, row, size);
        const NoiseLattice::Point point{static_cast<std::size_t>(start[0]), static_cast<std::size_t>(start[1]),
                                        static_cast<std::size_t>(start[2])};
        const auto along               = static_cast<std::size_t>((face / 2 + 1) % 3);
        const std::vector<float> noise = fractal.noise == Noise::Billow
                                             ? lattice.billow_row(along, point, fractal.gain, fractal.seed)
                                             : lattice.fbm_row(along, point, fractal.gain, fractal.seed);
        std::copy(noise.begin(), noise.end(), values.begin() + static_cast<std::ptrdiff_t>(i * points));
    });
    return values;
}

std::uint8_t encode(float n, FractalCode code) {
    if (code == FractalCode::Half) return static_cast<std::uint8_t>(std::min(n * 128.0f, 127.0f));
    return static_cast<std::uint8_t>(std::min(0.6f + 0.8f * n, 1.0f) * 255.0f + 0.5f);
}

// The code of the share of values below each: 0..1, evenly spread. Equal values stay equal.
std::vector<std::uint8_t> equalize(const std::vector<float>& values, FractalCode code) {
    constexpr std::uint32_t kBins = 4096;
    const auto [low, high]        = std::minmax_element(values.begin(), values.end());
    const float lowest = *low, range = *high - *low;
    if (!(range > 0.0f)) return std::vector<std::uint8_t>(values.size(), encode(0.5f, code));
    std::vector<std::uint16_t> bins(values.size());
    with_wide_loops([&] {
        for (std::size_t i = 0; i < bins.size(); ++i) {
            const auto bin = static_cast<std::int32_t>((values[i] - lowest) / range * static_cast<float>(kBins));
            bins[i] = static_cast<std::uint16_t>(std::min<std::uint32_t>(static_cast<std::uint32_t>(bin), kBins - 1));
        }
    });
    std::vector<std::uint32_t> counts(kBins, 0);
    for (const std::uint16_t bin : bins) ++counts[bin];
    std::array<std::uint8_t, kBins> codes;
    double below = 0.0;
    for (std::size_t bin = 0; bin < kBins; ++bin) {
        const double in_bin = counts[bin], share = (below + 0.5 * in_bin) / static_cast<double>(values.size());
        codes[bin] = encode(static_cast<float>(share), code);
        below += in_bin;
    }
    std::vector<std::uint8_t> texels(values.size());
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = codes[bins[i]];
    return texels;
}

std::vector<std::uint8_t> halve(const std::vector<std::uint8_t>& fine, int fine_size) {
    const int size = fine_size / 2;
    std::vector<std::uint8_t> coarse;
    coarse.reserve(static_cast<std::size_t>(size) * size);
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            const std::size_t at = static_cast<std::size_t>(2 * row) * fine_size + 2 * column;
            const int sum        = fine[at] + fine[at + 1] + fine[at + fine_size] + fine[at + fine_size + 1];
            coarse.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
        }
    return coarse;
}

// Gives all texels that lie on one point of the lattice their mean.
void join_borders(FractalFaces& faces, int size) {
    struct Shared {
        int sum = 0, count = 0;
    };
    std::map<LatticePoint, Shared> shared;
    const auto for_each_border_texel = [&](auto&& visit) {
        for (int face = 0; face < kBoxFaces; ++face)
            for (int row = 0; row < size; ++row) {
                const bool whole_row = row == 0 || row == size - 1;
                for (int column = 0; column < size; column += whole_row ? 1 : std::max(size - 1, 1))
                    visit(shared[lattice_point(face, column, row, size)],
                          faces[static_cast<std::size_t>(face)][static_cast<std::size_t>(row) * size + column]);
            }
    };
    for_each_border_texel([](Shared& point, std::uint8_t texel) {
        point.sum += texel;
        ++point.count;
    });
    for_each_border_texel([](Shared& point, std::uint8_t& texel) {
        texel = static_cast<std::uint8_t>((2 * point.sum + point.count) / (2 * point.count));
    });
}

}  // namespace

int fractal_levels(int face_size) {
    int levels = 1;
    for (; face_size > 1; face_size /= 2) ++levels;
    return levels;
}

FractalFaces make_fractal(const Fractal& fractal, Vec3 box_size, FractalCode code, const ForEach& for_each) {
    const std::vector<std::uint8_t> finest = equalize(evaluate_noise(fractal, box_size, for_each), code);
    const std::ptrdiff_t texels            = static_cast<std::ptrdiff_t>(fractal.face_size) * fractal.face_size;
    FractalFaces level, all;
    for (std::size_t face = 0; face < level.size(); ++face) {
        const auto first = finest.begin() + static_cast<std::ptrdiff_t>(face) * texels;
        level[face].assign(first, first + texels);
        all[face].reserve(level[face].size() * 4 / 3 + 1);
    }
    for (int size = fractal.face_size;; size /= 2) {
        for (std::size_t face = 0; face < level.size(); ++face)
            all[face].insert(all[face].end(), level[face].begin(), level[face].end());
        if (size <= 1) return all;
        for (std::vector<std::uint8_t>& texels_of_face : level) texels_of_face = halve(texels_of_face, size);
        join_borders(level, size / 2);
    }
}

}  // namespace cloud
