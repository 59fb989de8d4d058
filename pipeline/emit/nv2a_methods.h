// SPDX-License-Identifier: MIT
// Methods of the NV2A's classes and the fields of their values, spelled as in nxdk's lib/pbkit/nv_regs.h and xemu's
// hw/xbox/nv2a/nv2a_regs.h, which the numbers are from (versions: emit_nv2a.h).
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace pipeline {

// `entries` of them, `stride` bytes apart, of up to `words` words each.
struct Nv2aMethod {
    std::uint16_t offset = 0;
    std::string_view name;
    std::uint16_t words = 1, entries = 1, stride = 0;
};

// Bits `shift` .. `shift + width - 1` of a value.
struct Nv2aField {
    std::string_view name;
    int shift = 0, width = 0;
};

// The value in its bits. Throws std::invalid_argument if it has more.
inline std::uint32_t pack(const Nv2aField& field, std::uint64_t value) {
    if (value >> field.width != 0)
        throw std::invalid_argument("the NV2A's " + std::string(field.name) + " has " + std::to_string(field.width) +
                                    " bits; got " + std::to_string(value));
    return static_cast<std::uint32_t>(value << field.shift);
}

// A value and what it is called.
struct Nv2aValue {
    std::uint32_t value = 0;
    std::string_view name;
};

namespace nv097 {

inline constexpr std::uint16_t kTextures = 4, kLights = 8, kCombiners = 8, kAttributes = 16, kWindowClips = 8;

inline constexpr Nv2aMethod WAIT_FOR_IDLE{0x0110, "NV097_WAIT_FOR_IDLE"};

// X or Y: the first pixel; WIDTH or HEIGHT: how many.
inline constexpr Nv2aMethod SET_SURFACE_CLIP_HORIZONTAL{0x0200, "NV097_SET_SURFACE_CLIP_HORIZONTAL"};
inline constexpr Nv2aMethod SET_SURFACE_CLIP_VERTICAL{0x0204, "NV097_SET_SURFACE_CLIP_VERTICAL"};
inline constexpr Nv2aField SURFACE_CLIP_FIRST{"SET_SURFACE_CLIP_*_X/Y", 0, 16};
inline constexpr Nv2aField SURFACE_CLIP_SIZE{"SET_SURFACE_CLIP_*_WIDTH/HEIGHT", 16, 16};

inline constexpr Nv2aMethod SET_SURFACE_FORMAT{0x0208, "NV097_SET_SURFACE_FORMAT"};
inline constexpr Nv2aField SURFACE_FORMAT_COLOR{"SET_SURFACE_FORMAT_COLOR", 0, 4};
inline constexpr Nv2aField SURFACE_FORMAT_ZETA{"SET_SURFACE_FORMAT_ZETA", 4, 4};
inline constexpr Nv2aField SURFACE_FORMAT_TYPE{"SET_SURFACE_FORMAT_TYPE", 8, 4};
inline constexpr std::uint32_t SURFACE_FORMAT_TYPE_PITCH = 1;

inline constexpr Nv2aMethod SET_SURFACE_PITCH{0x020c, "NV097_SET_SURFACE_PITCH"};  // bytes
inline constexpr Nv2aField SURFACE_PITCH_COLOR{"SET_SURFACE_PITCH_COLOR", 0, 16};
inline constexpr Nv2aField SURFACE_PITCH_ZETA{"SET_SURFACE_PITCH_ZETA", 16, 16};
inline constexpr Nv2aMethod SET_SURFACE_COLOR_OFFSET{0x0210, "NV097_SET_SURFACE_COLOR_OFFSET"};
inline constexpr Nv2aMethod SET_SURFACE_ZETA_OFFSET{0x0214, "NV097_SET_SURFACE_ZETA_OFFSET"};

inline constexpr Nv2aMethod SET_COMBINER_ALPHA_ICW{0x0260, "NV097_SET_COMBINER_ALPHA_ICW", 1, kCombiners, 4};
inline constexpr Nv2aMethod SET_COMBINER_SPECULAR_FOG_CW0{0x0288, "NV097_SET_COMBINER_SPECULAR_FOG_CW0"};
inline constexpr Nv2aMethod SET_COMBINER_SPECULAR_FOG_CW1{0x028c, "NV097_SET_COMBINER_SPECULAR_FOG_CW1"};

inline constexpr Nv2aMethod SET_CONTROL0{0x0290, "NV097_SET_CONTROL0"};
inline constexpr Nv2aField CONTROL0_TEXTURE_PERSPECTIVE_ENABLE{"SET_CONTROL0_TEXTURE_PERSPECTIVE_ENABLE", 20, 1};

inline constexpr Nv2aMethod SET_LIGHT_CONTROL{0x0294, "NV097_SET_LIGHT_CONTROL"};
inline constexpr Nv2aField LIGHT_CONTROL_SEPARATE_SPECULAR{"SET_LIGHT_CONTROL_SEPARATE_SPECULAR", 0, 1};
inline constexpr Nv2aMethod SET_COLOR_MATERIAL{0x0298, "NV097_SET_COLOR_MATERIAL"};
inline constexpr Nv2aField COLOR_MATERIAL_DIFFUSE{"SET_COLOR_MATERIAL_DIFFUSE", 4, 2};

inline constexpr Nv2aMethod SET_FOG_MODE{0x029c, "NV097_SET_FOG_MODE"};
inline constexpr Nv2aMethod SET_FOG_GEN_MODE{0x02a0, "NV097_SET_FOG_GEN_MODE"};
inline constexpr Nv2aMethod SET_FOG_ENABLE{0x02a4, "NV097_SET_FOG_ENABLE"};
inline constexpr Nv2aMethod SET_FOG_COLOR{0x02a8, "NV097_SET_FOG_COLOR"};  // 0xAABBGGRR

// Eight rectangles; TYPE 0: what lies in one of them is drawn. Both ends are included.
inline constexpr Nv2aMethod SET_WINDOW_CLIP_TYPE{0x02b4, "NV097_SET_WINDOW_CLIP_TYPE"};
inline constexpr Nv2aMethod SET_WINDOW_CLIP_HORIZONTAL{0x02c0, "NV097_SET_WINDOW_CLIP_HORIZONTAL", kWindowClips};
inline constexpr Nv2aMethod SET_WINDOW_CLIP_VERTICAL{0x02e0, "NV097_SET_WINDOW_CLIP_VERTICAL", kWindowClips};
inline constexpr Nv2aField WINDOW_CLIP_MIN{"SET_WINDOW_CLIP_*_MIN", 0, 12};
inline constexpr Nv2aField WINDOW_CLIP_MAX{"SET_WINDOW_CLIP_*_MAX", 16, 12};

inline constexpr Nv2aMethod SET_ALPHA_TEST_ENABLE{0x0300, "NV097_SET_ALPHA_TEST_ENABLE"};
inline constexpr Nv2aMethod SET_BLEND_ENABLE{0x0304, "NV097_SET_BLEND_ENABLE"};
inline constexpr Nv2aMethod SET_CULL_FACE_ENABLE{0x0308, "NV097_SET_CULL_FACE_ENABLE"};
inline constexpr Nv2aMethod SET_DEPTH_TEST_ENABLE{0x030c, "NV097_SET_DEPTH_TEST_ENABLE"};
inline constexpr Nv2aMethod SET_DITHER_ENABLE{0x0310, "NV097_SET_DITHER_ENABLE"};
inline constexpr Nv2aMethod SET_LIGHTING_ENABLE{0x0314, "NV097_SET_LIGHTING_ENABLE"};
inline constexpr Nv2aMethod SET_POINT_PARAMS_ENABLE{0x0318, "NV097_SET_POINT_PARAMS_ENABLE"};
inline constexpr Nv2aMethod SET_POINT_SMOOTH_ENABLE{0x031c, "NV097_SET_POINT_SMOOTH_ENABLE"};
inline constexpr Nv2aMethod SET_LINE_SMOOTH_ENABLE{0x0320, "NV097_SET_LINE_SMOOTH_ENABLE"};
inline constexpr Nv2aMethod SET_POLY_SMOOTH_ENABLE{0x0324, "NV097_SET_POLY_SMOOTH_ENABLE"};
inline constexpr Nv2aMethod SET_SKIN_MODE{0x0328, "NV097_SET_SKIN_MODE"};
inline constexpr Nv2aMethod SET_STENCIL_TEST_ENABLE{0x032c, "NV097_SET_STENCIL_TEST_ENABLE"};
inline constexpr Nv2aMethod SET_POLY_OFFSET_FILL_ENABLE{0x0338, "NV097_SET_POLY_OFFSET_FILL_ENABLE"};
inline constexpr Nv2aMethod SET_ALPHA_FUNC{0x033c, "NV097_SET_ALPHA_FUNC"};
inline constexpr Nv2aMethod SET_ALPHA_REF{0x0340, "NV097_SET_ALPHA_REF"};
inline constexpr Nv2aMethod SET_BLEND_FUNC_SFACTOR{0x0344, "NV097_SET_BLEND_FUNC_SFACTOR"};
inline constexpr Nv2aMethod SET_BLEND_FUNC_DFACTOR{0x0348, "NV097_SET_BLEND_FUNC_DFACTOR"};
inline constexpr Nv2aMethod SET_BLEND_EQUATION{0x0350, "NV097_SET_BLEND_EQUATION"};
inline constexpr std::uint32_t BLEND_EQUATION_V_FUNC_ADD = 0x8006;
inline constexpr Nv2aMethod SET_DEPTH_FUNC{0x0354, "NV097_SET_DEPTH_FUNC"};
inline constexpr Nv2aMethod SET_COLOR_MASK{0x0358, "NV097_SET_COLOR_MASK"};
inline constexpr Nv2aField COLOR_MASK_BLUE_WRITE_ENABLE{"SET_COLOR_MASK_BLUE_WRITE_ENABLE", 0, 1};
inline constexpr Nv2aField COLOR_MASK_GREEN_WRITE_ENABLE{"SET_COLOR_MASK_GREEN_WRITE_ENABLE", 8, 1};
inline constexpr Nv2aField COLOR_MASK_RED_WRITE_ENABLE{"SET_COLOR_MASK_RED_WRITE_ENABLE", 16, 1};
inline constexpr Nv2aField COLOR_MASK_ALPHA_WRITE_ENABLE{"SET_COLOR_MASK_ALPHA_WRITE_ENABLE", 24, 1};
inline constexpr Nv2aMethod SET_DEPTH_MASK{0x035c, "NV097_SET_DEPTH_MASK"};
inline constexpr Nv2aMethod SET_SHADE_MODE{0x037c, "NV097_SET_SHADE_MODE"};
inline constexpr Nv2aMethod SET_FRONT_POLYGON_MODE{0x038c, "NV097_SET_FRONT_POLYGON_MODE"};
inline constexpr Nv2aMethod SET_BACK_POLYGON_MODE{0x0390, "NV097_SET_BACK_POLYGON_MODE"};
inline constexpr std::uint32_t POLYGON_MODE_V_FILL = 0x1b02;
inline constexpr Nv2aMethod SET_CLIP_MIN{0x0394, "NV097_SET_CLIP_MIN"};
inline constexpr Nv2aMethod SET_CLIP_MAX{0x0398, "NV097_SET_CLIP_MAX"};
inline constexpr Nv2aMethod SET_CULL_FACE{0x039c, "NV097_SET_CULL_FACE"};
inline constexpr Nv2aMethod SET_FRONT_FACE{0x03a0, "NV097_SET_FRONT_FACE"};
inline constexpr std::uint32_t FRONT_FACE_V_CW = 0x900;

inline constexpr Nv2aMethod SET_NORMALIZATION_ENABLE{0x03a4, "NV097_SET_NORMALIZATION_ENABLE"};
inline constexpr Nv2aMethod SET_MATERIAL_EMISSION{0x03a8, "NV097_SET_MATERIAL_EMISSION", 3};
inline constexpr Nv2aMethod SET_MATERIAL_ALPHA{0x03b4, "NV097_SET_MATERIAL_ALPHA"};
inline constexpr Nv2aMethod SET_SPECULAR_ENABLE{0x03b8, "NV097_SET_SPECULAR_ENABLE"};
inline constexpr Nv2aMethod SET_LIGHT_ENABLE_MASK{0x03bc, "NV097_SET_LIGHT_ENABLE_MASK"};  // two bits for each
inline constexpr std::uint32_t LIGHT_INFINITE = 1, LIGHT_LOCAL = 2;

inline constexpr Nv2aMethod SET_TEXGEN_S{0x03c0, "NV097_SET_TEXGEN_S", 1, kTextures, 16};
inline constexpr Nv2aMethod SET_TEXGEN_T{0x03c4, "NV097_SET_TEXGEN_T", 1, kTextures, 16};
inline constexpr Nv2aMethod SET_TEXGEN_R{0x03c8, "NV097_SET_TEXGEN_R", 1, kTextures, 16};
inline constexpr Nv2aMethod SET_TEXGEN_Q{0x03cc, "NV097_SET_TEXGEN_Q", 1, kTextures, 16};
inline constexpr Nv2aMethod SET_TEXTURE_MATRIX_ENABLE{0x0420, "NV097_SET_TEXTURE_MATRIX_ENABLE", 1, kTextures, 4};

// Matrices that multiply column vectors, by rows.
inline constexpr Nv2aMethod SET_MODEL_VIEW_MATRIX{0x0480, "NV097_SET_MODEL_VIEW_MATRIX", 4, 4, 16};
inline constexpr Nv2aMethod SET_INVERSE_MODEL_VIEW_MATRIX{0x0580, "NV097_SET_INVERSE_MODEL_VIEW_MATRIX", 4, 3, 16};
inline constexpr Nv2aMethod SET_COMPOSITE_MATRIX{0x0680, "NV097_SET_COMPOSITE_MATRIX", 4, 4, 16};
// Four rows for each texture, one texture's after the other's.
inline constexpr Nv2aMethod SET_TEXTURE_MATRIX{0x06c0, "NV097_SET_TEXTURE_MATRIX", 4, 4 * kTextures, 16};
// S, T, R, Q of each texture.
inline constexpr Nv2aMethod SET_TEXGEN_PLANE{0x0840, "NV097_SET_TEXGEN_PLANE", 4, 4 * kTextures, 16};
inline constexpr Nv2aMethod SET_FOG_PARAMS{0x09c0, "NV097_SET_FOG_PARAMS", 3};
inline constexpr Nv2aMethod SET_FOG_PLANE{0x09d0, "NV097_SET_FOG_PLANE", 4};
inline constexpr Nv2aMethod SET_PROVOKING_VERTEX{0x09fc, "NV097_SET_PROVOKING_VERTEX"};  // 1: the first
inline constexpr Nv2aMethod SET_SCENE_AMBIENT_COLOR{0x0a10, "NV097_SET_SCENE_AMBIENT_COLOR", 3};
inline constexpr Nv2aMethod SET_VIEWPORT_OFFSET{0x0a20, "NV097_SET_VIEWPORT_OFFSET", 4};
inline constexpr Nv2aMethod SET_EYE_POSITION{0x0a50, "NV097_SET_EYE_POSITION", 4};

inline constexpr Nv2aMethod SET_COMBINER_FACTOR0{0x0a60, "NV097_SET_COMBINER_FACTOR0", 1, kCombiners, 4};  // 0xAARRGGBB
inline constexpr Nv2aMethod SET_COMBINER_ALPHA_OCW{0x0aa0, "NV097_SET_COMBINER_ALPHA_OCW", 1, kCombiners, 4};
inline constexpr Nv2aMethod SET_COMBINER_COLOR_ICW{0x0ac0, "NV097_SET_COMBINER_COLOR_ICW", 1, kCombiners, 4};

inline constexpr Nv2aMethod SET_LIGHT_AMBIENT_COLOR{0x1000, "NV097_SET_LIGHT_AMBIENT_COLOR", 3, kLights, 128};
inline constexpr Nv2aMethod SET_LIGHT_DIFFUSE_COLOR{0x100c, "NV097_SET_LIGHT_DIFFUSE_COLOR", 3, kLights, 128};
inline constexpr Nv2aMethod SET_LIGHT_SPECULAR_COLOR{0x1018, "NV097_SET_LIGHT_SPECULAR_COLOR", 3, kLights, 128};
inline constexpr Nv2aMethod SET_LIGHT_LOCAL_RANGE{0x1024, "NV097_SET_LIGHT_LOCAL_RANGE", 1, kLights, 128};
inline constexpr Nv2aMethod SET_LIGHT_INFINITE_DIRECTION{0x1034, "NV097_SET_LIGHT_INFINITE_DIRECTION", 3, kLights, 128};
inline constexpr Nv2aMethod SET_LIGHT_LOCAL_POSITION{0x105c, "NV097_SET_LIGHT_LOCAL_POSITION", 3, kLights, 128};
inline constexpr Nv2aMethod SET_LIGHT_LOCAL_ATTENUATION{0x1068, "NV097_SET_LIGHT_LOCAL_ATTENUATION", 3, kLights, 128};

inline constexpr Nv2aMethod SET_VERTEX_DATA_ARRAY_OFFSET{0x1720, "NV097_SET_VERTEX_DATA_ARRAY_OFFSET", 1, kAttributes,
                                                         4};
inline constexpr Nv2aMethod SET_VERTEX_DATA_ARRAY_FORMAT{0x1760, "NV097_SET_VERTEX_DATA_ARRAY_FORMAT", 1, kAttributes,
                                                         4};
inline constexpr Nv2aField VERTEX_DATA_ARRAY_FORMAT_TYPE{"SET_VERTEX_DATA_ARRAY_FORMAT_TYPE", 0, 4};
inline constexpr Nv2aField VERTEX_DATA_ARRAY_FORMAT_SIZE{"SET_VERTEX_DATA_ARRAY_FORMAT_SIZE", 4, 4};
inline constexpr Nv2aField VERTEX_DATA_ARRAY_FORMAT_STRIDE{"SET_VERTEX_DATA_ARRAY_FORMAT_STRIDE", 8, 24};
inline constexpr std::uint32_t TYPE_UB_D3D = 0, TYPE_F = 2;
inline constexpr std::uint16_t ATTR_POSITION = 0, ATTR_NORMAL = 2, ATTR_DIFFUSE = 3, ATTR_SPECULAR = 4,
                               ATTR_TEXTURE0 = 9;

inline constexpr Nv2aMethod SET_LOGIC_OP_ENABLE{0x17bc, "NV097_SET_LOGIC_OP_ENABLE"};
inline constexpr Nv2aMethod SET_BEGIN_END{0x17fc, "NV097_SET_BEGIN_END"};
inline constexpr std::uint32_t OP_END = 0, OP_TRIANGLES = 5, OP_QUADS = 8;
inline constexpr Nv2aMethod ARRAY_ELEMENT16{0x1800, "NV097_ARRAY_ELEMENT16"};  // two, the first in the low half
inline constexpr Nv2aMethod ARRAY_ELEMENT32{0x1808, "NV097_ARRAY_ELEMENT32"};
inline constexpr Nv2aMethod DRAW_ARRAYS{0x1810, "NV097_DRAW_ARRAYS"};
inline constexpr Nv2aField DRAW_ARRAYS_START_INDEX{"DRAW_ARRAYS_START_INDEX", 0, 24};
inline constexpr Nv2aField DRAW_ARRAYS_COUNT{"DRAW_ARRAYS_COUNT", 24, 8};  // less one

inline constexpr Nv2aMethod SET_TEXTURE_OFFSET{0x1b00, "NV097_SET_TEXTURE_OFFSET", 1, kTextures, 64};
inline constexpr Nv2aMethod SET_TEXTURE_FORMAT{0x1b04, "NV097_SET_TEXTURE_FORMAT", 1, kTextures, 64};
inline constexpr Nv2aField TEXTURE_FORMAT_CONTEXT_DMA{"SET_TEXTURE_FORMAT_CONTEXT_DMA", 0, 2};      // 1: A
inline constexpr Nv2aField TEXTURE_FORMAT_BORDER_SOURCE{"SET_TEXTURE_FORMAT_BORDER_SOURCE", 3, 1};  // 1: a colour
inline constexpr Nv2aField TEXTURE_FORMAT_DIMENSIONALITY{"SET_TEXTURE_FORMAT_DIMENSIONALITY", 4, 4};
inline constexpr Nv2aField TEXTURE_FORMAT_COLOR{"SET_TEXTURE_FORMAT_COLOR", 8, 8};
inline constexpr Nv2aField TEXTURE_FORMAT_MIPMAP_LEVELS{"SET_TEXTURE_FORMAT_MIPMAP_LEVELS", 16, 4};
inline constexpr Nv2aField TEXTURE_FORMAT_BASE_SIZE_U{"SET_TEXTURE_FORMAT_BASE_SIZE_U", 20, 4};  // logarithms
inline constexpr Nv2aField TEXTURE_FORMAT_BASE_SIZE_V{"SET_TEXTURE_FORMAT_BASE_SIZE_V", 24, 4};
inline constexpr Nv2aMethod SET_TEXTURE_ADDRESS{0x1b08, "NV097_SET_TEXTURE_ADDRESS", 1, kTextures, 64};
inline constexpr Nv2aField TEXTURE_ADDRESS_U{"SET_TEXTURE_ADDRESS_U", 0, 4};
inline constexpr Nv2aField TEXTURE_ADDRESS_V{"SET_TEXTURE_ADDRESS_V", 8, 4};
inline constexpr Nv2aField TEXTURE_ADDRESS_P{"SET_TEXTURE_ADDRESS_P", 16, 4};
inline constexpr Nv2aMethod SET_TEXTURE_CONTROL0{0x1b0c, "NV097_SET_TEXTURE_CONTROL0", 1, kTextures, 64};
inline constexpr Nv2aField TEXTURE_CONTROL0_ENABLE{"SET_TEXTURE_CONTROL0_ENABLE", 30, 1};
inline constexpr Nv2aField TEXTURE_CONTROL0_MIN_LOD_CLAMP{"SET_TEXTURE_CONTROL0_MIN_LOD_CLAMP", 18, 12};
inline constexpr Nv2aField TEXTURE_CONTROL0_MAX_LOD_CLAMP{"SET_TEXTURE_CONTROL0_MAX_LOD_CLAMP", 6, 12};
inline constexpr std::uint32_t LOD_CLAMP_NONE = 4095;
inline constexpr Nv2aMethod SET_TEXTURE_CONTROL1{0x1b10, "NV097_SET_TEXTURE_CONTROL1", 1, kTextures, 64};
inline constexpr Nv2aField TEXTURE_CONTROL1_IMAGE_PITCH{"SET_TEXTURE_CONTROL1_IMAGE_PITCH", 16, 16};
inline constexpr Nv2aMethod SET_TEXTURE_FILTER{0x1b14, "NV097_SET_TEXTURE_FILTER", 1, kTextures, 64};
inline constexpr Nv2aField TEXTURE_FILTER_CONVOLUTION_KERNEL{"SET_TEXTURE_FILTER_CONVOLUTION_KERNEL", 13, 3};
inline constexpr Nv2aField TEXTURE_FILTER_MIN{"SET_TEXTURE_FILTER_MIN", 16, 8};
inline constexpr Nv2aField TEXTURE_FILTER_MAG{"SET_TEXTURE_FILTER_MAG", 24, 4};
inline constexpr Nv2aMethod SET_TEXTURE_IMAGE_RECT{0x1b1c, "NV097_SET_TEXTURE_IMAGE_RECT", 1, kTextures, 64};
inline constexpr Nv2aField TEXTURE_IMAGE_RECT_WIDTH{"SET_TEXTURE_IMAGE_RECT_WIDTH", 16, 16};
inline constexpr Nv2aField TEXTURE_IMAGE_RECT_HEIGHT{"SET_TEXTURE_IMAGE_RECT_HEIGHT", 0, 16};

inline constexpr Nv2aMethod SET_ZMIN_MAX_CONTROL{0x1d78, "NV097_SET_ZMIN_MAX_CONTROL"};
inline constexpr std::uint32_t ZMIN_MAX_CONTROL_CULL_NEAR_FAR = 1;
inline constexpr Nv2aMethod SET_ANTI_ALIASING_CONTROL{0x1d7c, "NV097_SET_ANTI_ALIASING_CONTROL"};
inline constexpr std::uint32_t ANTI_ALIASING_CONTROL_OFF = 0xffff0000;  // all samples of the mask, not enabled
inline constexpr Nv2aMethod SET_ZSTENCIL_CLEAR_VALUE{0x1d8c, "NV097_SET_ZSTENCIL_CLEAR_VALUE"};
inline constexpr Nv2aMethod SET_COLOR_CLEAR_VALUE{0x1d90, "NV097_SET_COLOR_CLEAR_VALUE"};
inline constexpr Nv2aMethod CLEAR_SURFACE{0x1d94, "NV097_CLEAR_SURFACE"};
inline constexpr std::uint32_t CLEAR_SURFACE_Z = 1, CLEAR_SURFACE_STENCIL = 2, CLEAR_SURFACE_COLOR = 0xf0;
inline constexpr Nv2aMethod SET_CLEAR_RECT_HORIZONTAL{0x1d98, "NV097_SET_CLEAR_RECT_HORIZONTAL"};
inline constexpr Nv2aMethod SET_CLEAR_RECT_VERTICAL{0x1d9c, "NV097_SET_CLEAR_RECT_VERTICAL"};
inline constexpr Nv2aField CLEAR_RECT_MIN{"SET_CLEAR_RECT_*_MIN", 0, 16};
inline constexpr Nv2aField CLEAR_RECT_MAX{"SET_CLEAR_RECT_*_MAX", 16, 16};

inline constexpr Nv2aMethod SET_SPECULAR_FOG_FACTOR{0x1e20, "NV097_SET_SPECULAR_FOG_FACTOR", 2};
inline constexpr Nv2aMethod SET_COMBINER_COLOR_OCW{0x1e40, "NV097_SET_COMBINER_COLOR_OCW", 1, kCombiners, 4};
inline constexpr Nv2aMethod SET_COMBINER_CONTROL{0x1e60, "NV097_SET_COMBINER_CONTROL"};
inline constexpr Nv2aMethod SET_SHADER_STAGE_PROGRAM{0x1e70,
                                                     "NV097_SET_SHADER_STAGE_PROGRAM"};  // 5 bits for each texture
inline constexpr std::uint32_t PROGRAM_NONE = 0, PROGRAM_2D_PROJECTIVE = 1;
inline constexpr Nv2aMethod SET_SHADER_OTHER_STAGE_INPUT{0x1e78, "NV097_SET_SHADER_OTHER_STAGE_INPUT"};
inline constexpr Nv2aMethod SET_TRANSFORM_EXECUTION_MODE{0x1e94, "NV097_SET_TRANSFORM_EXECUTION_MODE"};
inline constexpr Nv2aField TRANSFORM_EXECUTION_MODE_RANGE_MODE{"SET_TRANSFORM_EXECUTION_MODE_RANGE_MODE", 2, 30};
inline constexpr std::uint32_t RANGE_MODE_PRIV = 1;

}  // namespace nv097

// Two surfaces in memory, and copying between them.
namespace nv062 {
inline constexpr Nv2aMethod SET_COLOR_FORMAT{0x0300, "NV062_SET_COLOR_FORMAT"};
inline constexpr Nv2aMethod SET_PITCH{0x0304, "NV062_SET_PITCH"};
inline constexpr Nv2aField PITCH_SOURCE{"NV062_SET_PITCH_SOURCE", 0, 16};
inline constexpr Nv2aField PITCH_DESTIN{"NV062_SET_PITCH_DESTIN", 16, 16};
inline constexpr Nv2aMethod SET_OFFSET_SOURCE{0x0308, "NV062_SET_OFFSET_SOURCE"};
inline constexpr Nv2aMethod SET_OFFSET_DESTIN{0x030c, "NV062_SET_OFFSET_DESTIN"};
}  // namespace nv062
namespace nv09f {
inline constexpr Nv2aMethod SET_OPERATION{0x02fc, "NV09F_SET_OPERATION"};
inline constexpr std::uint32_t OPERATION_SRCCOPY = 3;
inline constexpr Nv2aMethod CONTROL_POINT_IN{0x0300, "NV09F_CONTROL_POINT_IN"};
inline constexpr Nv2aMethod CONTROL_POINT_OUT{0x0304, "NV09F_CONTROL_POINT_OUT"};
inline constexpr Nv2aMethod SIZE{0x0308, "NV09F_SIZE"};
inline constexpr Nv2aField LOW{"NV09F x or width", 0, 16};
inline constexpr Nv2aField HIGH{"NV09F y or height", 16, 16};
}  // namespace nv09f

}  // namespace pipeline
