// SPDX-License-Identifier: MIT
#include <tbb/parallel_for.h>

#include <cmath>

#include "pipeline/truth/blur_chain.h"

namespace pipeline::truth {
namespace {

// Weights of the samples `reach` before to `reach` after; their sum is 1.
struct Kernel {
    int reach = 0;
    std::vector<double> weights;
};

Kernel gaussian(double variance, double shift, int per_axis) {
    Kernel kernel{.reach = static_cast<int>(std::ceil((6.0 * std::sqrt(variance) + std::abs(shift)) * per_axis))};
    double sum = 0.0;
    for (int k = -kernel.reach; k <= kernel.reach; ++k) {
        const double distance = static_cast<double>(k) / per_axis - shift;
        kernel.weights.push_back(std::exp(-distance * distance / (2.0 * variance)));
        sum += kernel.weights.back();
    }
    for (double& weight : kernel.weights) weight /= sum;
    return kernel;
}

// Around sample `i`, which is kept within first..end-1; `at(k)` is sample k.
template <class At>
Color weighed(const Kernel& kernel, int i, int first, int end, At at) {
    Color sum(0.0);
    for (int k = -kernel.reach; k <= kernel.reach; ++k)
        sum += kernel.weights[static_cast<std::size_t>(k + kernel.reach)] * at(std::clamp(i + k, first, end - 1));
    return sum;
}

PixelRect in_samples(const PixelRect& pixels, int n) {
    return {pixels.x0 * n, pixels.y0 * n, pixels.x1 * n, pixels.y1 * n};
}

void blur(const BlurChain& chain, const BlurArea& area, const Samples& source, bool has_alpha, Samples& target) {
    const int n          = source.per_axis;
    const PixelRect read = in_samples(area.read, n), written = in_samples(area.written, n);
    const Kernel across = gaussian(chain.variance[0], chain.shift[0], n);
    const Kernel down   = gaussian(chain.variance[1], chain.shift[1], n);

    const int width = written.x1 - written.x0;
    std::vector<Color> rows(static_cast<std::size_t>(read.y1 - read.y0) * static_cast<std::size_t>(width));
    const auto blurred = [&](int column, int row) -> Color& {
        return rows[static_cast<std::size_t>(row - read.y0) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(column - written.x0)];
    };
    tbb::parallel_for(read.y0, read.y1, [&](int row) {
        for (int column = written.x0; column < written.x1; ++column)
            blurred(column, row) =
                weighed(across, column, read.x0, read.x1, [&](int k) { return source.color[source.at(k, row)]; });
    });
    tbb::parallel_for(written.y0, written.y1, [&](int row) {
        for (int column = written.x0; column < written.x1; ++column) {
            Color& to          = target.color[target.at(column, row)];
            const double alpha = to.a;
            to = clamp01(weighed(down, row, read.y0, read.y1, [&](int k) { return blurred(column, k); }));
            if (!has_alpha) to.a = alpha;
        }
    });
}

}  // namespace

void draw_gaussian(const BlurChain& chain, const Samples& source, bool has_alpha, Samples& target) {
    for (const BlurArea& area : chain.areas) blur(chain, area, source, has_alpha, target);
}

}  // namespace pipeline::truth
