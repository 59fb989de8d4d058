/* SPDX-License-Identifier: MIT
 * Stands in for libogc's gccore.h on the host: the types, values and calls that GX programs use, each call a line of the standard
 * output, so that a program can be compiled, run and read. Names, signatures and values as in libogc
 * (github.com/devkitPro/libogc), gc/ogc/gx.h, gu.h, video.h, cache.h and system.h.
 * Numbers are decimal, floats hexadecimal, addresses bytes from frame_data. */
#pragma once

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef uint8_t u8;
typedef uint16_t u16;
typedef uint32_t u32;
typedef int8_t s8;
typedef int16_t s16;
typedef int32_t s32;
typedef float f32;
typedef f32 Mtx[3][4];
typedef f32 Mtx44[4][4];
typedef struct {
    u8 r, g, b, a;
} GXColor;
typedef struct {
    u8 pad[128];
} GXFifoObj;
typedef struct {
    u16 r[10];
} GXFogAdjTbl;
/* Opaque to programs; here, what the line of the call that loads one says. */
typedef struct {
    void* texels;
    u16 width, height;
    u8 format, wrap_s, wrap_t, mipmap, min_filter, mag_filter;
    f32 min_lod, max_lod, lod_bias;
} GXTexObj;
typedef struct {
    f32 position[3], direction[3], a[3], k[3];
    GXColor color;
} GXLightObj;
typedef struct {
    u32 viTVMode;
    u16 fbWidth, efbHeight, xfbHeight;
} GXRModeObj;

#ifndef FALSE
#define FALSE 0
#define TRUE 1
#endif
#define COLOR_BLACK 0x10801080
#define MEM_K0_TO_K1(x) (x)

enum { GX_FALSE = 0, GX_TRUE = 1, GX_DISABLE = 0, GX_ENABLE = 1 };
enum { GX_CLIP_ENABLE = 0, GX_CLIP_DISABLE = 1, GX_PERSPECTIVE = 0, GX_ORTHOGRAPHIC = 1 };
enum { GX_COLOR0, GX_COLOR1, GX_ALPHA0, GX_ALPHA1, GX_COLOR0A0, GX_COLOR1A1, GX_COLORZERO, GX_COLORNULL = 0xff };
enum { GX_MTX3x4 = 0, GX_MTX2x4 = 1, GX_VTXFMT0 = 0 };
enum { GX_NONE, GX_DIRECT, GX_INDEX8, GX_INDEX16 };
enum { GX_F32 = 4, GX_RGBA8 = 5, GX_POS_XYZ = 1, GX_NRM_XYZ = 0, GX_CLR_RGBA = 1, GX_TEX_ST = 1 };
enum { GX_VA_POS = 9, GX_VA_NRM, GX_VA_CLR0, GX_VA_CLR1, GX_VA_TEX0, GX_VA_TEX1 };
enum { GX_QUADS = 0x80, GX_TRIANGLES = 0x90 };
enum { GX_SRC_REG, GX_SRC_VTX };
enum { GX_LIGHTNULL = 0, GX_LIGHT0 = 1, GX_LIGHT1 = 2, GX_LIGHT2 = 4, GX_LIGHT3 = 8 };
enum { GX_LIGHT4 = 0x10, GX_LIGHT5 = 0x20, GX_LIGHT6 = 0x40, GX_LIGHT7 = 0x80 };
enum { GX_DF_NONE, GX_DF_SIGNED, GX_DF_CLAMP };
enum { GX_AF_SPEC, GX_AF_SPOT, GX_AF_NONE };
enum { GX_PNMTX0 = 0, GX_TEXMTX0 = 30, GX_TEXMTX1 = 33, GX_IDENTITY = 60 };
enum { GX_TEXCOORD0, GX_TEXCOORD1, GX_TEXCOORDNULL = 0xff };
enum { GX_TF_I8 = 1, GX_TF_RGBA8 = 6, GX_TF_Z8 = 0x11 };
enum { GX_ZT_DISABLE = 0 };
enum { GX_TG_MTX3x4 = 0, GX_TG_MTX2x4 = 1, GX_TG_POS = 0, GX_TG_NRM = 1, GX_TG_TEX0 = 4, GX_TG_TEX1 = 5 };
enum { GX_NEVER, GX_LESS, GX_EQUAL, GX_LEQUAL, GX_GREATER, GX_NEQUAL, GX_GEQUAL, GX_ALWAYS };
enum { GX_CLAMP, GX_REPEAT, GX_MIRROR };
enum { GX_BM_NONE, GX_BM_BLEND, GX_BM_LOGIC, GX_BM_SUBTRACT };
enum {
    GX_BL_ZERO,
    GX_BL_ONE,
    GX_BL_SRCCLR,
    GX_BL_INVSRCCLR,
    GX_BL_SRCALPHA,
    GX_BL_INVSRCALPHA,
    GX_BL_DSTALPHA,
    GX_BL_INVDSTALPHA,
    GX_BL_DSTCLR    = GX_BL_SRCCLR,
    GX_BL_INVDSTCLR = GX_BL_INVSRCCLR
};
enum { GX_LO_COPY = 3 };
enum {
    GX_CC_CPREV,
    GX_CC_APREV,
    GX_CC_C0,
    GX_CC_A0,
    GX_CC_C1,
    GX_CC_A1,
    GX_CC_C2,
    GX_CC_A2,
    GX_CC_TEXC,
    GX_CC_TEXA,
    GX_CC_RASC,
    GX_CC_RASA,
    GX_CC_ONE,
    GX_CC_HALF,
    GX_CC_KONST,
    GX_CC_ZERO
};
enum { GX_CA_APREV, GX_CA_A0, GX_CA_A1, GX_CA_A2, GX_CA_TEXA, GX_CA_RASA, GX_CA_KONST, GX_CA_ZERO };
enum { GX_TEVSTAGE0, GX_TEVSTAGE1, GX_TEVSTAGE2, GX_TEVSTAGE3, GX_TEVSTAGE4, GX_TEVSTAGE5, GX_MAX_TEVSTAGE = 16 };
enum { GX_TEV_ADD, GX_TEV_SUB };
enum { GX_TB_ZERO, GX_TB_ADDHALF, GX_TB_SUBHALF };
enum { GX_CS_SCALE_1, GX_CS_SCALE_2, GX_CS_SCALE_4, GX_CS_DIVIDE_2 };
enum { GX_TEVPREV, GX_TEVREG0, GX_TEVREG1, GX_TEVREG2 };
enum { GX_CULL_NONE, GX_CULL_FRONT, GX_CULL_BACK, GX_CULL_ALL };
enum { GX_TEXMAP0, GX_TEXMAP1, GX_TEXMAP_NULL = 0xff };
enum { GX_AOP_AND, GX_AOP_OR, GX_AOP_XOR, GX_AOP_XNOR };
enum { GX_TEV_KASEL_1 = 0, GX_TEV_SWAP0 = 0 };
enum { GX_CH_RED, GX_CH_GREEN, GX_CH_BLUE, GX_CH_ALPHA };
enum {
    GX_FOG_NONE       = 0,
    GX_FOG_PERSP_LIN  = 2,
    GX_FOG_PERSP_EXP  = 4,
    GX_FOG_PERSP_EXP2 = 5,
    GX_FOG_ORTHO_LIN  = 10,
    GX_FOG_ORTHO_EXP  = 12,
    GX_FOG_ORTHO_EXP2 = 13
};
enum { GX_PF_RGB8_Z24 = 0, GX_PF_RGBA6_Z24 = 1, GX_ZC_LINEAR = 0 };
enum { GX_CLAMP_NONE = 0, GX_CLAMP_TOP = 1, GX_CLAMP_BOTTOM = 2, GX_GM_1_0 = 0 };
enum { GX_NEAR, GX_LINEAR, GX_NEAR_MIP_NEAR, GX_LIN_MIP_NEAR, GX_NEAR_MIP_LIN, GX_LIN_MIP_LIN, GX_ANISO_1 = 0 };

extern const u8 frame_data[];
static inline long long gx_address(const void* at) {
    return (long long)((intptr_t)at - (intptr_t)frame_data);
}
static inline void gx_log_ints(const char* name, int count, const long long* values) {
    int i;
    fputs(name, stdout);
    for (i = 0; i < count; ++i) printf(" %lld", values[i]);
    putchar('\n');
}
static inline void gx_log_floats(const char* name, long long first, int count, const f32* values) {
    int i;
    printf("%s %lld", name, first);
    for (i = 0; i < count; ++i) printf(" %a", values[i]);
    putchar('\n');
}
#define GX_LOG(name, ...)                                                    \
    do {                                                                     \
        const long long values_[] = {__VA_ARGS__};                           \
        gx_log_ints(name, (int)(sizeof values_ / sizeof *values_), values_); \
    } while (0)
#define GX_CALL0(name)              \
    static inline void name(void) { \
        puts(#name);                \
    }
#define GX_CALL1(name, A)            \
    static inline void name(A a) {   \
        GX_LOG(#name, (long long)a); \
    }
#define GX_CALL2(name, A, B)                       \
    static inline void name(A a, B b) {            \
        GX_LOG(#name, (long long)a, (long long)b); \
    }
#define GX_CALL3(name, A, B, C)                                  \
    static inline void name(A a, B b, C c) {                     \
        GX_LOG(#name, (long long)a, (long long)b, (long long)c); \
    }
#define GX_CALL4(name, A, B, C, D)                                             \
    static inline void name(A a, B b, C c, D d) {                              \
        GX_LOG(#name, (long long)a, (long long)b, (long long)c, (long long)d); \
    }
#define GX_CALL5(name, A, B, C, D, E)                                                        \
    static inline void name(A a, B b, C c, D d, E e) {                                       \
        GX_LOG(#name, (long long)a, (long long)b, (long long)c, (long long)d, (long long)e); \
    }
#define GX_CALL6(name, A, B, C, D, E, F)                                                                   \
    static inline void name(A a, B b, C c, D d, E e, F f) {                                                \
        GX_LOG(#name, (long long)a, (long long)b, (long long)c, (long long)d, (long long)e, (long long)f); \
    }

/* Set-up and display. */
static inline void VIDEO_Init(void) {}
static inline GXRModeObj* VIDEO_GetPreferredMode(GXRModeObj* mode) {
    static GXRModeObj ntsc = {0, 640, 480, 480};
    (void)mode;
    return &ntsc;
}
static inline void* SYS_AllocateFramebuffer(GXRModeObj* mode) {
    return malloc(2u * mode->fbWidth * mode->xfbHeight);
}
static inline void VIDEO_ClearFrameBuffer(GXRModeObj* mode, void* fb, u32 color) {
    (void)mode, (void)fb, (void)color;
}
static inline void VIDEO_Configure(GXRModeObj* mode) {
    (void)mode;
}
static inline void VIDEO_SetNextFramebuffer(void* fb) {
    (void)fb;
}
static inline void VIDEO_SetBlack(bool black) {
    (void)black;
}
static inline void VIDEO_Flush(void) {}
static inline void GX_DrawDone(void);
/* The second one ends the program. */
static inline void VIDEO_WaitVSync(void) {
    static int count;
    if (++count == 2) exit(0);
}
static inline void DCFlushRange(void* start, u32 length) {
    GX_LOG("DCFlushRange", gx_address(start), length);
}
static inline GXFifoObj* GX_Init(void* base, u32 size) {
    static GXFifoObj fifo;
    (void)base;
    GX_LOG("GX_Init", size);
    return &fifo;
}
GX_CALL0(GX_DrawDone)
GX_CALL1(GX_SetClipMode, u8)
GX_CALL1(GX_SetCoPlanar, u8)
GX_CALL1(GX_SetCopyClamp, u8)
GX_CALL1(GX_SetDispCopyGamma, u8)
GX_CALL2(GX_SetScissorBoxOffset, s32, s32)
static inline void GX_SetFogRangeAdj(u8 enable, u16 center, GXFogAdjTbl* table) {
    (void)center, (void)table;
    GX_LOG("GX_SetFogRangeAdj", enable);
}
GX_CALL3(GX_SetZTexture, u8, u8, u32)
static inline void GX_SetCopyFilter(u8 aa, u8 sample_pattern[12][2], u8 vf, u8 vfilter[7]) {
    (void)sample_pattern, (void)vfilter;
    GX_LOG("GX_SetCopyFilter", aa, vf);
}
GX_CALL4(GX_SetDispCopySrc, u16, u16, u16, u16)
GX_CALL2(GX_SetDispCopyDst, u16, u16)
static inline u32 GX_SetDispCopyYScale(f32 scale) {
    gx_log_floats("GX_SetDispCopyYScale", 0, 1, &scale);
    return 480;
}
static inline void GX_CopyDisp(void* dest, u8 clear) {
    (void)dest;
    GX_LOG("GX_CopyDisp", clear);
}

/* Space. */
static inline void GX_SetViewport(f32 x, f32 y, f32 width, f32 height, f32 near, f32 far) {
    const f32 values[] = {x, y, width, height, near, far};
    gx_log_floats("GX_SetViewport", 0, 6, values);
}
GX_CALL4(GX_SetScissor, u32, u32, u32, u32)
static inline void GX_LoadProjectionMtx(Mtx44 m, u8 type) {
    gx_log_floats("GX_LoadProjectionMtx", type, 16, m[0]);
}
static inline void GX_LoadPosMtxImm(Mtx m, u32 id) {
    gx_log_floats("GX_LoadPosMtxImm", id, 12, m[0]);
}
static inline void GX_LoadNrmMtxImm(Mtx m, u32 id) {
    gx_log_floats("GX_LoadNrmMtxImm", id, 12, m[0]);
}
static inline void GX_LoadTexMtxImm(Mtx m, u32 id, u8 type) {
    if (type != GX_MTX3x4) abort();
    gx_log_floats("GX_LoadTexMtxImm", id, 12, m[0]);
}
GX_CALL1(GX_SetCurrentMtx, u32)
GX_CALL1(GX_SetCullMode, u8)

/* Colour channels and lights. */
GX_CALL1(GX_SetNumChans, u8)
static inline void GX_SetChanCtrl(s32 channel, u8 enable, u8 ambient, u8 material, u8 lights, u8 diffuse,
                                  u8 attenuation) {
    GX_LOG("GX_SetChanCtrl", channel, enable, ambient, material, lights, diffuse, attenuation);
}
static inline void GX_SetChanAmbColor(s32 channel, GXColor c) {
    GX_LOG("GX_SetChanAmbColor", channel, c.r, c.g, c.b, c.a);
}
static inline void GX_SetChanMatColor(s32 channel, GXColor c) {
    GX_LOG("GX_SetChanMatColor", channel, c.r, c.g, c.b, c.a);
}
static inline void GX_InitLightPos(GXLightObj* light, f32 x, f32 y, f32 z) {
    light->position[0] = x, light->position[1] = y, light->position[2] = z;
}
static inline void GX_InitLightDir(GXLightObj* light, f32 x, f32 y, f32 z) {
    light->direction[0] = x, light->direction[1] = y, light->direction[2] = z;
}
static inline void GX_InitLightColor(GXLightObj* light, GXColor color) {
    light->color = color;
}
static inline void GX_InitLightAttn(GXLightObj* light, f32 a0, f32 a1, f32 a2, f32 k0, f32 k1, f32 k2) {
    light->a[0] = a0, light->a[1] = a1, light->a[2] = a2;
    light->k[0] = k0, light->k[1] = k1, light->k[2] = k2;
}
static inline void GX_LoadLightObj(const GXLightObj* light, u8 id) {
    const f32 values[] = {light->position[0], light->position[1], light->position[2], light->color.r,
                          light->color.g,     light->color.b,     light->a[0],        light->a[1],
                          light->a[2],        light->k[0],        light->k[1],        light->k[2]};
    gx_log_floats("GX_LoadLightObj", id, 12, values);
}

/* Textures and the TEV. */
GX_CALL1(GX_SetNumTexGens, u32)
GX_CALL4(GX_SetTexCoordGen, u16, u32, u32, u32)
static inline void GX_InitTexObj(GXTexObj* object, void* texels, u16 width, u16 height, u8 format, u8 wrap_s, u8 wrap_t,
                                 u8 mipmap) {
    memset(object, 0, sizeof *object);
    object->texels = texels, object->width = width, object->height = height, object->format = format;
    object->wrap_s = wrap_s, object->wrap_t = wrap_t, object->mipmap = mipmap;
}
static inline void GX_InitTexObjLOD(GXTexObj* object, u8 min_filter, u8 mag_filter, f32 min_lod, f32 max_lod, f32 bias,
                                    u8 bias_clamp, u8 edge_lod, u8 anisotropy) {
    (void)bias_clamp, (void)edge_lod, (void)anisotropy;
    object->min_filter = min_filter, object->mag_filter = mag_filter;
    object->min_lod = min_lod, object->max_lod = max_lod, object->lod_bias = bias;
}
static inline void GX_LoadTexObj(GXTexObj* object, u8 map) {
    if ((intptr_t)object->texels % 32 != 0) abort();
    GX_LOG("GX_LoadTexObj", map, gx_address(object->texels), object->width, object->height, object->format,
           object->wrap_s, object->wrap_t, object->mipmap, object->min_filter, object->mag_filter,
           (long long)object->min_lod, (long long)object->max_lod);
}
GX_CALL0(GX_InvalidateTexAll)
GX_CALL1(GX_SetNumTevStages, u8)
GX_CALL1(GX_SetNumIndStages, u8)
GX_CALL1(GX_SetTevDirect, u8)
GX_CALL4(GX_SetTevOrder, u8, u8, u32, u8)
GX_CALL5(GX_SetTevColorIn, u8, u8, u8, u8, u8)
GX_CALL5(GX_SetTevAlphaIn, u8, u8, u8, u8, u8)
GX_CALL6(GX_SetTevColorOp, u8, u8, u8, u8, u8, u8)
GX_CALL6(GX_SetTevAlphaOp, u8, u8, u8, u8, u8, u8)
static inline void GX_SetTevColor(u8 id, GXColor c) {
    GX_LOG("GX_SetTevColor", id, c.r, c.g, c.b, c.a);
}
GX_CALL2(GX_SetTevKAlphaSel, u8, u8)
GX_CALL3(GX_SetTevSwapMode, u8, u8, u8)
GX_CALL5(GX_SetTevSwapModeTable, u8, u8, u8, u8, u8)

/* Pixels. */
static inline void GX_SetFog(u8 type, f32 start, f32 end, f32 near, f32 far, GXColor c) {
    const f32 values[] = {start, end, near, far, c.r, c.g, c.b};
    gx_log_floats("GX_SetFog", type, 7, values);
}
GX_CALL4(GX_SetBlendMode, u8, u8, u8, u8)
GX_CALL1(GX_SetColorUpdate, u8)
GX_CALL1(GX_SetAlphaUpdate, u8)
GX_CALL2(GX_SetDstAlpha, u8, u8)
GX_CALL1(GX_SetDither, u8)
GX_CALL3(GX_SetZMode, u8, u8, u8)
GX_CALL1(GX_SetZCompLoc, u8)
GX_CALL5(GX_SetAlphaCompare, u8, u8, u8, u8, u8)
GX_CALL2(GX_SetPixelFmt, u8, u8)
GX_CALL4(GX_SetTexCopySrc, u16, u16, u16, u16)
GX_CALL4(GX_SetTexCopyDst, u16, u16, u32, u8)
static inline void GX_CopyTex(void* dest, u8 clear) {
    if ((intptr_t)dest % 32 != 0) abort();
    GX_LOG("GX_CopyTex", gx_address(dest), clear);
}
GX_CALL0(GX_PixModeSync)

/* Vertices. */
GX_CALL0(GX_InvVtxCache)
GX_CALL0(GX_ClearVtxDesc)
GX_CALL2(GX_SetVtxDesc, u8, u8)
GX_CALL5(GX_SetVtxAttrFmt, u8, u32, u32, u32, u32)
static inline void GX_SetArray(u32 attribute, void* at, u8 stride) {
    GX_LOG("GX_SetArray", attribute, gx_address(at), stride);
}
GX_CALL3(GX_Begin, u8, u8, u16)
GX_CALL0(GX_End)
static inline void GX_Position3f32(f32 x, f32 y, f32 z) {
    const f32 values[] = {x, y, z};
    gx_log_floats("GX_Position3f32", 0, 3, values);
}
GX_CALL1(GX_Position1x16, u16)
GX_CALL1(GX_Normal1x16, u16)
GX_CALL1(GX_Color1u32, u32)
GX_CALL1(GX_Color1x16, u16)
static inline void GX_TexCoord2f32(f32 s, f32 t) {
    const f32 values[] = {s, t};
    gx_log_floats("GX_TexCoord2f32", 0, 2, values);
}
GX_CALL1(GX_TexCoord1x16, u16)
