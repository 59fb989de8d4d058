// SPDX-License-Identifier: MIT
#include "tests/extremes/positions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <random>
#include <utility>

#include "pipeline/execute/clip.h"
#include "pipeline/execute/window_triangles.h"
#include "pipeline/frame/field_traits.h"
#include "pipeline/validate/validate.h"
#include "raster/primitives.h"
#include "tests/support/one_pass_frame.h"

namespace extremes {

using namespace pipeline;

namespace {

constexpr int kTarget = 64;

void set_projection(Frame& frame, double near, double far) {
    Mat4& projection = frame.cameras[0].projection;
    projection       = Mat4(0.0f);
    projection[0][0] = projection[1][1] = 2.0f;
    projection[2][2]                    = static_cast<float>(far / (near - far));
    projection[3][2]                    = static_cast<float>(near * far / (near - far));
    projection[2][3]                    = -1.0f;
}

class WildNumbers {
  public:
    explicit WildNumbers(std::uint32_t seed) : bits_(seed) {}

    float coordinate() {
        const std::uint32_t kind = bits_() % 16;
        if (kind == 0) return 0.0f;
        if (kind == 1) last_ = std::nextafter(last_, 1e38f);
        if (kind == 2) last_ = -last_;
        if (kind > 2) {
            // Few powers of two at a time, so that they do meet.
            const int exponent = kind < 6 ? static_cast<int>(bits_() % 250) - 149 : static_cast<int>(bits_() % 24) - 12;
            const double mantissa = 1.0 + (kind % 2 == 0 ? 0.0 : static_cast<double>(bits_()) / 4294967296.0);
            last_                 = static_cast<float>(std::ldexp(bits_() % 2 == 0 ? mantissa : -mantissa, exponent));
        }
        return last_;
    }

    bool chance() { return bits_() % 2 == 0; }

    // So that the edge passes the origin, where w is 0, as near as floats allow.
    Vec3 opposite(const Vec3& p) {
        const float scale     = std::ldexp(-1.0f, static_cast<int>(bits_() % 61) - 30);
        constexpr float kMost = 0x1p101f;
        Vec3 q                = glm::clamp(p * scale, -kMost, kMost);
        float& nudged         = (&q.x)[bits_() % 3];
        if (chance()) nudged = std::nextafter(nudged, chance() ? 1e38f : -1e38f);
        return q;
    }

  private:
    std::mt19937 bits_;
    float last_ = 1.0f;
};

void add_window_vertices(const Frame& frame, WildVertices& found) {
    const Pass& pass = frame.passes[0];
    const WindowMesh mesh =
        to_window_triangles(frame, pass, std::get<DrawTriangles>(pass.draws[0]), {0, 0, kTarget, kTarget}, 4096.0f);
    found.triangles += mesh.indices.size() / 3;
    found.vertices += mesh.vertices.size();
    // One at a time, as validate stops at the first.
    Frame window = test_support::one_pass_frame(kTarget, kTarget);
    window.window_vertices.resize(1);
    for (const WindowVertex& vertex : mesh.vertices) {
        window.window_vertices[0] = vertex;
        found.invalid += !validate(window).empty();
        found.greatest_rhw = std::max(found.greatest_rhw, double{vertex.rhw});
    }
}

// No other plane then cuts off what is near the eye.
void without_depth(Frame& frame) {
    frame.cameras[0].projection[2][2] = frame.cameras[0].projection[3][2] = 0.0f;
}

// A triangle in view, one of whose corners is at `corner`: the first, the second, the third.
template <class Change>
WildVertices with_corner(const Vec3& corner, Change&& change) {
    WildVertices found;
    for (std::size_t which = 0; which < 3; ++which) {
        Frame frame = test_support::one_pass_frame(kTarget, kTarget, TargetFormat::D24);
        set_projection(frame, 1e-3, 1e4);
        change(frame);
        frame.vertices.resize(3);
        const std::array<Vec3, 3> in_view{Vec3(0.1f, 0.0f, -1.0f), Vec3(0.0f, 0.1f, -1.0f), Vec3(-0.1f, -0.1f, -1.0f)};
        for (std::size_t i = 0; i < 3; ++i) frame.vertices[i].position = i == which ? corner : in_view[i];
        frame.indices         = {0, 1, 2};
        frame.passes[0].draws = {DrawTriangles{.index_count = 3, .textures = {}}};
        add_window_vertices(frame, found);
    }
    return found;
}

}  // namespace

Frame wild_frame(std::uint32_t seed, std::uint32_t triangles) {
    Frame frame = test_support::one_pass_frame(kTarget, kTarget, TargetFormat::D24);
    set_projection(frame, 1e-3, 1e4);
    if (seed % 2 == 1) frame.cameras[0].projection[2][2] = frame.cameras[0].projection[3][2] = 0.0f;
    WildNumbers numbers(seed);
    for (std::uint32_t i = 0; i < 3 * triangles; ++i) {
        Vertex& vertex  = frame.vertices.emplace_back();
        vertex.position = i % 3 != 0 && numbers.chance()
                              ? numbers.opposite(frame.vertices[i - 1].position)
                              : Vec3(numbers.coordinate(), numbers.coordinate(), numbers.coordinate());
        vertex.diffuse  = {0xff000000 | i * 2654435761u >> 8};
        vertex.uv0      = {numbers.coordinate(), numbers.coordinate()};
        frame.indices.push_back(i);
    }
    Pass& pass       = frame.passes[0];
    pass.clear.depth = 1.0f;
    pass.state.depth = {CompareFunc::LessEqual, true};
    pass.draws       = {DrawTriangles{.index_count = 3 * triangles, .textures = {}}};
    return frame;
}

WildVertices wild_vertices(std::uint32_t frames) {
    WildVertices found;
    for (std::uint32_t seed = 0; seed < frames; ++seed) add_window_vertices(wild_frame(seed, 1000), found);
    return found;
}

WildVertices corners_next_to_eye() {
    return with_corner(Vec3(0.0f, 0.0f, -0x1p-35f), without_depth);
}

WildVertices corners_at_infinity() {
    return with_corner(Vec3(0x1p101f, 0.0f, -1.0f), [](Frame& frame) { frame.cameras[0].view[0][0] = 0x1p100f; });
}

FarDepth far_depth() {
    constexpr double kNear = 1e-3, kFar = 1e4;
    Frame frame = test_support::one_pass_frame(kTarget, kTarget);
    set_projection(frame, kNear, kFar);
    std::vector<double> distances;
    for (double d = kNear * 1.0001; d < kFar * 0.9999; d *= 1.001) distances.push_back(static_cast<float>(d));
    for (const double d : distances) {
        const auto first = static_cast<std::uint32_t>(frame.vertices.size());
        const auto z     = static_cast<float>(-d);
        for (const auto& [x, y] : {std::pair{-0.5f, -0.5f}, {0.5f, -0.5f}, {0.0f, 0.5f}})
            frame.vertices.emplace_back().position = {x * -z, y * -z, z};
        for (std::uint32_t i = 0; i < 3; ++i) frame.indices.push_back(first + i);
    }
    const DrawTriangles draw{.index_count = static_cast<std::uint32_t>(frame.indices.size()), .textures = {}};
    const WindowMesh mesh = to_window_triangles(frame, frame.passes[0], draw, {0, 0, kTarget, kTarget}, 4096.0f);
    FarDepth depth{.vertices = mesh.indices.size() / 3};
    if (depth.vertices != distances.size()) return {};
    float before = 0.0f;
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const float z      = mesh.vertices[mesh.indices[3 * i]].z;
        const double exact = kFar / (kFar - kNear) * (1.0 - kNear / distances[i]);
        depth.error        = std::max(depth.error, std::abs(z - exact) * 0x1p24);
        depth.out_of_order += z < before;
        before = z;
    }
    constexpr int kBits[3]{16, 24, 32};
    for (int format = 0; format < 3; ++format) {
        const auto stored = [&](std::size_t i) {
            return raster::to_depth_format(raster::depth_value(mesh.vertices[mesh.indices[3 * i]].z), kBits[format]);
        };
        // 1.001^10 is 1.01.
        for (std::size_t i = 0; i + 10 < distances.size() && depth.merges_at[format] == 0.0; ++i)
            if (stored(i) == stored(i + 10)) depth.merges_at[format] = distances[i] / kNear;
    }
    return depth;
}

EyeCorners eye_corners(std::uint32_t triangles) {
    EyeCorners found;
    std::mt19937 bits(1);
    const auto share = [&] { return static_cast<double>(bits()) / 4294967296.0; };
    for (std::uint32_t i = 0; i < triangles; ++i) {
        const auto in    = [&](double size) { return static_cast<float>(size * (2.0 * share() - 1.0)); };
        const auto a     = static_cast<float>(std::ldexp(1.0 + share(), static_cast<int>(bits() % 60) - 10));
        const auto scale = static_cast<float>(std::ldexp(1.0 + share(), static_cast<int>(bits() % 60) - 30));
        const float x = bits() % 2 == 0 ? 0.0f : in(a), y = bits() % 2 == 0 ? 0.0f : in(a);
        std::array<ClipVertex, 3> triangle;
        triangle[0].position         = {x, y, 0.0f, a};
        triangle[1].position         = {-x * scale, -y * scale, 0.0f, -a * scale};
        triangle[2].position         = {in(a), in(a), 0.0f, a};
        const ClippedPolygon polygon = clip_triangle({.gx = 129.0, .gy = 129.0}, triangle);
        for (int corner = 0; corner < polygon.count; ++corner) {
            ++found.corners;
            found.bad += !(polygon.corners[corner].position.w >= kLeastW);
        }
    }
    return found;
}

namespace {

void collect(float& value, std::vector<float*>& floats) {
    floats.push_back(&value);
}
template <glm::length_t N>
void collect(glm::vec<N, float>& value, std::vector<float*>& floats) {
    for (glm::length_t i = 0; i < N; ++i) floats.push_back(&value[i]);
}
void collect(Mat4& value, std::vector<float*>& floats) {
    for (glm::length_t i = 0; i < 4; ++i) collect(value[i], floats);
}
template <class T>
void collect(T& value, std::vector<float*>& floats) {
    if constexpr (FieldStruct<T>) {
        visit_fields(value, [&](std::string_view, auto& field) { collect(field, floats); });
    } else if constexpr (kIsList<T> || kIsArray<T>) {
        for (auto& entry : value) collect(entry, floats);
    } else if constexpr (kIsOptional<T>) {
        if (value) collect(*value, floats);
    } else if constexpr (kIsVariant<T>) {
        std::visit([&](auto& alternative) { collect(alternative, floats); }, value);
    }
}

}  // namespace

NotFinite not_finite() {
    Frame frame      = test_support::one_pass_frame(kTarget, kTarget, TargetFormat::D24);
    Pass& pass       = frame.passes[0];
    pass.clear.depth = 1.0f;
    pass.state.lighting.lights.resize(2);
    frame.vertices.resize(1);
    frame.window_vertices.resize(1);
    pass.draws = {DrawTriangles{}, DrawWindowTriangles{}, DrawRectangle{}};
    NotFinite found;
    if (!validate(frame).empty()) return found;
    std::vector<float*> floats;
    collect(frame, floats);
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (float* const value : floats)
        for (const float bad : {std::numeric_limits<float>::quiet_NaN(), kInfinity, -kInfinity}) {
            const float good = std::exchange(*value, bad);
            ++found.values;
            found.passed += validate(frame).empty();
            *value = good;
        }
    return found;
}

std::vector<Row> position_rows() {
    const WildVertices wild  = wild_vertices(kWildFrames);
    const EyeCorners eye     = eye_corners(kEyeTriangles);
    const NotFinite infinite = not_finite();
    const FarDepth far       = far_depth();
    const auto times         = [](double distance) { return count_text(static_cast<std::uint64_t>(distance)); };
    return {
        {"positions of any size", "0, 2^-149 to 2^101, edges through the eye", "what is drawn is a valid window vertex",
         count_text(wild.invalid) + " invalid of " + count_text(wild.vertices),
         "a triangle is dropped once a clip coordinate is infinite, from 3.4 * 10^38 on"},
        {"edges through the eye", "w from 2^-10 to 2^50 and as far behind", "w >= 2^-32 after clipping",
         count_text(eye.bad) + " less of " + count_text(eye.corners), "1/w ends at 2^32"},
        {"not a number, infinity", "each float of a frame", "refused",
         count_text(infinite.passed) + " pass of " + count_text(infinite.values), "nowhere"},
        {"near : far = 1 : 10^7", "depth at vertices against double", "4.5 * 2^-24",
         ceil_text(far.error, 2) + " * 2^-24",
         "distances 1 % apart merge from " + times(far.merges_at[0]) + " near on in D16, from " +
             times(far.merges_at[1]) + " on in D24 and D32: a vertex's depth is a float"},
    };
}

}  // namespace extremes
