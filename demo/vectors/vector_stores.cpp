// SPDX-License-Identifier: MIT
// What formats keep, and the copy engine's halving.
#include <algorithm>

#include "demo/vectors/vector_probe.h"

namespace demo {

using namespace pipeline;

namespace {

const std::vector<std::string> kChannels{"red", "green", "blue", "alpha"};

// An ordered 4x4 matrix, in which every value of -4..3 stands twice.
constexpr std::array<std::int32_t, 16> kDimx{-4, 2, -3, 3, 0, -2, 1, -1, -3, 3, -4, 2, 1, -1, 0, -2};

void add_store(Prober& prober, TargetFormat format, std::vector<VectorTable>& tables) {
    tables.push_back({.name  = "store_" + lower_case(enum_name(format)),
                      .topic = "store",
                      .rule  = std::string(enum_name(format)),
                      .what  = "a byte written to every channel of " + std::string(enum_name(format)) +
                              " and read back, with blending off",
                      .expression = "see formula",
                      .formula    = formula(format),
                      .axes       = {{"value", AxisRange{}}, {"channel", kChannels}},
                      .draw       = [&prober, format] {
                          Probe probe{.format = format, .bands = {{.state = {}, .rows = {{}}}}};
                          probe.bands[0].state.stages[0] = ramp_color_and_alpha();
                          return prober.draw(probe, "rgba");
                      }});
}

// size: of the matrix.
void add_dithered_store(Prober& prober, TargetFormat format, const PipelineState& state, int size,
                        const std::string& suffix, const std::string& what, std::vector<VectorTable>& tables) {
    const DitherMode mode = state.dither.mode;
    tables.push_back({.name  = "store_" + lower_case(enum_name(format)) + suffix,
                      .topic = "dither",
                      .rule  = std::string(enum_name(mode)) + ", " + std::string(enum_name(format)),
                      .what  = "a byte written to every channel of " + std::string(enum_name(format)) +
                              " at each place of the dither matrix and read back" + what,
                      .expression = "see formula; alpha is not dithered",
                      .formula    = formula(mode),
                      .axes       = {{"value", AxisRange{}},
                                     {"y", AxisRange{0, size - 1}},
                                     {"x", AxisRange{0, size - 1}},
                                     {"channel", kChannels}},
                      .draw       = [&prober, format, state, size] {
                          Probe probe{.format = format, .columns = size, .bands = {{.state = state, .rows = {}}}};
                          for (std::uint32_t value = 0; value < 256; ++value)
                              for (int y = 0; y < size; ++y)
                                  probe.bands[0].rows.push_back({.dest = 0, .source = all_channels(value)});
                          return prober.draw(probe, "rgba");
                      }});
}

void add_dithers(const Profile& profile, Prober& prober, std::vector<VectorTable>& tables) {
    for (const TargetFormat format : profile.formats.draw) {
        if (keeps_bytes(format)) continue;
        for (const DitherMode mode : profile.states.dithers) {
            if (mode == DitherMode::None) continue;
            PipelineState state;
            state.dither.mode = mode;
            if (mode == DitherMode::Flipper2x2) {
                add_dithered_store(prober, format, state, 2, "_dither", "", tables);
                continue;
            }
            state.dither.matrix = kDimx;
            std::string what    = ", with DIMX, row by row,";
            for (const std::int32_t value : kDimx) what += ' ' + std::to_string(value);
            add_dithered_store(prober, format, state, 4, "_dither", what + "; COLCLAMP 1", tables);
            state.gs_blend.colclamp = false;
            add_dithered_store(prober, format, state, 4, "_dither_colclamp0", what + "; COLCLAMP 0", tables);
        }
    }
}

// Blocks of 2x2: one pixel of `first`, three of `second`; the sums then are all that there can be.
Frame halving_frame(const Prober& prober, TargetFormat format, const std::vector<int>& levels) {
    const int size = static_cast<int>(levels.size());
    Frame frame    = probe_frame(TargetFormat::A8R8G8B8, size, size);
    frame.targets.push_back({.name = "source", .format = format, .width = 2 * size, .height = 2 * size});
    Texture& texture = frame.textures.emplace_back();
    texture.name     = "blocks";
    texture.width = texture.height = 2 * size;
    for (int y = 0; y < 2 * size; ++y)
        for (int x = 0; x < 2 * size; ++x) {
            const bool is_first = x % 2 == 0 && y % 2 == 0;
            const int level     = levels[static_cast<std::size_t>((is_first ? y : x) / 2)];
            texture.texels.insert(texture.texels.end(), 4, static_cast<std::uint8_t>(level));
        }
    Pass& draw           = frame.passes.emplace_back();
    draw.color           = {1};
    draw.state.stages[0] = ramp_color_and_alpha();
    DrawRectangle all    = prober.rectangle(0, 0, 2 * size, 2 * size);
    all.textures[0]      = {.texture = {0}, .target = {}};
    draw.draws           = {all};
    Pass& copy           = frame.passes.emplace_back();
    copy.color           = {0};
    copy.draws           = {CopyRectangle{.source = {1}, .from = {0, 0, 2 * size, 2 * size}, .halve = true}};
    return frame;
}

void add_halving(Prober& prober, TargetFormat format, std::vector<VectorTable>& tables) {
    const std::vector<int> levels = prober.levels(format, "r");
    const bool is_6_bits          = format == TargetFormat::R6G6B6A6;
    tables.push_back(
        {.name  = "halve_" + lower_case(enum_name(format)),
         .topic = "copy",
         .rule  = "halve, " + std::string(enum_name(format)),
         .what  = "2x2 pixels of " + std::string(enum_name(format)) +
                 " copied as one to A8R8G8B8: one of value first, three of value second",
         .expression = is_6_bits ? "S = (first >> 2) + 3 * (second >> 2): S + (S >> 6)" : "(first + 3 * second) >> 2",
         .formula    = is_6_bits ? "S, the sum of the four 6 bit values, 0..252, to S + (S >> 6)"
                                 : "S, the sum of the four bytes, to S >> 2",
         .axes       = {{"first", levels}, {"second", levels}},
         .draw       = [&prober, format, levels] { return prober.draw(halving_frame(prober, format, levels), "r"); }});
}

}  // namespace

void add_store_tables(const Profile& profile, Prober& prober, std::vector<VectorTable>& tables) {
    for (const TargetFormat format : profile.formats.draw) add_store(prober, format, tables);
    add_dithers(profile, prober, tables);
    if (!profile.formats.copies_halve) return;
    // What ends in a byte: R6G6B6A6 by its own sum, and bytes.
    for (const TargetFormat format : {TargetFormat::R6G6B6A6, TargetFormat::X8R8G8B8})
        if (std::find(profile.formats.draw.begin(), profile.formats.draw.end(), format) != profile.formats.draw.end())
            add_halving(prober, format, tables);
}

}  // namespace demo
