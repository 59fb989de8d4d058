// SPDX-License-Identifier: MIT
#include "demo/solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "demo/noise.h"
#include "demo/right_triangles.h"
#include "demo/trigonometry.h"

namespace demo {
namespace {

// Two triangles for each cell of a grid of vertices that starts at `first`: columns run to the right, rows downwards,
// as seen from outside.
void append_grid(SolidMesh& mesh, std::uint32_t first, int columns, int rows) {
    for (int row = 0; row + 1 < rows; ++row) {
        for (int column = 0; column + 1 < columns; ++column) {
            const auto corner = first + static_cast<std::uint32_t>(row * columns + column);
            const auto below  = corner + static_cast<std::uint32_t>(columns);
            for (const std::uint32_t index : {corner, below, below + 1, corner, below + 1, corner + 1})
                mesh.indices.push_back(index);
        }
    }
}

void append_box(SolidMesh& mesh, const Vec3& low, const Vec3& high) {
    constexpr int kPointsAcross = 9;  // so that shadows of clouds can fall across a face
    struct Face {
        Vec3 right, down;  // as seen from outside
    };
    constexpr std::array<Face, 6> kFaces = {{{{1, 0, 0}, {0, -1, 0}},
                                             {{0, 0, -1}, {0, -1, 0}},
                                             {{-1, 0, 0}, {0, -1, 0}},
                                             {{0, 0, 1}, {0, -1, 0}},
                                             {{1, 0, 0}, {0, 0, 1}},
                                             {{1, 0, 0}, {0, 0, -1}}}};
    const Vec3 middle = 0.5f * (low + high), half = 0.5f * (high - low);
    for (const Face& face : kFaces) {
        const Vec3 out   = glm::cross(face.down, face.right);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (int row = 0; row < kPointsAcross; ++row) {
            for (int column = 0; column < kPointsAcross; ++column) {
                const float u = static_cast<float>(2 * column) / (kPointsAcross - 1) - 1.0f;
                const float v = static_cast<float>(2 * row) / (kPointsAcross - 1) - 1.0f;
                const Vec3 p  = middle + half * (out + u * face.right + v * face.down);
                mesh.vertices.push_back({p, out, {glm::dot(p, face.right), glm::dot(p, face.down)}, 1.0f});
            }
        }
        append_grid(mesh, first, kPointsAcross, kPointsAcross);
    }
}

void append_cylinder(SolidMesh& mesh, const Solid& solid) {
    const Vec3 span    = solid.to - solid.from;
    const float length = glm::length(span);
    const Vec3 axis    = span / length;
    const Vec3 side    = glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.7f ? Vec3(1, 0, 0) : Vec3(0, 0, 1)));
    const Vec3 other   = glm::cross(side, axis);
    const float widest = std::max(solid.radius, solid.top_radius);
    const int sides    = widest < 0.2f ? 6 : widest < 0.5f ? 10 : 32;
    const int rows     = std::clamp(static_cast<int>(length / 8.0f), 1, 40) + 1;
    const float slope  = (solid.radius - solid.top_radius) / length;

    const auto around = [&](int column) {
        const double angle = 2.0 * kPi * column / sides;
        return static_cast<float>(cosine(angle)) * side - static_cast<float>(sine(angle)) * other;
    };
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int row = 0; row < rows; ++row) {
        const float along  = 1.0f - static_cast<float>(row) / static_cast<float>(rows - 1);
        const float radius = mix(solid.radius, solid.top_radius, along);
        for (int column = 0; column <= sides; ++column) {
            const Vec3 out = around(column % sides);
            const Vec3 p   = solid.from + along * span + radius * out;
            const float u  = static_cast<float>(2.0 * kPi * column / sides) * widest;
            mesh.vertices.push_back({p, glm::normalize(out + slope * axis), {u, -p.y}, 1.0f});
        }
    }
    append_grid(mesh, first, sides + 1, rows);
    for (const bool top : {false, true}) {
        const Vec3 normal  = top ? axis : -axis;
        const Vec3 center  = top ? solid.to : solid.from;
        const float radius = top ? solid.top_radius : solid.radius;
        if (radius <= 0.0f) continue;
        const auto hub = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back({center, normal, {center.x, center.z}, 1.0f});
        for (int column = 0; column < sides; ++column) {
            const Vec3 p = center + radius * around(column);
            mesh.vertices.push_back({p, normal, {p.x, p.z}, 1.0f});
        }
        for (int column = 0; column < sides; ++column) {
            const auto a = hub + 1 + static_cast<std::uint32_t>(column);
            const auto b = hub + 1 + static_cast<std::uint32_t>((column + 1) % sides);
            for (const std::uint32_t index : {hub, top ? a : b, top ? b : a}) mesh.indices.push_back(index);
        }
    }
}

// A tower of layered rock. In the direction of an angle it reaches a share of its box's half size, by height; beds of
// different hardness step in and out, clefts run down its sides, and it narrows towards a broken top.
struct SpireShape {
    Vec3 low, high;
    std::uint32_t seed, top_seed;

    // Share of the half size reached at `turn` (0..1 around), `height` (0 foot .. 1 top); cleft: 0..1.
    float reach(float turn, float height, float& cleft) const {
        const float y     = low.y + height * (high.y - low.y);
        const float width = std::min(high.x - low.x, high.z - low.z);
        const float bed_y = y / std::max(0.3f * width, 1.5f) + 0.4f * noise(turn * 4.0f, y / width, seed, {4, 0});
        const auto bed    = static_cast<std::int32_t>(std::floor(bed_y));
        const float into  = bed_y - static_cast<float>(bed);

        // A bed is split into blocks, which stand out or back each by itself.
        constexpr int kBlocks = 9;
        const auto block_in   = [&](std::int32_t in_bed) {
            const float along = turn * kBlocks + hash_unit(in_bed / 3, 1, seed + 1u) +
                                0.3f * noise(turn * 16.0f, y / (0.5f * width), seed + 2u, {16, 0});
            const auto block  = static_cast<std::int32_t>(std::floor(along));
            const float edge  = smooth_step(0.80f, 1.0f, along - static_cast<float>(block));
            const auto stands = [&](std::int32_t i) { return hash_unit((i + kBlocks) % kBlocks, in_bed, seed + 3u); };
            return mix(stands(block), stands(block + 1), edge);
        };
        const float block  = mix(block_in(bed), block_in(bed + 1), smooth_step(0.86f, 1.0f, into));
        const float lobes  = fractal_noise(turn * 4.0f, y / (2.2f * width), 2, seed + 10u, {4, 0});
        const float groove = ridged_noise(turn * 7.0f, y / (3.0f * width), 1, seed + 20u, {7, 0});
        cleft              = smooth_step(0.80f, 1.0f, groove);
        const float chips  = noise(turn * 40.0f, y / (0.09f * width), seed + 30u, {40, 0});
        const float foot   = 0.08f * (1.0f - smooth_step(0.0f, 0.3f, height));
        const float taper  = mix(0.90f, 0.70f, height) - 0.10f * smooth_step(0.88f, 1.0f, height);
        const float share  = taper + foot + 0.15f * lobes + 0.16f * (block - 0.5f) - 0.11f * cleft + 0.02f * chips;
        return std::clamp(share, 0.12f, 1.0f);
    }
};

// A tower's points before some are left out: as many rows as columns, the last column being the first once more. Rows
// count from the middle of the top outwards, then down the side.
struct SpireGrid {
    int cells;
    std::vector<SolidVertex> vertices;
    SolidVertex& at(int column, int row) { return vertices[static_cast<std::size_t>(row * (cells + 1) + column)]; }
    const SolidVertex& at(GridPoint p) const {
        return vertices[static_cast<std::size_t>(p.row * (cells + 1) + p.column)];
    }
};

SpireGrid spire_points(const SpireShape& shape, int cells) {
    const Vec3 low = shape.low, high = shape.high;
    const Vec3 middle = 0.5f * (low + high), half = 0.5f * (high - low);
    const float girth = 3.4f * (half.x + half.z);
    const int cap     = cells / 16;  // rows on the top
    SpireGrid grid{cells, {}};
    grid.vertices.reserve(static_cast<std::size_t>((cells + 1) * (cells + 1)));
    // The seam is at -z, the side turned away from the camera's start; clockwise from above, so rightwards from outside
    // is counter-clockwise.
    std::vector<Vec2> directions;
    for (int column = 0; column <= cells; ++column) {
        const double angle = 2.0 * kPi * (column % cells) / cells;
        directions.emplace_back(static_cast<float>(-sine(angle)), static_cast<float>(-cosine(angle)));
    }
    for (int row = 0; row <= cells; ++row) {
        const float inward = row < cap ? static_cast<float>(row) / static_cast<float>(cap) : 1.0f;
        const float height = row < cap ? 1.0f : 1.0f - static_cast<float>(row - cap) / static_cast<float>(cells - cap);
        for (int column = 0; column <= cells; ++column) {
            const float turn   = static_cast<float>(column % cells) / static_cast<float>(cells);
            const float s      = directions[static_cast<std::size_t>(column)].x,
                        c      = directions[static_cast<std::size_t>(column)].y;
            // From a circle towards a rounded square: 1 / (s^4 + c^4)^(1/4) reaches the corners.
            const float square = 1.0f / std::sqrt(std::sqrt(s * s * s * s + c * c * c * c));
            float cleft        = 0.0f;
            const float reach  = shape.reach(turn, height, cleft) * mix(1.0f, square, 0.7f) * 0.93f;
            const float x      = std::clamp(s * reach, -1.0f, 1.0f) * inward;
            const float z      = std::clamp(c * reach, -1.0f, 1.0f) * inward;
            // The top is broken: some parts have fallen further than others. Nothing rises above the box.
            const float fallen = std::min(0.06f, 0.35f * std::min(half.x, half.z) / (high.y - low.y)) *
                                 (1.0f + noise(x * 1.9f + 7.3f, z * 1.9f, shape.top_seed)) *
                                 smooth_step(0.75f, 1.0f, height);
            const float y = low.y + (high.y - low.y) * (height - fallen * height);
            const Vec3 p(middle.x + half.x * x, y, middle.z + half.z * z);
            const float u = girth * static_cast<float>(column) / static_cast<float>(cells);
            grid.vertices.push_back(
                {p, Vec3(0.0f), {u, -p.y - 0.5f * (1.0f - inward) * half.x}, 1.0f - 0.6f * cleft * inward});
        }
    }
    return grid;
}

// Normals: the sum of the faces around, weighted by area; both sides of the seam are one vertex.
void set_normals(SpireGrid& grid) {
    const auto add_face = [](SolidVertex& a, SolidVertex& b, SolidVertex& c) {
        const Vec3 face = glm::cross(b.position - a.position, c.position - a.position);
        for (SolidVertex* vertex : {&a, &b, &c}) vertex->normal += face;
    };
    for (int row = 0; row < grid.cells; ++row)
        for (int column = 0; column < grid.cells; ++column) {
            SolidVertex &corner = grid.at(column, row), &across = grid.at(column + 1, row + 1);
            add_face(corner, grid.at(column, row + 1), across);
            add_face(corner, across, grid.at(column + 1, row));
        }
    for (int row = 0; row <= grid.cells; ++row) {
        SolidVertex &left = grid.at(0, row), &right = grid.at(grid.cells, row);
        left.normal = right.normal = left.normal + right.normal;
    }
    for (SolidVertex& vertex : grid.vertices) {
        const float length = glm::length(vertex.normal);
        vertex.normal      = length > 1e-12f ? vertex.normal / length : Vec3(0.0f, 1.0f, 0.0f);
    }
}

void append_spire(SolidMesh& mesh, const Solid& solid, const Vec3& low, const Vec3& high) {
    const float width  = std::min(high.x - low.x, high.z - low.z);
    const float around = 1.7f * (high.x - low.x + high.z - low.z);
    SpireGrid grid     = spire_points({low, high, solid.seed * 1009u, solid.seed + 40u}, around < 60.0f ? 64 : 128);
    set_normals(grid);

    // What may be left out: bumps, which show in the outline, by the tower's width, and turns of the surface, which
    // show in its shading, where they are large enough to be seen.
    const float tolerance_m = 0.016f * width, longest_m = std::max(0.5f * width, 4.0f);
    const auto middle_error = [&](GridPoint a, GridPoint b, GridPoint m) {
        const SolidVertex &from = grid.at(a), &to = grid.at(b), &middle = grid.at(m);
        const float edge = glm::length(to.position - from.position);
        const float bump = glm::length(middle.position - 0.5f * (from.position + to.position));
        const float turn = glm::length(middle.normal - 0.5f * (from.normal + to.normal));
        return std::max({bump / tolerance_m, edge / longest_m, turn * edge / (0.12f * width)});
    };
    const TriangleMesh kept = halve_right_triangles(grid.cells, true, middle_error);
    const auto first        = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const std::uint32_t point : kept.points) mesh.vertices.push_back(grid.vertices[point]);
    for (const auto& triangle : kept.triangles)
        for (const std::uint32_t corner : triangle) mesh.indices.push_back(first + corner);
}

}  // namespace

SolidMesh solid_mesh(const Solid& solid) {
    const Vec3 low = glm::min(solid.from, solid.to), high = glm::max(solid.from, solid.to);
    SolidMesh mesh;
    switch (solid.kind) {
        case Solid::Kind::Box:
            append_box(mesh, low, high);
            break;
        case Solid::Kind::Cylinder:
            append_cylinder(mesh, solid);
            break;
        case Solid::Kind::Spire:
            append_spire(mesh, solid, low, high);
            break;
    }
    return mesh;
}

std::vector<ShadowColumn> shadow_columns(const Solid& solid) {
    const Vec3 low = glm::min(solid.from, solid.to), high = glm::max(solid.from, solid.to);
    const Vec3 foot              = Vec3(0.5f * (low.x + high.x), low.y, 0.5f * (low.z + high.z));
    const Vec3 half              = 0.5f * (high - low);
    constexpr float kLeastRadius = 1.0f;
    switch (solid.kind) {
        case Solid::Kind::Box:
            // The ellipse of the box's area.
            return {{foot, high.y, 1.13f * half.x, 1.13f * half.z}};
        case Solid::Kind::Spire: {
            // Narrower towards the top.
            const float height = high.y - low.y;
            return {{foot, low.y + 0.5f * height, 0.9f * half.x, 0.9f * half.z},
                    {foot, low.y + 0.9f * height, 0.74f * half.x, 0.74f * half.z}};
        }
        case Solid::Kind::Cylinder: {
            const bool upright = std::max(half.x, half.z) < 0.1f * half.y;
            if (!upright || solid.radius < kLeastRadius) return {};
            return {{foot, high.y, solid.radius, solid.radius}};
        }
    }
    return {};
}

}  // namespace demo
