// SPDX-License-Identifier: MIT
// The Xbox's NV2A. "Captures" are those of a console in github.com/abaire/nxdk_pgraph_tests_golden_results, made by
// github.com/abaire/nxdk_pgraph_tests; formulas were fitted to them. xemu is github.com/xemu-project/xemu.
#include "pipeline/profile/tables.h"

namespace pipeline {

Profile make_xbox() {
    using enum TargetFormat;
    return {
        .name       = "xbox",
        .chip       = "NVIDIA NV2A (Microsoft Xbox)",
        .arithmetic = {.snap         = SnapRule::Truncate,
                       .pixel_center = 8,
                       .gouraud      = GouraudRule::Nearest,
                       .filter       = FilterRule::Nv2aHalfUp8,
                       .combine      = CombineRule::Nearest255,
                       .fog          = FogRule::Nearest255,
                       .blend        = BlendRule::Nearest255,
                       .blend_source = BlendSource::TargetBits},
        .formats    = {.draw           = {A8R8G8B8, X8R8G8B8, R5G6B5},
                       .copy_targets   = {A8R8G8B8, X8R8G8B8, R5G6B5},
                       .depth          = {D16, D24},
                       .copies_convert = false,
                       .copies_halve   = false},
        .states     = {.dest_alpha_test = false, .alpha_fails = {AlphaFail::Keep}},
        .limits     = {.texture_width     = 4096,
                       .texture_height    = 4096,
                       .memory            = 64u << 20,
                       .pitch_alignment   = 64,
                       .address_alignment = 128,
                       .swizzles_textures = true},
        .evidence =
            {
                {"snap", "xemu, pull request 2183, measured on a console: toward zero, to 1/16 pixel", Grade::Measured,
                 "Pull requests 735 and 1362 describe the same as a threshold of 0.5625 pixel"},
                {"pixel_center", "captures of Texture_LOD_Bias: samples at the middle of pixels", Grade::Fitted,
                 "Xbox Direct3D 8 adds 0.53125 to the viewport, and so has centres at integers, rounded "
                 "(abaire/pbkitplusplus)"},
                {"vertex_depth", "chosen: finer than the depth buffer", Grade::Chosen, "No source"},
                {"gouraud", "chosen: to nearest", Grade::Chosen,
                 "Two points are known: 0.1 and 0.7 are stored as 25 and 178, that is cut, or ties down"},
                {"filter",
                 "captures of Texture_LOD_Bias, 75264 of 75264 samples: along u, rounded half up, then along v, then "
                 "between mip levels",
                 Grade::Fitted, "Fractions were multiples of 1/16; how many bits the chip keeps is not known"},
                {"combine", "chosen: one rounding of the exact result, to nearest", Grade::Chosen,
                 "The register combiners are signed 9 bit numbers by the OpenGL extension; xboxdevwiki.net says the "
                 "chip's own are untested"},
                {"fog", "chosen: one rounding of the exact result, to nearest", Grade::Chosen,
                 "No source: the final combiner does it, see combine"},
                {"blend",
                 "captures of Blend_tests, 4004 of 4004 samples of 11 pairs of factors; gradients, 4176 of 4176 each "
                 "for SRCALPHA/INVSRCALPHA and SRCALPHA/DESTALPHA: the exact sum, rounded once",
                 Grade::Fitted, "One console; no test with every pair of bytes"},
                {"blend_source",
                 "captures of Blend_surface, R5G6B5, 4176 of 4176 samples: red, green and blue are cut, with zeros "
                 "below",
                 Grade::Fitted, "Other 16 bit formats were not captured"},
                {"store", "captures of Blend_surface: R5G6B5 truncates; X8R8G8B8 and R5G6B5 read alpha as one",
                 Grade::Fitted,
                 "That the blender expands what R5G6B5 holds by repeating bits is chosen. Dithering is not modelled: "
                 "no capture has it"},
                {"alpha_test", "Direct3D 8's D3DCMPFUNC: 8 functions, 8 bits of reference", Grade::Document, ""},
                {"depth", "xemu, hw/xbox/nv2a/pgraph/glsl/psh.c: fixed depth is floored, by a test on a console",
                 Grade::Measured, "Float depth and the w buffer are not modelled"},
                {"copy", "xemu, hw/xbox/nv2a/pgraph/gl/blit.c, class NV09F, SRCCOPY: 1:1, nothing is halved",
                 Grade::Emulators, "Alpha of X8R8G8B8 is forced to 0 or 255 there"},
                {"targets",
                 "xemu, nv2a_regs.h, NV097_SET_SURFACE_FORMAT; captures of Blend_surface for what alpha reads as",
                 Grade::Emulators,
                 "X1R5G5B5 and X1A7R8G8B8 are not modelled. Whether colour and depth of different bits a pixel go "
                 "together is not known"},
                {"states",
                 "xemu, nv2a_regs.h: all factors on both sides, SET_COLOR_MASK for each channel, scissor, culling",
                 Grade::Emulators,
                 "Constant colours as factors, subtraction, minimum and maximum, and the logic operations are not "
                 "modelled"},
                {"stages",
                 "xemu, hw/xbox/nv2a/pgraph/glsl/psh.c: the register combiners, which Direct3D 8's stages become",
                 Grade::Emulators, "The chip has 4 textures and 8 combiners; a frame has 2 stages"},
                {"flat", "chosen: the first vertex, as in Direct3D 8", Grade::Chosen, "No capture has it"},
                {"lod", "chosen: from the texels that a pixel spans, its logarithm linear between powers of two",
                 Grade::Chosen,
                 "The captures of Texture_LOD_Bias give the mix of two levels, not how a level is found"},
                {"limits",
                 "xemu, nv2a_regs.h: textures of Y8, A8 and A8R8G8B8, swizzled in powers of two, or linear in any size, "
                 "with one level; 4096 texels: Cxbx-Reloaded, XbD3D8Types.h",
                 Grade::Emulators,
                 "Cxbx-Reloaded speaks of 12 mip levels, which 2048 texels have. The largest target is not known. What "
                 "A8 reads in red, green and blue was not captured"},
                {"memory",
                 "tomshardware.com, review of the Xbox: 64 MB, shared with the processor; Cxbx-Reloaded, "
                 "XbD3D8Types.h: D3DTEXTURE_PITCH_ALIGNMENT is 64 bytes, D3DTEXTURE_ALIGNMENT 128",
                 Grade::Emulators,
                 "The memory is the program's as well, and holds the picture that the display shows; neither is "
                 "counted. Tiled and compressed surfaces are not modelled"},
            },
    };
}

}  // namespace pipeline
