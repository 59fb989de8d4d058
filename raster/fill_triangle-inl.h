// SPDX-License-Identifier: MIT
// A triangle within one tile: the loop over its pixels, a column of blocks at a time.
// Highway's per-target include guard.
#if defined(NIMBUS7_RASTER_FILL_TRIANGLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NIMBUS7_RASTER_FILL_TRIANGLE_INL_H_
#undef NIMBUS7_RASTER_FILL_TRIANGLE_INL_H_
#else
#define NIMBUS7_RASTER_FILL_TRIANGLE_INL_H_
#endif

#include <algorithm>
#include <cstring>

#include "raster/cover-inl.h"
#include "raster/hidden-inl.h"
#include "raster/ramps-inl.h"
#include "raster/sampling-inl.h"
#include "raster/shade-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

HWY_INLINE VI floor_to_int(VF value) {
    constexpr float kLimit = 1073741824.0f;  // 2^30
    const VF kept          = hn::Min(hn::Max(value, hn::Set(DF(), -kLimit)), hn::Set(DF(), kLimit));
#if HWY_TARGET <= HWY_AVX3
    return VI{_mm512_cvt_roundps_epi32(kept.raw, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC)};
#elif HWY_TARGET == HWY_AVX2
    return VI{_mm256_cvttps_epi32(_mm256_floor_ps(kept.raw))};  // ConvertTo minds overflow, which cannot be
#else
    return hn::ConvertTo(DI(), hn::Floor(kept));
#endif
}

// Room for every pixel of a column, and for the rest of a vector.
inline constexpr int kListLanes = kColumnRows * kBlockWidth + kBlockWidth;

// Where a texture is read: u, v in 1/256 texel of level 0, lod in 1/256 level.
struct TexturePoints {
    alignas(64) std::int32_t u[kListLanes];
    alignas(64) std::int32_t v[kListLanes];
    alignas(64) std::int32_t lod[kListLanes];
};

// From a triangle's planes to points, by raster/sampling_rules.h.
class TextureRamps {
  public:
    HWY_INLINE void enter_triangle(const TexturePlanes& planes) {
        start_lanes<kTextureDrop>(planes.s, s_.lane);
        start_lanes<kTextureDrop>(planes.t, t_.lane);
        start_lanes<kTextureDrop>(planes.q, q_.lane);
    }
    HWY_INLINE void enter_column(const TexturePlanes& planes, int x, int y, int rows) {
        start_rows<kTextureDrop>(planes.s, x, y, rows, s_.row);
        start_rows<kTextureDrop>(planes.t, x, y, rows, t_.row);
        start_rows<kTextureDrop>(planes.q, x, y, rows, q_.row);
    }
    template <class Lanes>
    HWY_INLINE VF reciprocal_q(const Lanes& lanes) const {
        return hn::Div(hn::Set(DF(), 1.0f), hn::ConvertTo(DF(), hn::Max(lanes.at(q_), seti(1))));
    }
    // Of a vector of lanes, to `to` and on. r: their reciprocal_q.
    template <class Texture, class Lanes>
    HWY_INLINE void locate(Texture texture, int lod_max, const TexturePlanes& planes, const Lanes& lanes, VF r,
                           TexturePoints& out, int to) const {
        const VF ku = hn::Set(DF(), planes.scale_u), kv = hn::Set(DF(), planes.scale_v), unit = hn::Set(DF(), 256.0f);
        const VF s = hn::ConvertTo(DF(), lanes.at(s_)), t = hn::ConvertTo(DF(), lanes.at(t_));
        const VF u = hn::Mul(s, r), v = hn::Mul(t, r);
        hn::Store(floor_to_int(hn::Mul(hn::Mul(u, ku), unit)), DI(), out.u + to);
        hn::Store(floor_to_int(hn::Mul(hn::Mul(v, kv), unit)), DI(), out.v + to);
        if (!texture->has_mips) return;
        const auto change = [&](float step, VF coordinate, float step_q, VF scale) NIMBUS7_LAMBDA {
            const VF difference = hn::Sub(hn::Set(DF(), step), hn::Mul(coordinate, hn::Set(DF(), step_q)));
            return hn::Mul(hn::Mul(difference, r), scale);
        };
        const VF ux = change(planes.sx, u, planes.qx, ku), vx = change(planes.tx, v, planes.qx, kv);
        const VF uy = change(planes.sy, u, planes.qy, ku), vy = change(planes.ty, v, planes.qy, kv);
        const VF rho2 = hn::Max(hn::Add(hn::Mul(ux, ux), hn::Mul(vx, vx)), hn::Add(hn::Mul(uy, uy), hn::Mul(vy, vy)));
        const VI log  = hn::ShiftRight<16>(hn::Sub(hn::BitCast(DI(), rho2), seti(0x3f800000)));
        hn::Store(hn::Min(hn::Max(log, seti(0)), seti(lod_max)), DI(), out.lod + to);
    }

  private:
    Ramp s_, t_, q_;
};

template <class Program>
class TriangleFill {
  public:
    HWY_INLINE TriangleFill(Program program, const FillPlan& plan, const SetUpTriangle& triangle,
                            const FillTarget& target, const TileWork& work)
        : program_(program),
          plan_(plan),
          triangle_(triangle),
          target_(target),
          work_(work),
          stride_((target.color ? target.color : target.depth)->stride()) {
        counter_.is_asked = work.counts != nullptr;
        if (program->depth_bits != 0) start_lanes<kDepthDrop>(triangle.depth, depth_.lane);
        if (!program->makes_color) return;
        if (program->reads_diffuse)
            diffuse_.enter_triangle(diffuse_use(), triangle.diffuse_varies, triangle.flat_diffuse, triangle.diffuse);
        if (program->reads_specular)
            specular_.enter_triangle(specular_use(), triangle.specular_varies, triangle.flat_specular,
                                     triangle.specular);
        if (samples(0)) textures_[0].enter_triangle(triangle.textures[0]);
        if (samples(1)) textures_[1].enter_triangle(triangle.textures[1]);
        // Divisions are dear, and q is mostly that of the perspective in both textures.
        shares_q_ = samples(0) && samples(1) && triangle.textures[0].q == triangle.textures[1].q;
    }

    // The pixels of a column that `cover` has entered, in the rows that have a bit in `live`.
    HWY_INLINE void fill_column(const ColumnCover& cover, unsigned live, int x, int y, int rows) {
        x_ = x, y_ = y, rows_ = rows;
        color_        = target_.color ? target_.color->row(y) + x : nullptr;
        depth_pixels_ = target_.depth ? target_.depth->row(y) + x : nullptr;
        if (program_->depth_bits != 0) start_rows<kDepthDrop>(triangle_.depth, x, y, rows, depth_.row);
        if (!program_->is_textured()) return fill_directly(cover, live);
        pixels_ = 0;
        live    = test_rows(cover, live);
        if (live == 0 || !program_->makes_color) return;
        enter_color_ramps();
        if (program_->is_textured() && 4 * pixels_ < 3 * kBlockWidth * std::popcount(live))
            fill_listed(live);
        else
            fill_in_place(live);
    }

    HWY_INLINE void add_counts() const {
        if (work_.counts) counter_.add_to(*work_.counts, program_, plan_);
    }

  private:
    HWY_INLINE bool samples(int stage) const {
        return program_->textures[stage].is_read && program_->textures[stage].has_texels;
    }
    HWY_INLINE bool settles() const { return program_->is_last_word() && work_.settled; }
    HWY_INLINE ColorUse diffuse_use() const { return {program_->floor_colors, false}; }
    HWY_INLINE ColorUse specular_use() const { return {program_->floor_colors, program_->reads_fog_only}; }

    HWY_INLINE Place place(int row, int lane) const {
        const std::ptrdiff_t offset = row * stride_ + lane;
        return {program_->uses_color_target() ? color_ + offset : nullptr,
                program_->depth_bits != 0 ? depth_pixels_ + offset : nullptr, lane, y_ + row};
    }
    HWY_INLINE auto depth_at(int row, int lane) const {
        return [this, row, lane]() NIMBUS7_LAMBDA {
            const VI value = LanesOfRow{row, lane}.at(depth_);
            const VI kept  = hn::Min(hn::Max(value, seti(triangle_.depth_min)), seti(triangle_.depth_max));
            return depth_units(program_->depth_bits, hn::BitCast(DU(), kept));
        };
    }

    // Of lanes of a row, or of the list. `point`: where theirs are among the points.
    template <class Lanes>
    struct Source {
        const TriangleFill& fill;
        const Lanes& lanes;
        int point;
        HWY_INLINE Pixels diffuse() const { return fill.diffuse_.at(fill.diffuse_use(), lanes); }
        HWY_INLINE Pixels specular() const { return fill.specular_.at(fill.specular_use(), lanes); }
        template <int kStage>
        HWY_INLINE Pixels texel() const {
            const TexturePoints& points = fill.points_[kStage];
            return sample(texture_of<kStage>(fill.program_), fill.plan_.samplers[kStage],
                          hn::Load(DI(), points.u + point), hn::Load(DI(), points.v + point), points.lod + point);
        }
    };

    HWY_INLINE void enter_color_ramps() {
        if (program_->reads_diffuse) diffuse_.enter_column(diffuse_use(), triangle_.diffuse, x_, y_, rows_);
        if (program_->reads_specular) specular_.enter_column(specular_use(), triangle_.specular, x_, y_, rows_);
        if (samples(0)) textures_[0].enter_column(triangle_.textures[0], x_, y_, rows_);
        if (samples(1)) textures_[1].enter_column(triangle_.textures[1], x_, y_, rows_);
    }

    // The lanes that are covered and pass the tests that need no colour.
    HWY_INLINE MU test_lanes(const ColumnCover& cover, int row, int lane) {
        MU mask = cover.lanes(row, lane);
        if (settles()) mask = hn::AndNot(mask_of(work_.settled->block(x_, y_ + row) >> lane & all_lanes()), mask);
        if (counter_.is_asked) counter_.covered += count_lanes(mask);
        if (program_->tests_first())
            mask = test_stored(program_, place(row, lane), depth_at(row, lane), mask, mask, counter_);
        if (settles()) work_.settled->add(x_, y_ + row, bits_of(mask) << lane);
        return mask;
    }

    // Without textures: each vector of lanes from its cover to its colour.
    HWY_INLINE void fill_directly(const ColumnCover& cover, unsigned live) {
        bool has_colors = false;
        for (; live != 0; live &= live - 1) {
            const int row = std::countr_zero(live);
            for (int lane = cover.first_lane(); lane < cover.end_lane(); lane += lane_count()) {
                const MU mask = test_lanes(cover, row, lane);
                if (!program_->makes_color || hn::AllFalse(DU(), mask)) continue;
                if (!has_colors) enter_color_ramps();
                has_colors = true;
                const LanesOfRow lanes{row, lane};
                finish(program_, plan_, place(row, lane), depth_at(row, lane),
                       make_color(program_, plan_, Source<LanesOfRow>{*this, lanes, 0}), mask, counter_);
            }
        }
    }

    // test_lanes of all rows, into alive_; a bit for each row that has some.
    HWY_INLINE unsigned test_rows(const ColumnCover& cover, unsigned live) {
        unsigned alive = 0;
        for (; live != 0; live &= live - 1) {
            const int row = std::countr_zero(live);
            unsigned bits = 0;
            for (int lane = cover.first_lane(); lane < cover.end_lane(); lane += lane_count())
                bits |= bits_of(test_lanes(cover, row, lane)) << lane;
            alive_[row] = static_cast<std::uint16_t>(bits);
            alive |= static_cast<unsigned>(bits != 0) << row;
            pixels_ += std::popcount(bits);
        }
        return alive;
    }

    // Vector by vector of each row. Lanes that are not alive read textures as well: any point is a good one.
    HWY_INLINE void fill_in_place(unsigned live) {
        if (program_->is_textured())
            for (unsigned rest = live; rest != 0; rest &= rest - 1) {
                const int row = std::countr_zero(rest);
                for (int lane = 0; lane < kBlockWidth; lane += lane_count())
                    locate(LanesOfRow{row, lane}, row * kBlockWidth + lane);
            }
        for (; live != 0; live &= live - 1) {
            const int row = std::countr_zero(live);
            for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
                const unsigned bits = static_cast<unsigned>(alive_[row]) >> lane & all_lanes();
                if (lane_count() < kBlockWidth && bits == 0) continue;
                const LanesOfRow lanes{row, lane};
                const Source<LanesOfRow> source{*this, lanes, row * kBlockWidth + lane};
                finish(program_, plan_, place(row, lane), depth_at(row, lane), make_color(program_, plan_, source),
                       mask_of(bits), counter_);
            }
        }
    }

    // Reading textures is the dearest step, and small triangles leave most lanes of a block empty. So the pixels that
    // need it are listed, made in full vectors, and put back.
    HWY_INLINE void fill_listed(unsigned live) {
        alignas(64) std::uint8_t list[kListLanes];
        alignas(64) std::uint32_t colors[kListLanes];
        int listed = 0;
        for (unsigned rest = live; rest != 0; rest &= rest - 1) {
            const int row = std::countr_zero(rest);
            append_lanes(alive_[row], row, list, listed);
        }
        std::fill(list + listed, list + (listed + kBlockWidth - 1) / kBlockWidth * kBlockWidth, list[listed - 1]);
        // Points first, for all: the way to a texel is long, and the processor can go it for several vectors at once.
        for (int i = 0; i < listed; i += lane_count()) {
            const LanesOfList lanes(list + i);
            locate(lanes, i);
        }
        for (int i = 0; i < listed; i += lane_count()) {
            const LanesOfList lanes(list + i);
            hn::Store(pack(make_color(program_, plan_, Source<LanesOfList>{*this, lanes, i})), DU(), colors + i);
        }
        const std::uint32_t* color = colors;
        for (unsigned rest = live; rest != 0; rest &= rest - 1) {
            const int row = std::countr_zero(rest);
            for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
                const unsigned bits = static_cast<unsigned>(alive_[row]) >> lane & all_lanes();
                if (lane_count() < kBlockWidth && bits == 0) continue;
                finish(program_, plan_, place(row, lane), depth_at(row, lane), unpack(expand(color, bits)),
                       mask_of(bits), counter_);
                color += std::popcount(bits);
            }
        }
    }

    // Where a vector of lanes reads the textures: to `to` and on of the points.
    template <class Lanes>
    HWY_INLINE void locate(const Lanes& lanes, int to) {
        VF r = hn::Zero(DF());
        if (samples(0)) {
            r = textures_[0].reciprocal_q(lanes);
            locate_in<0>(lanes, r, to);
        }
        if (samples(1)) {
            if (!shares_q_) r = textures_[1].reciprocal_q(lanes);
            locate_in<1>(lanes, r, to);
        }
    }
    template <int kStage, class Lanes>
    HWY_INLINE void locate_in(const Lanes& lanes, VF r, int to) {
        textures_[kStage].locate(texture_of<kStage>(program_), plan_.samplers[kStage].lod_max,
                                 triangle_.textures[kStage], lanes, r, points_[kStage], to);
        // Mostly a target, which is large; of it a column of blocks reads a line here and a line there.
        const TextureProgram& texture = program_->textures[kStage];
        const TexturePoints& points   = points_[kStage];
        if (!texture.linear && !texture.has_mips)
            prefetch_texel(texture_of<kStage>(program_), plan_.samplers[kStage], points.u[to], points.v[to]);
    }

    // Each as 16 * row + lane. Writes up to 8 bytes beyond.
    static HWY_INLINE void append_lanes(unsigned bits, int row, std::uint8_t* list, int& listed) {
        for (int lane = 0; lane < kBlockWidth; lane += 8) {
            const unsigned mask       = bits >> lane & 255;
            const std::uint64_t first = static_cast<std::uint64_t>(kBlockWidth * row + lane) * 0x0101010101010101u;
            const std::uint64_t bytes = kLanesOfMask[mask] + first;
            std::memcpy(list + listed, &bytes, sizeof bytes);
            listed += std::popcount(mask);
        }
    }

    Program program_;
    const FillPlan& plan_;
    const SetUpTriangle& triangle_;
    const FillTarget& target_;
    const TileWork& work_;
    // The column.
    int x_ = 0, y_ = 0, rows_ = 0;
    std::uint32_t *color_ = nullptr, *depth_pixels_ = nullptr;  // its first pixel in each
    std::ptrdiff_t stride_;
    std::uint16_t alive_[kColumnRows];
    int pixels_ = 0;  // that are alive
    Counter counter_;
    Ramp depth_;
    ColorRamps diffuse_, specular_;
    TextureRamps textures_[kMaxTextures];
    TexturePoints points_[kMaxTextures];
    bool shares_q_ = false;  // both textures have the same
};

// Program: OneProgram or AnyProgram.
template <class Program>
HWY_INLINE void fill_triangle(Program program, const FillPlan& plan, const SetUpTriangle& triangle, const Rect& tile,
                              const FillTarget& target, const TileWork& work) {
    const Rect bounds = intersect(triangle.bounds, tile);
    if (bounds.empty()) return;
    if (!work.counts && is_hidden(program, triangle, bounds, target, work)) return;
    TileEdges edges;
    if (!enter_tile(triangle, tile, edges)) return;
    ColumnCover cover(edges);
    TriangleFill<Program> fill(program, plan, triangle, target, work);
    for (int x = edges.bounds.x0 & -kBlockWidth; x < edges.bounds.x1; x += kBlockWidth)
        for (int y = edges.bounds.y0; y < edges.bounds.y1; y += kColumnRows) {
            const int rows      = std::min(kColumnRows, edges.bounds.y1 - y);
            const unsigned live = cover.enter(x, y, rows);
            if (live != 0) fill.fill_column(cover, live, x, y, rows);
        }
    fill.add_counts();
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#endif  // include guard
