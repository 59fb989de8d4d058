// SPDX-License-Identifier: MIT
#include "tests/extremes/coverage.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "pipeline/execute/execute.h"
#include "pipeline/profile/profile.h"
#include "raster/fill_pass.h"
#include "tests/support/one_pass_frame.h"

namespace extremes {

using namespace pipeline;

namespace {

constexpr int kFanTarget = 32;

class Random {
  public:
    explicit Random(std::uint32_t seed) : bits_(seed) {}
    double in(double least, double greatest) {
        return least + (greatest - least) * (static_cast<double>(bits_()) / 4294967296.0);
    }

  private:
    std::mt19937 bits_;
};

// Places on a square's rim, in order: 0..4, from its top left corner on, clockwise on the screen.
std::vector<double> random_rim(Random& random, std::size_t count) {
    std::vector<double> places{0.0, 1.0, 2.0, 3.0};
    while (places.size() < count) places.push_back(random.in(0.0, 4.0));
    std::sort(places.begin(), places.end());
    return places;
}
struct Point {
    double x = 0.0, y = 0.0;
};
// Of the square from (-1, -1) to (1, 1), y down.
Point on_rim(double place) {
    const int side     = static_cast<int>(place);
    const double along = 2.0 * (place - side) - 1.0;
    const Point starts[4]{{along, -1.0}, {1.0, along}, {-along, 1.0}, {-1.0, -along}};
    return starts[side];
}

void add_fan_indices(Frame& frame, std::uint32_t rim) {
    for (std::uint32_t i = 0; i < rim; ++i) {
        const std::uint32_t corners[3]{0, 1 + i, 1 + (i + 1) % rim};
        frame.indices.insert(frame.indices.end(), std::begin(corners), std::end(corners));
    }
}

float to_grid(double pixels) {
    return static_cast<float>(std::nearbyint(pixels * 16.0) / 16.0);
}

// On the subpixel grid.
void add_window_fan(Frame& frame, Point hub, Random& random) {
    frame.window_vertices.push_back({.x = static_cast<float>(hub.x), .y = static_cast<float>(hub.y)});
    const double half = random.in(40.0, 300.0);
    for (const double place : random_rim(random, 24)) {
        const Point p = on_rim(place);
        frame.window_vertices.push_back({.x = to_grid(hub.x + half * p.x), .y = to_grid(hub.y + half * p.y)});
    }
    add_fan_indices(frame, 24);
}

// Far beyond the guard band, and off the grid.
void add_far_fan(Frame& frame, Point hub, Random& random, std::uint32_t triangles) {
    const auto add = [&](double x, double y) {
        const double half = kFanTarget / 2.0;
        Vertex& vertex    = frame.vertices.emplace_back();
        vertex.position   = {static_cast<float>(x / half - 1.0), static_cast<float>(1.0 - y / half), 0.5f};
    };
    add(hub.x, hub.y);
    const double half = std::exp2(random.in(12.5, 24.0));
    for (const double place : random_rim(random, triangles))
        add(hub.x + half * on_rim(place).x, hub.y + half * on_rim(place).y);
    add_fan_indices(frame, triangles);
}

// On a slope that the eye sees all of its picture filled with, and that goes on behind the eye: z = -5 + 2y in camera space,
// with x/-z and y/-z within +-0.4 on the screen.
void add_sloping_fan(Frame& frame, Point hub, Random& random) {
    constexpr double kTangent = 0.4, kNear = 0.01, kFar = 1e6;
    Mat4& projection = frame.cameras[0].projection;
    projection       = Mat4(0.0f);
    projection[0][0] = projection[1][1] = static_cast<float>(1.0 / kTangent);
    projection[2][2]                    = static_cast<float>(kFar / (kNear - kFar));
    projection[3][2]                    = static_cast<float>(kNear * kFar / (kNear - kFar));
    projection[2][3]                    = -1.0f;
    const auto add                      = [&](double x, double y) {
        frame.vertices.emplace_back().position = {static_cast<float>(x), static_cast<float>(y),
                                                  static_cast<float>(-5.0 + 2.0 * y)};
    };
    const double half   = kFanTarget / 2.0;
    const double seen_x = (hub.x / half - 1.0) * kTangent, seen_y = (1.0 - hub.y / half) * kTangent;
    const double y = 5.0 * seen_y / (1.0 + 2.0 * seen_y), distance = 5.0 - 2.0 * y;
    add(seen_x * distance, y);
    // Up to y = 100 and more: behind the eye from y = 2.5 on. Clockwise on the screen, y up here.
    const double reach = std::exp2(random.in(7.0, 16.0));
    for (const double place : random_rim(random, 24)) add(reach * on_rim(place).x, -reach * on_rim(place).y);
    add_fan_indices(frame, 24);
}

}  // namespace

std::vector<Arithmetic> grids() {
    std::vector<Arithmetic> grids;
    for (const Profile& profile : profiles()) {
        Arithmetic grid;
        grid.snap         = profile.arithmetic.snap;
        grid.pixel_center = profile.arithmetic.pixel_center;
        if (std::find(grids.begin(), grids.end(), grid) == grids.end()) grids.push_back(grid);
    }
    return grids;
}

Frame counting_frame(int width, int height, const Arithmetic& grid) {
    Frame frame          = test_support::one_pass_frame(width, height);
    frame.arithmetic     = grid;
    PipelineState& state = frame.passes[0].state;
    state.cull           = CullMode::CounterClockwise;
    state.texture_factor = {0x00010000};
    state.blend          = {.source = BlendFactor::One, .dest = BlendFactor::One};
    state.stages[0]      = {.color_op   = TextureOp::SelectArg1,
                            .color_arg1 = {.source = ArgSource::TFactor},
                            .alpha_op   = TextureOp::SelectArg1,
                            .alpha_arg1 = {.source = ArgSource::TFactor}};
    return frame;
}

void count_with(Frame& frame) {
    const auto count = static_cast<std::uint32_t>(frame.indices.size());
    if (frame.window_vertices.empty())
        frame.passes[0].draws = {DrawTriangles{.index_count = count, .textures = {}}};
    else
        frame.passes[0].draws = {DrawWindowTriangles{.index_count = count, .textures = {}}};
    Pass& others                = frame.passes.emplace_back(Pass(frame.passes[0]));
    others.state.cull           = CullMode::Clockwise;
    others.state.texture_factor = {0x00000100};
}

Hits hits_of(const Frame& frame, const PixelRect& covered) {
    const ColorImage image = execute(frame).output;
    Hits hits{.pixels = image.pixels.size()};
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const std::uint32_t pixel     = image.pixels[static_cast<std::size_t>(y * image.width + x)];
            const std::uint32_t clockwise = pixel >> 16 & 255, others = pixel >> 8 & 255;
            const bool is_covered =
                covered == PixelRect{} || (x >= covered.x0 && x < covered.x1 && y >= covered.y0 && y < covered.y1);
            hits.wrong += clockwise != others + is_covered;
            hits.twice += others != 0;
        }
    return hits;
}

Frame random_fan(Cut cut, const Arithmetic& grid, int phase_x, int phase_y, std::uint32_t seed) {
    Random random(seed * 256 + static_cast<std::uint32_t>(phase_y * 16 + phase_x));
    Frame frame = counting_frame(kFanTarget, kFanTarget, grid);
    const Point hub{std::floor(random.in(0, kFanTarget)) + phase_x / 16.0,
                    std::floor(random.in(0, kFanTarget)) + phase_y / 16.0};
    switch (cut) {
        case Cut::Nothing:
            add_window_fan(frame, hub, random);
            break;
        case Cut::GuardBand:
            add_far_fan(frame, hub, random, 24);
            break;
        case Cut::NearPlane:
            add_sloping_fan(frame, hub, random);
            break;
    }
    count_with(frame);
    return frame;
}

Hits fan_hits(Cut cut, const Arithmetic& grid, std::uint32_t fans_per_phase) {
    Hits hits;
    for (std::uint32_t fan = 0; fan < fans_per_phase; ++fan)
        for (int phase = 0; phase < 256; ++phase) hits += hits_of(random_fan(cut, grid, phase % 16, phase / 16, fan));
    return hits;
}

Hits rectangle_hits(const Arithmetic& grid) {
    constexpr int kSide = 8;
    Hits hits;
    for (int phase = 0; phase < 16; ++phase) {
        Frame frame     = counting_frame(kSide, kSide, grid);
        const auto ends = [](float first) { return std::array{-1.0f, first, first + 0.0625f, kSide + 1.0f}; };
        const auto x    = ends(3.0f + static_cast<float>(phase) / 16.0f),
                   y    = ends(5.0f - static_cast<float>(phase) / 16.0f);
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 3; ++column) {
                DrawRectangle part;
                part.x0 = x[column], part.x1 = x[column + 1];
                part.y0 = y[row], part.y1 = y[row + 1];
                frame.passes[0].draws.emplace_back(part);
            }
        for (const std::uint32_t pixel : execute(frame).output.pixels) {
            ++hits.pixels;
            hits.wrong += (pixel >> 16 & 255) != 1;
        }
    }
    return hits;
}

Hits million_hits() {
    constexpr std::uint32_t kTriangles = 1000000;
    Frame frame                        = counting_frame(128, 128, {});
    frame.window_vertices.push_back({.x = 64.0f + 5 / 16.0f, .y = 64.0f + 11 / 16.0f});
    for (std::uint32_t i = 0; i < kTriangles; ++i) {
        const Point p = on_rim(4.0 * i / kTriangles);
        frame.window_vertices.push_back({.x = to_grid(16384.0 * p.x), .y = to_grid(16384.0 * p.y)});
    }
    add_fan_indices(frame, kTriangles);
    count_with(frame);
    return hits_of(frame);
}

Hits fine_hits() {
    Hits hits;
    for (const Arithmetic& grid : grids()) {
        Random random(5);
        Frame frame = counting_frame(kFanTarget, kFanTarget, grid);
        add_far_fan(frame, {13.3, 17.7}, random, 50000);
        count_with(frame);
        hits += hits_of(frame);
    }
    return hits;
}

Hits mesh_hits(int exponent) {
    constexpr std::uint32_t kCells = 64, kCorners = kCells + 1;
    constexpr int kTarget = 64;
    const double side     = std::exp2(exponent);
    Frame frame           = counting_frame(kTarget, kTarget, {});
    for (std::uint32_t row = 0; row < kCorners; ++row)
        for (std::uint32_t column = 0; column < kCorners; ++column) {
            const auto clip = [&](std::uint32_t i) {
                return static_cast<float>((i - kCells / 2.0) * side / (kTarget / 2.0));
            };
            frame.vertices.emplace_back().position = {clip(column), -clip(row), 0.5f};
        }
    for (std::uint32_t row = 0; row < kCells; ++row)
        for (std::uint32_t column = 0; column < kCells; ++column) {
            const std::uint32_t a = row * kCorners + column, below = a + kCorners;
            const std::uint32_t corners[6]{a, a + 1, below, a + 1, below + 1, below};
            frame.indices.insert(frame.indices.end(), std::begin(corners), std::end(corners));
        }
    count_with(frame);
    // The pixels whose centres lie within the snapped edges: low <= i + 1/2 < high.
    const double half = std::nearbyint(std::min(kCells / 2.0 * side, double{kTarget}) * 16.0) / 16.0;
    const auto first  = [&](double edge) {
        return std::clamp(static_cast<int>(std::ceil(kTarget / 2 + edge - 0.5)), 0, kTarget);
    };
    const int low = first(-half), high = first(half);
    const PixelRect covered = low < high ? PixelRect{low, low, high, high} : PixelRect{-1, -1, -1, -1};
    return hits_of(frame, covered);
}

SliverErrors sliver_errors() {
    SliverErrors errors;
    raster::Image color(256, 16), depth(256, 16);
    raster::PassFill pass{.color = &color, .depth = &depth, .depth_bits = 32, .scissor = color.bounds(), .draws = {}};
    raster::Draw& draw             = pass.draws.emplace_back();
    draw.state.depth_write         = true;
    // Two rows of corners, subpixel by subpixel; a strip between them. Depth and colour are as different as can be.
    constexpr std::uint32_t kCount = 257;
    const auto corner              = [](std::uint32_t i) {
        const bool left = i % 2 == 0;
        raster::Vertex vertex;
        vertex.x       = left ? -16000.0f : 16000.0f;
        vertex.y       = (left ? -500.0f : 500.0f) + static_cast<float>(i / 2) / 16.0f + 4.0f;
        vertex.z       = left ? 0.0f : 1.0f;
        vertex.diffuse = left ? 0xff00ff00 : 0xffff00ff;
        return vertex;
    };
    for (std::uint32_t i = 0; i < kCount; ++i) draw.vertices.push_back(corner(i));
    for (std::uint32_t i = 0; i + 2 < kCount; ++i) draw.triangles.push_back({i, i + 1, i + 2});
    // At a pixel both vary with x alone but for the slope of the ends, which all slivers have alike.
    raster::fill_pass(pass);
    for (int y = 0; y < color.height(); ++y)
        for (int x = 0; x < color.width(); ++x) {
            const std::uint32_t argb = color.row(y)[x];
            if (argb == 0) continue;
            ++errors.pixels;
            const double t        = (x + 0.5 + 16000.0) / 32000.0;
            const std::uint32_t d = depth.row(y)[x] >> 2;
            const double red = argb >> 16 & 255, green = argb >> 8 & 255;
            errors.depth = std::max(errors.depth, std::abs(d - t * ((1 << 30) - 1)));
            errors.color = std::max({errors.color, std::abs(red - 255.0 * t), std::abs(green - 255.0 * (1.0 - t))});
        }
    return errors;
}

std::vector<Row> coverage_rows() {
    const auto wrong = [](const Hits& hits) { return count_text(hits.wrong) + " wrong of " + count_text(hits.pixels); };
    std::vector<Row> rows;
    for (const auto& [cut, what] : {std::pair{Cut::Nothing, "random fans"},
                                    {Cut::GuardBand, "random fans, cut at the guard band"},
                                    {Cut::NearPlane, "random fans, cut at the near plane and the guard band"}}) {
        Hits hits;
        for (const Arithmetic& grid : grids()) hits += fan_hits(cut, grid, 1);
        rows.push_back({what, "16x16 phases of the hub, 4 grids", "each pixel once", wrong(hits),
                        hits.twice == 0 ? "nowhere" : count_text(hits.twice) + " hit again, in folds"});
    }
    const Hits fine = fine_hits();
    rows.push_back({"50,000 slivers around a point, cut at the guard band", "to 2^24 px, off the grid, 4 grids",
                    "each pixel once more clockwise than not", wrong(fine),
                    count_text(fine.twice) + " hit again, where snapped slivers fold over"});
    rows.push_back({"1,000,000 triangles around a point", "to 16,384 px, on the grid", "each pixel once",
                    wrong(million_hits()), "window vertices end at 16,384 px"});
    Hits meshes;
    for (int exponent = kLeastSide; exponent <= kGreatestSide; ++exponent) meshes += mesh_hits(exponent);
    rows.push_back({"meshes of 8,192 triangles", "sides of 1/4,096 to 131,072 px",
                    "each pixel of the snapped mesh once", wrong(meshes),
                    "corners less than 1/16 px apart may become one; such triangles are dropped"});
    const SliverErrors slivers = sliver_errors();
    rows.push_back({"slivers of 1/16 by 32,000 px, depth", count_text(slivers.pixels) + " pixels",
                    ceil_text(kDepthBound, 0) + " * 2^-30", ceil_text(slivers.depth, 1) + " * 2^-30",
                    "four units of D24, at the longest sides"});
    rows.push_back({"slivers of 1/16 by 32,000 px, colour", count_text(slivers.pixels) + " pixels",
                    ceil_text(kColorBound, 2) + " of 255", ceil_text(slivers.color, 2) + " of 255", "1 of 255"});
    return rows;
}

}  // namespace extremes
