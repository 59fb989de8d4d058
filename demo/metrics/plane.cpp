// SPDX-License-Identifier: MIT
#include "demo/metrics/plane.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace demo {
namespace {

Vec3 color_of(std::uint32_t argb) {
    return Vec3(static_cast<float>(argb >> 16 & 255), static_cast<float>(argb >> 8 & 255),
                static_cast<float>(argb & 255)) /
           255.0f;
}

// The lower envelope of parabolas (x - i)^2 + cost[i]: for each x the i that is lowest there, -1 where all costs are
// infinite.
std::vector<int> lowest_parabolas(const std::vector<double>& cost) {
    const int count = static_cast<int>(cost.size());
    std::vector<int> apex;
    std::vector<double> from;  // where each apex begins to be the lowest
    for (int i = 0; i < count; ++i) {
        const double own = cost[static_cast<std::size_t>(i)];
        if (!std::isfinite(own)) continue;
        double start = -std::numeric_limits<double>::infinity();
        while (!apex.empty()) {
            const double last = apex.back(), other = cost[static_cast<std::size_t>(apex.back())];
            start = ((own + double{1} * i * i) - (other + last * last)) / (2.0 * (i - last));
            if (start > from.back()) break;
            apex.pop_back(), from.pop_back();
            start = -std::numeric_limits<double>::infinity();
        }
        apex.push_back(i), from.push_back(start);
    }
    std::vector<int> lowest(cost.size(), -1);
    std::size_t at = 0;
    for (int x = 0; x < count && !apex.empty(); ++x) {
        while (at + 1 < apex.size() && from[at + 1] <= x) ++at;
        lowest[static_cast<std::size_t>(x)] = apex[at];
    }
    return lowest;
}

}  // namespace

Plane coverage_of(const pipeline::ColorImage& white, const pipeline::ColorImage& black) {
    Plane coverage(white.width, white.height);
    for (std::size_t i = 0; i < coverage.values.size(); ++i) {
        const Vec3 through = color_of(white.pixels[i]) - color_of(black.pixels[i]);
        coverage.values[i] = 1.0f - (through.x + through.y + through.z) / 3.0f;
    }
    return coverage;
}

ColorPlane colors_of(const pipeline::ColorImage& image) {
    ColorPlane colors(image.width, image.height);
    for (std::size_t i = 0; i < colors.values.size(); ++i) colors.values[i] = color_of(image.pixels[i]);
    return colors;
}

Plane alpha_of(const pipeline::ColorImage& image) {
    Plane alpha(image.width, image.height);
    for (std::size_t i = 0; i < alpha.values.size(); ++i)
        alpha.values[i] = static_cast<float>(image.pixels[i] >> 24) / 255.0f;
    return alpha;
}

float luminance(Vec3 color) {
    return 0.299f * color.x + 0.587f * color.y + 0.114f * color.z;
}

Plane luminance_of(const ColorPlane& colors) {
    Plane plane(colors.width, colors.height);
    for (std::size_t i = 0; i < plane.values.size(); ++i) plane.values[i] = luminance(colors.values[i]);
    return plane;
}

float sample(const Plane& plane, float x, float y) {
    x            = std::clamp(x, 0.0f, static_cast<float>(plane.width - 1));
    y            = std::clamp(y, 0.0f, static_cast<float>(plane.height - 1));
    const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
    const int x1 = std::min(x0 + 1, plane.width - 1), y1 = std::min(y0 + 1, plane.height - 1);
    const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
    const float top    = plane.at(x0, y0) * (1.0f - fx) + plane.at(x1, y0) * fx;
    const float bottom = plane.at(x0, y1) * (1.0f - fx) + plane.at(x1, y1) * fx;
    return top * (1.0f - fy) + bottom * fy;
}

Vec2 gradient(const Plane& plane, int x, int y) {
    const auto value = [&](int at_x, int at_y) {
        return plane.at(std::clamp(at_x, 0, plane.width - 1), std::clamp(at_y, 0, plane.height - 1));
    };
    return 0.5f * Vec2(value(x + 1, y) - value(x - 1, y), value(x, y + 1) - value(x, y - 1));
}

Plane smoothed(const Plane& plane, double sigma_px) {
    const int reach = std::max(1, static_cast<int>(std::ceil(3.0 * sigma_px)));
    std::vector<double> weights;
    double sum = 0.0;
    for (int i = -reach; i <= reach; ++i) {
        weights.push_back(std::exp(-0.5 * i * i / (sigma_px * sigma_px)));
        sum += weights.back();
    }
    const auto along = [&](const Plane& from, int dx, int dy) {
        Plane to(from.width, from.height);
        for (int y = 0; y < from.height; ++y)
            for (int x = 0; x < from.width; ++x) {
                double value = 0.0;
                for (int i = -reach; i <= reach; ++i)
                    value += weights[static_cast<std::size_t>(i + reach)] *
                             static_cast<double>(from.at(std::clamp(x + i * dx, 0, from.width - 1),
                                                         std::clamp(y + i * dy, 0, from.height - 1)));
                to.at(x, y) = static_cast<float>(value / sum);
            }
        return to;
    };
    return along(along(plane, 1, 0), 0, 1);
}

Mask edges_of(const Plane& plane, float step) {
    Mask edges(plane.width, plane.height);
    for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x)
            for (const auto& [nx, ny] : {std::pair{x + 1, y}, std::pair{x, y + 1}})
                if (plane.has(nx, ny) && std::abs(plane.at(x, y) - plane.at(nx, ny)) > step)
                    edges.at(x, y) = edges.at(nx, ny) = 1;
    return edges;
}

Nearest nearest_marked(const Mask& mask) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    Nearest nearest{Grid<int>(mask.width, mask.height, -1),
                    Plane(mask.width, mask.height, std::numeric_limits<float>::infinity())};
    // First within columns, then, with these distances as costs, within rows.
    Grid<int> row_of(mask.width, mask.height, -1);
    for (int x = 0; x < mask.width; ++x) {
        std::vector<double> cost;
        for (int y = 0; y < mask.height; ++y) cost.push_back(mask.at(x, y) != 0 ? 0.0 : kNone);
        const std::vector<int> lowest = lowest_parabolas(cost);
        for (int y = 0; y < mask.height; ++y) row_of.at(x, y) = lowest[static_cast<std::size_t>(y)];
    }
    for (int y = 0; y < mask.height; ++y) {
        std::vector<double> cost;
        for (int x = 0; x < mask.width; ++x) {
            const double down = row_of.at(x, y) - y;
            cost.push_back(row_of.at(x, y) < 0 ? kNone : down * down);
        }
        const std::vector<int> lowest = lowest_parabolas(cost);
        for (int x = 0; x < mask.width; ++x) {
            const int column = lowest[static_cast<std::size_t>(x)];
            if (column < 0) continue;
            const double across    = column - x;
            nearest.index.at(x, y) = static_cast<int>(mask.index(column, row_of.at(column, y)));
            nearest.distance.at(x, y) =
                static_cast<float>(std::sqrt(across * across + cost[static_cast<std::size_t>(column)]));
        }
    }
    return nearest;
}

Mask rim_of(const Plane& coverage) {
    Mask rim(coverage.width, coverage.height);
    for (std::size_t i = 0; i < rim.values.size(); ++i)
        rim.values[i] = coverage.values[i] > 0.02f && coverage.values[i] < 0.98f;
    return rim;
}

}  // namespace demo
