// SPDX-License-Identifier: MIT
#include "pipeline/emit/gs_draw_state.h"
#include "pipeline/legalize/window_map.h"

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "pipeline/check/target_use.h"

namespace pipeline {

namespace {

std::size_t at(std::int32_t index) {
    return static_cast<std::size_t>(index);
}

std::uint64_t atst(CompareFunc func) {
    switch (func) {
        case CompareFunc::Never:
            return 0;
        case CompareFunc::Always:
            return 1;
        case CompareFunc::Less:
            return 2;
        case CompareFunc::LessEqual:
            return 3;
        case CompareFunc::Equal:
            return 4;
        case CompareFunc::GreaterEqual:
            return 5;
        case CompareFunc::Greater:
            return 6;
        case CompareFunc::NotEqual:
            return 7;
    }
    return 1;
}

std::uint64_t ztst(CompareFunc func) {
    switch (func) {
        case CompareFunc::Never:
            return 0;
        case CompareFunc::Always:
            return 1;
        case CompareFunc::GreaterEqual:
            return 2;
        case CompareFunc::Greater:
            return 3;
        case CompareFunc::Less:
        case CompareFunc::LessEqual:
        case CompareFunc::Equal:
        case CompareFunc::NotEqual:
            break;
    }
    throw std::invalid_argument("the Graphics Synthesizer has no depth test " + std::string(enum_name(func)));
}

std::uint64_t afail(AlphaFail fail) {
    switch (fail) {
        case AlphaFail::Keep:
            return 0;
        case AlphaFail::FbOnly:
            return 1;
        case AlphaFail::ZbOnly:
            return 2;
        case AlphaFail::RgbOnly:
            return 3;
    }
    return 0;
}

std::uint64_t operand(GsColor color) {
    return color == GsColor::Cs ? 0 : color == GsColor::Cd ? 1 : 2;
}
std::uint64_t operand(GsAlpha alpha) {
    return alpha == GsAlpha::As ? 0 : alpha == GsAlpha::Ad ? 1 : 2;
}

// Bits of FBMSK stay: red lowest, alpha highest, 8 each, whatever the format.
std::uint32_t kept_bits(const ColorMask& mask) {
    return (mask.red ? 0 : 0x000000ffu) | (mask.green ? 0 : 0x0000ff00u) | (mask.blue ? 0 : 0x00ff0000u) |
           (mask.alpha ? 0 : 0xff000000u);
}

std::uint64_t dimx(const DitherState& dither) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < dither.matrix.size(); ++i)
        value |= (static_cast<std::uint64_t>(dither.matrix[i]) & 7) << (4 * i);
    return value;
}

void set_tests(const PipelineState& state, bool has_depth, GsBuilder& out) {
    const AlphaTestState& alpha = state.alpha_test;
    const bool tests_alpha      = alpha.func != CompareFunc::Always,
               tests_dest       = state.dest_alpha_test != DestAlphaTest::Off;
    // ZTE 0 is said to be forbidden; the test that always passes stands for it.
    out.set(GsReg::Test, {{"ATE", tests_alpha},
                          {"ATST", atst(alpha.func)},
                          {"AREF", alpha.reference},
                          {"AFAIL", afail(alpha.fail)},
                          {"DATE", tests_dest},
                          {"DATM", state.dest_alpha_test == DestAlphaTest::One},
                          {"ZTE", 1},
                          {"ZTST", ztst(has_depth ? state.depth.func : CompareFunc::Always)}});
}

void set_blend(const GsBlend& blend, GsBuilder& out) {
    out.set(GsReg::Alpha, {{"A", operand(blend.a)},
                           {"B", operand(blend.b)},
                           {"C", operand(blend.c)},
                           {"D", operand(blend.d)},
                           {"FIX", blend.fix}});
    out.set(GsReg::Pabe, {{"PABE", blend.pabe}});
    out.set(GsReg::ColClamp, {{"CLAMP", blend.colclamp}});
    out.set(GsReg::Fba, {{"FBA", blend.fba}});
}

enum class Source { Other, Vertex, Texel };
Source selected(TextureOp op, const TextureArg& arg1, const TextureArg& arg2) {
    if (op != TextureOp::SelectArg1 && op != TextureOp::SelectArg2) return Source::Other;
    return (op == TextureOp::SelectArg1 ? arg1 : arg2).source == ArgSource::Texture ? Source::Texel : Source::Vertex;
}

}  // namespace

GsSurface frame_surface(const GsMemory& memory, const Pass& pass) {
    if (pass.color) return memory.targets[at(pass.color.index)];
    GsSurface surface = memory.targets[at(pass.depth.index)];
    surface.psm       = surface.has_16_bits() ? GsPsm::Ct16 : GsPsm::Ct32;
    return surface;
}

void set_targets(const GsTargets& targets, const PixelRect& part, GsBuilder& out) {
    const GsSurface& color = targets.color;
    out.set(GsReg::Frame,
            {{"FBP", color.page()}, {"FBW", color.width64}, {"PSM", code(color.psm)}, {"FBMSK", targets.keep_bits}});
    // Without a depth target ZBUF must still be of the colour's family. It is neither read nor written.
    const GsPsm none = color.has_16_bits() ? GsPsm::Z16 : GsPsm::Z24;
    out.set(GsReg::Zbuf, {{"ZBP", targets.depth ? targets.depth->page() : color.page()},
                          {"PSM", code(targets.depth ? targets.depth->psm : none) & 15},
                          {"ZMSK", !(targets.depth && targets.writes_depth)}});
    out.set(GsReg::XyOffset, {{"OFX", kGsWindowOrigin}, {"OFY", kGsWindowOrigin}});
    out.set(GsReg::Scissor, {{"SCAX0", static_cast<std::uint64_t>(part.x0)},
                             {"SCAX1", static_cast<std::uint64_t>(part.x1 - 1)},
                             {"SCAY0", static_cast<std::uint64_t>(part.y0)},
                             {"SCAY1", static_cast<std::uint64_t>(part.y1 - 1)}});
}

void set_pass_state(const Frame& frame, const GsMemory& memory, const Pass& pass, GsBuilder& out) {
    const PipelineState& state = pass.state;
    GsTargets targets{.color = frame_surface(memory, pass)};
    targets.keep_bits     = pass.color ? kept_bits(state.color_mask) : 0xffffffffu;
    // A depth target that the pass does not use may be of the other family.
    const bool uses_depth = pass.depth && (state.depth.write || state.depth.func != CompareFunc::Always);
    if (uses_depth) targets.depth = memory.targets[at(pass.depth.index)];
    targets.writes_depth = state.depth.write;
    set_targets(targets, limit_of(frame, pass), out);
    set_tests(state, uses_depth, out);
    set_blend(state.gs_blend, out);
    const bool dithers = state.dither.mode == DitherMode::GsDimx;
    if (dithers) out.set(GsReg::Dimx, dimx(state.dither));
    out.set(GsReg::Dthe, {{"DTHE", dithers}});
    const std::uint32_t fog = state.fog.color.value;
    if (state.fog.mode != FogMode::None)
        out.set(GsReg::FogCol, {{"FCR", fog >> 16 & 255}, {"FCG", fog >> 8 & 255}, {"FCB", fog & 255}});
}

void set_plain_state(GsBuilder& out) {
    set_tests({}, false, out);
    set_blend({}, out);
    out.set(GsReg::Dthe, {{"DTHE", 0}});
}

std::optional<GsFunction> texture_function(const PipelineState& state) {
    constexpr std::uint32_t kModulate = 0, kDecal = 1, kHighlight = 2, kHighlight2 = 3;
    const TextureStage& stage = state.stages[0];
    const Source color        = selected(stage.color_op, stage.color_arg1, stage.color_arg2),
                 alpha        = selected(stage.alpha_op, stage.alpha_arg1, stage.alpha_arg2);
    if (stage.color_op == TextureOp::Disable || color == Source::Vertex) return {};
    const std::uint32_t tcc = alpha == Source::Vertex ? 0 : 1;
    if (color == Source::Texel) return GsFunction{kDecal, tcc};
    if (stage.color_op == TextureOp::Modulate) return GsFunction{kModulate, tcc};
    return GsFunction{alpha == Source::Texel ? kHighlight2 : kHighlight, tcc};
}

GsTexture bound_texture(const Frame& frame, const GsMemory& memory, const TextureBinding& binding) {
    if (binding.target) return {memory.targets[at(binding.target.index)], {}};
    if (!binding.texture) return {*memory.white, {}};
    const TextureFormat format = frame.textures[at(binding.texture.index)].format;
    const GsSurface& surface   = memory.textures[at(binding.texture.index)];
    if (format == TextureFormat::A8) return {surface, memory.a8_palette};
    if (format == TextureFormat::L8) return {surface, memory.l8_palette};
    return {surface, {}};
}

std::uint32_t log2_size(std::int32_t size) {
    return static_cast<std::uint32_t>(std::bit_width(static_cast<std::uint32_t>(size) - 1));
}

void set_texture(const GsTexture& texture, const GsFunction& function, bool linear, bool repeat_u, bool repeat_v,
                 GsBuilder& out) {
    const GsSurface& surface = texture.surface;
    // What has no alpha, or one bit of it: 0x80 is one.
    out.set(GsReg::TexA, {{"TA0", surface.psm == GsPsm::Ct24 ? 0x80u : 0u}, {"AEM", 0}, {"TA1", 0x80}});
    out.set(GsReg::Tex1, {{"LCM", 1}, {"MXL", 0}, {"MMAG", linear}, {"MMIN", linear}, {"K", 0}});
    // REGION_CLAMP takes any size, where CLAMP takes 2^TW and 2^TH.
    const auto mode = [](bool repeats, std::int32_t size) -> std::uint64_t {
        return repeats ? 0 : std::has_single_bit(static_cast<std::uint32_t>(size)) ? 1 : 2;
    };
    out.set(GsReg::Clamp, {{"WMS", mode(repeat_u, surface.width)},
                           {"WMT", mode(repeat_v, surface.height)},
                           {"MINU", 0},
                           {"MAXU", static_cast<std::uint64_t>(surface.width - 1)},
                           {"MINV", 0},
                           {"MAXV", static_cast<std::uint64_t>(surface.height - 1)}});
    out.set(GsReg::Tex0, {{"TBP0", surface.block},
                          {"TBW", surface.width64},
                          {"PSM", code(surface.psm)},
                          {"TW", log2_size(surface.width)},
                          {"TH", log2_size(surface.height)},
                          {"TCC", function.tcc},
                          {"TFX", function.tfx},
                          {"CBP", texture.palette.value_or(0)},
                          {"CPSM", code(GsPsm::Ct32)},
                          {"CSM", 0},
                          {"CSA", 0},
                          {"CLD", texture.palette ? 1u : 0u}});
}

bool blends(const GsBlend& blend) {
    return blend.a != blend.b || blend.d != GsColor::Cs;
}

}  // namespace pipeline
