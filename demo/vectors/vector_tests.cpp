// SPDX-License-Identifier: MIT
// The tests that a fragment must pass: 255 where it was drawn, 0 where it was not.
#include <algorithm>

#include "demo/vectors/vector_probe.h"

namespace demo {

using namespace pipeline;

namespace {

template <class Enum>
std::vector<std::string> names(const std::vector<Enum>& values) {
    std::vector<std::string> out;
    for (const Enum value : values) out.emplace_back(enum_name(value));
    return out;
}

void add_alpha_test(const Profile& profile, Prober& prober, std::vector<VectorTable>& tables) {
    tables.push_back(
        {.name       = "alpha_test",
         .topic      = "alpha_test",
         .rule       = "alpha_test",
         .what       = "alpha test, a fragment that fails being dropped",
         .expression = "alpha FUNC reference ? 255 : 0",
         .formula    = "unsigned bytes compare; ALWAYS and NEVER do not look",
         .axes       = {{"func", names(all_of<CompareFunc>())}, {"reference", AxisRange{}}, {"alpha", AxisRange{}}},
         .draw       = [&prober, format = profile.formats.with_bytes] {
             Probe probe{.format = format};
             for (const CompareFunc func : all_of<CompareFunc>())
                 for (int reference = 0; reference < 256; ++reference) {
                     ProbeBand& band       = probe.bands.emplace_back();
                     band.rows             = {{}};
                     band.state.stages[0]  = ramp_alpha();
                     band.state.alpha_test = {.func = func, .reference = static_cast<std::uint8_t>(reference)};
                 }
             return prober.draw(probe, "r");
         }});
}

// A depth format of the chip for a colour format, and the other way round: the last of each that goes with it.
TargetFormat depth_beside(const ChipFormats& formats, TargetFormat color) {
    return *std::find_if(formats.depth.rbegin(), formats.depth.rend(),
                         [&](TargetFormat depth) { return go_together(formats, color, depth); });
}
TargetFormat color_beside(const ChipFormats& formats, TargetFormat depth) {
    if (go_together(formats, formats.with_bytes, depth)) return formats.with_bytes;
    return *std::find_if(formats.draw.begin(), formats.draw.end(),
                         [&](TargetFormat color) { return go_together(formats, color, depth); });
}

// Each row, a format's fail mode, is drawn to a black pixel whose depth is 0. Column 1 then becomes black again, and
// white once more if the depth is still below 1/2.
Frame alpha_fail_frame(const Prober& prober, TargetFormat format, TargetFormat depth_format,
                       const std::vector<AlphaFail>& modes) {
    const int count = static_cast<int>(modes.size());
    Frame frame     = probe_frame(format, 2, count);
    frame.targets.push_back({.name = "depth", .format = depth_format, .width = 2, .height = count});
    const auto add_pass = [&](int x0, int x1, int y0, int y1, std::uint32_t color, float depth) -> Pass& {
        Pass& pass         = frame.passes.emplace_back();
        pass.color         = {0};
        pass.depth         = {1};
        DrawRectangle draw = prober.rectangle(x0, y0, x1, y1, color);
        draw.depth         = depth;
        pass.draws         = {draw};
        return pass;
    };
    for (int mode = 0; mode < count; ++mode) {
        Pass& pass            = add_pass(0, 2, mode, mode + 1, 0xffffffff, 1.0f);
        pass.state.depth      = {.func = CompareFunc::Always, .write = true};
        pass.state.alpha_test = {
            .func = CompareFunc::Never, .reference = 0, .fail = modes[static_cast<std::size_t>(mode)]};
    }
    add_pass(1, 2, 0, count, 0xffffffff, 0.0f);
    add_pass(1, 2, 0, count, 0x00000000, 0.5f).state.depth.func = CompareFunc::GreaterEqual;
    return frame;
}

// White is not 255 in every format.
std::uint8_t was_drawn(std::uint8_t red) {
    return red == 0 ? 0 : 255;
}

void add_alpha_fail(const Profile& profile, Prober& prober, std::vector<VectorTable>& tables) {
    const std::vector<AlphaFail>& modes = profile.states.alpha_fails;
    tables.push_back(
        {.name       = "alpha_fail",
         .topic      = "alpha_test",
         .rule       = "alpha_test.fail",
         .what       = "a white, opaque fragment whose alpha test fails, over a black pixel of alpha 0: red and "
                       "alpha of the pixel after it, and 255 if its depth was written",
         .expression = "see formula",
         .formula    = "KEEP writes nothing; FB_ONLY colour and alpha; ZB_ONLY depth; RGB_ONLY colour, but also "
                       "alpha where the target's alpha has not 8 bits",
         .axes       = {{"format", names(profile.formats.draw)},
                        {"fail", names(modes)},
                        {"part", std::vector<std::string>{"red", "alpha", "depth"}}},
         .draw       = [&prober, &profile] {
             Bytes bytes;
             for (const TargetFormat format : profile.formats.draw) {
                 const Bytes drawn = prober.draw(alpha_fail_frame(prober, format, depth_beside(profile.formats, format),
                                                                        profile.states.alpha_fails),
                                                       "ra");
                 for (std::size_t row = 0; row < drawn.size(); row += 4)
                     bytes.insert(bytes.end(), {drawn[row], drawn[row + 1], was_drawn(drawn[row + 2])});
             }
             return bytes;
         }});
}

void add_dest_alpha_test(const Profile& profile, Prober& prober, std::vector<VectorTable>& tables) {
    tables.push_back(
        {.name  = "dest_alpha_test",
         .topic = "dest_alpha_test",
         .rule  = "dest_alpha_test",
         .what  = "a white fragment over pixels written with red, green, blue 0 and the alpha of the axis",
         .expression =
             "bit 7 of the alpha that the target gives back is what is asked for ? white, as the target keeps it : 0",
         .formula = "DATE with DATM 0 (ZERO) and 1 (ONE); on a target without alpha nothing passes",
         .axes    = {{"format", names(profile.formats.draw)},
                     {"test", std::vector<std::string>{"ZERO", "ONE"}},
                     {"written_alpha", AxisRange{}}},
         .draw    = [&prober, formats = profile.formats.draw] {
             Bytes bytes;
             for (const TargetFormat format : formats) {
                 Probe probe{.format = format, .columns = 1};
                 for (const DestAlphaTest test : {DestAlphaTest::Zero, DestAlphaTest::One}) {
                     ProbeBand& band            = probe.bands.emplace_back();
                     band.state.dest_alpha_test = test;
                     for (std::uint32_t alpha = 0; alpha < 256; ++alpha)
                         band.rows.push_back({.dest = with_alpha(0, alpha)});
                 }
                 const Bytes part = prober.draw(probe, "r");
                 bytes.insert(bytes.end(), part.begin(), part.end());
             }
             return bytes;
         }});
}

// Some a unit of D16, of D24 or of a float apart.
const std::vector<double> kDepths{0.0,           0x1p-25,       0x1p-24,       0x1p-17,       0x1p-16,
                                  0.25,          0.5 - 0x1p-17, 0.5 - 0x1p-25, 0.5,           0.5 + 0x1p-24,
                                  0.5 + 0x1p-17, 0.75,          1.0 - 0x1p-17, 1.0 - 0x1p-24, 1.0};

Frame depth_frame(const Prober& prober, const Profile& profile, TargetFormat format) {
    const int count = static_cast<int>(kDepths.size()), funcs = static_cast<int>(profile.states.depth_funcs.size());
    Frame frame = probe_frame(color_beside(profile.formats, format), count, count * funcs);
    frame.targets.push_back({.name = "depth", .format = format, .width = count, .height = count * funcs});
    Pass& stored       = frame.passes.emplace_back();
    stored.color       = {0};
    stored.depth       = {1};
    stored.state.depth = {.func = CompareFunc::Always, .write = true};
    for (int row = 0; row < count * funcs; ++row) {
        DrawRectangle draw = prober.rectangle(0, row, count, row + 1, 0);
        draw.depth         = static_cast<float>(kDepths[static_cast<std::size_t>(row % count)]);
        stored.draws.emplace_back(draw);
    }
    for (int func = 0; func < funcs; ++func) {
        Pass& tested            = frame.passes.emplace_back();
        tested.color            = {0};
        tested.depth            = {1};
        tested.state.depth.func = profile.states.depth_funcs[static_cast<std::size_t>(func)];
        for (int column = 0; column < count; ++column) {
            DrawRectangle draw = prober.rectangle(column, func * count, column + 1, (func + 1) * count);
            draw.depth         = static_cast<float>(kDepths[static_cast<std::size_t>(column)]);
            tested.draws.emplace_back(draw);
        }
    }
    return frame;
}

void add_depth_test(const Profile& profile, Prober& prober, std::vector<VectorTable>& tables) {
    for (const TargetFormat format : profile.formats.depth) {
        tables.push_back(
            {.name  = "depth_test_" + lower_case(enum_name(format)),
             .topic = "depth",
             .rule  = std::string(enum_name(format)),
             .what  = "depth test against " + std::string(enum_name(format)) +
                     ", of rectangles of constant depth; the axes' values are single precision",
             .expression = "units of fragment FUNC units of stored ? 255 : 0",
             .formula    = formula(format),
             .axes       = {{"func", names(profile.states.depth_funcs)}, {"stored", kDepths}, {"fragment", kDepths}},
             .draw       = [&prober, &profile, format] {
                 Bytes bytes = prober.draw(depth_frame(prober, profile, format), "r");
                 std::transform(bytes.begin(), bytes.end(), bytes.begin(), &was_drawn);
                 return bytes;
             }});
    }
}

}  // namespace

void add_test_tables(const Profile& profile, Prober& prober, std::vector<VectorTable>& tables) {
    add_alpha_test(profile, prober, tables);
    if (profile.states.alpha_fails.size() > 1) add_alpha_fail(profile, prober, tables);
    if (profile.states.dest_alpha_test) add_dest_alpha_test(profile, prober, tables);
    add_depth_test(profile, prober, tables);
}

}  // namespace demo
