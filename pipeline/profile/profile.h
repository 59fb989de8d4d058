// SPDX-License-Identifier: MIT
// A chip as a table: how it computes and which formats and functions it has, each with its source and how sure that
// is. A profile changes no picture by itself: what it says becomes data in a frame (Frame::arithmetic, formats,
// states), and `execute` knows no chip.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "pipeline/frame/frame.h"

namespace pipeline {

// What a fact rests on, the surest first.
enum class Grade : std::uint8_t {
    Measured,   // on the real chip, by who reports it
    Fitted,     // a formula fitted to captures of the real chip
    Emulators,  // emulators agree; no measurement is known
    Document,   // of the maker or of its time
    Chosen,     // sources disagree or are silent: see `open`
};
template <>
struct EnumNames<Grade> {
    static constexpr std::array<std::string_view, 5> names{"measured", "fitted", "emulators", "document", "chosen"};
};

// topic: a field of Arithmetic, or "store", "dither", "alpha_test", "dest_alpha_test", "depth", "copy", "targets"
// (formats and what may stand together), "states" (blend factors, masks, scissor, culling), "stages" (texture stages
// and addressing), "flat" (shading), "lod" (level of detail), and of chips alone "limits" (sizes, texture formats) and
// "memory" (how much, and how it is laid out). open: what is not known, or where sources disagree and
// what the switch is; empty if nothing is.
struct Evidence {
    std::string_view topic;
    std::string_view source;
    Grade grade = Grade::Chosen;
    std::string_view open;
};

// Formats. What is drawn to, and what copies write, can differ.
struct ChipFormats {
    std::vector<TargetFormat> draw, copy_targets, depth;
    // Of `draw`: one with whole bytes of red, green and blue; the one that keeps the most of alpha; and what stands for
    // X8R8G8B8, colours without alpha.
    TargetFormat with_bytes = TargetFormat::A8R8G8B8, with_alpha = TargetFormat::A8R8G8B8,
                 opaque = TargetFormat::X8R8G8B8;
    bool pairs_depth    = false;  // D16 stands beside 16 bit colours alone, the others beside the others
    bool reads_targets  = true;   // what was drawn to can be a texture as it is, without a copy
    bool copies         = true;   // pixels as they are
    bool copies_convert = true;   // and to another format
    bool copies_halve   = true;
};

// Which channels a mask tells apart.
enum class MaskKind : std::uint8_t { None, ColorAndAlpha, Channels };
template <>
struct EnumNames<MaskKind> {
    static constexpr std::array<std::string_view, 3> names{"none", "colour and alpha", "each channel"};
};
// The vertex that gives a flat triangle its colour; None: there is no flat shading.
enum class FlatVertex : std::uint8_t { None, First, Last };
template <>
struct EnumNames<FlatVertex> {
    static constexpr std::array<std::string_view, 3> names{"none", "first", "last"};
};

template <NamedEnum Enum>
std::vector<Enum> all_of() {
    std::vector<Enum> values;
    for (std::size_t i = 0; i < EnumNames<Enum>::names.size(); ++i) values.push_back(static_cast<Enum>(i));
    return values;
}

// The states of a pass that the chip has; by default all but dithers.
struct ChipStates {
    std::vector<CompareFunc> depth_funcs    = all_of<CompareFunc>();
    std::vector<BlendFactor> source_factors = all_of<BlendFactor>();  // by ONE and ZERO alone, blending is off
    std::vector<BlendFactor> dest_factors   = all_of<BlendFactor>();
    std::vector<DitherMode> dithers         = {DitherMode::None};
    MaskKind color_mask                     = MaskKind::Channels;
    bool dest_alpha_test                    = true;
    std::vector<AlphaFail> alpha_fails      = all_of<AlphaFail>();
    bool scissor                            = true;
    bool transforms                         = true;  // and lights: triangles need not be in window space
    bool culling                            = true;
    FlatVertex flat                         = FlatVertex::First;
    bool specular_addition                  = true;
    int stages                              = kTextureStages;
    std::vector<ArgSource> arguments        = all_of<ArgSource>();
    bool complement                         = true;
    bool alpha_replicate                    = true;
    std::vector<TextureAddress> addresses   = all_of<TextureAddress>();
    std::vector<MipFilter> mip_filters      = all_of<MipFilter>();
};

// How memory is laid out: rows of surfaces one after the other; the Graphics Synthesizer's pages and blocks; the
// GameCube's tiles in main memory, beside the frame buffer in the chip. See pipeline/check/memory_map.h.
enum class MemoryLayout : std::uint8_t { Surfaces, GsPages, FlipperTiles };
template <>
struct EnumNames<MemoryLayout> {
    static constexpr std::array<std::string_view, 3> names{"surfaces", "pages", "tiles"};
};

// Sizes in pixels or texels, memory in bytes. 0 is no limit, or none that is known.
struct ChipLimits {
    std::vector<TextureFormat> texture_formats = all_of<TextureFormat>();
    std::int32_t texture_width = 0, texture_height = 0;  // largest texture, and largest target that is read as one
    std::int32_t target_width = 0, target_height = 0;    // largest target that is drawn to
    // The one memory that is drawn to, if there is such: depth lies at the same places, and copies read nothing else.
    std::int32_t frame_buffer_width = 0, frame_buffer_height = 0;
    // What copies read has corners at multiples of `copy_from_step`, and they write tiles of copy_tile x copy_tile.
    std::int32_t copy_from_step = 1, copy_tile = 1;
    std::uint64_t memory          = 0;
    MemoryLayout layout           = MemoryLayout::Surfaces;
    // Of Surfaces: rows and starts at multiples of these, but no padding in rows of a swizzled texture, whose sizes are
    // powers of two.
    std::uint32_t pitch_alignment = 1, address_alignment = 1;
    bool swizzles_textures = false;
};

struct Profile {
    std::string_view name;  // as on the command line
    std::string_view chip;
    Arithmetic arithmetic;
    ChipFormats formats;
    ChipStates states;
    ChipLimits limits;
    std::vector<Evidence> evidence;  // an entry for each topic that the chip has
};

// Can a pass have both?
bool go_together(const ChipFormats& formats, TargetFormat color, TargetFormat depth);

// ideal, dx7, ps2, gamecube, xbox.
std::span<const Profile> profiles();
const Profile* find_profile(std::string_view name);  // null if there is none

// What the table says of a topic; null if it has nothing.
const Evidence* find_evidence(const Profile& profile, std::string_view topic);

// The formula of a rule in words that a reader can program from.
std::string_view formula(SnapRule rule);
std::string_view formula(VertexDepth rule);
std::string_view formula(GouraudRule rule);
std::string_view formula(FilterRule rule);
std::string_view formula(CombineRule rule);
std::string_view formula(FogRule rule);
std::string_view formula(BlendRule rule);
std::string_view formula(BlendSource rule);
std::string_view formula(DitherMode mode);
std::string_view formula(TargetFormat format);

}  // namespace pipeline
