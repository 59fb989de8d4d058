// SPDX-License-Identifier: MIT
// The Graphics Synthesizer's blends, named by the low byte of register ALPHA: A | B << 2 | C << 4 | D << 6. Red stands
// for the three colour channels.
#include <array>
#include <cstdio>

#include "demo/vectors/vector_probe.h"

namespace demo {

using namespace pipeline;

namespace {

constexpr int kAlphaBytes[] = {0x44, 0x48, 0x68, 0x64, 0x42, 0x62, 0x89, 0x98, 0x54, 0x11};

GsBlend blend_of(int byte) {
    return {.a = static_cast<GsColor>(byte & 3),
            .b = static_cast<GsColor>(byte >> 2 & 3),
            .c = static_cast<GsAlpha>(byte >> 4 & 3),
            .d = static_cast<GsColor>(byte >> 6 & 3)};
}

std::string operand(GsColor color) {
    return color == GsColor::Cs ? "s" : color == GsColor::Cd ? "d" : "0";
}

// ((A - B) * C >> 7) + D without zeros.
std::string sum_of(const GsBlend& blend) {
    const std::string a = operand(blend.a), b = operand(blend.b), d = operand(blend.d);
    if (blend.a == blend.b) return d;
    const std::string factor  = b == "0" ? a : a == "0" ? "-" + b : "(" + a + " - " + b + ")";
    const std::string product = factor + " * c >> 7";
    return d == "0" ? product : "(" + product + ") + " + d;
}

std::string hexadecimal(int byte) {
    char text[3];
    std::snprintf(text, sizeof text, "%02x", static_cast<unsigned>(byte));
    return text;
}

class GsBlendTables {
  public:
    GsBlendTables(const Profile& profile, Prober& prober, std::vector<VectorTable>& tables)
        : profile_(profile), prober_(prober), tables_(tables) {}

    // factor: AS, AD or FIX, the first axis; without it the array is over destination and source.
    void add_color(int byte, GsBlend blend, TargetFormat format, const std::string& suffix) {
        VectorTable table = described("blend_" + hexadecimal(byte) + "_color" + suffix, format, blend);
        table.what        = "ALPHA 0x" + hexadecimal(byte) + states(blend) + " on " + std::string(enum_name(format)) +
                     "; red, for red, green and blue";
        const bool uses_source       = blend.a == GsColor::Cs || blend.b == GsColor::Cs || blend.d == GsColor::Cs;
        const bool uses_dest         = blend.a == GsColor::Cd || blend.b == GsColor::Cd || blend.d == GsColor::Cd;
        const std::vector<int> bytes = prober_.levels(TargetFormat::Psmct32, "r");
        // What does not matter is not an axis, and is 0; As alone, without Cs, takes the source's place.
        const std::vector<int> dest  = uses_dest ? prober_.levels(format, "r") : std::vector<int>{0};
        const bool is_alpha_source   = blend.c == GsAlpha::As && !uses_source;
        const std::vector<int> third = blend.c == GsAlpha::Ad ? prober_.levels(format, "a")
                                       : is_alpha_source      ? std::vector<int>{0}
                                                              : bytes;
        if (third.size() > 1) {
            const char* const names[] = {"source_alpha_c", "destination_alpha_c", "fix_c"};
            table.axes.push_back({names[static_cast<std::size_t>(blend.c)], third});
        }
        if (uses_dest) table.axes.push_back({"destination_d", dest});
        table.axes.push_back({is_alpha_source ? "source_alpha_c" : "source_s", AxisRange{}});
        table.draw = [this_prober = &prober_, blend, format, dest, third, is_alpha_source] {
            Probe probe{.format = format};
            for (const int c : third) {
                const auto alpha    = static_cast<std::uint32_t>(c);
                ProbeBand& band     = probe.bands.emplace_back();
                band.state.gs_blend = blend;
                if (blend.c == GsAlpha::Fix) band.state.gs_blend.fix = static_cast<std::uint8_t>(c);
                band.state.stages[0] = is_alpha_source ? ramp_alpha() : ramp_color();
                for (const int d : dest)
                    band.rows.push_back({.dest   = with_alpha(grey(static_cast<std::uint32_t>(d)), alpha),
                                         .source = with_alpha(0, alpha)});
            }
            return this_prober->draw(probe, "r");
        };
        tables_.push_back(std::move(table));
    }

    void add_alpha(GsBlend blend, TargetFormat format, const std::string& suffix) {
        VectorTable table = described("blend_44_alpha" + suffix, format, blend);
        table.what        = "ALPHA 0x44" + states(blend) + " on " + std::string(enum_name(format)) + "; alpha";
        table.expression  = std::string(blend.fba ? "s | 0x80" : "s") + ", then as the target keeps it";
        const std::vector<int> dest = prober_.levels(format, "a");
        table.axes                  = {{"destination_alpha", dest}, {"source_alpha_s", AxisRange{}}};
        table.draw                  = [this_prober = &prober_, blend, format, dest] {
            Probe probe{.format = format, .bands = {{.state = {}, .rows = {}}}};
            probe.bands[0].state.gs_blend  = blend;
            probe.bands[0].state.stages[0] = ramp_color_and_alpha();
            for (const int d : dest)
                probe.bands[0].rows.push_back({.dest = all_channels(static_cast<std::uint32_t>(d))});
            return this_prober->draw(probe, "a");
        };
        tables_.push_back(std::move(table));
    }

  private:
    static std::string states(const GsBlend& blend) {
        return std::string(", COLCLAMP ") + (blend.colclamp ? "1" : "0") + (blend.pabe ? ", PABE 1" : "") +
               (blend.fba ? ", FBA 1" : "");
    }

    VectorTable described(const std::string& name, TargetFormat format, const GsBlend& blend) const {
        const std::string sum  = sum_of(blend);
        std::string expression = blend.colclamp ? "min(255, max(0, " + sum + "))" : "(" + sum + ") & 255";
        if (blend.pabe) expression = "c < 0x80 ? s : " + expression;
        if (format == TargetFormat::Psmct24 && blend.c == GsAlpha::Ad) expression += ", c being 0x80";
        return {.name       = name,
                .topic      = "blend",
                .rule       = std::string(enum_name(profile_.arithmetic.blend)),
                .what       = {},
                .expression = expression + ", then as the target keeps it",
                .formula    = formula(profile_.arithmetic.blend),
                .axes       = {},
                .draw       = {}};
    }

    const Profile& profile_;
    Prober& prober_;
    std::vector<VectorTable>& tables_;
};

}  // namespace

void add_gs_blend_tables(const Profile& profile, Prober& prober, std::vector<VectorTable>& tables) {
    using enum TargetFormat;
    GsBlendTables add(profile, prober, tables);
    for (const int byte : kAlphaBytes) add.add_color(byte, blend_of(byte), Psmct32, "");
    for (const int byte : {0x48, 0x42}) {
        GsBlend wrapped  = blend_of(byte);
        wrapped.colclamp = false;
        add.add_color(byte, wrapped, Psmct32, "_colclamp0");
    }
    GsBlend pabe = blend_of(0x44), fba = blend_of(0x44);
    pabe.pabe = true;
    fba.fba   = true;
    add.add_color(0x44, pabe, Psmct32, "_pabe");
    add.add_color(0x54, blend_of(0x54), Psmct24, "_psmct24");
    add.add_color(0x54, blend_of(0x54), Psmct16, "_psmct16");
    add.add_color(0x44, blend_of(0x44), Psmct16, "_psmct16");
    add.add_alpha(blend_of(0x44), Psmct32, "");
    add.add_alpha(fba, Psmct32, "_fba");
    add.add_alpha(blend_of(0x44), Psmct16, "_psmct16");
    add.add_alpha(fba, Psmct16, "_psmct16_fba");
}

}  // namespace demo
