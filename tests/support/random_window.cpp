// SPDX-License-Identifier: MIT
#include "tests/support/random_window.h"

namespace test_support {

using namespace pipeline;

namespace {

class WindowMeshBuilder {
  public:
    WindowMeshBuilder(Frame& frame, int width, int height, Random& random)
        : frame_(frame), width_(static_cast<float>(width)), height_(static_cast<float>(height)), random_(random) {}

    std::uint32_t vertex(const Vec2& place) {
        const float least = -kMost, x = place.x < least ? least : place.x, y = place.y < least ? least : place.y;
        const float rhw = random_.chance(40) ? 1.0f : random_.real(0.05f, 2.0f);
        WindowVertex vertex{.x       = x > kMost ? kMost : x,
                            .y       = y > kMost ? kMost : y,
                            .z       = random_.chance(20) ? random_.one_of({0.0f, 1.0f}) : random_.real(0.0f, 1.0f),
                            .rhw     = rhw,
                            .diffuse = {random_.bits()}};
        if (random_.chance(50)) vertex.diffuse.value |= 0xff000000u;
        if (random_.chance(50)) vertex.specular = {random_.bits()};
        vertex.uv0 = coordinates();
        vertex.uv1 = coordinates();
        frame_.window_vertices.push_back(vertex);
        return static_cast<std::uint32_t>(frame_.window_vertices.size() - 1);
    }

    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        for (const std::uint32_t index : {a, b, c}) frame_.indices.push_back(index);
    }

    // All corners within `reach` pixels of a point of the target.
    void around_a_point(float reach) {
        const Vec2 point = somewhere();
        std::uint32_t corners[3];
        for (std::uint32_t& corner : corners) {
            const float x = point.x + random_.real(-reach, reach), y = point.y + random_.real(-reach, reach);
            corner = vertex({x, y});
        }
        triangle(corners[0], corners[1], corners[2]);
    }

    void sliver() {
        const Vec2 from = somewhere(), to = somewhere();
        const std::uint32_t a = vertex(from), b = vertex(to);
        triangle(a, b, vertex((from + to) * 0.5f + Vec2(random_.real(-0.2f, 0.2f), 0.0f)));
    }

    void without_area() {
        const Vec2 from = somewhere(), to = somewhere();
        const std::uint32_t a = vertex(from), b = vertex(to);
        triangle(a, b, random_.chance(50) ? a : b);
    }

    // Corners at pixels' corners and centres, so that edges run through sample points; two triangles share an edge.
    void on_the_grid() {
        const auto half = [&](float size) {
            return static_cast<float>(random_.from(-8, static_cast<int>(size) + 8)) * 0.5f;
        };
        const auto place = [&] {
            const float x = half(2.0f * width_);
            return Vec2(x, half(2.0f * height_));
        };
        const std::uint32_t a = vertex(place()), b = vertex(place()), c = vertex(place()), d = vertex(place());
        triangle(a, b, c);
        triangle(c, b, d);
    }

  private:
    static constexpr auto kMost = static_cast<float>(kMaxWindowCoordinate);

    Vec2 somewhere() {
        const float x = random_.real(-0.2f, 1.2f) * width_;
        return {x, random_.real(-0.2f, 1.2f) * height_};
    }

    // (s, t, q): q is 1, another divisor, or what crosses zero within a triangle.
    Vec3 coordinates() {
        const float u = random_.real(-1.0f, 2.0f), v = random_.real(-1.0f, 2.0f);
        if (random_.chance(60)) return {u, v, 1.0f};
        const float q = random_.chance(80) ? random_.real(0.2f, 4.0f) : random_.real(-1.0f, 1.0f);
        return {u * q, v * q, q};
    }

    Frame& frame_;
    float width_, height_;
    Random& random_;
};

}  // namespace

DrawWindowTriangles append_window_triangles(Frame& frame, int width, int height, Random& random) {
    DrawWindowTriangles draw;
    draw.first_index = static_cast<std::uint32_t>(frame.indices.size());
    WindowMeshBuilder mesh(frame, width, height, random);
    const int parts = random.chance(5) ? 0 : random.from(1, 6);
    for (int i = 0; i < parts; ++i) {
        switch (random.from(0, 8)) {
            case 0:
            case 1:
            case 2:
                mesh.around_a_point(40.0f);
                break;
            case 3:
                mesh.around_a_point(2.0f);
                break;
            case 4:
                mesh.around_a_point(random.one_of({1000.0f, 6000.0f, 20000.0f}));
                break;
            case 5:
                mesh.sliver();
                break;
            case 6:
                mesh.without_area();
                break;
            default:
                mesh.on_the_grid();
                break;
        }
    }
    draw.index_count = static_cast<std::uint32_t>(frame.indices.size()) - draw.first_index;
    return draw;
}

}  // namespace test_support
