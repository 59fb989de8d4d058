// SPDX-License-Identifier: MIT
// The programs that have a kernel of their own: those of the built-in scenes, and plain fills. To add one, write it
// here; `nimbus7 render SCENE --stats` shows which passes have none.
#pragma once

#include <array>

#include "raster/fill_program.h"

namespace raster {
namespace special {

using Source = CombineArg::Source;
inline constexpr CombineArg kDiffuse{Source::Diffuse}, kCurrent{Source::Current}, kTexel{Source::Texel},
    kConstant{Source::Constant};
inline constexpr BlendFactor kSourceColor{BlendFactor::Operand::Source},
    kSourceAlpha{BlendFactor::Operand::Source, true}, kInvSourceAlpha{BlendFactor::Operand::Source, true, true},
    kDest{BlendFactor::Operand::Dest};

constexpr Combine select(CombineArg a) {
    return {CombineOp::Select, a, a, {}};
}
constexpr Combine modulate(CombineArg a, CombineArg b) {
    return {CombineOp::Modulate, a, b, {}};
}

// What is written, opaque until a blend is added: a colour that is constant over a rectangle or varies over a triangle.
constexpr FillProgram vertex_color() {
    return {.makes_color = true, .reads_diffuse = true, .writes = Writes::All};
}
// The last texture of the stages, as it is or with an alpha of its own.
constexpr FillProgram stages(CombineStage first) {
    FillProgram program{.makes_color = true, .stage_count = 1, .writes = Writes::All};
    program.stages[0] = first;
    return program;
}
constexpr FillProgram stages(CombineStage first, CombineStage second) {
    FillProgram program = stages(first);
    program.stage_count = 2;
    program.stages[1]   = second;
    return program;
}

// Each of these takes a program one step further.
constexpr FillProgram lit(FillProgram program) {
    program.reads_diffuse = true;
    return program;
}
constexpr FillProgram fogged(FillProgram program) {
    program.fog = program.reads_specular = program.reads_fog_only = true;
    return program;
}
constexpr FillProgram depth(FillProgram program, Compare func, bool write) {
    program.depth_bits  = 24;
    program.depth_func  = func;
    program.depth_write = write;
    return program;
}
constexpr FillProgram blended(FillProgram program, BlendFactor source, BlendFactor dest) {
    program.source = source;
    program.dest   = dest;
    return program;
}
constexpr FillProgram over(FillProgram program) {
    return blended(program, kSourceAlpha, kInvSourceAlpha);
}
constexpr FillProgram alpha_only(FillProgram program) {
    program.writes = Writes::Alpha;
    return program;
}
// The alpha that is there stays.
constexpr FillProgram without_alpha(FillProgram program) {
    program.writes = Writes::Some;
    return program;
}
// Where bit 7 of the alpha that is there is set.
constexpr FillProgram masked(FillProgram program) {
    program.dest_alpha_test = DestAlphaTest::One;
    return without_alpha(program);
}
constexpr FillProgram not_clear(FillProgram program) {
    program.alpha_func = Compare::Greater;
    return program;
}
constexpr FillProgram texture(FillProgram program, int stage, TextureProgram how) {
    program.textures[stage] = how;
    return program;
}

inline constexpr TextureProgram kWhite{.is_read = true};
inline constexpr TextureProgram kPoint{
    .is_read = true, .has_texels = true, .address_u = Address::Clamp, .address_v = Address::Clamp};
inline constexpr TextureProgram kLinear{
    .is_read = true, .has_texels = true, .linear = true, .address_u = Address::Clamp, .address_v = Address::Clamp};
inline constexpr TextureProgram kLinearRepeated{.is_read = true, .has_texels = true, .linear = true};
constexpr TextureProgram mipped(Address address) {
    return {.is_read    = true,
            .has_texels = true,
            .linear     = true,
            .has_mips   = true,
            .mip        = MipFilter::Linear,
            .address_u  = address,
            .address_v  = address};
}
inline constexpr TextureProgram kRepeated = mipped(Address::Wrap);
// One channel, for fractals.
constexpr TextureProgram alpha_quads(TextureProgram texture) {
    texture.alpha_quads = true;
    return texture;
}
inline constexpr TextureProgram kFractal = alpha_quads(mipped(Address::Clamp)), kFlatFractal = alpha_quads(kLinear);

inline constexpr CombineStage kTexelAsItIs{select(kTexel), select(kTexel)};
inline constexpr CombineStage kLitTexel{modulate(kTexel, kDiffuse), select(kConstant)};
inline constexpr CombineStage kDetail{{CombineOp::Modulate2X, kTexel, kCurrent, {}}, select(kCurrent)};
inline constexpr CombineStage kSplat{modulate(kTexel, kDiffuse), {CombineOp::Modulate4X, kTexel, kDiffuse, {}}};
inline constexpr CombineStage kTintedTexel{modulate(kTexel, kConstant), modulate(kTexel, kConstant)};
inline constexpr CombineStage kDissolvedTexel{modulate(kTexel, kConstant),
                                              {CombineOp::Subtract, kTexel, kConstant, {}}};
inline constexpr CombineStage kTexelFaded{select(kTexel), modulate(kTexel, kConstant)};
inline constexpr CombineStage kAlphaOfTexel{select(kCurrent), modulate(kTexel, kConstant)};
inline constexpr CombineStage kSoftDisc{select(kDiffuse), modulate(kTexel, kDiffuse)};
inline constexpr CombineStage kLayer{select(kTexel), modulate(kTexel, kDiffuse)};
inline constexpr CombineStage kErosion{select(kCurrent), {CombineOp::AddSigned2X, kTexel, kCurrent, {}}};

inline constexpr FillProgram kLandscape = depth(fogged(lit(stages(kLitTexel))), Compare::LessEqual, true);
inline constexpr FillProgram kDetailed  = depth(fogged(lit(stages(kLitTexel, kDetail))), Compare::LessEqual, true);
constexpr FillProgram veil(CombineStage stage, TextureProgram how) {
    FillProgram program = not_clear(over(depth(fogged(lit(stages(stage))), Compare::LessEqual, false)));
    return texture(program, 0, how);
}
// A cloud that is read at its own texel, with the fractal of a box's side.
constexpr FillProgram eroded(CombineStage cloud) {
    return texture(texture(stages(cloud, kErosion), 0, kPoint), 1, kFractal);
}
inline constexpr FillProgram kSplatted = over(depth(fogged(lit(stages(kSplat))), Compare::LessEqual, false));

inline constexpr FillProgram kThrownLight =
    without_alpha(blended(depth(fogged(stages({modulate(kTexel, kConstant), select(kConstant)},
                                              {modulate(kTexel, kCurrent), select(kCurrent)})),
                                Compare::LessEqual, false),
                          kDest, kOne));

}  // namespace special

inline constexpr std::array kTrianglePrograms{
    // Landscape: a texture, a second one, a third laid over; without a texture; the sky.
    special::texture(special::kLandscape, 0, special::kRepeated),
    special::texture(special::texture(special::kDetailed, 0, special::kRepeated), 1, special::kRepeated),
    special::texture(special::kSplatted, 0, special::kRepeated),
    special::texture(special::kLandscape, 0, special::kWhite),
    special::depth(special::vertex_color(), Compare::LessEqual, false),
    special::depth(special::vertex_color(), Compare::LessEqual, true),
    // Light thrown on it.
    special::texture(special::texture(special::kThrownLight, 0, special::kLinear), 1, special::kLinear),
    // Mega-particles and their skirt.
    special::depth(special::fogged(special::vertex_color()), Compare::LessEqual, true),
    special::depth(special::fogged(special::vertex_color()), Compare::LessEqual, false),
    // The mask of their rim.
    special::alpha_only(special::depth(special::vertex_color(), Compare::LessEqual, false)),
    // Fractal boxes: eroding at once over the scene, or what dissolves into a target of its own; multiplying.
    special::over(special::eroded(special::kTexelAsItIs)),
    special::eroded(special::kDissolvedTexel),
    special::alpha_only(special::blended(special::texture(special::stages(special::kTexelAsItIs), 0, special::kFractal),
                                         kZero, special::kSourceColor)),
    special::alpha_only(
        special::blended(special::texture(special::stages(special::kTexelAsItIs), 0, special::kFlatFractal), kZero,
                         special::kSourceColor)),
    // Displaced alpha.
    special::over(special::texture(
        special::texture(special::stages(special::kTintedTexel, special::kAlphaOfTexel), 0, special::kPoint), 1,
        special::kLinear)),
    // What mega-particles are compared with: sprites, slices of a volume.
    special::veil(special::kSoftDisc, special::kFlatFractal),
    special::veil(special::kLayer, special::kLinear),
};

inline constexpr std::array kRectanglePrograms{
    // Blits: filtered, copied, blended.
    special::texture(special::stages(special::kTexelAsItIs), 0, special::kLinear),
    special::texture(special::stages(special::kTexelAsItIs), 0, special::kPoint),
    special::texture(special::stages({special::select(special::kTexel), special::select(special::kConstant)}), 0,
                     special::kPoint),
    special::over(special::texture(special::stages(special::kTexelFaded), 0, special::kPoint)),
    special::over(special::texture(special::stages(special::kTexelAsItIs), 0, special::kPoint)),
    // The same where a mask allows it; making the mask.
    special::masked(special::over(special::texture(special::stages(special::kTexelFaded), 0, special::kPoint))),
    special::alpha_only(special::vertex_color()),
    // Plain colours.
    special::vertex_color(),
    special::depth(special::vertex_color(), Compare::LessEqual, true),
    special::over(special::vertex_color()),
    special::blended(special::vertex_color(), kZero, special::kSourceColor),
    special::blended(special::vertex_color(), special::kDest, kOne),
    // The same with the alpha that is there, as a chip with alpha in its back buffer draws.
    special::without_alpha(special::vertex_color()),
    special::without_alpha(special::texture(special::stages(special::kTexelAsItIs), 0, special::kLinearRepeated)),
};

}  // namespace raster
