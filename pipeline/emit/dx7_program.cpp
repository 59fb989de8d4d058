// SPDX-License-Identifier: MIT
#include "pipeline/emit/dx7_program.h"

namespace pipeline::dx7 {

constexpr std::string_view kHead = R"(#define DIRECTDRAW_VERSION 0x0700
#define DIRECT3D_VERSION 0x0700
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
#include <ddraw.h>
#include <d3d.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

using Surface = IDirectDrawSurface7;

static void check(HRESULT result, const char* call) {
    if (SUCCEEDED(result)) return;
    std::fprintf(stderr, "%.*s: HRESULT 0x%08lx\n", static_cast<int>(std::strcspn(call, "(")), call,
                 static_cast<unsigned long>(result));
    std::exit(1);
}
#define TRY(call) check((call), #call)

static void stop(const std::string& what) {
    std::fprintf(stderr, "%s\n", what.c_str());
    std::exit(1);
}

enum Format { A8R8G8B8, X8R8G8B8, R5G6B5, A1R5G5B5, A8, L8, D16, D24 };

struct TargetInfo {
    const char* name;
    Format format;
    DWORD width, height;
    bool is_used, is_texture, is_zeroed;
};
struct TextureInfo {
    Format format;
    DWORD width, height, levels;
    size_t texels;  // byte in the side file
};
struct MeshInfo {
    bool is_window;
    size_t vertices;  // byte in the side file
    DWORD vertex_count;
    size_t indices;  // byte in the side file
    DWORD index_count;
};

// As in the side file.
struct Vertex {
    D3DVALUE x, y, z, nx, ny, nz;
    D3DCOLOR diffuse, specular;
    D3DVALUE u0, v0, u1, v1;
};
struct WindowVertex {
    D3DVALUE x, y, z, rhw;
    D3DCOLOR diffuse, specular;
    D3DVALUE u0, v0, u1, v1;
};
static const DWORD vertex_format        = D3DFVF_XYZ | D3DFVF_NORMAL | D3DFVF_DIFFUSE | D3DFVF_SPECULAR | D3DFVF_TEX2;
static const DWORD window_vertex_format = D3DFVF_XYZRHW | D3DFVF_DIFFUSE | D3DFVF_SPECULAR | D3DFVF_TEX2;
)";

constexpr std::string_view kPasses =
    R"(// A z-buffer is attached to one surface at a time, and taken up by SetRenderTarget.
static std::vector<std::pair<Surface*, Surface*>> attached;  // colour, depth
static void attach(Surface* color, Surface* depth) {
    for (size_t i = 0; i < attached.size(); ++i) {
        const auto pair = attached[i];
        if (pair.first == color && pair.second == depth) return;
        if (pair.first != color && pair.second != depth) continue;
        TRY(pair.first->DeleteAttachedSurface(0, pair.second));
        attached.erase(attached.begin() + i--);
    }
    TRY(color->AddAttachedSurface(depth));
    attached.emplace_back(color, depth);
}

static void begin_pass(Surface* color, Surface* depth, DWORD x, DWORD y, DWORD width, DWORD height) {
    for (DWORD stage = 0; stage < 2; ++stage) TRY(device->SetTexture(stage, nullptr));
    if (depth) attach(color, depth);
    TRY(device->SetRenderTarget(color, 0));
    D3DVIEWPORT7 viewport = {x, y, width, height, 0.0f, 1.0f};
    TRY(device->SetViewport(&viewport));
    for (DWORD light = 0; light < 8; ++light) TRY(device->LightEnable(light, FALSE));
    reset_states();
}

inline void set_transform(D3DTRANSFORMSTATETYPE which, D3DMATRIX matrix) {
    TRY(device->SetTransform(which, &matrix));
}

inline D3DCOLORVALUE color(float r, float g, float b, float a) {
    D3DCOLORVALUE value;
    value.r = r, value.g = g, value.b = b, value.a = a;
    return value;
}
inline D3DVECTOR vector(float x, float y, float z) {
    D3DVECTOR value;
    value.x = x, value.y = y, value.z = z;
    return value;
}

inline void draw_mesh(size_t mesh) {
    const MeshInfo& info = mesh_infos[mesh];
    TRY(device->DrawIndexedPrimitiveVB(D3DPT_TRIANGLELIST, meshes[mesh], 0, info.vertex_count,
                                       reinterpret_cast<WORD*>(data.data() + info.indices), info.index_count, 0));
}

struct UvRect {
    D3DVALUE u0, v0, u1, v1;
};
// Corners in pixels of the target. Specular alpha one: no fog.
inline void draw_rectangle(D3DVALUE x0, D3DVALUE y0, D3DVALUE x1, D3DVALUE y1, D3DVALUE z, D3DCOLOR diffuse,
                           UvRect first, UvRect second) {
    const D3DCOLOR specular  = 0xff000000;
    WindowVertex corners[4] = {{x0, y0, z, 1.0f, diffuse, specular, first.u0, first.v0, second.u0, second.v0},
                               {x1, y0, z, 1.0f, diffuse, specular, first.u1, first.v0, second.u1, second.v0},
                               {x1, y1, z, 1.0f, diffuse, specular, first.u1, first.v1, second.u1, second.v1},
                               {x0, y1, z, 1.0f, diffuse, specular, first.u0, first.v1, second.u0, second.v1}};
    TRY(device->DrawPrimitive(D3DPT_TRIANGLEFAN, window_vertex_format, corners, 4, 0));
}

inline void copy(Surface* to, LONG x, LONG y, Surface* from, RECT part) {
    RECT there = {x, y, x + part.right - part.left, y + part.bottom - part.top};
    TRY(to->Blt(&there, from, &part, DDBLT_WAIT, nullptr));
}
)";

constexpr std::string_view kMain = R"(// 0xAARRGGBB. Fewer bits than 8 are repeated; without alpha it is one.
static uint32_t argb(Format format, const uint8_t* pixel) {
    uint32_t color = 0;
    std::memcpy(&color, pixel, format == R5G6B5 || format == A1R5G5B5 ? 2 : 4);
    const auto widened = [&](int shift, int bits) {
        const uint32_t value = color >> shift & ((1u << bits) - 1);
        return value << (8 - bits) | value >> (2 * bits - 8);
    };
    switch (format) {
        case A8R8G8B8: return color;
        case R5G6B5:   return 0xff000000u | widened(11, 5) << 16 | widened(5, 6) << 8 | widened(0, 5);
        case A1R5G5B5:
            return (color & 0x8000 ? 0xff000000u : 0u) | widened(10, 5) << 16 | widened(5, 5) << 8 | widened(0, 5);
        default:       return 0xff000000u | color;
    }
}

// A BMP of 32 bits: B, G, R, A, rows from the bottom.
static void save(Surface* surface, const TargetInfo& info, const std::string& path) {
    std::vector<uint8_t> file(54 + static_cast<size_t>(4) * info.width * info.height);
    const auto put = [&](size_t at, uint32_t value) { std::memcpy(&file[at], &value, 4); };
    file[0] = 'B', file[1] = 'M';
    put(2, static_cast<uint32_t>(file.size())), put(10, 54), put(14, 40), put(18, info.width), put(22, info.height);
    file[26] = 1, file[28] = 32;
    DDSURFACEDESC2 desc = {};
    desc.dwSize         = sizeof desc;
    TRY(surface->Lock(nullptr, &desc, DDLOCK_WAIT | DDLOCK_READONLY, nullptr));
    const size_t pixel_bytes = info.format == R5G6B5 || info.format == A1R5G5B5 ? 2 : 4;
    for (DWORD y = 0; y < info.height; ++y)
        for (DWORD x = 0; x < info.width; ++x) {
            const uint8_t* row = static_cast<const uint8_t*>(desc.lpSurface) + y * desc.lPitch;
            put(54 + static_cast<size_t>(4) * ((info.height - 1 - y) * info.width + x),
                argb(info.format, row + pixel_bytes * x));
        }
    TRY(surface->Unlock(nullptr));
    FILE* out = std::fopen(path.c_str(), "wb");
    const bool is_written = out && std::fwrite(file.data(), 1, file.size(), out) == file.size();
    if (!out || std::fclose(out) != 0 || !is_written) stop(path + ": cannot be written");
}

int main(int count, char** arguments) {
    read_data();
    find_device();
    create_all();
    for (size_t i = 0; i < passes.size(); ++i) {
        passes[i].draw();
        if (count > 2 && passes[i].color >= 0)
            save(targets[passes[i].color], target_infos[passes[i].color], arguments[2] + std::to_string(i) + ".bmp");
    }
    save(targets[output_target], target_infos[output_target], count > 1 ? arguments[1] : "frame.bmp");
}
)";

}  // namespace pipeline::dx7
