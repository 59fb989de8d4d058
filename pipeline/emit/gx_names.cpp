// SPDX-License-Identifier: MIT
#include "pipeline/emit/gx_names.h"

#include <stdexcept>
#include <string>

namespace pipeline {

namespace {

template <NamedEnum Enum>
[[noreturn]] void refuse(Enum value) {
    throw std::invalid_argument("GX has nothing for " + std::string(enum_name(value)));
}

// Those that both sides have.
std::string_view common_factor(BlendFactor factor) {
    switch (factor) {
        case BlendFactor::Zero:
            return "GX_BL_ZERO";
        case BlendFactor::One:
            return "GX_BL_ONE";
        case BlendFactor::SourceAlpha:
            return "GX_BL_SRCALPHA";
        case BlendFactor::InvSourceAlpha:
            return "GX_BL_INVSRCALPHA";
        case BlendFactor::DestAlpha:
            return "GX_BL_DSTALPHA";
        case BlendFactor::InvDestAlpha:
            return "GX_BL_INVDSTALPHA";
        case BlendFactor::SourceColor:
        case BlendFactor::InvSourceColor:
        case BlendFactor::DestColor:
        case BlendFactor::InvDestColor:
            break;
    }
    refuse(factor);
}

}  // namespace

std::string_view gx_compare(CompareFunc func) {
    switch (func) {
        case CompareFunc::Always:
            return "GX_ALWAYS";
        case CompareFunc::LessEqual:
            return "GX_LEQUAL";
        case CompareFunc::Less:
            return "GX_LESS";
        case CompareFunc::GreaterEqual:
            return "GX_GEQUAL";
        case CompareFunc::Greater:
            return "GX_GREATER";
        case CompareFunc::Equal:
            return "GX_EQUAL";
        case CompareFunc::NotEqual:
            return "GX_NEQUAL";
        case CompareFunc::Never:
            return "GX_NEVER";
    }
    refuse(func);
}

std::string_view gx_source_factor(BlendFactor factor) {
    if (factor == BlendFactor::DestColor) return "GX_BL_DSTCLR";
    if (factor == BlendFactor::InvDestColor) return "GX_BL_INVDSTCLR";
    return common_factor(factor);
}

std::string_view gx_dest_factor(BlendFactor factor) {
    if (factor == BlendFactor::SourceColor) return "GX_BL_SRCCLR";
    if (factor == BlendFactor::InvSourceColor) return "GX_BL_INVSRCCLR";
    return common_factor(factor);
}

std::string_view gx_cull(CullMode mode) {
    switch (mode) {
        case CullMode::None:
            return "GX_CULL_NONE";
        case CullMode::Clockwise:
            return "GX_CULL_FRONT";
        case CullMode::CounterClockwise:
            return "GX_CULL_BACK";
    }
    refuse(mode);
}

std::string_view gx_wrap(TextureAddress address) {
    switch (address) {
        case TextureAddress::Wrap:
            return "GX_REPEAT";
        case TextureAddress::Clamp:
            return "GX_CLAMP";
        case TextureAddress::Mirror:
            return "GX_MIRROR";
    }
    refuse(address);
}

std::string_view gx_min_filter(TextureFilter filter, MipFilter mip) {
    const bool is_linear = filter == TextureFilter::Linear;
    switch (mip) {
        case MipFilter::None:
            return gx_mag_filter(filter);
        case MipFilter::Point:
            return is_linear ? "GX_LIN_MIP_NEAR" : "GX_NEAR_MIP_NEAR";
        case MipFilter::Linear:
            return is_linear ? "GX_LIN_MIP_LIN" : "GX_NEAR_MIP_LIN";
    }
    refuse(mip);
}

std::string_view gx_mag_filter(TextureFilter filter) {
    return filter == TextureFilter::Linear ? "GX_LINEAR" : "GX_NEAR";
}

std::string_view gx_pixel_format(TargetFormat format) {
    if (format == TargetFormat::X8R8G8B8) return "GX_PF_RGB8_Z24";
    if (format == TargetFormat::R6G6B6A6) return "GX_PF_RGBA6_Z24";
    refuse(format);
}

}  // namespace pipeline
