// SPDX-License-Identifier: MIT
// A frame is plain data: everything that determines a picture, and nothing else. A technique writes it; validate,
// execute and the text form read it. Two frames that compare equal give equal bytes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "pipeline/frame/arithmetic.h"
#include "pipeline/frame/pipeline_state.h"

namespace pipeline {

// An index into the frame's vector of `Of`; -1 refers to nothing.
template <class Of>
struct Id {
    std::int32_t index = -1;
    constexpr explicit operator bool() const { return index >= 0; }
    bool operator==(const Id&) const = default;
};
using TargetId  = Id<struct Target>;
using TextureId = Id<struct Texture>;
using CameraId  = Id<struct Camera>;

// Colour formats keep the top bits of each byte that is written (5, 6 or 1 of them), and give back a byte:
//   R5G6B5, A1R5G5B5, R6G6B6A6   by repeating the bits that they kept: 6 bits v as v << 2 | v >> 4; one bit as 0 or 255
//   PSMCT16                      with zeros below the 5 bits that it kept; one bit of alpha as 0 or 0x80
// Formats without alpha give back 255, but PSMCT24 0x80, which is one. R6G6B6A6 is the GameCube's RGBA6_Z24 (its RGB8_Z24 is
// X8R8G8B8), PSMCT* are the PlayStation 2's.
// D16, D24, D32: unsigned integers of that many bits; depth 1.0 is all ones.
enum class TargetFormat : std::uint8_t {
    A8R8G8B8,
    X8R8G8B8,
    R5G6B5,
    A1R5G5B5,
    R6G6B6A6,
    Psmct32,
    Psmct24,
    Psmct16,
    D16,
    D24,
    D32,
};
template <>
struct EnumNames<TargetFormat> {
    static constexpr std::array<std::string_view, 11> names{
        "A8R8G8B8", "X8R8G8B8", "R5G6B5", "A1R5G5B5", "R6G6B6A6", "PSMCT32", "PSMCT24", "PSMCT16", "D16", "D24", "D32"};
};
constexpr bool is_depth(TargetFormat format) {
    return format >= TargetFormat::D16;
}
// Does a colour format keep 8 bits of red, green and blue?
constexpr bool keeps_bytes(TargetFormat format) {
    return format == TargetFormat::A8R8G8B8 || format == TargetFormat::X8R8G8B8 || format == TargetFormat::Psmct32 ||
           format == TargetFormat::Psmct24;
}
constexpr int bytes_per_pixel(TargetFormat format) {
    switch (format) {
        case TargetFormat::R5G6B5:
        case TargetFormat::A1R5G5B5:
        case TargetFormat::Psmct16:
        case TargetFormat::D16:
            return 2;
        case TargetFormat::R6G6B6A6:
            return 3;
        default:
            return 4;
    }
}

// Memory that passes draw to; a colour target can also be read as a texture by later passes. Starts as if zeros had been written.
struct Target {
    std::string name;
    TargetFormat format                  = TargetFormat::A8R8G8B8;
    std::int32_t width                   = 0;
    std::int32_t height                  = 0;
    bool operator==(const Target&) const = default;
};
template <SameStruct<Target> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [name, format, width, height] = state;
    visit("name", name);
    visit("format", format);
    visit("width", width);
    visit("height", height);
}
inline constexpr std::int32_t kMaxTargetSize = 8192;

// A8 reads as (0, 0, 0, a); L8 as (l, l, l, 1). Texels are bytes, rows from the top; A8R8G8B8 is stored B, G, R, A.
enum class TextureFormat : std::uint8_t { A8, L8, A8R8G8B8 };
template <>
struct EnumNames<TextureFormat> {
    static constexpr std::array<std::string_view, 3> names{"A8", "L8", "A8R8G8B8"};
};
constexpr int bytes_per_texel(TextureFormat format) {
    return format == TextureFormat::A8R8G8B8 ? 4 : 1;
}

inline constexpr std::int32_t kMaxTextureSize = 8192;

// `texels` holds `levels` mip levels one after the other, each max(1, size >> level) wide and high. More than one level
// requires powers of two.
struct Texture {
    std::string name;
    TextureFormat format = TextureFormat::A8R8G8B8;
    std::int32_t width   = 0;
    std::int32_t height  = 0;
    std::int32_t levels  = 1;
    std::vector<std::uint8_t> texels;
    bool operator==(const Texture&) const = default;
};
template <SameStruct<Texture> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [name, format, width, height, levels, texels] = state;
    visit("name", name);
    visit("format", format);
    visit("width", width);
    visit("height", height);
    visit("levels", levels);
    visit("texels", texels);
}

struct Camera {
    std::string name;
    Mat4 view                            = Mat4(1.0f);
    Mat4 projection                      = Mat4(1.0f);
    bool operator==(const Camera&) const = default;
};
template <SameStruct<Camera> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [name, view, projection] = state;
    visit("name", name);
    visit("view", view);
    visit("projection", projection);
}

// Object space. Shared by draws through indices. diffuse and specular are COLOR1 and COLOR2 of the lighting state.
struct Vertex {
    Vec3 position = Vec3(0.0f);
    Vec3 normal   = Vec3(0.0f);
    Argb diffuse;
    Argb specular                        = {0};
    Vec2 uv0                             = Vec2(0.0f);
    Vec2 uv1                             = Vec2(0.0f);
    bool operator==(const Vertex&) const = default;
};
template <SameStruct<Vertex> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [position, normal, diffuse, specular, uv0, uv1] = state;
    visit("position", position);
    visit("normal", normal);
    visit("diffuse", diffuse);
    visit("specular", specular);
    visit("uv0", uv0);
    visit("uv1", uv1);
}

// Window space, already lit, as Direct3D 7's D3DTLVERTEX. x, y: pixels, within +-kMaxWindowCoordinate; z: depth, 0..1; rhw: 1/w,
// greater than 0. The alpha of specular is the fog factor, 255 for no fog. uv is (s, t, q): the texture is read at (s/q, t/q), and
// each times rhw stays below 2^40.
struct WindowVertex {
    float x = 0.0f, y = 0.0f, z = 0.0f, rhw = 1.0f;
    Argb diffuse;
    Argb specular                              = {0xff000000};
    Vec3 uv0                                   = Vec3(0.0f, 0.0f, 1.0f);
    Vec3 uv1                                   = Vec3(0.0f, 0.0f, 1.0f);
    bool operator==(const WindowVertex&) const = default;
};
template <SameStruct<WindowVertex> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [x, y, z, rhw, diffuse, specular, uv0, uv1] = state;
    visit("x", x);
    visit("y", y);
    visit("z", z);
    visit("rhw", rhw);
    visit("diffuse", diffuse);
    visit("specular", specular);
    visit("uv0", uv0);
    visit("uv1", uv1);
}
inline constexpr std::int32_t kMaxWindowCoordinate = 16384;

// What a draw binds to a stage: nothing, a texture, or a colour target other than the one drawn to. As in Direct3D 7 a
// stage that reads TEXTURE with nothing bound gets white.
struct TextureBinding {
    TextureId texture;
    TargetId target;
    bool operator==(const TextureBinding&) const = default;
};
template <SameStruct<TextureBinding> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [texture, target] = state;
    visit("texture", texture);
    visit("target", target);
}
using TextureBindings = std::array<TextureBinding, kTextureStages>;

// Triangles of `index_count` indices from `first_index` on, three each, through transform, lighting and clipping.
struct DrawTriangles {
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0;
    Mat4 world                = Mat4(1.0f);
    TextureBindings textures;
    bool operator==(const DrawTriangles&) const = default;
};
template <SameStruct<DrawTriangles> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [first_index, index_count, world, textures] = state;
    visit("first_index", first_index);
    visit("index_count", index_count);
    visit("world", world);
    visit("textures", textures);
}

// Triangles whose indices name window vertices: not transformed, lit, clipped or given coordinates; the pass's viewport limits
// them as its scissor does. They are culled, and fogged by their vertices' factors where the pass has fog.
struct DrawWindowTriangles {
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0;
    TextureBindings textures;
    bool operator==(const DrawWindowTriangles&) const = default;
};
template <SameStruct<DrawWindowTriangles> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [first_index, index_count, textures] = state;
    visit("first_index", first_index);
    visit("index_count", index_count);
    visit("textures", textures);
}

// Texture coordinates (u, v) at the top left and bottom right corner; 0..1 spans the texture.
struct UvRect {
    float u0 = 0.0f, v0 = 0.0f, u1 = 1.0f, v1 = 1.0f;
    bool operator==(const UvRect&) const = default;
};
template <SameStruct<UvRect> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [u0, v0, u1, v1] = state;
    visit("u0", u0);
    visit("v0", v0);
    visit("u1", u1);
    visit("v1", v1);
}

inline constexpr std::int32_t kMaxRectangleCoordinate = 16384;
inline constexpr std::int32_t kMaxRectangleTexel      = 16384;

// An axis-aligned rectangle in window space, in pixels of the target: a blit. Not transformed, lit, fogged or culled.
// x0 <= x1, y0 <= y1; depth in 0..1. Corners stay within +-kMaxRectangleCoordinate pixels, and uv times the texture's
// size within +-kMaxRectangleTexel texels.
struct DrawRectangle {
    float x0 = 0.0f, y0 = 0.0f, x1 = 0.0f, y1 = 0.0f;
    float depth = 0.0f;
    Argb color;
    std::array<UvRect, kTextureStages> uv;
    TextureBindings textures;
    bool operator==(const DrawRectangle&) const = default;
};
template <SameStruct<DrawRectangle> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [x0, y0, x1, y1, depth, color, uv, textures] = state;
    visit("x0", x0);
    visit("y0", y0);
    visit("x1", x1);
    visit("y1", y1);
    visit("depth", depth);
    visit("color", color);
    visit("uv", uv);
    visit("textures", textures);
}

// What a copy moves: whole pixels; the alpha of each to red, green and blue; or its green to alpha. The other channels stay.
enum class CopyChannels : std::uint8_t { All, AlphaToColor, GreenToAlpha };
template <>
struct EnumNames<CopyChannels> {
    static constexpr std::array<std::string_view, 3> names{"ALL", "ALPHA_TO_COLOR", "GREEN_TO_ALPHA"};
};

// Copies pixels of another colour target to the pass's, `from` whole and with its top left corner to (x, y): a copy engine, to
// which no state applies. A pass that copies does nothing else but clear, which viewport and scissor limit. halve: each 2x2 pixels become one, channel by
// channel, S >> 2 with S the sum of the four; from R6G6B6A6, with S the sum of the four 6-bit values, S + (S >> 6), a
// whole byte. Only targets of 8 or 6 bits can be halved, from even corners, and not from one channel to another.
struct CopyRectangle {
    TargetId source;
    PixelRect from;
    std::int32_t x = 0, y = 0;
    bool halve                                  = false;
    CopyChannels channels                       = CopyChannels::All;
    bool operator==(const CopyRectangle&) const = default;
};
template <SameStruct<CopyRectangle> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [source, from, x, y, halve, channels] = state;
    visit("source", source);
    visit("from", from);
    visit("x", x);
    visit("y", y);
    visit("halve", halve);
    visit("channels", channels);
}

using Draw = std::variant<DrawTriangles, DrawRectangle, CopyRectangle, DrawWindowTriangles>;

// What a draw binds; null if it copies.
inline const TextureBindings* bindings_of(const Draw& draw) {
    if (const auto* triangles = std::get_if<DrawTriangles>(&draw)) return &triangles->textures;
    if (const auto* rectangle = std::get_if<DrawRectangle>(&draw)) return &rectangle->textures;
    if (const auto* triangles = std::get_if<DrawWindowTriangles>(&draw)) return &triangles->textures;
    return nullptr;
}
inline TextureBindings* bindings_of(Draw& draw) {
    return const_cast<TextureBindings*>(bindings_of(std::as_const(draw)));
}
inline TextureBindings textures_of(const Draw& draw) {
    const TextureBindings* bindings = bindings_of(draw);
    return bindings != nullptr ? *bindings : TextureBindings{};
}

// Sets what lies within viewport and scissor before the draws; as in Direct3D 7 no other state applies.
struct Clear {
    std::optional<Argb> color;
    std::optional<float> depth;  // 0..1
    bool operator==(const Clear&) const = default;
};
template <SameStruct<Clear> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [color, depth] = state;
    visit("color", color);
    visit("depth", depth);
}

// color or depth may refer to nothing, not both; where both are there, they have the same size.
struct Pass {
    std::string label;
    TargetId color;
    TargetId depth;
    CameraId camera;
    Clear clear;
    PipelineState state;
    std::vector<Draw> draws;
    bool operator==(const Pass&) const = default;
};
template <SameStruct<Pass> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [label, color, depth, camera, clear, pipeline_state, draws] = state;
    visit("label", label);
    visit("color", color);
    visit("depth", depth);
    visit("camera", camera);
    visit("clear", clear);
    visit("state", pipeline_state);
    visit("draws", draws);
}

struct Frame {
    TargetId output;  // the colour target that is the picture
    Arithmetic arithmetic;
    std::vector<Target> targets;
    std::vector<Camera> cameras;
    std::vector<Pass> passes;
    std::vector<Texture> textures;
    std::vector<Vertex> vertices;
    std::vector<WindowVertex> window_vertices;
    std::vector<std::uint32_t> indices;  // of either, as the draw that uses them says
    bool operator==(const Frame&) const = default;
};
template <SameStruct<Frame> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [output, arithmetic, targets, cameras, passes, textures, vertices, window_vertices, indices] = state;
    visit("output", output);
    visit("arithmetic", arithmetic);
    visit("targets", targets);
    visit("cameras", cameras);
    visit("passes", passes);
    visit("textures", textures);
    visit("vertices", vertices);
    visit("window_vertices", window_vertices);
    visit("indices", indices);
}

}  // namespace pipeline
