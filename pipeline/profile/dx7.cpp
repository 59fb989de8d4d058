// SPDX-License-Identifier: MIT
// A PC card of Direct3D 7, in the flavour of NVIDIA's NV10 and NV15 (GeForce 256, GeForce2).
#include "pipeline/profile/tables.h"

namespace pipeline {

Profile make_dx7() {
    using enum TargetFormat;
    return {
        .name       = "dx7",
        .chip       = "Direct3D 7 card of the class of NVIDIA NV10 / NV15 (GeForce 256, GeForce2)",
        .arithmetic = {.snap = SnapRule::Truncate, .pixel_center = 0},
        // A copy is a Blt of DirectDraw, within one format.
        .formats    = {.draw           = {A8R8G8B8, X8R8G8B8, R5G6B5, A1R5G5B5},
                       .copy_targets   = {A8R8G8B8, X8R8G8B8, R5G6B5, A1R5G5B5},
                       .depth          = {D16, D24},
                       .copies_convert = false,
                       .copies_halve   = false},
        // Direct3D 7 has neither a mask nor a scissor, whatever the chips had.
        .states     = {.color_mask      = MaskKind::None,
                       .dest_alpha_test = false,
                       .alpha_fails     = {AlphaFail::Keep},
                       .scissor         = false},
        // A target that is read as a texture keeps to the rules for textures.
        .limits     = {.texture_width     = 2048,
                       .texture_height    = 2048,
                       .memory            = 32u << 20,
                       .pitch_alignment   = 64,
                       .address_alignment = 64},
        .evidence =
            {
                {"snap",
                 "envytools (github.com/envytools/envytools), nvhw/pgraph_celsius_xfrm.c, xfrm_squash_xy, which its "
                 "hwtest compares with the card: bits below 1/16 pixel are cleared; Wine 9.0, "
                 "dlls/d3d9/tests/visual.c, fill rule test: a GeForce4 Go (a GeForce2) needs 1/16 pixel to move a "
                 "pixel",
                 Grade::Measured,
                 "Other cards of the time: Radeon R100 chooses truncation or rounding and 1/16 to 1/2 pixel in "
                 "SE_CNTL (Mesa 7.10, radeon_reg.h)"},
                {"pixel_center",
                 "DirectX 5, 6 and 7 SDK help and MSDN Library April 2000, \"Triangle Rasterization Rules\": centres "
                 "at integer coordinates, top-left rule",
                 Grade::Document, "The help adds that the rule does not apply to all hardware"},
                {"vertex_depth", "chosen: finer than the depth buffer", Grade::Chosen,
                 "D3DTLVERTEX holds a float; no source for what a chip keeps of it"},
                {"gouraud", "chosen: to nearest, as Direct3D 10's data conversion rules have it for a store",
                 Grade::Chosen,
                 "No source for the rounding of an interpolated colour. That it starts from bytes at the vertices is "
                 "envytools' xfrm_f2b"},
                {"filter", "chosen: 8 fraction bits (Matrox G400's specification says 8) and one rounding",
                 Grade::Chosen, "Fraction bits and rounding of NV10, NV15 and R100 are not known"},
                {"combine", "chosen: one rounding of the exact result, to nearest", Grade::Chosen,
                 "The DirectX 5 to 9 SDK texts give no rounding. NV10's register combiners are signed 9 bit numbers "
                 "over 255 (OpenGL extension NV_register_combiners); their rounding is not known"},
                {"fog", "chosen: one rounding of the exact result, to nearest", Grade::Chosen,
                 "No source for the rounding"},
                {"blend",
                 "chosen: what was fitted to NVIDIA's next chip, the Xbox's NV2A (see profile xbox), one rounding of "
                 "the exact sum",
                 Grade::Chosen,
                 "NV10 and NV15 themselves were not measured. 3dfx Voodoo: (c * (f + 1)) >> 8 for each product (MAME, "
                 "voodoo.cpp). R100 has a bit ROUND_ENABLE (Mesa 7.10, radeon_reg.h)"},
                {"blend_source", "chosen: whole bytes", Grade::Chosen,
                 "The Xbox's NV2A cuts the source to the bits of a 16 bit target; NV10 and NV15 were not measured"},
                {"store",
                 "R5G6B5 read back by repeating bits: MAME, voodoo.cpp, EXTRACT_565_TO_888; X8R8G8B8 and R5G6B5 read "
                 "alpha as one: Wine 9.0, dlls/ddraw/tests/visual.c, test_blend, and wined3d",
                 Grade::Chosen,
                 "That a 16 bit store truncates is chosen. Dithering (D3DRENDERSTATE_DITHERENABLE) is not modelled: "
                 "no source for its pattern"},
                {"alpha_test",
                 "Wine 9.0, dlls/ddraw/tests/ddraw7.c, test_alphatest (a test made to be run on Windows): the low 8 "
                 "bits of ALPHAREF, 8 functions",
                 Grade::Measured, ""},
                {"depth",
                 "DirectX 7 SDK help, D3DCMPFUNC: 8 functions; Mesa 7.10, nv10_state_fb.c: NV10 has Z16 and Z24S8 only",
                 Grade::Document, "That depth is floored to the format's bits is chosen"},
                {"copy", "chosen: DirectDraw's Blt, unstretched and within one format, moves pixels as they are",
                 Grade::Chosen, "No source on a chip's own blits. Blts that stretch or convert are left out"},
                {"targets",
                 "A8R8G8B8, X8R8G8B8, R5G6B5: Mesa 7.10, nv10_state_fb.c; A1R5G5B5: Mesa 7.10, radeon (Radeon R100)",
                 Grade::Document,
                 "A driver may refuse colour and depth of different bits a pixel (Windows driver documents, \"Render "
                 "Target Requirements\"); here they go together. Whether NV10 draws to A1R5G5B5 is not known"},
                {"states",
                 "DirectX 7 SDK help, D3DBLEND; all factors on both sides: Mesa 7.10, NV10 and R100. No colour mask: "
                 "MSDN Library April 2000, render states; no scissor: Wine 9.0, dlls/ddraw/tests/ddraw7.c, test_clear",
                 Grade::Document,
                 "Matrox G400 has DESTCOLOR as a source factor only, SRCCOLOR as a destination factor only (Mesa "
                 "7.10, mgastate.c), which is all that the Windows logo asked for. The chips have masks; only "
                 "Direct3D 7 has none"},
                {"stages", "DirectX 7 SDK help, D3DTEXTUREOP and D3DTA; 2 stages: Mesa 7.10, NV10_TEXTURE_UNITS",
                 Grade::Document, "Radeon R100 has 3 stages"},
                {"flat",
                 "DirectX 8.1 SDK help and Wine 9.0, dlls/ddraw/tests/ddraw7.c, test_shademode: the first vertex",
                 Grade::Document, ""},
                {"lod", "chosen: from the texels that a pixel spans, its logarithm linear between powers of two",
                 Grade::Chosen, "No source for the level of detail of NV10, NV15 or R100"},
                {"limits",
                 "2048 texels: Mesa 7.10, NV10's 12 texture levels; sizes that are no powers of two, clamped and without "
                 "mip levels: NVIDIA, NV_texture_rectangle, Release 10 drivers; A8 as (0, 0, 0, A), L8 as (L, L, L, 1): Wine 9.0, wined3d",
                 Grade::Document,
                 "The largest target is not known. Direct3D's flag for such sizes is D3DPTEXTURECAPS_NONPOW2CONDITIONAL; "
                 "which drivers set it is not known, and without it a target that is read needs powers of two. The "
                 "Windows logo asked for 1024 texels. That A8 reads black is not confirmed for every chip"},
                {"memory",
                 "32 MB, the least of the boards with a GeForce 256 (tecchannel, guru3d); rows at multiples of 64 "
                 "bytes: Mesa, nouveau_surface.c, the pitch of linear surfaces",
                 Grade::Document,
                 "Boards with 64 MB exist. That surfaces start at multiples of 64 bytes is chosen. Tiled surfaces, "
                 "whose pitch Mesa aligns to 256 bytes, and textures in system memory are not modelled; the front "
                 "buffer is not counted"},
            },
    };
}

}  // namespace pipeline
