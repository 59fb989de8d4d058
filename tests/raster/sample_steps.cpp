// SPDX-License-Identifier: MIT
// Step 1 of raster/fill_state.h: how triangles and rectangles read textures, at places from memory.
#include <cstddef>
#include <utility>

#include "tests/raster/fill_steps.h"
#include "tests/raster/special_parts.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/raster/sample_steps.cpp"
#include "hwy/foreach_target.h"
#include "raster/fill_rectangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fill_steps {
namespace HWY_NAMESPACE {

using namespace raster;
using namespace raster::HWY_NAMESPACE;

template <class Texture>
HWY_INLINE void sample_points(Texture program, const SamplePlan& plan, const SamplePoints& points, int blocks,
                              Colors& out) {
    for (int i = 0; i < blocks * kBlockWidth; i += lane_count()) {
        const VI u = hn::Load(DI(), points.u.data() + i), v = hn::Load(DI(), points.v.data() + i);
        hn::Store(pack(sample(program, plan, u, v, points.lod.data() + i)), DU(), out.data() + i);
    }
}

template <class Texture>
HWY_INLINE void sample_rows(Texture program, const SamplePlan& plan, const SampleRows& rows, int blocks, Colors& out) {
    for (int i = 0; i < blocks * kBlockWidth; i += lane_count()) {
        const int block   = i / kBlockWidth;
        const auto gained = static_cast<std::uint32_t>(i % kBlockWidth) * static_cast<std::uint32_t>(rows.step[block]);
        const auto start  = static_cast<std::int32_t>(static_cast<std::uint32_t>(rows.start[block]) + gained);
        const Columns columns(*program.operator->(), start, rows.step[block], plan.levels[0].width);
        hn::Store(pack(sample_row(program, plan, columns, rows.v[block], 0)), DU(), out.data() + i);
    }
}

void sample_generally(const TextureProgram& program, const SamplePlan& plan, const SamplePoints& points, int blocks,
                      Colors& out) {
    sample_points(AnyTexture{&program}, plan, points, blocks, out);
}
void sample_rows_generally(const TextureProgram& program, const SamplePlan& plan, const SampleRows& rows, int blocks,
                           Colors& out) {
    sample_rows(AnyTexture{&program}, plan, rows, blocks, out);
}
template <TextureProgram kTexture>
void sample_specially(const TextureProgram&, const SamplePlan& plan, const SamplePoints& points, int blocks,
                      Colors& out) {
    sample_points(OneTexture<kTexture>(), plan, points, blocks, out);
}
template <TextureProgram kTexture>
void sample_rows_specially(const TextureProgram&, const SamplePlan& plan, const SampleRows& rows, int blocks,
                           Colors& out) {
    sample_rows(OneTexture<kTexture>(), plan, rows, blocks, out);
}

// use(a OneTexture) if it is the program's.
template <TextureProgram kTexture, class Use>
void with_texture(const TextureProgram& program, Use&& use) {
    if constexpr (kTexture.has_texels)
        if (program == kTexture) use(OneTexture<kTexture>());
}
template <std::size_t... kIndices, class Use>
void with_special_texture(const TextureProgram& program, std::index_sequence<kIndices...>, Use&& use) {
    static_assert(kMaxTextures == 2);
    using special_parts::kPrograms;
    ((with_texture<kPrograms[kIndices].textures[0]>(program, use),
      with_texture<kPrograms[kIndices].textures[1]>(program, use)),
     ...);
}
template <class Use>
void with_special_texture(const TextureProgram& program, Use&& use) {
    with_special_texture(program, std::make_index_sequence<special_parts::kPrograms.size()>(), use);
}

template <TextureProgram kTexture>
Sample special_sample(OneTexture<kTexture>) {
    return &sample_specially<kTexture>;
}
template <TextureProgram kTexture>
SampleRowsStep special_sample_rows(OneTexture<kTexture>) {
    return &sample_rows_specially<kTexture>;
}

Sample get_sample(const TextureProgram& program, Kind kind) {
    if (kind == Kind::General) return &sample_generally;
    Sample found = nullptr;
    with_special_texture(program, [&](auto texture) { found = special_sample(texture); });
    return found;
}
SampleRowsStep get_sample_rows(const TextureProgram& program, Kind kind) {
    if (kind == Kind::General) return &sample_rows_generally;
    SampleRowsStep found = nullptr;
    with_special_texture(program, [&](auto texture) { found = special_sample_rows(texture); });
    return found;
}

}  // namespace HWY_NAMESPACE
}  // namespace fill_steps
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fill_steps {

HWY_EXPORT(get_sample);
HWY_EXPORT(get_sample_rows);

Sample sample_step(const raster::TextureProgram& program, Kind kind) {
    return HWY_DYNAMIC_DISPATCH(get_sample)(program, kind);
}
SampleRowsStep sample_rows_step(const raster::TextureProgram& program, Kind kind) {
    return HWY_DYNAMIC_DISPATCH(get_sample_rows)(program, kind);
}

}  // namespace fill_steps
#endif
