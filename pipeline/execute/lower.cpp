// SPDX-License-Identifier: MIT
#include "pipeline/execute/lower.h"

#include <algorithm>

#include "pipeline/execute/vertex_stage.h"
#include "raster/sample_plan.h"

namespace pipeline {

static_assert(kTextureStages <= raster::kMaxTextures);
static_assert(kMaxTextureSize < 1 << raster::kMaxLevels);
static_assert(kMaxTargetSize + static_cast<int>(kGuardBand) <= static_cast<int>(raster::kMaxCoordinate));
static_assert(kMaxRectangleCoordinate <= static_cast<int>(raster::kMaxCoordinate));

namespace {

raster::BlendFactor lower(BlendFactor factor) {
    using enum raster::BlendFactor::Operand;
    switch (factor) {
        case BlendFactor::Zero:
            return raster::kZero;
        case BlendFactor::One:
            return raster::kOne;
        case BlendFactor::SourceColor:
            return {Source, false, false};
        case BlendFactor::InvSourceColor:
            return {Source, false, true};
        case BlendFactor::DestColor:
            return {Dest, false, false};
        case BlendFactor::InvDestColor:
            return {Dest, false, true};
        case BlendFactor::SourceAlpha:
            return {Source, true, false};
        case BlendFactor::InvSourceAlpha:
            return {Source, true, true};
        case BlendFactor::DestAlpha:
            return {Dest, true, false};
        case BlendFactor::InvDestAlpha:
            return {Dest, true, true};
    }
    return raster::kZero;
}

raster::Compare lower(CompareFunc func) {
    switch (func) {
        case CompareFunc::Always:
            return raster::Compare::Always;
        case CompareFunc::LessEqual:
            return raster::Compare::LessEqual;
        case CompareFunc::Less:
            return raster::Compare::Less;
        case CompareFunc::GreaterEqual:
            return raster::Compare::GreaterEqual;
        case CompareFunc::Greater:
            return raster::Compare::Greater;
        case CompareFunc::Equal:
            return raster::Compare::Equal;
        case CompareFunc::NotEqual:
            return raster::Compare::NotEqual;
        case CompareFunc::Never:
            return raster::Compare::Never;
    }
    return raster::Compare::Always;
}

raster::CombineArg::Source lower(ArgSource source) {
    using Source = raster::CombineArg::Source;
    switch (source) {
        case ArgSource::Diffuse:
            return Source::Diffuse;
        case ArgSource::Current:
            return Source::Current;
        case ArgSource::Texture:
            return Source::Texel;
        case ArgSource::TFactor:
            return Source::Constant;
        case ArgSource::Specular:
            return Source::Specular;
    }
    return Source::Current;
}

raster::CombineArg lower(const TextureArg& arg) {
    return {lower(arg.source), arg.complement, arg.alpha_replicate};
}

raster::Combine lower(TextureOp op, const TextureArg& arg1, const TextureArg& arg2) {
    const raster::CombineArg a = lower(arg1), b = lower(arg2);
    const auto blend = [&](ArgSource alpha) {
        return raster::Combine{raster::CombineOp::Lerp, a, b, {lower(alpha), false, true}};
    };
    switch (op) {
        case TextureOp::Disable:
            break;  // the chain has ended before
        case TextureOp::SelectArg1:
            return {raster::CombineOp::Select, a, a, {}};
        case TextureOp::SelectArg2:
            return {raster::CombineOp::Select, b, b, {}};
        case TextureOp::Modulate:
            return {raster::CombineOp::Modulate, a, b, {}};
        case TextureOp::Modulate2X:
            return {raster::CombineOp::Modulate2X, a, b, {}};
        case TextureOp::Modulate4X:
            return {raster::CombineOp::Modulate4X, a, b, {}};
        case TextureOp::Add:
            return {raster::CombineOp::Add, a, b, {}};
        case TextureOp::AddSigned:
            return {raster::CombineOp::AddSigned, a, b, {}};
        case TextureOp::AddSigned2X:
            return {raster::CombineOp::AddSigned2X, a, b, {}};
        case TextureOp::Subtract:
            return {raster::CombineOp::Subtract, a, b, {}};
        case TextureOp::BlendDiffuseAlpha:
            return blend(ArgSource::Diffuse);
        case TextureOp::BlendTextureAlpha:
            return blend(ArgSource::Texture);
        case TextureOp::BlendFactorAlpha:
            return blend(ArgSource::TFactor);
        case TextureOp::BlendCurrentAlpha:
            return blend(ArgSource::Current);
        case TextureOp::ModulateColorAddAlpha:
            return {raster::CombineOp::MultiplyAdd, a, b, {a.source, a.complement, true}};
    }
    return {};
}

raster::Address lower(TextureAddress address) {
    switch (address) {
        case TextureAddress::Wrap:
            return raster::Address::Wrap;
        case TextureAddress::Clamp:
            return raster::Address::Clamp;
        case TextureAddress::Mirror:
            return raster::Address::Mirror;
    }
    return raster::Address::Wrap;
}

raster::MipFilter lower(MipFilter filter) {
    switch (filter) {
        case MipFilter::None:
            return raster::MipFilter::None;
        case MipFilter::Point:
            return raster::MipFilter::Point;
        case MipFilter::Linear:
            return raster::MipFilter::Linear;
    }
    return raster::MipFilter::None;
}

raster::FilterRule lower(FilterRule rule) {
    switch (rule) {
        case FilterRule::Reference8:
            return raster::FilterRule::Single8;
        case FilterRule::GsFloor4:
            return raster::FilterRule::Cascade4;
        case FilterRule::GsNearest4:
            return raster::FilterRule::Single4;
        case FilterRule::FlipperFloor7:
            return raster::FilterRule::Single7;
        case FilterRule::Nv2aHalfUp8:
            return raster::FilterRule::Cascade8;
    }
    return raster::FilterRule::Single8;
}

raster::Sampler lower(FilterRule rule, const TextureStage& stage, const TextureBinding& binding,
                      const FrameMemory& memory) {
    raster::Sampler sampler = memory.sampler(binding);
    sampler.linear          = stage.filter == TextureFilter::Linear;
    sampler.rule            = lower(rule);
    sampler.mip             = lower(stage.mip_filter);
    sampler.address_u       = lower(stage.address_u);
    sampler.address_v       = lower(stage.address_v);
    return sampler;
}

raster::CombineRule lower(CombineRule rule) {
    switch (rule) {
        case CombineRule::Nearest255:
            return raster::CombineRule::Nearest255;
        case CombineRule::GsShift7:
            return raster::CombineRule::Shift7;
        case CombineRule::Tev:
            return raster::CombineRule::Expanded256;
    }
    return raster::CombineRule::Nearest255;
}

raster::FogRule lower(FogRule rule) {
    switch (rule) {
        case FogRule::Nearest255:
            return raster::FogRule::Nearest255;
        case FogRule::GsFloor256:
            return raster::FogRule::Floor256;
        case FogRule::GsTwoFloors:
            return raster::FogRule::TwoFloors;
        case FogRule::FlipperFloor256:
            return raster::FogRule::Expanded256;
    }
    return raster::FogRule::Nearest255;
}

raster::AlphaFail lower(AlphaFail fail, std::optional<TargetFormat> color) {
    switch (fail) {
        case AlphaFail::Keep:
            return raster::AlphaFail::Keep;
        case AlphaFail::FbOnly:
            return raster::AlphaFail::ColorOnly;
        case AlphaFail::ZbOnly:
            return raster::AlphaFail::DepthOnly;
        case AlphaFail::RgbOnly:
            return color && color_format(*color).alpha == 8 ? raster::AlphaFail::RgbOnly : raster::AlphaFail::ColorOnly;
    }
    return raster::AlphaFail::Keep;
}

raster::DestAlphaTest lower(DestAlphaTest test) {
    switch (test) {
        case DestAlphaTest::Off:
            return raster::DestAlphaTest::Off;
        case DestAlphaTest::Zero:
            return raster::DestAlphaTest::Zero;
        case DestAlphaTest::One:
            return raster::DestAlphaTest::One;
    }
    return raster::DestAlphaTest::Off;
}

raster::BlendRule lower(BlendRule rule) {
    switch (rule) {
        case BlendRule::Nearest255:
            return raster::BlendRule::Nearest255;
        case BlendRule::GsShift7:
            return raster::BlendRule::Shift7;
        case BlendRule::FlipperTrunc256:
            return raster::BlendRule::Trunc256;
    }
    return raster::BlendRule::Nearest255;
}

raster::Shift7Blend lower(const GsBlend& blend) {
    using Operand      = raster::Shift7Blend::Operand;
    using Factor       = raster::Shift7Blend::Factor;
    const auto operand = [](GsColor color) {
        return color == GsColor::Cs ? Operand::Source : color == GsColor::Cd ? Operand::Dest : Operand::Zero;
    };
    const auto factor = [](GsAlpha alpha) {
        return alpha == GsAlpha::As ? Factor::SourceAlpha : alpha == GsAlpha::Ad ? Factor::DestAlpha : Factor::Constant;
    };
    return {.a               = operand(blend.a),
            .b               = operand(blend.b),
            .d               = operand(blend.d),
            .c               = factor(blend.c),
            .constant        = blend.fix,
            .only_above_half = blend.pabe,
            .clamp           = blend.colclamp,
            .set_top_bit     = blend.fba};
}

raster::Dither lower(DitherMode mode) {
    switch (mode) {
        case DitherMode::None:
            return raster::Dither::None;
        case DitherMode::Flipper2x2:
            return raster::Dither::Ordered2x2;
        case DitherMode::GsDimx:
            return raster::Dither::Matrix4x4;
    }
    return raster::Dither::None;
}

std::uint32_t lower(const ColorMask& mask) {
    return (mask.alpha ? 0xff000000u : 0u) | (mask.red ? 0x00ff0000u : 0u) | (mask.green ? 0x0000ff00u : 0u) |
           (mask.blue ? 0x000000ffu : 0u);
}

raster::Blend lower_blend(const Arithmetic& arithmetic, const PipelineState& state, std::optional<TargetFormat> color) {
    raster::Blend out;
    out.rule       = lower(arithmetic.blend);
    out.source     = lower(state.blend.source);
    out.dest       = lower(state.blend.dest);
    out.shift7     = lower(state.gs_blend);
    out.cut_source = arithmetic.blend_source == BlendSource::TargetBits;
    out.dither     = lower(state.dither.mode);
    std::transform(state.dither.matrix.begin(), state.dither.matrix.end(), out.dither_matrix.begin(),
                   [](std::int32_t offset) { return static_cast<std::int8_t>(offset); });
    out.write_mask = lower(state.color_mask);
    if (color && color_format(*color).alpha == 0) out.write_mask &= 0x00ffffff;  // there is nothing to write
    return out;
}

}  // namespace

raster::FillState lower(const Arithmetic& arithmetic, const PipelineState& state, std::optional<TargetFormat> color,
                        const TextureBindings& textures, const FrameMemory& memory) {
    raster::FillState out;
    out.floor_colors = arithmetic.gouraud == GouraudRule::Floor;
    out.whole_depth  = arithmetic.vertex_depth == VertexDepth::WholeUnits;
    out.stage_count  = stage_count(state);
    for (int i = 0; i < out.stage_count; ++i) {
        const TextureStage& stage = state.stages[i];
        out.stages[i]             = {.color = lower(stage.color_op, stage.color_arg1, stage.color_arg2),
                                     .alpha = lower(stage.alpha_op, stage.alpha_arg1, stage.alpha_arg2)};
        out.samplers[i]           = lower(arithmetic.filter, stage, textures[i], memory);
    }
    out.combine_rule    = lower(arithmetic.combine);
    out.constant        = state.texture_factor.value;
    out.add_specular    = state.lighting.specular_enable;
    out.fog             = state.fog.mode != FogMode::None;
    out.fog_rule        = lower(arithmetic.fog);
    out.fog_color       = state.fog.color.value;
    out.alpha_func      = lower(state.alpha_test.func);
    out.alpha_reference = state.alpha_test.reference;
    out.alpha_fail      = lower(state.alpha_test.fail, color);
    out.dest_alpha_test = lower(state.dest_alpha_test);
    if (state.dest_alpha_test != DestAlphaTest::Off && color && color_format(*color).alpha == 0) {
        out.alpha_func      = raster::Compare::Never;  // nothing passes, see test_state.h
        out.alpha_fail      = raster::AlphaFail::Keep;
        out.dest_alpha_test = raster::DestAlphaTest::Off;
    }
    out.depth_func  = lower(state.depth.func);
    out.depth_write = state.depth.write;
    out.blend       = lower_blend(arithmetic, state, color);
    return out;
}

raster::ColorFormat color_format(TargetFormat format) {
    switch (format) {
        case TargetFormat::A8R8G8B8:
        case TargetFormat::Psmct32:
        case TargetFormat::D16:
        case TargetFormat::D24:
        case TargetFormat::D32:
            break;
        case TargetFormat::X8R8G8B8:
            return {.alpha = 0};
        case TargetFormat::R5G6B5:
            return {.red = 5, .green = 6, .blue = 5, .alpha = 0};
        case TargetFormat::A1R5G5B5:
            return {.red = 5, .green = 5, .blue = 5, .alpha = 1};
        case TargetFormat::R6G6B6A6:
            return {.red = 6, .green = 6, .blue = 6, .alpha = 6};
        case TargetFormat::Psmct24:
            return {.alpha = 0, .zero_fill = true};
        case TargetFormat::Psmct16:
            return {.red = 5, .green = 5, .blue = 5, .alpha = 1, .zero_fill = true};
    }
    return {};
}

int depth_bits(TargetFormat format) {
    return format == TargetFormat::D16 ? 16 : format == TargetFormat::D24 ? 24 : format == TargetFormat::D32 ? 32 : 0;
}

raster::PixelGrid pixel_grid(const Arithmetic& arithmetic) {
    return {.center = arithmetic.pixel_center, .truncate = arithmetic.snap == SnapRule::Truncate};
}

bool reads_destination(const Arithmetic& arithmetic, const PipelineState& state) {
    if (arithmetic.blend == BlendRule::GsShift7) {
        const GsBlend& blend   = state.gs_blend;
        const bool has_product = blend.a != blend.b;
        return blend.d == GsColor::Cd ||
               (has_product && (blend.a == GsColor::Cd || blend.b == GsColor::Cd || blend.c == GsAlpha::Ad));
    }
    return lower(state.blend.source).operand == raster::BlendFactor::Operand::Dest ||
           state.blend.dest != BlendFactor::Zero;
}

}  // namespace pipeline
