// SPDX-License-Identifier: MIT
#include "demo/scene_file_cloud.h"

#include <algorithm>
#include <cmath>

namespace demo {
namespace {

constexpr Range kTurn{-360.0, 360.0};  // degrees a second
constexpr std::size_t kMaxCloudLights = 16;

void read_fractal(TableReader reader, cloud::Fractal& fractal) {
    reader.read("size", fractal.face_size, 1, 1024);
    if ((fractal.face_size & (fractal.face_size - 1)) != 0) reader.fail("size", "must be a power of two");
    reader.read("octaves", fractal.octaves, 1, 12);
    reader.read("gain", fractal.gain, kShare);
    reader.read("cycles", fractal.cycles, {0.0, 1024.0, true});
    reader.read("seed", fractal.seed);
    if (const auto noise = reader.read_choice("noise", {"fbm", "billow"}))
        fractal.noise = *noise == 0 ? cloud::Noise::Fbm : cloud::Noise::Billow;
    reader.finish("[cloud.fractal]");
}

// What is placed and scaled must be of a size that floats and the cloud's meshes bear.
void read_cores(TableReader& reader, CloudPlan& plan) {
    const auto rows = reader.read_rows("cores", 4, kMaxParticlesPerCloud);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto& row = rows[i];
        if (row[3] < 0.01) reader.fail_at_row("cores", i, "must have radii >= 0.01, each [x, y, z, radius]");
        plan.cores.push_back({Vec3(static_cast<float>(row[0]), static_cast<float>(row[1]), static_cast<float>(row[2])),
                              static_cast<float>(row[3])});
    }
    // What remains once all is placed and scaled must be of a size that floats and the cloud's meshes bear.
    for (std::size_t i = 0; i < plan.cores.size(); ++i) {
        const Vec3 center  = glm::abs(plan.position + plan.scale * plan.cores[i].center);
        const float radius = plan.scale * plan.cores[i].radius;
        if (std::max({center.x, center.y, center.z}) > 5e5f || radius < 0.02f || radius > 1e5f)
            reader.fail_at_row(
                "cores", i,
                "must lie within 500 km of the origin, with a radius of 0.02 to 1e5, once placed and scaled");
    }
}

void read_cumulus(TableReader& reader, CloudPlan& plan) {
    cloud::CumulusShape& shape = plan.cumulus.emplace();
    reader.read("size", shape.size, {0.1, 1e4});
    reader.read("flatness", shape.flatness, kShare);
    shape.seed           = plan.seed;
    plan.settings.base_y = 0.0f;  // if the scene says no other
    int generations      = 3;
    reader.read("generations", generations, 1, 3);
    const auto cores = static_cast<int>(cloud::cumulus_cores(shape).size());
    if (generations >= 2) plan.crown = std::min(4 * cores, kMaxParticlesPerCloud - cores);
    if (generations >= 3) plan.rim = std::min(40 * cores, kMaxParticlesPerCloud - cores - plan.crown);
    plan.rim = std::min(plan.rim, 600);
}

ParticleStream read_stream(TableReader reader) {
    ParticleStream stream;
    if (const auto birth = reader.read_choice("birth", {"steady", "fill", "burst"}))
        stream.birth = static_cast<ParticleStream::Birth>(*birth);
    reader.read("count", stream.count, 1, kMaxParticlesPerCloud);
    reader.read("life", stream.life_s, {0.01, 1e5});
    const auto read_ages = [&](const char* key, std::size_t width, auto&& add) {
        const auto rows = reader.read_rows(key, width, kMaxKeys);
        double last     = -1.0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (rows[i][0] <= last || rows[i][0] < 0.0 || rows[i][0] > 1.0)
                reader.fail_at_row(key, i, "must have rising ages from 0 to 1, each row's first number");
            last = rows[i][0];
            add(rows[i]);
        }
    };
    const auto number = [](double value) { return static_cast<float>(value); };
    read_ages("stages", 5, [&](const std::vector<double>& row) {
        if (row[3] < 0.0 || row[4] < 0.0 || row[4] > 1.0 || std::abs(row[1]) > 1e4 || std::abs(row[2]) > 1e4 ||
            row[3] > 1e4)
            reader.fail("stages",
                        "must have spreads, heights and radii up to 1e4, radii from 0 and alphas from 0 to 1");
        stream.stages.add(row[0], {number(row[1]), number(row[2]), number(row[3]), number(row[4])});
    });
    if (stream.stages.empty()) reader.fail("stages", "must hold rows of [age, spread, height, radius, alpha]");
    const auto add_color = [&](Track<Vec3>& track) {
        return [&](const std::vector<double>& row) {
            if (std::min({row[1], row[2], row[3]}) < 0.0 || std::max({row[1], row[2], row[3]}) > kLight.high)
                reader.fail("stages", "must have colors and glow from 0 to 4");
            track.add(row[0], Vec3(number(row[1]), number(row[2]), number(row[3])));
        };
    };
    read_ages("colors", 4, add_color(stream.color));
    read_ages("glow", 4, add_color(stream.glow));
    if (const auto form = reader.read_choice("form", {"column", "ball"})) stream.in_ball = *form == 1;
    reader.read("swirl", stream.swirl_deg, {-3600.0, 3600.0});
    reader.read("bumps", stream.bumps, 0, 100);
    if (stream.count * (1 + stream.bumps) > kMaxParticlesPerCloud)
        reader.fail("bumps", "with count must come to at most " + std::to_string(kMaxParticlesPerCloud) + " particles");
    reader.read("bump_radius", stream.bump_radius, {0.01, 1.0});
    reader.read("irregularity", stream.irregularity, kShare);
    reader.read("seed", stream.seed);
    reader.finish("[cloud.stream]");
    return stream;
}

// One way to say what the cloud is made of.
void read_particles(TableReader& reader, CloudPlan& plan) {
    read_cores(reader, plan);
    if (reader.read_choice("generate", {"cumulus"})) {
        if (!plan.cores.empty()) reader.fail("generate", "and cloud.cores exclude each other");
        read_cumulus(reader, plan);
    }
    if (auto stream = reader.table("stream")) plan.stream = read_stream(*stream);
    FileReference file;
    if (reader.read("particles", file)) plan.particle_file = file;
    const int ways =
        !plan.cores.empty() + plan.cumulus.has_value() + plan.stream.has_value() + plan.particle_file.has_value();
    if (ways != 1)
        reader.fail("cores",
                    "must hold one core or more, each [x, y, z, radius]; or cloud.generate, cloud.stream or "
                    "cloud.particles stand in its place, one of them");
    if (plan.stream || plan.particle_file) return;
    reader.read("crown", plan.crown, 0, kMaxParticlesPerCloud);
    reader.read("rim", plan.rim, 0, kMaxParticlesPerCloud);
    const std::size_t cores = plan.cumulus ? cloud::cumulus_cores(*plan.cumulus).size() : plan.cores.size();
    const int particles     = static_cast<int>(cores) + plan.crown + plan.rim;
    if (particles > kMaxParticlesPerCloud)
        reader.fail("cores", "with crown and rim must come to at most " + std::to_string(kMaxParticlesPerCloud) +
                                 " particles (got " + std::to_string(particles) + ")");
}

void read_key(TableReader reader, double& last_s, Track<CloudKey>& keys) {
    const double at = read_time(reader, last_s);
    CloudKey key;
    reader.read("offset", key.offset, kCoordinate);
    reader.read("color", key.color, kShare);
    reader.read("size", key.size, {0.001, 1000.0});
    reader.read("spread", key.spread, {0.0, 1000.0});
    reader.read("opacity", key.opacity, kShare);
    reader.read("dissolve", key.dissolve, kShare);
    reader.finish("[[cloud.key]]");
    keys.add(at, key);
}

CloudLight read_cloud_light(TableReader reader) {
    CloudLight light;
    reader.read("position", light.light.center, kCoordinate);
    reader.read("color", light.light.color, kLight);
    reader.read("range", light.light.range, kLength);
    reader.read("scene_range", light.scene_range, {0.0, 1e5});
    reader.read("flicker", light.flicker, kShare);
    for (const auto& row : reader.read_rows("flashes", 2, kMaxKeys)) light.flashes.push_back({row[0], row[1]});
    for (std::size_t i = 0; i < light.flashes.size(); ++i)
        if (!(light.flashes[i].length_s > 0.0))
            reader.fail_at_row("flashes", i, "must have lengths above 0, each [start, length] in seconds");
    reader.finish("[[cloud.light]]");
    return light;
}

}  // namespace

CloudPlan read_cloud(TableReader reader) {
    CloudPlan plan;
    cloud::Cloud& cloud = plan.settings;
    reader.read("name", cloud.name);
    if (const auto mode = reader.read_choice("mode", {"skirt", "article", "premultiplied", "black"}))
        cloud.mode = static_cast<cloud::Mode>(*mode);
    if (const auto detail = reader.read_choice("detail", {"fractal", "displacement", "none"}))
        cloud.detail = static_cast<cloud::Detail>(*detail);
    reader.read("position", plan.position, kCoordinate);
    reader.read("scale", plan.scale, {0.001, 1000.0});
    reader.read("stretch", plan.stretch, {0.05, 20.0});
    reader.read("color", plan.color, kShare);
    reader.read("seed", plan.seed);
    read_particles(reader, plan);
    reader.read("jitter", plan.jitter, {0.0, 0.25});
    reader.read("base_y", cloud.base_y, kCoordinate);
    reader.read("blur", cloud.blur_m, {0.0, 1000.0});
    reader.read("opacity", cloud.opacity, kShare);
    reader.read("absorption", cloud.absorption, {0.0, 100.0});
    reader.read("silver_lining", cloud.silver_lining, kLight);
    reader.read("lumpiness", cloud.lumpiness, {0.0, 0.5});
    bool order_free = false;
    reader.read("order_free", order_free);
    if (order_free) cloud.order = cloud::Order::OrderFree;
    reader.read("dissolve", cloud.dissolve, kShare);
    reader.read("displacement", cloud.displacement, {0.0, 10.0});
    reader.read("tint", cloud.tint, kShare);
    reader.read("box_turn", plan.box_turn_deg, kTurn);
    plan.has_second_box = reader.read("second_box_turn", plan.second_box_turn_deg, kTurn);
    if (cloud.blur_m * plan.scale > 1e5f) reader.fail("blur", "must be <= 1e5 once scaled");
    if (auto fractal = reader.table("fractal")) read_fractal(*fractal, cloud.fractal);
    double last_s = -1.0;
    for (TableReader& table : reader.tables("key", kMaxKeys)) read_key(std::move(table), last_s, plan.keys);
    for (TableReader& table : reader.tables("light", kMaxCloudLights))
        plan.lights.push_back(read_cloud_light(std::move(table)));
    reader.finish("[[cloud]]");
    return plan;
}

double read_time(TableReader& reader, double& last_s) {
    double at = 0.0;
    reader.read("at", at, {0.0, 1e6});
    if (at <= last_s) reader.fail("at", "must be later than that of the key before");
    return last_s = at;
}

}  // namespace demo
