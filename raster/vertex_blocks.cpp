// SPDX-License-Identifier: MIT
#include "raster/vertex_blocks.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/vertex_blocks.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// As many floats as there are doubles in a vector, so that the one can become the other anywhere.
using DD = hn::CappedTag<double, kVertexBlock>;
using DF = hn::Rebind<float, DD>;
using DI = hn::Rebind<std::int32_t, DD>;
using VD = hn::Vec<DD>;
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;

HWY_INLINE int step() {
    return static_cast<int>(hn::Lanes(DD()));
}
HWY_INLINE VF set(float value) {
    return hn::Set(DF(), value);
}
HWY_INLINE VD set_double(double value) {
    return hn::Set(DD(), value);
}
HWY_INLINE VF load(const VertexLanes<float>& from, int i) {
    return hn::Load(DF(), from.lanes + i);
}
HWY_INLINE void store(VF value, VertexLanes<float>& to, int i) {
    hn::Store(value, DF(), to.lanes + i);
}
HWY_INLINE VD widen(VF value) {
    return hn::PromoteTo(DD(), value);
}
HWY_INLINE VF clamp(VF value, VF least, VF greatest) {
    return hn::IfThenElse(hn::Lt(value, least), least, hn::IfThenElse(hn::Lt(greatest, value), greatest, value));
}
// To 0..1; not-a-number becomes 0.
HWY_INLINE VF clamp01(VF value) {
    const VF limited = hn::IfThenElse(hn::Lt(value, set(1.0f)), value, set(1.0f));
    return hn::IfThenElseZero(hn::Gt(value, set(0.0f)), limited);
}
// round(c * 255), half up, of 0..1.
HWY_INLINE VI to_byte(VF value) {
    return hn::DemoteTo(DI(), hn::Add(hn::Mul(widen(value), set_double(255.0)), set_double(0.5)));
}

void transform(const Matrix4& m, const Points3& in, int count, Points4& out) {
    for (int i = 0; i < count; i += step()) {
        const VF x = load(in.x, i), y = load(in.y, i), z = load(in.z, i);
        const auto row = [&](int r) HWY_ATTR {
            return hn::Add(hn::Add(hn::Mul(set(m[0][r]), x), hn::Mul(set(m[1][r]), y)),
                           hn::Add(hn::Mul(set(m[2][r]), z), set(m[3][r])));
        };
        store(row(0), out.x, i);
        store(row(1), out.y, i);
        store(row(2), out.z, i);
        store(row(3), out.w, i);
    }
}

HWY_INLINE VF window_x(const WindowTransform& t, VF x, VF w) {
    const VF pixels = hn::Add(set(t.x), hn::Mul(hn::Mul(hn::Add(set(1.0f), hn::Div(x, w)), set(t.width)), set(0.5f)));
    return clamp(pixels, set(t.x - t.band), set(t.x + t.width + t.band));
}
HWY_INLINE VF window_y(const WindowTransform& t, VF y, VF w) {
    const VF pixels = hn::Add(set(t.y), hn::Mul(hn::Mul(hn::Sub(set(1.0f), hn::Div(y, w)), set(t.height)), set(0.5f)));
    return clamp(pixels, set(t.y - t.band), set(t.y + t.height + t.band));
}

// As snap_to_subpixels. Below 2^22 the sum has no room for a fraction, so it rounds to nearest, ties to even.
HWY_INLINE VI snap(const PixelGrid& grid, VF pixels) {
    const VF subpixels = hn::Mul(pixels, set(float{kSubpixels})), round = set(0x1.8p23f);
    return hn::ConvertTo(DI(), grid.truncate ? subpixels : hn::Sub(hn::Add(subpixels, round), round));
}

void place(const WindowTransform& t, const Points4& clip, int count, PlacedVertices& out) {
    const VF zero = set(0.0f);
    for (int i = 0; i < count; i += step()) {
        const VF x = load(clip.x, i), y = load(clip.y, i), z = load(clip.z, i), w = load(clip.w, i);
        // A sum of two floats has the sign of their comparison.
        const VF negative_w = hn::Neg(w);
        const auto behind   = hn::Lt(w, set(t.least_w));
        const auto too_near = hn::Lt(z, zero);
        const auto too_far  = hn::Lt(w, z);
        const auto beyond   = [&](VF coordinate, double g) HWY_ATTR {
            const VD limit = hn::Mul(set_double(g), widen(w));
            return hn::IfThenElseZero(hn::Lt(limit, hn::Abs(widen(coordinate))), set_double(1.0));
        };
        const VF beyond_band = hn::DemoteTo(DF(), hn::Add(beyond(x, t.gx), beyond(y, t.gy)));
        const auto in_band   = hn::AndNot(hn::Or(behind, hn::Or(too_near, too_far)), hn::Eq(beyond_band, zero));
        const auto is_finite = [&](VF v) HWY_ATTR { return hn::Eq(hn::Sub(v, v), zero); };
        const auto finite    = hn::And(hn::And(is_finite(x), is_finite(y)), hn::And(is_finite(z), is_finite(w)));
        const auto placed    = hn::And(in_band, finite);

        const auto flag = [&](hn::Mask<DF> mask, std::int32_t bit)
                              HWY_ATTR { return hn::IfThenElseZero(hn::RebindMask(DI(), mask), hn::Set(DI(), bit)); };
        const VI depth_flags = hn::Or(hn::Or(flag(behind, 1), flag(too_near, 2)), flag(too_far, 4));
        const VI side_flags  = hn::Or(hn::Or(flag(hn::Lt(x, negative_w), 8), flag(hn::Lt(w, x), 16)),
                                      hn::Or(flag(hn::Lt(y, negative_w), 32), flag(hn::Lt(w, y), 64)));
        const VI others      = hn::Or(hn::IfThenZeroElse(hn::RebindMask(DI(), in_band), hn::Set(DI(), kOutsideBand)),
                                      hn::IfThenZeroElse(hn::RebindMask(DI(), finite), hn::Set(DI(), kNotFinite)));
        const VI flags       = hn::Or(hn::Or(depth_flags, side_flags), others);
        hn::Store(hn::BitCast(hn::Rebind<std::uint32_t, DD>(), flags), hn::Rebind<std::uint32_t, DD>(),
                  out.flags.lanes + i);

        // What has no place is put at 0, for its conversion to integers.
        const VF divisor = hn::IfThenElse(placed, w, set(1.0f));
        const VF px      = window_x(t, hn::IfThenElseZero(placed, x), divisor);
        const VF py      = window_y(t, hn::IfThenElseZero(placed, y), divisor);
        hn::Store(snap(t.grid, px), DI(), out.x.lanes + i);
        hn::Store(snap(t.grid, py), DI(), out.y.lanes + i);
    }
}

void to_window(const WindowTransform& t, const Points4& clip, int count, Points4& out) {
    for (int i = 0; i < count; i += step()) {
        const VF x = load(clip.x, i), y = load(clip.y, i), z = load(clip.z, i), w = load(clip.w, i);
        store(window_x(t, x, w), out.x, i);
        store(window_y(t, y, w), out.y, i);
        store(clamp(hn::Div(z, w), set(0.0f), set(1.0f)), out.z, i);
        store(hn::Div(set(1.0f), w), out.w, i);
    }
}

HWY_INLINE VD length(VF x, VF y, VF z) {
    const VD dx = widen(x), dy = widen(y), dz = widen(z);
    return hn::Sqrt(hn::Add(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), hn::Mul(dz, dz)));
}

void fog(const LinearFog& fog, const Points4& camera, int count, VertexLanes<std::uint32_t>& out) {
    const hn::Rebind<std::uint32_t, DD> du;
    for (int i = 0; i < count; i += step()) {
        const VF z        = load(camera.z, i);
        const VD distance = fog.by_distance ? length(load(camera.x, i), load(camera.y, i), z) : hn::Abs(widen(z));
        const VD factor =
            fog.span == 0.0 ? hn::Zero(DD()) : hn::Div(hn::Sub(set_double(fog.end), distance), set_double(fog.span));
        hn::Store(hn::BitCast(du, to_byte(clamp01(hn::DemoteTo(DF(), factor)))), du, out.lanes + i);
    }
}

// A colour that may come from the vertices, channel by channel: red, green, blue, alpha.
class ColorLanes {
  public:
    HWY_INLINE ColorLanes(const DirectionalLighting::Color& color, const VertexColors& vertices)
        : constant_(color.constant.data()),
          lanes_(color.source == DirectionalLighting::Source::Constant ? nullptr
                 : color.source == DirectionalLighting::Source::Color1 ? vertices.first.lanes
                                                                       : vertices.second.lanes) {}
    template <int kChannel>
    HWY_INLINE VF at(int i) const {
        if (lanes_ == nullptr) return set(constant_[kChannel]);
        constexpr int kShift = kChannel == 3 ? 24 : 16 - 8 * kChannel;
        const hn::Rebind<std::uint32_t, DD> du;
        const auto byte = hn::And(hn::ShiftRight<kShift>(hn::Load(du, lanes_ + i)), hn::Set(du, 255));
        return hn::Div(hn::ConvertTo(DF(), hn::BitCast(DI(), byte)), set(255.0f));
    }

  private:
    const float* constant_;
    const std::uint32_t* lanes_;
};

void light(const DirectionalLighting& lighting, const Points3& normals, const VertexColors& colors, int count,
           VertexLanes<std::uint32_t>& out) {
    const auto& m = lighting.normal;
    const ColorLanes emissive(lighting.emissive, colors), ambient(lighting.ambient, colors),
        diffuse(lighting.diffuse, colors);
    for (int i = 0; i < count; i += step()) {
        const VF x = load(normals.x, i), y = load(normals.y, i), z = load(normals.z, i);
        const auto row = [&](int r) HWY_ATTR {
            return hn::Add(hn::Add(hn::Mul(set(m[0][r]), x), hn::Mul(set(m[1][r]), y)), hn::Mul(set(m[2][r]), z));
        };
        VF nx = row(0), ny = row(1), nz = row(2);
        if (lighting.normalize) {
            const VD n          = length(nx, ny, nz);
            const auto has_none = hn::Eq(n, hn::Zero(DD()));
            const VD divisor    = hn::IfThenElse(has_none, set_double(1.0), n);
            nx                  = hn::DemoteTo(DF(), hn::Div(widen(nx), divisor));
            ny                  = hn::DemoteTo(DF(), hn::Div(widen(ny), divisor));
            nz                  = hn::DemoteTo(DF(), hn::Div(widen(nz), divisor));
        }
        VF red = set(0.0f), green = set(0.0f), blue = set(0.0f);
        for (int l = 0; l < lighting.light_count; ++l) {
            const DirectionalLighting::Light& light = lighting.lights[l];
            const VF facing = hn::Add(hn::Add(hn::Mul(nx, set(light.to_light[0])), hn::Mul(ny, set(light.to_light[1]))),
                                      hn::Mul(nz, set(light.to_light[2])));
            const auto is_facing = hn::Gt(facing, set(0.0f));
            const auto add       = [&](VF& sum, float color) HWY_ATTR {
                sum = hn::IfThenElse(is_facing, hn::Add(sum, hn::Mul(facing, set(color))), sum);
            };
            add(red, light.color[0]);
            add(green, light.color[1]);
            add(blue, light.color[2]);
        }
        const auto total = [&](VF own, VF reflected, float ambient_light, VF scattered, VF sum) HWY_ATTR {
            return to_byte(
                clamp01(hn::Add(hn::Add(own, hn::Mul(reflected, set(ambient_light))), hn::Mul(scattered, sum))));
        };
        const auto& around = lighting.ambient_light;
        const VI r         = total(emissive.at<0>(i), ambient.at<0>(i), around[0], diffuse.at<0>(i), red);
        const VI g         = total(emissive.at<1>(i), ambient.at<1>(i), around[1], diffuse.at<1>(i), green);
        const VI b         = total(emissive.at<2>(i), ambient.at<2>(i), around[2], diffuse.at<2>(i), blue);
        const VI a         = to_byte(clamp01(diffuse.at<3>(i)));
        const VI argb      = hn::Or(hn::Or(hn::ShiftLeft<24>(a), hn::ShiftLeft<16>(r)), hn::Or(hn::ShiftLeft<8>(g), b));
        const hn::Rebind<std::uint32_t, DD> du;
        hn::Store(hn::BitCast(du, argb), du, out.lanes + i);
    }
}

VertexKernels get_vertex_kernels() {
    return {&transform, &place, &to_window, &fog, &light};
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raster {

HWY_EXPORT(get_vertex_kernels);
VertexKernels vertex_kernels() {
    return HWY_DYNAMIC_DISPATCH(get_vertex_kernels)();
}

}  // namespace raster
#endif
