// SPDX-License-Identifier: MIT
#include "pipeline/emit/nv2a_values.h"

#include <cmath>

namespace pipeline {
namespace {

[[noreturn]] void refuse(const std::string& what) {
    throw std::invalid_argument("the NV2A has no " + what);
}

}  // namespace

Nv2aValue nv2a_blend_factor(BlendFactor factor) {
    switch (factor) {
        case BlendFactor::Zero:
            return {0x0000, "ZERO"};
        case BlendFactor::One:
            return {0x0001, "ONE"};
        case BlendFactor::SourceColor:
            return {0x0300, "SRC_COLOR"};
        case BlendFactor::InvSourceColor:
            return {0x0301, "ONE_MINUS_SRC_COLOR"};
        case BlendFactor::SourceAlpha:
            return {0x0302, "SRC_ALPHA"};
        case BlendFactor::InvSourceAlpha:
            return {0x0303, "ONE_MINUS_SRC_ALPHA"};
        case BlendFactor::DestAlpha:
            return {0x0304, "DST_ALPHA"};
        case BlendFactor::InvDestAlpha:
            return {0x0305, "ONE_MINUS_DST_ALPHA"};
        case BlendFactor::DestColor:
            return {0x0306, "DST_COLOR"};
        case BlendFactor::InvDestColor:
            return {0x0307, "ONE_MINUS_DST_COLOR"};
    }
    refuse("such blend factor");
}

Nv2aValue nv2a_compare(CompareFunc func) {
    switch (func) {
        case CompareFunc::Never:
            return {0x200, "NEVER"};
        case CompareFunc::Less:
            return {0x201, "LESS"};
        case CompareFunc::Equal:
            return {0x202, "EQUAL"};
        case CompareFunc::LessEqual:
            return {0x203, "LEQUAL"};
        case CompareFunc::Greater:
            return {0x204, "GREATER"};
        case CompareFunc::NotEqual:
            return {0x205, "NOTEQUAL"};
        case CompareFunc::GreaterEqual:
            return {0x206, "GEQUAL"};
        case CompareFunc::Always:
            return {0x207, "ALWAYS"};
    }
    refuse("such comparison");
}

Nv2aValue nv2a_shade_mode(ShadeMode mode) {
    return mode == ShadeMode::Flat ? Nv2aValue{0x1d00, "FLAT"} : Nv2aValue{0x1d01, "SMOOTH"};
}

Nv2aValue nv2a_fog_mode(FogMode mode) {
    switch (mode) {
        case FogMode::None:
            break;
        case FogMode::Linear:
            return {0x2601, "LINEAR"};
        case FogMode::Exp:
            return {0x0800, "EXP"};
        case FogMode::Exp2:
            return {0x0801, "EXP2"};
    }
    refuse("such fog");
}

Nv2aValue nv2a_culled_face(CullMode mode) {
    switch (mode) {
        case CullMode::None:
            break;
        case CullMode::Clockwise:
            return {0x404, "FRONT"};
        case CullMode::CounterClockwise:
            return {0x405, "BACK"};
    }
    refuse("such culling");
}

Nv2aValue nv2a_surface_color(TargetFormat format) {
    if (format == TargetFormat::R5G6B5) return {0x3, "LE_R5G6B5"};
    if (format == TargetFormat::X8R8G8B8) return {0x4, "LE_X8R8G8B8_Z8R8G8B8"};
    if (format == TargetFormat::A8R8G8B8) return {0x8, "LE_A8R8G8B8"};
    refuse("colour format " + std::string(enum_name(format)));
}

Nv2aValue nv2a_surface_zeta(TargetFormat format) {
    if (format == TargetFormat::D16) return {0x1, "Z16"};
    if (format == TargetFormat::D24) return {0x2, "Z24S8"};
    refuse("depth format " + std::string(enum_name(format)));
}

Nv2aValue nv2a_blit_format(TargetFormat format) {
    if (format == TargetFormat::R5G6B5) return {0x04, "LE_R5G6B5"};
    if (format == TargetFormat::X8R8G8B8) return {0x06, "LE_X8R8G8B8_Z8R8G8B8"};
    if (format == TargetFormat::A8R8G8B8) return {0x0a, "LE_A8R8G8B8"};
    refuse("colour format " + std::string(enum_name(format)));
}

Nv2aValue nv2a_target_as_texture(TargetFormat format) {
    if (format == TargetFormat::R5G6B5) return {0x11, "LU_IMAGE_R5G6B5"};
    if (format == TargetFormat::X8R8G8B8) return {0x1e, "LU_IMAGE_X8R8G8B8"};
    if (format == TargetFormat::A8R8G8B8) return {0x12, "LU_IMAGE_A8R8G8B8"};
    refuse("colour format " + std::string(enum_name(format)));
}

Nv2aValue nv2a_texture_format(TextureFormat format, bool is_swizzled) {
    switch (format) {
        case TextureFormat::A8:
            return is_swizzled ? Nv2aValue{0x19, "SZ_A8"} : Nv2aValue{0x1f, "LU_IMAGE_A8"};
        case TextureFormat::L8:
            return is_swizzled ? Nv2aValue{0x00, "SZ_Y8"} : Nv2aValue{0x13, "LU_IMAGE_Y8"};
        case TextureFormat::A8R8G8B8:
            return is_swizzled ? Nv2aValue{0x06, "SZ_A8R8G8B8"} : Nv2aValue{0x12, "LU_IMAGE_A8R8G8B8"};
    }
    refuse("such texture format");
}

Nv2aValue nv2a_address(TextureAddress address) {
    switch (address) {
        case TextureAddress::Wrap:
            return {1, "WRAP"};
        case TextureAddress::Mirror:
            return {2, "MIRROR"};
        case TextureAddress::Clamp:
            return {3, "CLAMP_TO_EDGE"};
    }
    refuse("such addressing");
}

Nv2aValue nv2a_min_filter(TextureFilter filter, MipFilter mip) {
    const bool is_linear = filter == TextureFilter::Linear;
    switch (mip) {
        case MipFilter::None:
            return is_linear ? Nv2aValue{2, "TENT_LOD0"} : Nv2aValue{1, "BOX_LOD0"};
        case MipFilter::Point:
            return is_linear ? Nv2aValue{4, "TENT_NEARESTLOD"} : Nv2aValue{3, "BOX_NEARESTLOD"};
        case MipFilter::Linear:
            return is_linear ? Nv2aValue{6, "TENT_TENT_LOD"} : Nv2aValue{5, "BOX_TENT_LOD"};
    }
    refuse("such filter");
}

Nv2aValue nv2a_mag_filter(TextureFilter filter) {
    return filter == TextureFilter::Linear ? Nv2aValue{2, "TENT_LOD0"} : Nv2aValue{1, "BOX_LOD0"};
}

float nv2a_greatest_depth(TargetFormat zeta) {
    return zeta == TargetFormat::D16 ? 65535.0f : 16777215.0f;
}

std::uint32_t nv2a_clear_color(TargetFormat format, Argb color) {
    const std::uint32_t c = color.value;
    if (format != TargetFormat::R5G6B5) return c;
    return (c >> 8 & 0xf800) | (c >> 5 & 0x07e0) | (c >> 3 & 0x001f);
}

// 30 bits, to nearest, of which the format keeps the first (raster/primitives.h).
std::uint32_t nv2a_clear_depth(TargetFormat format, float depth) {
    const auto bits30 = static_cast<std::uint32_t>(std::nearbyint(static_cast<double>(depth) * ((1 << 30) - 1)));
    return format == TargetFormat::D16 ? bits30 >> 14 : bits30 >> 6 << 8;
}

}  // namespace pipeline
