// SPDX-License-Identifier: MIT
// The frame's states by the names of libogc's gx.h (github.com/devkitPro/libogc, gc/ogc/gx.h). Of what the chip lacks, as
// pipeline/check finds it, there is no name: std::invalid_argument.
#pragma once

#include <string_view>

#include "pipeline/frame/frame.h"

namespace pipeline {

std::string_view gx_compare(CompareFunc func);
// GX_BL_*: codes 2 and 3 are the other side's colour, so that one code has two names.
std::string_view gx_source_factor(BlendFactor factor);
std::string_view gx_dest_factor(BlendFactor factor);
// libogc calls a primitive front-facing whose corners go clockwise to the viewer, as Direct3D's D > 0.
std::string_view gx_cull(CullMode mode);
std::string_view gx_wrap(TextureAddress address);
std::string_view gx_min_filter(TextureFilter filter, MipFilter mip);
std::string_view gx_mag_filter(TextureFilter filter);
std::string_view gx_pixel_format(TargetFormat format);

}  // namespace pipeline
