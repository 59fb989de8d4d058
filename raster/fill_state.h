// SPDX-License-Identifier: MIT
// What happens to a covered pixel, in the order it happens. All arithmetic is on bytes; every operation clamps to
// 0..255, and div255(v) = floor((v + 127) / 255), that is v / 255 rounded to nearest, for v in 0..65025.
//   1. texel[i]   sampled by `samplers[i]` (raster/sampling_rules.h), for each stage that reads it
//   2. stages     current = diffuse; then for each stage, colour channels by `color` and alpha by `alpha`:
//                   Select a      Modulate, 2X, 4X  div255(min(65025, k * a * b)), k = 1, 2, 4      Add a + b
//                   Subtract a - b      AddSigned a + b - 127      AddSigned2X 2a + 2b - 255
//   3. specular   `add_specular`: r, g, b += specular r, g, b
//   4. fog        `fog`: r, g, b = div255(f * channel + (255 - f) * fog_color channel), f the alpha of specular
//   5. tests      alpha test, then depth test: the fragment is dropped unless "fragment FUNC reference", the reference
//                 being alpha_reference, or the depth already there
//   6. depth      written if `depth_write`
//   7. blend      div255(min(65025, source * Fs + dest * Fd)), each channel; only channels in `write_mask` change
#pragma once

#include <array>
#include <cstdint>

#include "raster/primitives.h"
#include "raster/sampling_rules.h"

namespace raster {

enum class Compare : std::uint8_t { Always, LessEqual, Less, GreaterEqual, Greater, Equal };

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

enum class CombineOp : std::uint8_t { Select, Modulate, Modulate2X, Modulate4X, Add, AddSigned, AddSigned2X, Subtract };

// alpha_replicate puts the source's alpha in every channel; complement then takes 255 - x. Specular reads with alpha
// 255.
struct CombineArg {
    enum class Source : std::uint8_t { Diffuse, Current, Texel, Constant, Specular };
    Source source                            = Source::Current;
    bool complement                          = false;
    bool alpha_replicate                     = false;
    bool operator==(const CombineArg&) const = default;
};

struct Combine {
    CombineOp op = CombineOp::Select;
    CombineArg a, b;
    bool operator==(const Combine&) const = default;
};

// Texel in stage i is that of samplers[i].
struct CombineStage {
    Combine color, alpha;
};

struct FillState {
    int stage_count = 0;
    std::array<CombineStage, kMaxTextures> stages;
    std::array<Sampler, kMaxTextures> samplers;
    std::uint32_t constant  = 0xffffffff;
    bool add_specular       = false;
    bool fog                = false;
    std::uint32_t fog_color = 0;  // alpha unused

    Compare alpha_func           = Compare::Always;
    std::uint8_t alpha_reference = 0;
    Compare depth_func           = Compare::Always;
    bool depth_write             = false;

    BlendFactor source_factor = kOne;
    BlendFactor dest_factor   = kZero;
    std::uint32_t write_mask  = 0xffffffff;  // 0 leaves the colour target alone
};

// Does stage `i` read `source`, in colour or in alpha?
bool reads(const FillState& state, int i, CombineArg::Source source);

}  // namespace raster
