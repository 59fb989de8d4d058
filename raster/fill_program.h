// SPDX-License-Identifier: MIT
// All that the fill loop branches on. The loop is written once, over a FillProgram; compiled with a constant one it is a
// kernel for that state, compiled with a variable it draws every state. Numbers (colours, references, sizes) are not part
// of it: they are in the FillPlan. What a program does not use is left at its default, so that equal programs are equal.
#pragma once

#include <array>
#include <cstdint>

#include "raster/fill_state.h"

namespace raster {

struct TextureProgram {
    bool is_read                                 = false;  // by a stage
    bool has_texels                              = false;  // white if not; the rest is only used with texels
    bool alpha_quads                             = false;  // packed as in raster/alpha_quads.h
    bool linear                                  = false;
    bool has_mips                                = false;  // more than one level may be read
    FilterRule rule                              = FilterRule::Single8;
    MipFilter mip                                = MipFilter::None;
    Address address_u                            = Address::Wrap;
    Address address_v                            = Address::Wrap;
    bool operator==(const TextureProgram&) const = default;
};

// Which bits of the colour target may change.
enum class Writes : std::uint8_t { Nothing, All, Alpha, Some };

struct FillProgram {
    // Tests, in the order of raster/fill_state.h.
    Compare alpha_func            = Compare::Always;
    AlphaFail alpha_fail          = AlphaFail::Keep;
    DestAlphaTest dest_alpha_test = DestAlphaTest::Off;
    std::uint8_t depth_bits       = 0;  // 16, 24, 32; 0: depth is neither tested nor written
    Compare depth_func            = Compare::Always;
    bool depth_write              = false;

    // The colour of a fragment.
    bool makes_color         = false;  // it is written, or its alpha tested
    bool floor_colors        = false;
    bool reads_diffuse       = false;
    bool reads_specular      = false;
    bool reads_fog_only      = false;  // of specular
    std::uint8_t stage_count = 0;
    CombineRule combine_rule = CombineRule::Nearest255;
    std::array<CombineStage, kMaxTextures> stages;
    std::array<TextureProgram, kMaxTextures> textures;
    bool add_specular = false;
    bool fog          = false;
    FogRule fog_rule  = FogRule::Nearest255;

    // Into the target.
    Writes writes      = Writes::Nothing;
    BlendRule blend    = BlendRule::Nearest255;
    BlendFactor source = kOne;
    BlendFactor dest   = kZero;
    Shift7Blend shift7;                                // its constant is in the plan
    bool whole_bytes                          = true;  // all bits written are kept, and nothing is dithered
    Dither dither                             = Dither::None;
    bool operator==(const FillProgram&) const = default;

    // No colour is needed to know whether depth may be tested and written.
    constexpr bool tests_first() const { return alpha_func == Compare::Always; }
    // A fragment that fails the alpha test goes on, with less to write.
    constexpr bool fails_on() const { return !tests_first() && alpha_fail != AlphaFail::Keep; }
    constexpr bool uses_color_target() const {
        return writes != Writes::Nothing || dest_alpha_test != DestAlphaTest::Off;
    }
    constexpr bool is_textured() const {
        return (textures[0].is_read && textures[0].has_texels) || (textures[1].is_read && textures[1].has_texels);
    }
    // With Nearest255: can s * Fs + d * Fd be more than 255 * 255? Not if one factor is 0, or one is 255 less the other.
    constexpr bool may_exceed_bytes() const {
        return source != kZero && dest != kZero &&
               !(source.operand == dest.operand && source.alpha == dest.alpha && source.invert != dest.invert);
    }
    // Is what is written the source as it is?
    constexpr bool is_replace() const { return blend != BlendRule::Shift7 && source == kOne && dest == kZero; }
    // Does it lay the texels of one texture, or what it makes of them, over the target without a test?
    constexpr bool is_picture() const {
        return textures[0].is_read && textures[0].has_texels && !textures[0].has_mips && !textures[0].alpha_quads &&
               !textures[1].is_read && tests_first() && depth_bits == 0 && dest_alpha_test == DestAlphaTest::Off &&
               writes == Writes::All;
    }
    // Is what is written the first texture's texel as it is?
    constexpr bool writes_texel() const {
        return is_replace() && whole_bytes && stage_count == 1 && !add_specular && !fog && textures[0].has_texels &&
               stages[0].color == stages[0].alpha && stages[0].color.op == CombineOp::Select &&
               stages[0].color.a == CombineArg{.source = CombineArg::Source::Texel};
    }
    // Of fragments of such programs, the last one to pass gives a pixel all that it has, whatever came before.
    constexpr bool is_last_word() const {
        return writes == Writes::All && is_replace() && tests_first() && dest_alpha_test == DestAlphaTest::Off &&
               !depth_write;
    }
    // Does a fragment change nothing where it is farther than what is there, or as far?
    constexpr bool fails_behind() const {
        return depth_bits != 0 && (depth_func == Compare::LessEqual || depth_func == Compare::Less);
    }
};

// What the fill loop is compiled with: a program that is known then, or one that is not.
template <FillProgram kProgram>
struct OneProgram {
    static constexpr bool kIsKnown = true;
    constexpr const FillProgram* operator->() const { return &kProgram; }
};
struct AnyProgram {
    static constexpr bool kIsKnown = false;
    const FillProgram* program;
    const FillProgram* operator->() const { return program; }
};

// The same for one texture of a program.
template <TextureProgram kTexture>
struct OneTexture {
    static constexpr bool kIsKnown = true;
    constexpr const TextureProgram* operator->() const { return &kTexture; }
};
struct AnyTexture {
    static constexpr bool kIsKnown = false;
    const TextureProgram* texture;
    const TextureProgram* operator->() const { return texture; }
};
template <int kStage, FillProgram kProgram>
constexpr OneTexture<kProgram.textures[kStage]> texture_of(OneProgram<kProgram>) {
    return {};
}
template <int kStage>
AnyTexture texture_of(AnyProgram program) {
    return {&program->textures[kStage]};
}

}  // namespace raster
