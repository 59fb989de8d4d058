// SPDX-License-Identifier: MIT
// Fog: triangles whose distance is chosen so that a row has the factor wanted.
#include "demo/vectors/vector_probe.h"

namespace demo {

using namespace pipeline;

namespace {

const std::vector<int> kFogColors{0, 1, 2, 31, 64, 85, 100, 127, 128, 129, 160, 192, 200, 253, 254, 255};

// A strip over row `f` of the target, at the distance 255 - f: with start 0 and end 255 the factor is f / 255.
void add_strip(Frame& frame, int f, float offset) {
    const auto first = static_cast<std::uint32_t>(frame.vertices.size());
    for (const auto& [x, y, u] : {std::tuple{0, f, 0.0f}, {256, f, 1.0f}, {256, f + 1, 1.0f}, {0, f + 1, 0.0f}}) {
        Vertex& vertex  = frame.vertices.emplace_back();
        vertex.position = {(static_cast<float>(x) + offset) / 128.0f - 1.0f,
                           1.0f - (static_cast<float>(y) + offset) / 128.0f, static_cast<float>(255 - f)};
        vertex.uv0      = {u, 0.5f};
    }
    for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) frame.indices.push_back(first + corner);
}

Frame fog_frame(const Prober& prober, TargetFormat format, int fog_color) {
    Frame frame = probe_frame(format, 256, 256);
    frame.textures.push_back(ramp_texture());
    // Window coordinates as they are; the distance is left to fog alone.
    frame.cameras.emplace_back().projection[2][2] = 0.0f;
    for (int f = 0; f < 256; ++f) add_strip(frame, f, prober.offset());
    Pass& pass           = frame.passes.emplace_back();
    pass.color           = {0};
    pass.camera          = {0};
    pass.state.stages[0] = ramp_color();
    pass.state.fog.mode  = FogMode::Linear;
    pass.state.fog.color = {grey(static_cast<std::uint32_t>(fog_color))};
    pass.state.fog.start = 0.0f;
    pass.state.fog.end   = 255.0f;
    DrawTriangles draw{.first_index = 0, .index_count = static_cast<std::uint32_t>(frame.indices.size())};
    draw.textures[0] = {.texture = {0}, .target = {}};
    pass.draws       = {draw};
    return frame;
}

// What follows the colon of a formula.
std::string value_of(std::string_view formula) {
    return std::string(formula.substr(formula.find(": ") + 2));
}

void add_fog(const Profile& profile, const Prober& prober, FogRule rule, const std::string& suffix,
             std::vector<VectorTable>& tables) {
    tables.push_back({.name       = "fog" + suffix,
                      .topic      = "fog",
                      .rule       = std::string(enum_name(rule)),
                      .what       = "vertex fog of factor f between the texel c and the fog colour k",
                      .expression = value_of(formula(rule)),
                      .formula    = formula(rule),
                      .axes       = {{"fog_color_k", kFogColors}, {"factor_f", AxisRange{}}, {"color_c", AxisRange{}}},
                      .draw       = [rule, format = profile.formats.with_bytes, &prober] {
                          Arithmetic other = prober.arithmetic();
                          other.fog        = rule;
                          Prober with_rule = prober.with(other);
                          Bytes bytes;
                          for (const int k : kFogColors) {
                              const Bytes part = with_rule.draw(fog_frame(with_rule, format, k), "r");
                              bytes.insert(bytes.end(), part.begin(), part.end());
                          }
                          return bytes;
                      }});
}

}  // namespace

void add_fog_tables(const Profile& profile, Prober& prober, std::vector<VectorTable>& tables) {
    add_fog(profile, prober, profile.arithmetic.fog, "", tables);
    if (profile.arithmetic.fog == FogRule::GsFloor256)
        add_fog(profile, prober, FogRule::GsTwoFloors, "_gs_two_floors", tables);
}

}  // namespace demo
