// SPDX-License-Identifier: MIT
#include "pipeline/execute/lower.h"

#include "pipeline/execute/vertex_stage.h"
#include "raster/sample_blocks.h"

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
    }
    return raster::Compare::Always;
}

raster::CombineArg lower(const TextureArg& arg) {
    using Source      = raster::CombineArg::Source;
    const auto source = [&] {
        switch (arg.source) {
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
    };
    return {source(), arg.complement, arg.alpha_replicate};
}

raster::Combine lower(TextureOp op, const TextureArg& arg1, const TextureArg& arg2) {
    const raster::CombineArg a = lower(arg1), b = lower(arg2);
    switch (op) {
        case TextureOp::Disable:
            break;  // the chain has ended before
        case TextureOp::SelectArg1:
            return {raster::CombineOp::Select, a, a};
        case TextureOp::SelectArg2:
            return {raster::CombineOp::Select, b, b};
        case TextureOp::Modulate:
            return {raster::CombineOp::Modulate, a, b};
        case TextureOp::Modulate2X:
            return {raster::CombineOp::Modulate2X, a, b};
        case TextureOp::Modulate4X:
            return {raster::CombineOp::Modulate4X, a, b};
        case TextureOp::Add:
            return {raster::CombineOp::Add, a, b};
        case TextureOp::AddSigned:
            return {raster::CombineOp::AddSigned, a, b};
        case TextureOp::AddSigned2X:
            return {raster::CombineOp::AddSigned2X, a, b};
        case TextureOp::Subtract:
            return {raster::CombineOp::Subtract, a, b};
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

raster::Sampler lower(const TextureStage& stage, const TextureBinding& binding, const FrameMemory& memory) {
    raster::Sampler sampler = memory.sampler(binding);
    sampler.linear          = stage.filter == TextureFilter::Linear;
    sampler.mip             = lower(stage.mip_filter);
    sampler.address_u       = lower(stage.address_u);
    sampler.address_v       = lower(stage.address_v);
    return sampler;
}

std::uint32_t lower(const ColorMask& mask) {
    return (mask.alpha ? 0xff000000u : 0u) | (mask.red ? 0x00ff0000u : 0u) | (mask.green ? 0x0000ff00u : 0u) |
           (mask.blue ? 0x000000ffu : 0u);
}

}  // namespace

raster::FillState lower(const PipelineState& state, const TextureBindings& textures, const FrameMemory& memory) {
    raster::FillState out;
    out.stage_count = stage_count(state);
    for (int i = 0; i < out.stage_count; ++i) {
        const TextureStage& stage = state.stages[i];
        out.stages[i]             = {.color = lower(stage.color_op, stage.color_arg1, stage.color_arg2),
                                     .alpha = lower(stage.alpha_op, stage.alpha_arg1, stage.alpha_arg2)};
        out.samplers[i]           = lower(stage, textures[i], memory);
    }
    out.constant        = state.texture_factor.value;
    out.add_specular    = state.lighting.specular_enable;
    out.fog             = state.fog.mode != FogMode::None;
    out.fog_color       = state.fog.color.value;
    out.alpha_func      = lower(state.alpha_test.func);
    out.alpha_reference = state.alpha_test.reference;
    out.depth_func      = lower(state.depth.func);
    out.depth_write     = state.depth.write;
    out.source_factor   = lower(state.blend.source);
    out.dest_factor     = lower(state.blend.dest);
    out.write_mask      = lower(state.color_mask);
    return out;
}

int depth_bits(TargetFormat format) {
    switch (format) {
        case TargetFormat::A8R8G8B8:
            break;
        case TargetFormat::D16:
            return 16;
        case TargetFormat::D24:
            return 24;
        case TargetFormat::D32:
            return 32;
    }
    return 0;
}

bool reads_destination(const BlendState& blend) {
    return lower(blend.source).operand == raster::BlendFactor::Operand::Dest || blend.dest != BlendFactor::Zero;
}

}  // namespace pipeline
