// SPDX-License-Identifier: MIT
// The GameCube's Flipper. Dolphin is github.com/dolphin-emu/dolphin, with its numbered pull requests; hwtests is
// github.com/dolphin-emu/hwtests, programs for the console; libogc is github.com/devkitPro/libogc.
#include "pipeline/profile/tables.h"

namespace pipeline {

Profile make_gamecube() {
    using enum TargetFormat;
    using enum BlendFactor;
    // GX_SetBlendMode names the other side's colour only.
    const std::vector<BlendFactor> alphas{Zero, One, SourceAlpha, InvSourceAlpha, DestAlpha, InvDestAlpha};
    std::vector<BlendFactor> source_factors = alphas, dest_factors = alphas;
    source_factors.insert(source_factors.end(), {DestColor, InvDestColor});
    dest_factors.insert(dest_factors.end(), {SourceColor, InvSourceColor});
    return {
        .name       = "gamecube",
        .chip       = "ATI / ArtX Flipper (Nintendo GameCube)",
        .arithmetic = {.snap         = SnapRule::Nearest,
                       .pixel_center = 9,
                       .gouraud      = GouraudRule::Nearest,
                       .filter       = FilterRule::FlipperFloor7,
                       .combine      = CombineRule::Tev,
                       .fog          = FogRule::FlipperFloor256,
                       .blend        = BlendRule::FlipperTrunc256,
                       .blend_source = BlendSource::Bytes},
        // The frame buffer is RGBA6_Z24 or RGB8_Z24. RGBA8 is a texture in main memory, which copies write.
        .formats    = {.draw          = {R6G6B6A6, X8R8G8B8},
                       .copy_targets  = {A8R8G8B8},
                       .depth         = {D24},
                       .with_bytes    = X8R8G8B8,
                       .with_alpha    = R6G6B6A6,
                       .reads_targets = false},
        // GX_SetColorUpdate and GX_SetAlphaUpdate are the masks.
        .states     = {.source_factors  = source_factors,
                       .dest_factors    = dest_factors,
                       .dithers         = {DitherMode::None, DitherMode::Flipper2x2},
                       .color_mask      = MaskKind::ColorAndAlpha,
                       .dest_alpha_test = false,
                       .alpha_fails     = {AlphaFail::Keep},
                       .flat            = FlatVertex::None,
                       .complement      = false},
        .limits     = {.texture_width       = 1024,
                       .texture_height      = 1024,
                       .target_width        = 640,
                       .target_height       = 528,
                       .frame_buffer_width  = 640,
                       .frame_buffer_height = 528,
                       .copy_from_step      = 2,
                       .copy_tile           = 4,
                       .memory              = 24u << 20,
                       .layout              = MemoryLayout::FlipperTiles},
        .evidence =
            {
                {"snap", "Dolphin, VideoBackends/Software/Rasterizer.cpp: 28.4 coordinates, rounded", Grade::Emulators,
                 "Ties go to even here and away from zero in Dolphin"},
                {"pixel_center",
                 "Dolphin, VideoBackends/Software/Rasterizer.cpp: 9/16 pixel, for which hwtests, "
                 "gxtest/rasterization.cpp, measures a border between 0.58329772949 and 0.58332824707 pixel",
                 Grade::Emulators,
                 "Coordinates rounded to 1/16 put that border at 9.5/16 = 0.59375, not at the console's 7/12"},
                {"vertex_depth", "chosen: finer than the depth buffer", Grade::Chosen, "No source"},
                {"gouraud", "chosen: to nearest", Grade::Chosen,
                 "No source. Dolphin evaluates colours at +0.495 pixel, in floats"},
                {"filter",
                 "Dolphin, VideoBackends/Software/TextureSampler.cpp: weights of 7 bits, one sum, >> 14; two mip "
                 "levels with 4 bits, >> 4",
                 Grade::Emulators, "Not compared with a console"},
                {"combine",
                 "hwtests, gxtest/tev.cpp, random inputs on the console; Dolphin, VideoBackends/Software/Tev.cpp, "
                 "pull request 277",
                 Grade::Measured,
                 "Measured for one stage's colour with d = 0. The argument that goes to input c, and so is expanded "
                 "to 0..256, is the second"},
                {"fog", "Dolphin, VideoBackends/Software/Tev.cpp: (c * (256 - F) + k * F) >> 8 with F 0..256",
                 Grade::Emulators, "The console computes its factor per pixel from depth; here it is one per vertex"},
                {"blend",
                 "Dolphin, VideoBackends/Software/SWEfbInterface.cpp, BlendColor; three games depend on the "
                 "truncation (pull requests 10394, 11389)",
                 Grade::Emulators, "hwtests has no program for blending"},
                {"blend_source",
                 "Dolphin, VideoBackends/Software/SWEfbInterface.cpp: the blender sees 8 bits; dither and "
                 "quantisation follow",
                 Grade::Emulators, ""},
                {"store",
                 "6 bits read back by repeating bits: hwtests, gxtest/copyfilter.cpp, on the console; a store keeps "
                 "the top 6: Dolphin, SWEfbInterface.cpp",
                 Grade::Emulators, "That the store truncates was not measured"},
                {"dither",
                 "Dolphin, SWEfbInterface.cpp, pull requests 3742 and 4194: {0, 2; 3, 1}, red, green and blue only",
                 Grade::Chosen, "libogc's documentation speaks of a 4x4 Bayer matrix; no hardware check is known"},
                {"alpha_test",
                 "Dolphin, Tev.cpp and libogc's GX_SetAlphaCompare: 8 functions, on the 8 bits of the TEV",
                 Grade::Emulators, "The console joins two comparisons; a frame has one"},
                {"depth", "libogc's GX_SetZMode and Dolphin, SWEfbInterface.cpp: 24 bits, 8 functions, new FUNC stored",
                 Grade::Emulators, "Depth of 16 bits exists with anti-aliasing alone and is not modelled"},
                {"copy",
                 "Dolphin as of libretro/dolphin, VideoBackends/Software/TextureEncoder.cpp: four 6 bit values S to S "
                 "+ (S >> 6), four bytes to S >> 2; alpha of RGB8_Z24 copies as 255: hwtests, gxtest/copyfilter.cpp",
                 Grade::Emulators, "The halving was not compared with a console"},
                {"targets",
                 "libogc, GX_SetPixelFmt and GX_CopyTex: RGBA6_Z24 and RGB8_Z24 in the embedded frame buffer, RGBA8 "
                 "in main memory",
                 Grade::Document,
                 "RGB565_Z16, with its three samples a pixel, and copies to formats other than RGBA8 are not "
                 "modelled; nor is the constant alpha that GX_SetDstAlpha writes"},
                {"states", "libogc, GX_SetBlendMode, GX_SetColorUpdate, GX_SetAlphaUpdate; Dolphin, SWEfbInterface.cpp",
                 Grade::Emulators, "GX_BM_SUBTRACT and the logic operations are not modelled"},
                {"stages",
                 "libogc, gx.h, GX_CC_* and GX_CA_*: texture, vertex colours, constants, each with its alpha for a "
                 "colour, none complemented; clamp, repeat, mirror",
                 Grade::Document,
                 "The TEV has 16 stages of four inputs; a frame has 2 of two. DIFFUSE and SPECULAR in one stage are "
                 "two stages of the TEV. Indirect textures are not modelled"},
                {"flat", "chosen: none, as libogc has no call for it", Grade::Chosen,
                 "That the chip has no flat shading was not checked in its registers"},
                {"lod", "Dolphin, VideoBackends/Software: from the differences across blocks of 2x2 pixels",
                 Grade::Emulators, "A frame's level is each pixel's own. Anisotropic filters are not modelled"},
                {"limits",
                 "libogc, gx.c and gx.h: textures up to 1024x1024; a frame buffer of 640x528; GX_SetTexCopySrc takes "
                 "multiples of 2, GX_CopyTex writes whole tiles, 4x4 in RGBA8",
                 Grade::Document,
                 "A8 and L8 are I8, which reads as its value in all four channels: the black of A8 and the alpha of "
                 "L8 are then constants of the TEV"},
                {"memory",
                 "nintendo.co.uk, \"Technical Details\": main memory of 24 MB; libogc and Dolphin: 640x528 pixels of 24 "
                 "bits of colour and 24 of depth in the chip; tiles of 32 bytes, 8x4 texels of 8 bits, and two for 4x4 "
                 "of RGBA8",
                 Grade::Document,
                 "Main memory is the program's as well, and holds the picture that the display shows; neither is "
                 "counted. That targets may lie side by side in the frame buffer is chosen"},
            },
    };
}

}  // namespace pipeline
