// SPDX-License-Identifier: MIT
#include "pipeline/emit/dx7_program.h"

namespace pipeline::dx7 {

constexpr std::string_view kDevice = R"(static std::vector<uint8_t> data;
static IDirectDraw7* direct_draw;
static IDirect3D7* direct_3d;
static IDirect3DDevice7* device;
static GUID device_kind;
static DWORD memory;                    // DDSCAPS_*: where surfaces lie
static bool has_hardware, has_hardware_tnl;
static bool has_a8, has_l8;             // as texture formats; others are expanded
static std::vector<Surface*> targets;   // and textures: none for what is not used
static std::vector<Surface*> textures;
static std::vector<IDirect3DVertexBuffer7*> meshes;
static Surface* white;                  // for a stage that reads a texture and has none

static void read_data() {
    FILE* file = std::fopen(data_file, "rb");
    if (!file) stop(std::string(data_file) + ": cannot be opened");
    data.resize(data_size);
    const bool is_whole = std::fread(data.data(), 1, data_size, file) == data_size && std::fgetc(file) == EOF;
    std::fclose(file);
    if (!is_whole) stop(std::string(data_file) + ": is not of the size that this program was made for");
}

static DDPIXELFORMAT pixel_format(Format format) {
    DDPIXELFORMAT out = {};
    out.dwSize        = sizeof out;
    const auto set    = [&](DWORD flags, DWORD bits, DWORD red, DWORD green, DWORD blue, DWORD alpha) {
        out.dwFlags           = flags;
        out.dwRGBBitCount     = bits;  // also dwAlphaBitDepth, dwLuminanceBitCount
        out.dwRBitMask        = red;   // also dwLuminanceBitMask
        out.dwGBitMask        = green;
        out.dwBBitMask        = blue;
        out.dwRGBAlphaBitMask = alpha;
    };
    switch (format) {
        case A8R8G8B8: set(DDPF_RGB | DDPF_ALPHAPIXELS, 32, 0xff0000, 0xff00, 0xff, 0xff000000); break;
        case X8R8G8B8: set(DDPF_RGB, 32, 0xff0000, 0xff00, 0xff, 0); break;
        case R5G6B5:   set(DDPF_RGB, 16, 0xf800, 0x7e0, 0x1f, 0); break;
        case A1R5G5B5: set(DDPF_RGB | DDPF_ALPHAPIXELS, 16, 0x7c00, 0x3e0, 0x1f, 0x8000); break;
        case A8:       set(DDPF_ALPHA, 8, 0, 0, 0, 0); break;
        case L8:       set(DDPF_LUMINANCE, 8, 0xff, 0, 0, 0); break;
        case D16:
        case D24:      break;  // one of the device's
    }
    return out;
}

// The device's own format with so many bits of depth, the one with the least stencil.
struct DepthSearch {
    int bits;
    DDPIXELFORMAT found;
};
static HRESULT CALLBACK compare_depth(DDPIXELFORMAT* format, void* context) {
    DepthSearch& search = *static_cast<DepthSearch*>(context);
    int bits            = 0;
    for (DWORD mask = format->dwZBitMask; mask != 0; mask &= mask - 1) ++bits;
    const bool is_better = search.found.dwSize == 0 || format->dwStencilBitDepth < search.found.dwStencilBitDepth;
    if (bits == search.bits && is_better) search.found = *format;
    return D3DENUMRET_OK;
}
static DDPIXELFORMAT depth_format(int bits) {
    DepthSearch search = {bits, {}};
    TRY(direct_3d->EnumZBufferFormats(device_kind, compare_depth, &search));
    if (search.found.dwSize == 0) stop("the device has no depth of " + std::to_string(bits) + " bits");
    return search.found;
}

static HRESULT CALLBACK note_texture_format(DDPIXELFORMAT* format, void*) {
    if ((format->dwFlags & DDPF_ALPHA) && format->dwAlphaBitDepth == 8) has_a8 = true;
    if (format->dwFlags == DDPF_LUMINANCE && format->dwLuminanceBitCount == 8) has_l8 = true;
    return D3DENUMRET_OK;
}

static HRESULT CALLBACK note_device(LPSTR, LPSTR, D3DDEVICEDESC7* desc, void*) {
    if (IsEqualGUID(desc->deviceGUID, IID_IDirect3DHALDevice)) has_hardware = true;
    if (IsEqualGUID(desc->deviceGUID, IID_IDirect3DTnLHalDevice)) has_hardware_tnl = true;
    return D3DENUMRET_OK;
}
static void find_device() {
    TRY(DirectDrawCreateEx(nullptr, reinterpret_cast<void**>(&direct_draw), IID_IDirectDraw7, nullptr));
    TRY(direct_draw->SetCooperativeLevel(nullptr, DDSCL_NORMAL | DDSCL_FPUPRESERVE));
    TRY(direct_draw->QueryInterface(IID_IDirect3D7, reinterpret_cast<void**>(&direct_3d)));
    TRY(direct_3d->EnumDevices(note_device, nullptr));
    const bool is_hal = has_hardware || has_hardware_tnl;
    device_kind = has_hardware_tnl ? IID_IDirect3DTnLHalDevice : is_hal ? IID_IDirect3DHALDevice : IID_IDirect3DRGBDevice;
    memory      = is_hal ? DDSCAPS_VIDEOMEMORY : DDSCAPS_SYSTEMMEMORY;
}
)";

constexpr std::string_view kSurfaces =
    R"(static Surface* create_surface(const DDPIXELFORMAT& format, DWORD width, DWORD height, DWORD caps, DWORD caps2 = 0,
                               DWORD levels = 1) {
    DDSURFACEDESC2 desc    = {};
    desc.dwSize            = sizeof desc;
    desc.dwFlags           = DDSD_CAPS | DDSD_WIDTH | DDSD_HEIGHT | DDSD_PIXELFORMAT;
    desc.dwWidth           = width;
    desc.dwHeight          = height;
    desc.ddpfPixelFormat   = format;
    desc.ddsCaps.dwCaps    = caps;
    desc.ddsCaps.dwCaps2   = caps2;
    if (levels > 1) {
        desc.dwFlags |= DDSD_MIPMAPCOUNT;
        desc.ddsCaps.dwCaps |= DDSCAPS_COMPLEX | DDSCAPS_MIPMAP;
        desc.dwMipMapCount = levels;
    }
    Surface* surface = nullptr;
    TRY(direct_draw->CreateSurface(&desc, &surface, nullptr));
    return surface;
}

// Only what is read as a texture has to be of a texture's size.
static Surface* create_target(const TargetInfo& info) {
    if (!info.is_used) return nullptr;
    if (info.format == D16 || info.format == D24)
        return create_surface(depth_format(info.format == D16 ? 16 : 24), info.width, info.height,
                              DDSCAPS_ZBUFFER | memory);
    return create_surface(pixel_format(info.format), info.width, info.height,
                          DDSCAPS_3DDEVICE | memory | (info.is_texture ? DDSCAPS_TEXTURE : DDSCAPS_OFFSCREENPLAIN));
}

static uint32_t expanded(Format format, uint8_t texel) {
    return format == A8 ? static_cast<uint32_t>(texel) << 24 : 0xff000000u | texel * 0x010101u;
}

static void fill_level(Surface* surface, Format format, bool expands, DWORD width, DWORD height, const uint8_t* from) {
    DDSURFACEDESC2 desc = {};
    desc.dwSize         = sizeof desc;
    TRY(surface->Lock(nullptr, &desc, DDLOCK_WAIT | DDLOCK_WRITEONLY, nullptr));
    const size_t row_bytes = format == A8R8G8B8 ? 4 * width : width;
    for (DWORD y = 0; y < height; ++y, from += row_bytes) {
        uint8_t* row = static_cast<uint8_t*>(desc.lpSurface) + y * desc.lPitch;
        if (!expands) std::memcpy(row, from, row_bytes);
        for (DWORD x = 0; expands && x < width; ++x) {
            const uint32_t color = expanded(format, from[x]);
            std::memcpy(row + 4 * x, &color, 4);
        }
    }
    TRY(surface->Unlock(nullptr));
}

// Managed by Direct3D, which takes it from system to video memory when it is used; software reads system memory.
static Surface* create_texture(const TextureInfo& info, const uint8_t* texels) {
    const bool expands  = (info.format == A8 && !has_a8) || (info.format == L8 && !has_l8);
    const bool managed  = memory == DDSCAPS_VIDEOMEMORY;
    Surface* const base = create_surface(pixel_format(expands ? A8R8G8B8 : info.format), info.width, info.height,
                                         DDSCAPS_TEXTURE | (managed ? 0 : memory), managed ? DDSCAPS2_TEXTUREMANAGE : 0,
                                         info.levels);
    Surface* surface = base;
    for (DWORD level = 0; level < info.levels; ++level) {
        const DWORD width = info.width >> level ? info.width >> level : 1;
        const DWORD height = info.height >> level ? info.height >> level : 1;
        fill_level(surface, info.format, expands, width, height, texels);
        texels += static_cast<size_t>(width) * height * (info.format == A8R8G8B8 ? 4 : 1);
        if (level + 1 == info.levels) break;
        DDSCAPS2 next = {};
        next.dwCaps   = DDSCAPS_TEXTURE | DDSCAPS_MIPMAP;
        Surface* smaller = nullptr;
        TRY(surface->GetAttachedSurface(&next, &smaller));
        if (surface != base) surface->Release();
        surface = smaller;
    }
    if (surface != base) surface->Release();
    return base;
}

// A card that transforms reads its own memory, software the system's.
static IDirect3DVertexBuffer7* create_mesh(const MeshInfo& info) {
    D3DVERTEXBUFFERDESC desc = {};
    desc.dwSize              = sizeof desc;
    desc.dwCaps              = has_hardware_tnl ? D3DVBCAPS_WRITEONLY : D3DVBCAPS_SYSTEMMEMORY;
    desc.dwFVF               = info.is_window ? window_vertex_format : vertex_format;
    desc.dwNumVertices       = info.vertex_count;
    IDirect3DVertexBuffer7* buffer = nullptr;
    TRY(direct_3d->CreateVertexBuffer(&desc, &buffer, 0));
    void* vertices = nullptr;
    TRY(buffer->Lock(DDLOCK_WAIT | DDLOCK_WRITEONLY, &vertices, nullptr));
    std::memcpy(vertices, data.data() + info.vertices,
                info.vertex_count * (info.is_window ? sizeof(WindowVertex) : sizeof(Vertex)));
    TRY(buffer->Unlock());
    return buffer;
}

static void fill_with_zeros(Surface* surface, const TargetInfo& info) {
    DDBLTFX fx = {};
    fx.dwSize  = sizeof fx;
    const bool is_depth = info.format == D16 || info.format == D24;
    TRY(surface->Blt(nullptr, nullptr, nullptr, (is_depth ? DDBLT_DEPTHFILL : DDBLT_COLORFILL) | DDBLT_WAIT, &fx));
}

static void create_all() {
    for (const TargetInfo& info : target_infos) targets.push_back(create_target(info));
    TRY(direct_3d->CreateDevice(device_kind, targets[output_target], &device));
    TRY(device->EnumTextureFormats(note_texture_format, nullptr));
    for (const TextureInfo& info : texture_infos) textures.push_back(create_texture(info, data.data() + info.texels));
    const uint8_t white_texel[] = {255, 255, 255, 255};
    white                       = create_texture({A8R8G8B8, 1, 1, 1, 0}, white_texel);
    for (const MeshInfo& info : mesh_infos) meshes.push_back(create_mesh(info));
    for (size_t i = 0; i < targets.size(); ++i)
        if (targets[i] && target_infos[i].is_zeroed) fill_with_zeros(targets[i], target_infos[i]);
}
)";

}  // namespace pipeline::dx7
