// SPDX-License-Identifier: MIT
// The frame's enumerators as the NV2A's values, with their names in nxdk's nv_regs.h.
#pragma once

#include "pipeline/emit/nv2a_methods.h"
#include "pipeline/frame/frame.h"

namespace pipeline {

Nv2aValue nv2a_blend_factor(BlendFactor factor);
Nv2aValue nv2a_compare(CompareFunc func);
Nv2aValue nv2a_shade_mode(ShadeMode mode);
Nv2aValue nv2a_fog_mode(FogMode mode);                  // not None
Nv2aValue nv2a_culled_face(CullMode mode);              // with FRONT_FACE CW; not None
Nv2aValue nv2a_surface_color(TargetFormat format);      // of a colour target
Nv2aValue nv2a_surface_zeta(TargetFormat format);       // of a depth target
Nv2aValue nv2a_blit_format(TargetFormat format);        // of a colour target
Nv2aValue nv2a_target_as_texture(TargetFormat format);  // of a colour target, linear
Nv2aValue nv2a_texture_format(TextureFormat format, bool is_swizzled);
Nv2aValue nv2a_address(TextureAddress address);
Nv2aValue nv2a_min_filter(TextureFilter filter, MipFilter mip);
Nv2aValue nv2a_mag_filter(TextureFilter filter);

// What a depth of 1 is.
float nv2a_greatest_depth(TargetFormat zeta);

// What CLEAR_SURFACE takes for a colour.
std::uint32_t nv2a_clear_color(TargetFormat format, Argb color);
// And for a depth, 0..1, rounded as the frame's are.
std::uint32_t nv2a_clear_depth(TargetFormat format, float depth);

}  // namespace pipeline
