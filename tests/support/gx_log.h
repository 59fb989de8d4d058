// SPDX-License-Identifier: MIT
// What a GX program does, read from the log that tests/support/gx_stub.h writes: registers are kept as the calls set them, and
// each primitive, each copy is handed out with all of them. Written from libogc's headers alone; numbers are libogc's values.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace test_support {

struct GxTevStageRead {
    std::array<int, 3> order{};                 // coordinate, map, colour channel
    std::array<int, 4> color_in{}, alpha_in{};  // a, b, c, d
    std::array<int, 5> color_op{}, alpha_op{};  // op, bias, scale, clamp, register
};

struct GxTextureRead {
    long long address = 0;
    int width = 0, height = 0, format = 0, wrap_s = 0, wrap_t = 0, mipmap = 0, min_filter = 0, mag_filter = 0,
        min_lod = 0, max_lod = 0;
};

struct GxLightRead {
    std::array<double, 3> position{}, color{}, a{}, k{};
};

struct GxRegisters {
    int pixel_format = -1, color_update = -1, alpha_update = -1, dither = -1, z_before_texture = -1, cull = -1,
        channels = -1, texgens = -1, tev_stages = -1, indirect_stages = -1, dst_alpha = -1;
    std::array<int, 4> blend{}, scissor{};
    std::array<int, 3> z{};
    std::array<int, 5> alpha_compare{};
    std::array<double, 6> viewport{};
    std::array<double, 16> projection{};
    int projection_type = -1;
    std::map<int, std::array<double, 12>> matrices;  // by number; 1000: normals
    std::map<int, std::array<int, 6>> channel;       // enable, ambient, material, lights, diffuse, attenuation
    std::map<int, std::array<int, 4>> ambient, material, tev_color;
    std::map<int, GxLightRead> lights;  // by bit
    std::map<int, std::array<int, 3>> texgen;
    std::map<int, GxTextureRead> textures;
    std::array<GxTevStageRead, 16> tev{};
    std::array<double, 8> fog{};  // type, start, end, near, far, red, green, blue
};

struct GxVertexRead {
    std::array<double, 3> position{}, normal{};
    std::array<int, 4> color0{}, color1{};
    std::array<std::array<double, 2>, 2> tex{};
};

struct GxEvent {
    enum class Kind { Primitive, Copy, Display } kind = Kind::Primitive;
    GxRegisters registers;
    int primitive = 0;
    std::vector<GxVertexRead> vertices;
    std::array<int, 4> copy_from{}, copy_to{};  // left, top, width, height; width, height, format, halve
    long long address = 0;
    bool is_synced    = false;  // before it, and after the copy before it: GX_PixModeSync and GX_InvalidateTexAll
};

// Compiles the program with the host's C compiler, warnings being errors, runs it and reads what it does. Throws
// std::runtime_error with the compiler's words.
std::vector<GxEvent> run_gx(const std::string& text, const std::vector<std::uint8_t>& data);

}  // namespace test_support
