// SPDX-License-Identifier: MIT
// Blends by two factors. Red stands for the three colour channels.
#include <algorithm>

#include "demo/vectors/vector_probe.h"

namespace demo {

using namespace pipeline;

namespace {

std::string suffix_of(TargetFormat format) {
    return std::string("_").append(lower_case(enum_name(format)));
}

enum class ThirdInput { None, SourceAlpha, DestAlpha };

// The blends that a cloud technique or its legal rewrites use. color, alpha: what becomes of s and d; a: the third
// input where there is one, and in the second the source's alpha is s and the destination's d.
struct Mode {
    BlendFactor source, dest;
    ThirdInput third;
    std::string_view color, alpha;
};
using enum BlendFactor;
constexpr Mode kOver    = {SourceAlpha, InvSourceAlpha, ThirdInput::SourceAlpha, "s * a + d * (255 - a)",
                           "s * s + d * (255 - s)"};
constexpr Mode kModes[] = {
    {One, Zero, ThirdInput::None, "s * 255", "s * 255"},
    kOver,
    {Zero, SourceColor, ThirdInput::None, "d * s", "d * s"},
    {DestColor, Zero, ThirdInput::None, "s * d", "s * d"},
    {Zero, SourceAlpha, ThirdInput::None, "d * s", "d * s"},
    {SourceAlpha, One, ThirdInput::SourceAlpha, "s * a + d * 255", "s * s + d * 255"},
    {One, One, ThirdInput::None, "s * 255 + d * 255", "s * 255 + d * 255"},
    {One, InvSourceAlpha, ThirdInput::SourceAlpha, "s * 255 + d * (255 - a)", "s * 255 + d * (255 - s)"},
    {DestAlpha, InvDestAlpha, ThirdInput::DestAlpha, "s * a + d * (255 - a)", "s * d + d * (255 - d)"},
    {Zero, InvSourceColor, ThirdInput::None, "d * (255 - s)", "d * (255 - s)"},
};

class BlendTables {
  public:
    BlendTables(const Profile& profile, Prober& prober, std::vector<VectorTable>& tables)
        : profile_(profile), prober_(prober), tables_(tables) {}

    // The colour channel "r" or "g" of a target.
    void add_color(const Mode& mode, TargetFormat format, std::string_view channel, const std::string& suffix) {
        VectorTable table = described(mode, format, mode.color);
        table.name += "_color" + suffix;
        table.what += channel == "g" ? "; green" : "; red, for red, green and blue";
        const std::vector<int> dest = prober_.levels(format, channel);
        std::vector<int> third      = {0};
        if (mode.third == ThirdInput::SourceAlpha) {
            table.axes.push_back({"source_alpha_a", AxisRange{}});
            third = prober_.levels(TargetFormat::A8R8G8B8, "a");
        } else if (mode.third == ThirdInput::DestAlpha) {
            third = prober_.levels(format, "a");
            table.axes.push_back({"destination_alpha_a", third});
        }
        table.axes.push_back({"destination_d", dest});
        table.axes.push_back({mode.dest == SourceAlpha ? "source_alpha_s" : "source_s", AxisRange{}});
        table.draw = [this_prober = &prober_, mode, format, channel, dest, third] {
            Probe probe{.format = format, .bands = {{.state = {}, .rows = {}}}};
            probe.bands[0].state.blend = {mode.source, mode.dest};
            probe.bands[0].state.stages[0] =
                mode.third == ThirdInput::SourceAlpha ? ramp_color() : ramp_color_and_alpha();
            for (const int a : third)
                for (const int d : dest)
                    probe.bands[0].rows.push_back(
                        {.dest   = with_alpha(grey(static_cast<std::uint32_t>(d)), static_cast<std::uint32_t>(a)),
                         .source = with_alpha(0, static_cast<std::uint32_t>(a))});
            return this_prober->draw(probe, channel);
        };
        tables_.push_back(std::move(table));
    }

    void add_alpha(const Mode& mode, TargetFormat format) {
        VectorTable table = described(mode, format, mode.alpha);
        table.name += "_alpha";
        table.what += "; alpha";
        const std::vector<int> dest = prober_.levels(format, "a");
        table.axes                  = {{"destination_alpha_d", dest}, {"source_alpha_s", AxisRange{}}};
        table.draw                  = [this_prober = &prober_, mode, format, dest] {
            Probe probe{.format = format, .bands = {{.state = {}, .rows = {}}}};
            probe.bands[0].state.blend     = {mode.source, mode.dest};
            probe.bands[0].state.stages[0] = ramp_color_and_alpha();
            for (const int d : dest)
                probe.bands[0].rows.push_back({.dest = all_channels(static_cast<std::uint32_t>(d))});
            return this_prober->draw(probe, "a");
        };
        tables_.push_back(std::move(table));
    }

  private:
    VectorTable described(const Mode& mode, TargetFormat format, std::string_view sum) const {
        const std::string factors = std::string(enum_name(mode.source)) + ", " + std::string(enum_name(mode.dest));
        const bool is_nearest     = profile_.arithmetic.blend == BlendRule::Nearest255;
        return {
            .name  = "blend_" + lower_case(enum_name(mode.source)) + "_" + lower_case(enum_name(mode.dest)),
            .topic = "blend",
            .rule  = std::string(enum_name(profile_.arithmetic.blend)) + ", " +
                    std::string(enum_name(profile_.arithmetic.blend_source)),
            .what = "blend " + factors + " on " + std::string(enum_name(format)),
            .expression =
                (is_nearest ? "floor((min(65025, " : "with each factor F as F + (F >> 7): min(255, (") +
                std::string(sum) + (is_nearest ? ") + 127) / 255)" : ") >> 8)") + ", then as the target keeps it" +
                (profile_.arithmetic.blend_source == BlendSource::TargetBits ? "; s is cut to the target's bits before"
                                                                             : ""),
            .formula = formula(profile_.arithmetic.blend),
            .axes    = {},
            .draw    = {}};
    }

    const Profile& profile_;
    Prober& prober_;
    std::vector<VectorTable>& tables_;
};

}  // namespace

void add_blend_tables(const Profile& profile, Prober& prober, std::vector<VectorTable>& tables) {
    BlendTables add(profile, prober, tables);
    // The GameCube has no format that keeps both alpha and whole bytes of colour.
    const TargetFormat with_alpha = profile.formats.with_alpha, with_bytes = profile.formats.with_bytes;
    const auto is_among = [](BlendFactor factor, const std::vector<BlendFactor>& factors) {
        return std::find(factors.begin(), factors.end(), factor) != factors.end();
    };
    for (const Mode& mode : kModes) {
        if (!is_among(mode.source, profile.states.source_factors) || !is_among(mode.dest, profile.states.dest_factors))
            continue;
        const TargetFormat color = mode.third == ThirdInput::DestAlpha ? with_alpha : with_bytes;
        add.add_color(mode, color, "r", color == with_bytes ? "" : suffix_of(color));
        add.add_alpha(mode, with_alpha);
    }
    for (const TargetFormat format : profile.formats.draw) {
        if (keeps_bytes(format)) continue;
        const std::string suffix = suffix_of(format);
        add.add_color(kOver, format, "r", suffix);
        if (prober.levels(format, "g") != prober.levels(format, "r"))
            add.add_color(kOver, format, "g", suffix + "_green");
    }
}

}  // namespace demo
