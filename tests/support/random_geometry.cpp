// SPDX-License-Identifier: MIT
#include "tests/support/random_geometry.h"

#include <cmath>

namespace test_support {

using namespace pipeline;

namespace {

constexpr float kNear = 0.5f, kFar = 20.0f;

// A little turned and moved, so that a point in camera space is at transpose(rotation) * (point - translation).
Mat4 random_view(Random& random) {
    const float x = random.real(-0.4f, 0.4f), y = random.real(-0.4f, 0.4f), z = random.real(-0.4f, 0.4f);
    const float n = 2.0f / (1.0f + x * x + y * y + z * z);  // quaternion (1, x, y, z)
    Mat4 view(1.0f);
    view[0] = Vec4(1.0f - n * (y * y + z * z), n * (x * y + z), n * (x * z - y), 0.0f);
    view[1] = Vec4(n * (x * y - z), 1.0f - n * (x * x + z * z), n * (y * z + x), 0.0f);
    view[2] = Vec4(n * (x * z + y), n * (y * z - x), 1.0f - n * (x * x + y * y), 0.0f);
    view[3] = {random.real(-2.0f, 2.0f), random.real(-2.0f, 2.0f), random.real(-2.0f, 2.0f), 1.0f};
    return view;
}

Vec3 to_world(const Mat4& view, const Vec3& point) {
    const Vec3 moved(point.x - view[3][0], point.y - view[3][1], point.z - view[3][2]);
    Vec3 world;
    for (int i = 0; i < 3; ++i) world[i] = view[i][0] * moved.x + view[i][1] * moved.y + view[i][2] * moved.z;
    return world;
}

class MeshBuilder {
  public:
    MeshBuilder(Frame& frame, const Camera& camera, Random& random)
        : frame_(frame), camera_(camera), random_(random), is_perspective_(camera.projection[2][3] != 0.0f) {}

    // Seen at (x, y) of the viewport, -1..1, at distance z ahead.
    std::uint32_t vertex(const Vec3& seen) {
        const float x = seen.x, y = seen.y, z = seen.z;
        const float w = is_perspective_ ? z : 1.0f;
        Vertex vertex;
        vertex.position =
            to_world(camera_.view, {x * w / camera_.projection[0][0], y * w / camera_.projection[1][1], z});
        for (int i = 0; i < 3; ++i) vertex.normal[i] = random_.real(-1.0f, 1.0f);
        if (random_.chance(70)) {
            vertex.normal =
                vertex.normal / std::sqrt(vertex.normal.x * vertex.normal.x + vertex.normal.y * vertex.normal.y +
                                          vertex.normal.z * vertex.normal.z + 1e-6f);
        }
        vertex.diffuse.value = random_.bits();
        if (random_.chance(50)) vertex.diffuse.value |= 0xff000000u;
        vertex.specular = {random_.chance(50) ? random_.bits() : 0xff000000u};
        vertex.uv0      = {random_.real(-1.0f, 2.0f), random_.real(-1.0f, 2.0f)};
        vertex.uv1      = Vec2(x * 0.5f + 0.5f, 0.5f - y * 0.5f);
        frame_.vertices.push_back(vertex);
        return static_cast<std::uint32_t>(frame_.vertices.size() - 1);
    }

    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        for (const std::uint32_t index : {a, b, c}) frame_.indices.push_back(index);
    }

    float ahead() { return random_.real(kNear * 1.1f, kFar * 0.5f); }

    // All corners within `reach` of a point in view; depths of their own.
    void around_a_point(float reach) {
        const float x = random_.real(-1.0f, 1.0f), y = random_.real(-1.0f, 1.0f);
        std::uint32_t corners[3];
        for (std::uint32_t& corner : corners) {
            corner = vertex({x + random_.real(-reach, reach), y + random_.real(-reach, reach), ahead()});
        }
        triangle(corners[0], corners[1], corners[2]);
    }

    void sliver() {
        const float x = random_.real(-1.0f, 1.0f), y = random_.real(-1.0f, 1.0f), z = ahead();
        const float dx = random_.real(-2.0f, 2.0f), dy = random_.real(-2.0f, 2.0f);
        const std::uint32_t a = vertex({x, y, z}), b = vertex({x + dx, y + dy, z});
        triangle(a, b, vertex({x + dx * 0.5f + random_.real(-0.01f, 0.01f), y + dy * 0.5f, z}));
    }

    void through_the_near_plane() {
        std::uint32_t corners[3];
        for (std::uint32_t& corner : corners) {
            corner = vertex({random_.real(-1.5f, 1.5f), random_.real(-1.5f, 1.5f), random_.real(-4.0f, 8.0f)});
        }
        triangle(corners[0], corners[1], corners[2]);
    }

    void without_area() {
        const std::uint32_t a = vertex({0.0f, 0.0f, 2.0f}), b = vertex({0.5f, 0.5f, 2.0f});
        triangle(a, b, random_.chance(50) ? a : b);
    }

    // columns x rows cells, each two triangles; every inner edge is shared.
    void patch() {
        const auto columns = static_cast<std::uint32_t>(random_.from(1, 5));
        const auto rows    = static_cast<std::uint32_t>(random_.from(1, 5));
        const float width = random_.real(0.3f, 2.4f), height = random_.real(0.3f, 2.4f);
        const float x0 = random_.real(-1.2f, 0.5f), y0 = random_.real(-1.2f, 0.5f), z = ahead();
        const auto first = static_cast<std::uint32_t>(frame_.vertices.size());
        for (std::uint32_t row = 0; row <= rows; ++row) {
            for (std::uint32_t column = 0; column <= columns; ++column) {
                vertex({x0 + width * (static_cast<float>(column) + random_.real(-0.2f, 0.2f)) /
                                 static_cast<float>(columns),
                        y0 + height * (static_cast<float>(row) + random_.real(-0.2f, 0.2f)) / static_cast<float>(rows),
                        z + random_.real(0.0f, 1.0f)});
            }
        }
        for (std::uint32_t row = 0; row < rows; ++row) {
            for (std::uint32_t column = 0; column < columns; ++column) {
                const std::uint32_t a = first + row * (columns + 1) + column, b = a + columns + 1;
                triangle(a, b, a + 1);
                triangle(a + 1, b, b + 1);
            }
        }
    }

  private:
    Frame& frame_;
    const Camera& camera_;
    Random& random_;
    bool is_perspective_;
};

}  // namespace

Camera random_camera(Random& random) {
    Camera camera;
    camera.view = random_view(random);
    Mat4& p     = camera.projection;
    if (random.chance(75)) {
        p[0][0] = random.real(0.7f, 2.5f);
        p[1][1] = random.real(0.7f, 2.5f);
        p[2][2] = kFar / (kFar - kNear);
        p[2][3] = 1.0f;
        p[3][2] = -kNear * kFar / (kFar - kNear);
        p[3][3] = 0.0f;
    } else {
        p[0][0] = random.real(0.1f, 0.5f);
        p[1][1] = random.real(0.1f, 0.5f);
        p[2][2] = 1.0f / (kFar - kNear);
        p[3][2] = -kNear / (kFar - kNear);
    }
    return camera;
}

DrawTriangles append_triangles(Frame& frame, const Camera& camera, Random& random) {
    DrawTriangles draw;
    draw.first_index = static_cast<std::uint32_t>(frame.indices.size());
    MeshBuilder mesh(frame, camera, random);
    const int parts = random.chance(5) ? 0 : random.from(1, 6);
    for (int i = 0; i < parts; ++i) {
        switch (random.from(0, 9)) {
            case 0:
            case 1:
            case 2:
                mesh.around_a_point(0.8f);
                break;
            case 3:
                mesh.around_a_point(0.05f);
                break;
            case 4:
                mesh.around_a_point(random.one_of({20.0f, 300.0f, 5000.0f}));
                break;
            case 5:
                mesh.sliver();
                break;
            case 6:
                mesh.through_the_near_plane();
                break;
            case 7:
                mesh.without_area();
                break;
            default:
                mesh.patch();
                break;
        }
    }
    draw.index_count = static_cast<std::uint32_t>(frame.indices.size()) - draw.first_index;
    return draw;
}

}  // namespace test_support
