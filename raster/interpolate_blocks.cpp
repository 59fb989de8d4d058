// SPDX-License-Identifier: MIT
#include "raster/interpolate_blocks.h"

#include <algorithm>
#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/interpolate_blocks.cpp"
#include "hwy/foreach_target.h"
#include "raster/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

// value(x, y) of a plane on the lanes that start at `lane`: its value at the block's first pixel, plus lane * step.
template <int S>
HWY_INLINE VI plane_lanes(const Plane& plane, int x, int y, int lane) {
    return hn::Add(seti(read_plane<S>(plane.at(x, y))), hn::Mul(lane_index(lane), seti(read_plane<S>(plane.dx))));
}

void interpolate_depth(const SetUpTriangle& triangle, int depth_bits, FragmentBatch& batch) {
    const VI least = seti(triangle.depth_min), greatest = seti(triangle.depth_max);
    for (int block = 0; block < batch.count; ++block) {
        for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
            const VI value = plane_lanes<kDepthDrop>(triangle.depth, batch.at[block].x, batch.at[block].y, lane);
            const VU depth = hn::BitCast(DU(), hn::Min(hn::Max(value, least), greatest));
            const VU units = depth_bits == 16   ? hn::ShiftRight<kDepthBits - 16>(depth)
                             : depth_bits == 24 ? hn::ShiftRight<kDepthBits - 24>(depth)
                                                : hn::Or(hn::ShiftLeft<2>(depth), hn::ShiftRight<28>(depth));
            hn::Store(units, DU(), batch.depth[block] + lane);
        }
    }
}

void interpolate_color(const std::array<Plane, 4>& planes, FragmentBatch& batch, BlockRows<std::uint32_t>& out) {
    // Blue and red, green and alpha, as pairs of 16-bit lanes in 8.7 fixed point.
    const auto pair = [](std::uint32_t low, std::uint32_t high) { return (low & 0xffff) | high << 16; };
    const auto step = [&](int channel) {
        return static_cast<std::uint32_t>(read_plane<kColorDrop>(planes[channel].dx));
    };
    const VU step_lo = set(pair(step(0), step(2))), step_hi = set(pair(step(1), step(3)));
    for (int block = 0; block < batch.count; ++block) {
        const auto start = [&](int channel) {
            const std::uint64_t plane = planes[channel].at(batch.at[block].x, batch.at[block].y);
            return static_cast<std::uint32_t>(read_plane<kColorDrop>(plane)) + 64;
        };
        const VU start_lo = set(pair(start(0), start(2))), start_hi = set(pair(start(1), start(3)));
        for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
            const VU index = lane_index_pair(lane), bytes = set_pair(0xff);
            const VU lo = shift_right_signed16<7>(add16(start_lo, mul16(index, step_lo)));
            const VU hi = shift_right_signed16<7>(add16(start_hi, mul16(index, step_hi)));
            hn::Store(pack({hn::And(lo, bytes), hn::And(hi, bytes)}), DU(), out[block] + lane);
        }
    }
}

void interpolate_floor_color(const std::array<Plane, 4>& planes, FragmentBatch& batch, BlockRows<std::uint32_t>& out) {
    for (int block = 0; block < batch.count; ++block)
        for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
            const auto channel = [&](int index) HWY_ATTR {
                const VI value = plane_lanes<kColorDrop>(planes[index], batch.at[block].x, batch.at[block].y, lane);
                const VI byte  = hn::ShiftRight<15>(hn::Add(value, seti(128)));
                return hn::BitCast(DU(), hn::Min(hn::Max(byte, seti(0)), seti(255)));
            };
            const VU rgb = hn::Or(channel(0), hn::Or(hn::ShiftLeft<8>(channel(1)), hn::ShiftLeft<16>(channel(2))));
            hn::Store(hn::Or(rgb, hn::ShiftLeft<24>(channel(3))), DU(), out[block] + lane);
        }
}

HWY_INLINE VI floor_to_int(VF value) {
    constexpr float kLimit = 1073741824.0f;  // 2^30
    return hn::ConvertTo(DI(), hn::Floor(hn::Min(hn::Max(value, hn::Set(DF(), -kLimit)), hn::Set(DF(), kLimit))));
}

// table[i], of one number for each block.
HWY_INLINE VI look_up(const std::int32_t* table, VI i) {
    static_assert(kBatchBlocks == 16);
#if HWY_TARGET <= HWY_AVX3
    return hn::TableLookupLanes(hn::Load(DI(), table), hn::IndicesFromVec(DI(), i));
#elif HWY_TARGET == HWY_AVX2
    const auto in_half = hn::IndicesFromVec(DI(), hn::And(i, seti(7)));
    return hn::IfThenElse(hn::Gt(i, seti(7)), hn::TableLookupLanes(hn::Load(DI(), table + 8), in_half),
                          hn::TableLookupLanes(hn::Load(DI(), table), in_half));
#else
    return hn::GatherIndex(DI(), table, i);
#endif
}

// A plane at any lanes of a batch: its value at the first pixel of the lane's block, plus lane * step.
class PlaneOverBatch {
  public:
    HWY_INLINE PlaneOverBatch(const Plane& plane, const FragmentBatch& batch)
        : step_(read_plane<kTextureDrop>(plane.dx)) {
        for (int block = 0; block < batch.count; ++block)
            starts_[block] = read_plane<kTextureDrop>(plane.at(batch.at[block].x, batch.at[block].y));
    }
    HWY_INLINE VI at(VI block, VI lane) const { return hn::Add(look_up(starts_, block), hn::Mul(lane, seti(step_))); }

  private:
    alignas(64) std::int32_t starts_[kBatchBlocks];
    std::int32_t step_;
};

void triangle_uv(const TexturePlanes& planes, int lod_max, const FragmentBatch& batch, PackedPoints& packed) {
    const VF ku = hn::Set(DF(), planes.scale_u), kv = hn::Set(DF(), planes.scale_v), texel = hn::Set(DF(), 256.0f);
    const PlaneOverBatch plane_s(planes.s, batch), plane_t(planes.t, batch), plane_q(planes.q, batch);
    for (int i = 0; i < packed.blocks() * kBlockWidth; i += lane_count()) {
        const VI index = hn::BitCast(DI(), hn::Load(DU(), packed.index.lanes + i));
        const VI block = hn::ShiftRight<4>(index), lane = hn::And(index, seti(kBlockWidth - 1));
        const VF s = hn::ConvertTo(DF(), plane_s.at(block, lane)), t = hn::ConvertTo(DF(), plane_t.at(block, lane));
        const VF q = hn::ConvertTo(DF(), hn::Max(plane_q.at(block, lane), seti(1)));
        const VF r = hn::Div(hn::Set(DF(), 1.0f), q);
        const VF u = hn::Mul(s, r), v = hn::Mul(t, r);
        hn::Store(floor_to_int(hn::Mul(hn::Mul(u, ku), texel)), DI(), packed.points.u.lanes + i);
        hn::Store(floor_to_int(hn::Mul(hn::Mul(v, kv), texel)), DI(), packed.points.v.lanes + i);
        if (lod_max == 0) continue;
        const auto change = [&](float step, VF coordinate, float step_q, VF scale) HWY_ATTR {
            const VF difference = hn::Sub(hn::Set(DF(), step), hn::Mul(coordinate, hn::Set(DF(), step_q)));
            return hn::Mul(hn::Mul(difference, r), scale);
        };
        const VF ux = change(planes.sx, u, planes.qx, ku), vx = change(planes.tx, v, planes.qx, kv);
        const VF uy = change(planes.sy, u, planes.qy, ku), vy = change(planes.ty, v, planes.qy, kv);
        const VF rho2 = hn::Max(hn::Add(hn::Mul(ux, ux), hn::Mul(vx, vx)), hn::Add(hn::Mul(uy, uy), hn::Mul(vy, vy)));
        const VI log  = hn::ShiftRight<16>(hn::Sub(hn::BitCast(DI(), rho2), seti(0x3f800000)));
        hn::Store(hn::Min(hn::Max(log, seti(0)), seti(lod_max)), DI(), packed.points.lod.lanes + i);
    }
}

void rectangle_uv(const SetUpRectangle::Texture& texture, int lod_max, FragmentBatch& batch) {
    const VI step = seti(read_plane<kRectangleDrop>(texture.u.step));
    const VI lod  = seti(rectangle_lod(texture, lod_max));
    for (int block = 0; block < batch.count; ++block) {
        const VI start = seti(read_plane<kRectangleDrop>(texture.u.at(batch.at[block].x)));
        const VI v     = seti(read_plane<kRectangleDrop>(texture.v.at(batch.at[block].y)) >> 8);
        for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
            const VI u = hn::ShiftRight<8>(hn::Add(start, hn::Mul(lane_index(lane), step)));
            hn::Store(u, DI(), batch.points.u[block] + lane);
            hn::Store(v, DI(), batch.points.v[block] + lane);
            hn::Store(lod, DI(), batch.points.lod[block] + lane);
        }
    }
}

void constant(std::uint32_t value, FragmentBatch& batch, BlockRows<std::uint32_t>& out) {
    for (int block = 0; block < batch.count; ++block)
        for (int lane = 0; lane < kBlockWidth; lane += lane_count()) hn::Store(set(value), DU(), out[block] + lane);
}

InterpolateKernels get_interpolate_kernels() {
    return {&interpolate_depth, &interpolate_color, &interpolate_floor_color, &triangle_uv, &rectangle_uv, &constant};
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raster {

HWY_EXPORT(get_interpolate_kernels);
InterpolateKernels interpolate_kernels() {
    return HWY_DYNAMIC_DISPATCH(get_interpolate_kernels)();
}

std::int32_t rectangle_lod(const SetUpRectangle::Texture& texture, int lod_max) {
    const float rho2 = std::max(texture.ux * texture.ux, texture.vy * texture.vy);
    return std::clamp((std::bit_cast<std::int32_t>(rho2) - std::bit_cast<std::int32_t>(1.0f)) >> 16, 0, lod_max);
}

}  // namespace raster
#endif
