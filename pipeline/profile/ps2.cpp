// SPDX-License-Identifier: MIT
// The PlayStation 2's Graphics Synthesizer. Numbers behind # are issues and pull requests of github.com/PCSX2/pcsx2.
#include "pipeline/profile/tables.h"

namespace pipeline {

Profile make_ps2() {
    using enum TargetFormat;
    using enum CompareFunc;
    return {
        .name       = "ps2",
        .chip       = "Sony Graphics Synthesizer (PlayStation 2)",
        .arithmetic = {.snap         = SnapRule::Truncate,
                       .pixel_center = 0,
                       .vertex_depth = VertexDepth::WholeUnits,
                       .gouraud      = GouraudRule::Floor,
                       .filter       = FilterRule::GsFloor4,
                       .combine      = CombineRule::GsShift7,
                       .fog          = FogRule::GsFloor256,
                       .blend        = BlendRule::GsShift7,
                       .blend_source = BlendSource::Bytes},
        .formats    = {.draw           = {Psmct32, Psmct24, Psmct16},
                       .copy_targets   = {Psmct32, Psmct24, Psmct16},
                       .depth          = {D16, D24, D32},
                       .with_bytes     = Psmct32,
                       .with_alpha     = Psmct32,
                       .opaque         = Psmct24,
                       .pairs_depth    = true,
                       .copies_convert = false,
                       .copies_halve   = false},
        // Blending is register ALPHA's, GsBlend.
        .states     = {.depth_funcs       = {Never, Always, GreaterEqual, Greater},
                       .source_factors    = {BlendFactor::One},
                       .dest_factors      = {BlendFactor::Zero},
                       .dithers           = {DitherMode::None, DitherMode::GsDimx},
                       .transforms        = false,
                       .culling           = false,
                       .flat              = FlatVertex::Last,
                       .specular_addition = false,
                       .stages            = 1,
                       .arguments         = {ArgSource::Diffuse, ArgSource::Current, ArgSource::Texture},
                       .complement        = false,
                       .alpha_replicate   = false,
                       .addresses         = {TextureAddress::Wrap, TextureAddress::Clamp},
                       .mip_filters       = {MipFilter::None}},
        // Sizes that are no powers of two are clamped by REGION_CLAMP. A8 and L8 are PSMT8 with a palette.
        .limits     = {.texture_width  = 1024,
                       .texture_height = 1024,
                       .target_width   = 2048,
                       .target_height  = 2048,
                       .memory         = 4u << 20,
                       .layout         = MemoryLayout::GsPages},
        .evidence =
            {
                {"snap", "chosen: the chip takes 12.4 integers; a program's conversion to them usually cuts",
                 Grade::Chosen, "What a program's vector unit code does before the chip is the program's"},
                {"pixel_center",
                 "jbit.net, \"Pixel Perfect Sprites on the PS2\", captures of a real GS: pixel centres at integers, "
                 "texel centres at halves",
                 Grade::Measured, ""},
                {"vertex_depth", "ps2tek, registers XYZ2 and XYZF2: Z is an integer, of 32 and of 24 bits",
                 Grade::Document, ""},
                {"gouraud",
                 "parallel-gs (Arntzen-Software/parallel-gs), gs/shaders: \"seems to require a floor\"; PCSX2, "
                 "GSDrawScanline.cpp, steps 8.7 numbers and cuts",
                 Grade::Emulators, "The width of the chip's interpolators is not known (#5898)"},
                {"filter",
                 "4 fraction bits, cut: measured on a console, #14078; the lerps, floored along u and then along v: "
                 "PCSX2, GSDrawScanline.cpp",
                 Grade::Chosen,
                 "Sources disagree on the rounding: parallel-gs rounds the host's filter to even, DobieStation "
                 "gsthread.cpp cuts once. Switch: filter GS_NEAREST4, the exact sum rounded once"},
                {"combine",
                 "ps2tek (israpps/ps2tek), Textures; PCSX2 GSDrawScanline.cpp, parallel-gs ubershader.comp, iris "
                 "(allkern/iris) software_thread.cpp, DobieStation gsthread.cpp (all agree, but the last forgets a "
                 "clamp)",
                 Grade::Emulators,
                 "PCSX2 keeps 7 fraction bits of a Gouraud colour in the product (#9654), parallel-gs floors it "
                 "first, as here"},
                {"fog",
                 "PCSX2 after #13171 and #13844 (2026): the factor of the fog colour is 256 - F, cut, said to match "
                 "the console",
                 Grade::Chosen,
                 "Sources disagree: ps2tek, DobieStation and iris floor two products, with 255 - F (switch: fog "
                 "GS_TWO_FLOORS); parallel-gs rounds, as F = 255 must keep 128 at 128"},
                {"blend",
                 "PCSX2 GSDrawScanline.cpp, DobieStation gsthread.cpp, iris software_thread.cpp, parallel-gs "
                 "ubershader.comp (all agree: the shift floors, alpha is written as it is)",
                 Grade::Emulators,
                 "Whether the chip's sum wraps at 9 or 10 bits before COLCLAMP, for C above 0x80, is not known"},
                {"blend_source",
                 "PCSX2 GSDrawScanline.cpp, DobieStation gsthread.cpp, iris software_thread.cpp: blend, dither, "
                 "clamp, FBA, and only then the format",
                 Grade::Emulators, ""},
                {"store",
                 "RenderWare 3.5 PS2 reference, alphablend16; DobieStation convert_color_up and convert_color_down, "
                 "parallel-gs utils.h, PCSX2 (all agree: >> 3, << 3, alpha bit is A >= 0x80; 24 bits read Ad as 0x80)",
                 Grade::Emulators, ""},
                {"dither",
                 "PCSX2 and parallel-gs: DIMX, two's complement, at (x & 3, y & 3), added after the blend; RenderWare "
                 "3.5 PS2 reference describes it for 16 bits",
                 Grade::Chosen,
                 "Sources disagree on other formats: PCSX2 and iris dither 16 bit frames alone, parallel-gs and "
                 "DobieStation all. Ask for it on PSMCT16 only"},
                {"alpha_test",
                 "PCSX2, DobieStation, parallel-gs (all agree); RGB_ONLY is FB_ONLY unless the frame has 32 bits: "
                 "measured on a console, #9652",
                 Grade::Emulators, ""},
                {"dest_alpha_test", "PCSX2, GSRendererSW.cpp; on 24 bit frames nothing is drawn: measured, #5569",
                 Grade::Measured, "ps2tek and parallel-gs let every pixel pass on 24 bit frames"},
                {"depth",
                 "ps2tek, registers TEST and ZBUF; PCSX2, DobieStation, parallel-gs: NEVER, ALWAYS, GEQUAL, GREATER "
                 "on unsigned integers of 16, 24 or 32 bits, floored (#13795)",
                 Grade::Emulators, "The precision of the chip's interpolation is not known"},
                {"copy",
                 "ps2tek, TRXDIR 2: a transfer within the local memory moves bits as they are; nothing is halved",
                 Grade::Document, ""},
                {"targets",
                 "PCSX2, GSRegs.h; 16 bit colours go with 16 bit depth and the others with 24 or 32 bits: PCSX2 "
                 "#14698, which calls other pairs disallowed",
                 Grade::Emulators,
                 "What the chip does with another pair of colour and depth is being tested (#14698). PSMCT16S and "
                 "Z16S are not modelled; they hold the same bits elsewhere"},
                {"states",
                 "ps2tek, registers ALPHA, TEST, FRAME (FBMSK masks bits), SCISSOR; PCSX2, GSRegs.h. The chip takes "
                 "triangles in window space, culls nothing and adds no second colour",
                 Grade::Emulators,
                 "FBMSK can mask single bits of a channel, and is not modelled so far; antialiased edges (AA1) are "
                 "not either"},
                {"stages",
                 "ps2tek, TEX0 and CLAMP: one texture, MODULATE, DECAL, HIGHLIGHT and HIGHLIGHT2; REPEAT, CLAMP and "
                 "their REGION forms",
                 Grade::Emulators, "REGION_CLAMP and REGION_REPEAT are not modelled"},
                {"flat", "PCSX2 and DobieStation, gsthread.cpp: IIP 0 takes the colour of the last vertex",
                 Grade::Emulators, "A frame's flat triangles take the first vertex, so that they are left out here"},
                {"lod", "PCSX2, GSVertexTrace.cpp: log2(1 / |Q|) << L, plus K, or K alone with UV coordinates",
                 Grade::Emulators,
                 "A frame's level comes from the texels that a pixel spans, so that mip levels are left out here"},
                {"limits",
                 "ps2tek and PCSX2, GSRegs.h: TW and TH of TEX0 are logarithms up to 10; REGION_CLAMP ignores them, "
                 "so that a clamped texture has any size; SCISSOR ends at 2047; FRAME's FBW counts 64 pixels, of "
                 "which PCSX2 takes up to 32",
                 Grade::Emulators,
                 "That REGION_CLAMP serves every other size follows from the registers, and was not tried. What the "
                 "chip does with FBW above 32 is not known"},
                {"memory",
                 "parallel-gs, swizzle_utils.h: 512 pages of 8 KB, of 64x32 pixels with 32 or 24 bits, 64x64 with 16, "
                 "128x64 of PSMT8, each of 32 blocks; PCSX2, GSTables.cpp: the blocks' order. Frame and depth buffers "
                 "start on pages, textures and palettes on blocks",
                 Grade::Emulators,
                 "A program's other buffers, as one that the display shows meanwhile, are not counted. Buffers that "
                 "are not needed at one time could share pages; here each has its own"},
            },
    };
}

}  // namespace pipeline
