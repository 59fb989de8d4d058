// SPDX-License-Identifier: MIT
// The C functions that every program's passes call, and its main.
#include <iterator>

#include "pipeline/emit/gx_program.h"

namespace pipeline {

namespace {

struct Function {
    std::string_view name, text;
};

// In the order in which they call each other.
constexpr Function kFunctions[] = {
    {"data_at(", R"(
/* The file of data, from the offset on. */
static void *data_at(u32 offset)
{
    return (void *)(frame_data + offset);
}
)"},
    {"set_up(", R"(
/* What the frame never changes. */
static void set_up(void)
{
    u8 stage;
    DCFlushRange(data_at(0), DATA_BYTES);
    GX_SetCopyFilter(GX_FALSE, NULL, GX_FALSE, NULL); /* pixels as they are, no anti-aliasing */
    GX_SetCopyClamp(GX_CLAMP_TOP | GX_CLAMP_BOTTOM);
    GX_SetDispCopyGamma(GX_GM_1_0);
    GX_SetClipMode(GX_CLIP_ENABLE);
    GX_SetScissorBoxOffset(0, 0);
    GX_SetCoPlanar(GX_DISABLE);
    GX_SetFogRangeAdj(GX_DISABLE, 0, NULL);
    GX_SetZTexture(GX_ZT_DISABLE, GX_TF_Z8, 0);
    GX_SetDstAlpha(GX_DISABLE, 0);
    GX_SetNumIndStages(0);
    GX_SetTevSwapModeTable(GX_TEV_SWAP0, GX_CH_RED, GX_CH_GREEN, GX_CH_BLUE, GX_CH_ALPHA);
    for (stage = 0; stage < GX_MAX_TEVSTAGE; ++stage) {
        GX_SetTevDirect(stage);
        GX_SetTevSwapMode(stage, GX_TEV_SWAP0, GX_TEV_SWAP0);
        GX_SetTevKAlphaSel(stage, GX_TEV_KASEL_1); /* GX_CA_KONST is 1 */
    }
    GX_SetVtxAttrFmt(GX_VTXFMT0, GX_VA_POS, GX_POS_XYZ, GX_F32, 0);
    GX_SetVtxAttrFmt(GX_VTXFMT0, GX_VA_NRM, GX_NRM_XYZ, GX_F32, 0);
    GX_SetVtxAttrFmt(GX_VTXFMT0, GX_VA_CLR0, GX_CLR_RGBA, GX_RGBA8, 0);
    GX_SetVtxAttrFmt(GX_VTXFMT0, GX_VA_CLR1, GX_CLR_RGBA, GX_RGBA8, 0);
    GX_SetVtxAttrFmt(GX_VTXFMT0, GX_VA_TEX0, GX_TEX_ST, GX_F32, 0);
    GX_SetVtxAttrFmt(GX_VTXFMT0, GX_VA_TEX1, GX_TEX_ST, GX_F32, 0);
    GX_SetCurrentMtx(GX_PNMTX0);
    GX_InvVtxCache();
    GX_InvalidateTexAll();
}
)"},
    {"window_space(", R"(
/* Positions in pixels of a target that lies at (x, y) in the frame buffer, depth in 0..1. */
static void window_space(u16 x, u16 y, u16 width, u16 height)
{
    Mtx44 projection = {
        { 2.0f / width, 0.0f, 0.0f, -1.0f }, { 0.0f, -2.0f / height, 0.0f, 1.0f },
        { 0.0f, 0.0f, 1.0f, -1.0f },         { 0.0f, 0.0f, 0.0f, 1.0f },
    };
    Mtx position = { { 1.0f, 0.0f, 0.0f, 0.0f }, { 0.0f, 1.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, 1.0f, 0.0f } };
    GX_SetViewport(x, y, width, height, 0.0f, 1.0f);
    GX_LoadProjectionMtx(projection, GX_ORTHOGRAPHIC);
    GX_LoadPosMtxImm(position, GX_PNMTX0);
}
)"},
    {"bind_texture(", R"(
/* levels: mip levels that are sampled. */
static void bind_texture(u8 map, void *texels, u16 width, u16 height, u8 format, u8 wrap_s, u8 wrap_t, u8 levels,
                         u8 min_filter, u8 mag_filter)
{
    GXTexObj object;
    GX_InitTexObj(&object, texels, width, height, format, wrap_s, wrap_t, levels > 1 ? GX_TRUE : GX_FALSE);
    GX_InitTexObjLOD(&object, min_filter, mag_filter, 0.0f, (f32)(levels - 1), 0.0f, GX_DISABLE, GX_DISABLE,
                     GX_ANISO_1);
    GX_LoadTexObj(&object, map);
}
)"},
    {"rectangle(", R"(
/* A rectangle in window space; the texture coordinates of its corners are u0, v0, u1, v1, or there are none. */
static void rectangle(f32 x0, f32 y0, f32 x1, f32 y1, f32 depth, u32 rgba, const f32 *tex0, const f32 *tex1)
{
    int corner;
    GX_ClearVtxDesc();
    GX_SetVtxDesc(GX_VA_POS, GX_DIRECT);
    GX_SetVtxDesc(GX_VA_CLR0, GX_DIRECT);
    if (tex0) GX_SetVtxDesc(GX_VA_TEX0, GX_DIRECT);
    if (tex1) GX_SetVtxDesc(GX_VA_TEX1, GX_DIRECT);
    GX_Begin(GX_QUADS, GX_VTXFMT0, 4);
    for (corner = 0; corner < 4; ++corner) {
        const int right = corner == 1 || corner == 2, bottom = corner >= 2;
        GX_Position3f32(right ? x1 : x0, bottom ? y1 : y0, depth);
        GX_Color1u32(rgba);
        if (tex0) GX_TexCoord2f32(tex0[right ? 2 : 0], tex0[bottom ? 3 : 1]);
        if (tex1) GX_TexCoord2f32(tex1[right ? 2 : 0], tex1[bottom ? 3 : 1]);
    }
    GX_End();
}
)"},
    {"plain_color(", R"(
/* One channel with the vertex's colour as it is, one stage that passes it on. */
static void plain_color(void)
{
    GX_SetNumChans(1);
    GX_SetChanCtrl(GX_COLOR0A0, GX_DISABLE, GX_SRC_REG, GX_SRC_VTX, GX_LIGHTNULL, GX_DF_NONE, GX_AF_NONE);
    GX_SetNumTexGens(0);
    GX_SetNumTevStages(1);
    GX_SetTevOrder(GX_TEVSTAGE0, GX_TEXCOORDNULL, GX_TEXMAP_NULL, GX_COLOR0A0);
    GX_SetTevColorIn(GX_TEVSTAGE0, GX_CC_ZERO, GX_CC_ZERO, GX_CC_ZERO, GX_CC_RASC);
    GX_SetTevColorOp(GX_TEVSTAGE0, GX_TEV_ADD, GX_TB_ZERO, GX_CS_SCALE_1, GX_TRUE, GX_TEVPREV);
    GX_SetTevAlphaIn(GX_TEVSTAGE0, GX_CA_ZERO, GX_CA_ZERO, GX_CA_ZERO, GX_CA_RASA);
    GX_SetTevAlphaOp(GX_TEVSTAGE0, GX_TEV_ADD, GX_TB_ZERO, GX_CS_SCALE_1, GX_TRUE, GX_TEVPREV);
}
)"},
    {"plain_pixels(", R"(
/* Nothing but what is drawn: no tests, no blending, no fog. */
static void plain_pixels(u8 color, u8 depth)
{
    GX_SetBlendMode(GX_BM_NONE, GX_BL_ONE, GX_BL_ZERO, GX_LO_COPY);
    GX_SetColorUpdate(color);
    GX_SetAlphaUpdate(color);
    GX_SetDither(GX_FALSE);
    GX_SetZMode(depth, GX_ALWAYS, depth);
    GX_SetZCompLoc(GX_TRUE);
    GX_SetAlphaCompare(GX_ALWAYS, 0, GX_AOP_AND, GX_ALWAYS, 0);
    GX_SetCullMode(GX_CULL_NONE);
    GX_SetFog(GX_FOG_NONE, 0.0f, 1.0f, 0.1f, 1.0f, (GXColor){ 0, 0, 0, 0 });
}
)"},
    {"clear_pixels(", R"(
/* Colour, depth or both of a rectangle of the frame buffer. */
static void clear_pixels(u16 x, u16 y, u16 width, u16 height, u8 has_color, u32 rgba, u8 has_depth, f32 depth)
{
    plain_pixels(has_color, has_depth);
    plain_color();
    window_space(x, y, width, height);
    GX_SetScissor(x, y, width, height);
    rectangle(0.0f, 0.0f, width, height, depth, rgba, NULL, NULL);
}
)"},
    {"copy_pixels(", R"(
/* A rectangle of the frame buffer to RGBA8 tiles; halve: by the copy engine's 2x2 box. texels: where its top left tile
 * goes in a texture of that width and height. */
static void copy_pixels(u16 x, u16 y, u16 width, u16 height, u8 *texels, u16 texture_width, u16 texture_height, u8 halve)
{
    GX_SetTexCopySrc(x, y, width, height);
    GX_SetTexCopyDst(texture_width, texture_height, GX_TF_RGBA8, halve);
    GX_CopyTex(texels, GX_FALSE);
}
)"},
    {"finish_copies(", R"(
/* After copies: what follows waits for them, and no texel that was there before is used. */
static void finish_copies(void)
{
    GX_PixModeSync();
    GX_InvalidateTexAll();
}
)"},
    {"vertex_arrays(", R"(
/* Arrays that triangles() indexes, by their offsets; normals, second colours and texture coordinates may be NONE. */
#define NONE 0xffffffffu
static u32 vertex_normals, vertex_colors1, vertex_tex0, vertex_tex1;
static void vertex_arrays(u32 positions, u32 normals, u32 colors0, u32 colors1, u32 tex0, u32 tex1)
{
    vertex_normals = normals;
    vertex_colors1 = colors1;
    vertex_tex0 = tex0;
    vertex_tex1 = tex1;
    GX_ClearVtxDesc();
    GX_SetVtxDesc(GX_VA_POS, GX_INDEX16);
    GX_SetArray(GX_VA_POS, data_at(positions), 12);
    if (normals != NONE) {
        GX_SetVtxDesc(GX_VA_NRM, GX_INDEX16);
        GX_SetArray(GX_VA_NRM, data_at(normals), 12);
    }
    GX_SetVtxDesc(GX_VA_CLR0, GX_INDEX16);
    GX_SetArray(GX_VA_CLR0, data_at(colors0), 4);
    if (colors1 != NONE) {
        GX_SetVtxDesc(GX_VA_CLR1, GX_INDEX16);
        GX_SetArray(GX_VA_CLR1, data_at(colors1), 4);
    }
    if (tex0 != NONE) {
        GX_SetVtxDesc(GX_VA_TEX0, GX_INDEX16);
        GX_SetArray(GX_VA_TEX0, data_at(tex0), 8);
    }
    if (tex1 != NONE) {
        GX_SetVtxDesc(GX_VA_TEX1, GX_INDEX16);
        GX_SetArray(GX_VA_TEX1, data_at(tex1), 8);
    }
}
)"},
    {"triangles(", R"(
static void triangles(u32 indices, u16 count)
{
    const u8 *at = frame_data + indices;
    u16 i;
    GX_Begin(GX_TRIANGLES, GX_VTXFMT0, count);
    for (i = 0; i < count; ++i, at += 2) {
        const u16 index = (u16)(at[0] << 8 | at[1]);
        GX_Position1x16(index);
        if (vertex_normals != NONE) GX_Normal1x16(index);
        GX_Color1x16(index);
        if (vertex_colors1 != NONE) GX_Color1x16(index);
        if (vertex_tex0 != NONE) GX_TexCoord1x16(index);
        if (vertex_tex1 != NONE) GX_TexCoord1x16(index);
    }
    GX_End();
}
)"},
    {"load_light(", R"(
static void load_light(u8 light, f32 x, f32 y, f32 z, GXColor color, f32 k0, f32 k1, f32 k2)
{
    GXLightObj object;
    memset(&object, 0, sizeof object);
    GX_InitLightPos(&object, x, y, z);
    GX_InitLightDir(&object, 0.0f, 0.0f, -1.0f); /* without effect: a1 and a2 are 0 */
    GX_InitLightColor(&object, color);
    GX_InitLightAttn(&object, 1.0f, 0.0f, 0.0f, k0, k1, k2);
    GX_LoadLightObj(&object, light);
}
)"},
};

constexpr std::string_view kMain = R"(
int main(void)
{
    enum { FIFO_BYTES = 256 * 1024 };
    GXRModeObj *mode;
    void *picture, *fifo;
    VIDEO_Init();
    mode = VIDEO_GetPreferredMode(NULL);
    picture = MEM_K0_TO_K1(SYS_AllocateFramebuffer(mode));
    VIDEO_ClearFrameBuffer(mode, picture, COLOR_BLACK);
    VIDEO_Configure(mode);
    VIDEO_SetNextFramebuffer(picture);
    VIDEO_SetBlack(FALSE);
    VIDEO_Flush();
    VIDEO_WaitVSync();

    fifo = memalign(32, FIFO_BYTES);
    memset(fifo, 0, FIFO_BYTES);
    GX_Init(fifo, FIFO_BYTES);
    set_up();
    draw_frame();
    show_picture(mode, picture);
    GX_DrawDone();
    for (;;) VIDEO_WaitVSync();
    return 0;
}
)";

}  // namespace

std::string gx_program_functions(std::string_view callers) {
    std::string text;
    for (auto function = std::rbegin(kFunctions); function != std::rend(kFunctions); ++function) {
        const bool is_called =
            callers.find(function->name) != std::string_view::npos || text.find(function->name) != std::string::npos;
        if (is_called) text.insert(0, function->text);
    }
    return text;
}

std::string_view gx_program_main() {
    return kMain;
}

}  // namespace pipeline
