// SPDX-License-Identifier: MIT
// What happens to a covered pixel, in the order it happens. All arithmetic is on bytes; >> floors; every operation clamps to
// 0..255 unless it says otherwise; nearest(v) = floor((v + 127) / 255), that is v / 255 rounded to nearest, for v in
// 0..65025; f' = f + (f >> 7), which is 0..256.
//   1. texel[i]   sampled by `samplers[i]` (raster/sampling_rules.h), for each stage that reads it
//   2. stages     current = diffuse; then for each stage, colour channels by `color` and alpha by `alpha`, rounded by
//                 `combine_rule`; k = 1, 2, 4 for Modulate, 2X, 4X:
//                                 Nearest255                         Expanded256                       Shift7
//                   Select        a                                  a                                 a
//                   Modulate k    nearest(min(65025, k * a * b))     (k * a * b' + 128) >> 8           a * b >> 7, k = 1
//                   Add           a + b                              a + b                             a + b
//                   Subtract      a - b                              a - b
//                   AddSigned     a + b - 127                        a + b - 128
//                   AddSigned2X   2a + 2b - 255                      2a + 2b - 256
//                   Lerp          nearest(a * c + b * (255 - c))     (a * c' + b * (256 - c') + 128) >> 8
//                   MultiplyAdd   nearest(a * b) + c                 ((a * b' + 128) >> 8) + c         (a * b >> 7) + c
//                 (b' and c' stand for the argument expanded; what Shift7 leaves out must not be asked of it)
//   3. specular   `add_specular`: r, g, b += specular r, g, b
//   4. fog        `fog`, with f the alpha of specular, and k the fog_color's channel; r, g, b =
//                   Nearest255 nearest(f * c + (255 - f) * k)        Floor256 (f * c + (256 - f) * k) >> 8
//                   TwoFloors (f * c >> 8) + ((255 - f) * k >> 8)        Expanded256 (f' * c + (256 - f') * k) >> 8
//   5. tests      alpha test, destination alpha test, depth test. The fragment is dropped unless "fragment FUNC reference", the
//                 reference being alpha_reference, or the depth already there; and unless bit 7 of the alpha already there
//                 is what `dest_alpha_test` asks, before the fragment changes it. A fragment that fails the alpha test
//                 is dropped (Keep), or goes on but writes no depth (ColorOnly), no colour (DepthOnly), neither depth
//                 nor alpha (RgbOnly).
//   6. depth      written if `depth_write`
//   7. blend      s: the fragment; or, where `cut_source`, red, green and blue of s are first the bits that the target
//                 keeps, with zeros below them. d: what is there. Each channel becomes
//                   Nearest255   nearest(min(65025, s * Fs + d * Fd))
//                   Trunc256     (s * Fs' + d * Fd') >> 8
//                   Shift7       r, g, b: ((A - B) * C >> 7) + D + dither, or, with `only_above_half` where alpha of s
//                                is below 128, s + dither; clamped, or modulo 256 if not `clamp`. Alpha: s, with bit 7
//                                set if `set_top_bit`.
//   8. dither     Ordered2x2: r, g, b = c - (c >> 6) + {0, 2; 3, 1}[y & 1][x & 1]. Matrix4x4: with Shift7 only, the `dither`
//                 above is dither_matrix[4 * (y & 3) + (x & 3)], -4..3; it is 0 otherwise.
//   9. store      by the target's format (raster/color_format.h); only channels in `write_mask` change
#pragma once

#include <array>
#include <cstdint>

#include "raster/color_format.h"
#include "raster/primitives.h"
#include "raster/sampling_rules.h"

namespace raster {

enum class Compare : std::uint8_t { Always, LessEqual, Less, GreaterEqual, Greater, Equal, NotEqual, Never };
enum class AlphaFail : std::uint8_t { Keep, ColorOnly, DepthOnly, RgbOnly };
enum class DestAlphaTest : std::uint8_t { Off, Zero, One };

enum class CombineOp : std::uint8_t {
    Select,
    Modulate,
    Modulate2X,
    Modulate4X,
    Add,
    AddSigned,
    AddSigned2X,
    Subtract,
    Lerp,
    MultiplyAdd,
};
enum class CombineRule : std::uint8_t { Nearest255, Expanded256, Shift7 };

// alpha_replicate puts the source's alpha in every channel; complement then takes 255 - x. Specular reads with alpha
// 255.
struct CombineArg {
    enum class Source : std::uint8_t { Diffuse, Current, Texel, Constant, Specular };
    Source source                            = Source::Current;
    bool complement                          = false;
    bool alpha_replicate                     = false;
    bool operator==(const CombineArg&) const = default;
};

// c is read by Lerp and MultiplyAdd.
struct Combine {
    CombineOp op = CombineOp::Select;
    CombineArg a, b, c;
    bool operator==(const Combine&) const = default;
};

// Texel in stage i is that of samplers[i].
struct CombineStage {
    Combine color, alpha;
    bool operator==(const CombineStage&) const = default;
};

enum class FogRule : std::uint8_t { Nearest255, Floor256, TwoFloors, Expanded256 };

// What a channel is multiplied by: an operand, its alpha in place of the channel if `alpha`, then 255 - x if `invert`.
// One is {Zero, invert}.
struct BlendFactor {
    enum class Operand : std::uint8_t { Zero, Source, Dest };
    Operand operand                           = Operand::Zero;
    bool alpha                                = false;
    bool invert                               = false;
    bool operator==(const BlendFactor&) const = default;
};
inline constexpr BlendFactor kZero{};
inline constexpr BlendFactor kOne{.invert = true};

// A, B, D, C of the rule Shift7. The default is A = B, so the result is D, the source.
struct Shift7Blend {
    enum class Operand : std::uint8_t { Source, Dest, Zero };
    enum class Factor : std::uint8_t { SourceAlpha, DestAlpha, Constant };
    Operand a = Operand::Source, b = Operand::Source, d = Operand::Source;
    Factor c                                  = Factor::SourceAlpha;
    std::uint8_t constant                     = 0;
    bool only_above_half                      = false;
    bool clamp                                = true;
    bool set_top_bit                          = false;
    bool operator==(const Shift7Blend&) const = default;
};

enum class BlendRule : std::uint8_t { Nearest255, Trunc256, Shift7 };
enum class Dither : std::uint8_t { None, Ordered2x2, Matrix4x4 };

// Steps 7 to 9, but for the target's format. source, dest: with Nearest255 and Trunc256. shift7: with Shift7.
struct Blend {
    BlendRule rule     = BlendRule::Nearest255;
    BlendFactor source = kOne;
    BlendFactor dest   = kZero;
    Shift7Blend shift7;
    bool cut_source = false;
    Dither dither   = Dither::None;
    std::array<std::int8_t, 16> dither_matrix{};
    std::uint32_t write_mask            = 0xffffffff;  // 0 leaves the colour target alone
    bool operator==(const Blend&) const = default;
};

struct FillState {
    bool floor_colors = false;  // of interpolated colours, see primitives.h
    bool whole_depth  = false;  // at the corners of triangles, see there
    int stage_count   = 0;
    std::array<CombineStage, kMaxTextures> stages;
    std::array<Sampler, kMaxTextures> samplers;
    CombineRule combine_rule = CombineRule::Nearest255;
    std::uint32_t constant   = 0xffffffff;
    bool add_specular        = false;
    bool fog                 = false;
    FogRule fog_rule         = FogRule::Nearest255;
    std::uint32_t fog_color  = 0;  // alpha unused

    Compare alpha_func            = Compare::Always;
    std::uint8_t alpha_reference  = 0;
    AlphaFail alpha_fail          = AlphaFail::Keep;
    DestAlphaTest dest_alpha_test = DestAlphaTest::Off;
    Compare depth_func            = Compare::Always;
    bool depth_write              = false;

    Blend blend;
};

// Does stage `i` read `source`, in colour or in alpha?
bool reads(const FillState& state, int i, CombineArg::Source source);

}  // namespace raster
