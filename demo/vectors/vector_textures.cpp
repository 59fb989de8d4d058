// SPDX-License-Identifier: MIT
// Texture functions and filters.
#include "demo/vectors/vector_probe.h"

namespace demo {

using namespace pipeline;

namespace {

// a is DIFFUSE, and b the texel; in the lerp, whose factor x must come from DIFFUSE's alpha, a is the texel.
struct Function {
    TextureOp op;
    std::string_view nearest255, tev, gs_shift7;  // empty: the rule has no such function
};
using enum TextureOp;
constexpr Function kFunctions[] = {
    {SelectArg1, "a", "a", "a"},
    {Modulate, "floor((a * b + 127) / 255)", "(a * e(b) + 128) >> 8", "min(255, a * b >> 7)"},
    {Modulate2X, "floor((min(65025, 2 * a * b) + 127) / 255)", "min(255, (2 * a * e(b) + 128) >> 8)", ""},
    {Modulate4X, "floor((min(65025, 4 * a * b) + 127) / 255)", "min(255, (4 * a * e(b) + 128) >> 8)", ""},
    {Add, "min(255, a + b)", "min(255, a + b)", "min(255, a + b)"},
    {AddSigned, "clamp(a + b - 127)", "clamp(a + b - 128)", ""},
    {AddSigned2X, "clamp(2 * a + 2 * b - 255)", "clamp(2 * a + 2 * b - 256)", ""},
    {Subtract, "max(0, a - b)", "max(0, a - b)", ""},
    {BlendDiffuseAlpha, "floor((a * x + b * (255 - x) + 127) / 255)", "(a * e(x) + b * (256 - e(x)) + 128) >> 8", ""},
    {ModulateColorAddAlpha, "min(255, floor((a * b + 127) / 255) + x)", "min(255, ((a * e(b) + 128) >> 8) + x)",
     "min(255, (a * b >> 7) + x)"},
};

std::string_view expression_of(const Function& function, CombineRule rule) {
    switch (rule) {
        case CombineRule::Nearest255:
            return function.nearest255;
        case CombineRule::Tev:
            return function.tev;
        case CombineRule::GsShift7:
            return function.gs_shift7;
    }
    return {};
}

constexpr bool has_three_inputs(TextureOp op) {
    return op == BlendDiffuseAlpha || op == ModulateColorAddAlpha;
}

// The Graphics Synthesizer adds alpha alone, in HIGHLIGHT.
bool is_of_alpha(CombineRule rule, TextureOp op) {
    return rule == CombineRule::GsShift7 && op == Add;
}

Bytes draw_function(Prober& prober, TargetFormat format, TextureOp op, bool is_of_alpha) {
    Probe probe{.format = format, .bands = {{.state = {}, .rows = {}}}};
    ProbeBand& band    = probe.bands[0];
    const bool is_lerp = op == BlendDiffuseAlpha;
    if (is_of_alpha) {
        band.state.stages[0]            = {.color_op = SelectArg1, .alpha_op = op};
        band.state.stages[0].alpha_arg1 = {.source = ArgSource::Diffuse};
        band.state.stages[0].alpha_arg2 = {.source = ArgSource::Texture};
        for (std::uint32_t row = 0; row < 256; ++row) band.rows.push_back({.dest = 0, .source = with_alpha(0, row)});
        return prober.draw(probe, "a");
    }
    band.state.stages[0] = {.color_op   = op,
                            .color_arg1 = {.source = is_lerp ? ArgSource::Texture : ArgSource::Diffuse},
                            .color_arg2 = {.source = is_lerp ? ArgSource::Diffuse : ArgSource::Texture},
                            .alpha_op   = SelectArg2};
    for (std::uint32_t x = 0; x < (has_three_inputs(op) ? 256u : 1u); ++x)
        for (std::uint32_t row = 0; row < 256; ++row)
            band.rows.push_back({.dest = 0, .source = with_alpha(grey(row), x)});
    return prober.draw(probe, "r");
}

void add_function(const Profile& profile, Prober& prober, const Function& function, std::vector<VectorTable>& tables) {
    const std::string_view expression = expression_of(function, profile.arithmetic.combine);
    if (expression.empty()) return;
    const TextureOp op        = function.op;
    const bool alpha          = is_of_alpha(profile.arithmetic.combine, op);
    const TargetFormat format = profile.formats.with_bytes;
    VectorTable table{
        .name  = "texture_" + lower_case(enum_name(op)),
        .topic = "combine",
        .rule  = std::string(enum_name(profile.arithmetic.combine)),
        .what  = "texture function " + std::string(enum_name(op)) +
                (op == BlendDiffuseAlpha ? " of the texel a and the vertex colour b; every BLENDxALPHA alike"
                 : alpha                 ? " of the vertex's alpha a and the texel's b, in HIGHLIGHT"
                                         : " of the vertex colour a and the texel b") +
                (op == ModulateColorAddAlpha ? ", x being the vertex alpha; HIGHLIGHT on the GS" : ""),
        .expression =
            std::string(expression) + (expression.find("e(") != expression.npos ? ", e(v) = v + (v >> 7)" : ""),
        .formula = formula(profile.arithmetic.combine),
        .axes    = {},
        .draw    = [&prober, format, op, alpha] { return draw_function(prober, format, op, alpha); }};
    if (has_three_inputs(op)) table.axes.push_back({"vertex_alpha_x", AxisRange{}});
    const bool is_lerp = op == BlendDiffuseAlpha;
    table.axes.push_back({is_lerp ? "vertex_color_b" : alpha ? "vertex_alpha_a" : "vertex_color_a", AxisRange{}});
    table.axes.push_back({is_lerp ? "texel_a" : alpha ? "texel_alpha_b" : "texel_b", AxisRange{}});
    tables.push_back(std::move(table));
}

constexpr std::size_t kQuads = 32;

// Texels t00 t10 t01 t11: one bright, pairs, extremes and middles, and then bytes of a small generator (x * 69069 + 1).
std::array<std::array<std::uint8_t, 4>, kQuads> filter_quads() {
    std::array<std::array<std::uint8_t, 4>, kQuads> quads{{{255, 0, 0, 0},
                                                           {0, 255, 0, 0},
                                                           {0, 0, 255, 0},
                                                           {0, 0, 0, 255},
                                                           {0, 255, 0, 255},
                                                           {255, 0, 255, 0},
                                                           {0, 0, 255, 255},
                                                           {255, 255, 0, 0},
                                                           {0, 255, 255, 0},
                                                           {255, 255, 255, 255},
                                                           {127, 128, 128, 127},
                                                           {0, 1, 1, 0},
                                                           {1, 0, 0, 0},
                                                           {254, 255, 255, 254},
                                                           {0, 85, 170, 255},
                                                           {255, 170, 85, 0}}};
    std::uint32_t x = 7;
    for (std::size_t i = 16; i < kQuads; ++i)
        for (std::uint8_t& texel : quads[i]) {
            x     = x * 69069 + 1;
            texel = static_cast<std::uint8_t>(x >> 24);
        }
    return quads;
}

// Pixel (i, j) of a quad's 256x256 pixels lies i / 256 and j / 256 of the way from its first texel to the next.
Bytes draw_filter(Prober& prober, TargetFormat format) {
    Frame frame                    = probe_frame(format, 256, 256 * kQuads);
    Pass& pass                     = frame.passes.emplace_back();
    pass.color                     = {0};
    pass.state.stages[0]           = ramp_color_and_alpha();
    pass.state.stages[0].filter    = TextureFilter::Linear;
    pass.state.stages[0].address_u = pass.state.stages[0].address_v = TextureAddress::Clamp;
    for (const auto& quad : filter_quads()) {
        const auto index   = static_cast<int>(frame.textures.size());
        Texture& texture   = frame.textures.emplace_back();
        texture.format     = TextureFormat::L8;
        texture.width      = 2;
        texture.height     = 2;
        texture.texels     = {quad.begin(), quad.end()};
        DrawRectangle draw = prober.rectangle(0, 256 * index, 256, 256 * (index + 1));
        const float start  = (0.5f - 0.5f / 256.0f) / 2.0f;  // so that the middle of pixel 0 is the middle of texel 0
        draw.uv[0]         = {start, start, start + 0.5f, start + 0.5f};
        draw.textures[0]   = {.texture = {index}, .target = {}};
        pass.draws.emplace_back(draw);
    }
    return prober.draw(std::move(frame), "r");
}

void add_filter(const Profile& profile, Prober& prober, FilterRule rule, const std::string& suffix,
                std::vector<VectorTable>& tables) {
    tables.push_back(
        {.name       = "filter" + suffix,
         .topic      = "filter",
         .rule       = std::string(enum_name(rule)),
         .what       = "filter LINEAR between the four texels of each quad of filter_quads",
         .expression = "see formula; the fractions are in 1/256 texel",
         .formula    = formula(rule),
         .axes       = {{"quad", AxisRange{0, kQuads - 1}}, {"fraction_v", AxisRange{}}, {"fraction_u", AxisRange{}}},
         .draw       = [rule, format = profile.formats.with_bytes, &prober] {
             Arithmetic other = prober.arithmetic();
             other.filter     = rule;
             Prober with_rule = prober.with(other);
             return draw_filter(with_rule, format);
         }});
}

}  // namespace

void add_texture_tables(const Profile& profile, Prober& prober, std::vector<VectorTable>& tables) {
    for (const Function& function : kFunctions) add_function(profile, prober, function, tables);
    tables.push_back(
        {.name       = "filter_quads",
         .topic      = "filter",
         .rule       = "input",
         .what       = "the texels that the filter arrays are drawn with",
         .expression = "an input, not a result",
         .formula    = "an input, not a result",
         .axes = {{"quad", AxisRange{0, kQuads - 1}}, {"texel", std::vector<std::string>{"t00", "t10", "t01", "t11"}}},
         .draw = [] {
             Bytes bytes;
             for (const auto& quad : filter_quads()) bytes.insert(bytes.end(), quad.begin(), quad.end());
             return bytes;
         }});
    add_filter(profile, prober, profile.arithmetic.filter, "", tables);
    if (profile.arithmetic.filter == FilterRule::GsFloor4)
        add_filter(profile, prober, FilterRule::GsNearest4, "_gs_nearest4", tables);
}

}  // namespace demo
