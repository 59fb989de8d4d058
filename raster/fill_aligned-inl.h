// SPDX-License-Identifier: MIT
// Rectangles that lay one picture over another pixel by pixel: what a copy, a halving, a step of a blur by half a texel and
// a composite do. Their texels are a window of the texture that advances as the pixels do, so whole rows are filled without
// another look at coordinates.
// Highway's per-target include guard.
#if defined(NIMBUS7_RASTER_FILL_ALIGNED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NIMBUS7_RASTER_FILL_ALIGNED_INL_H_
#undef NIMBUS7_RASTER_FILL_ALIGNED_INL_H_
#else
#define NIMBUS7_RASTER_FILL_ALIGNED_INL_H_
#endif

#include "raster/box-inl.h"
#include "raster/shade-inl.h"
#include "raster/triangle_setup.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

// One texel a pixel; the mean of the 2x2 that start there; that of 2x2 for each pixel.
enum class Alignment : std::uint8_t { None, Texel, Mean, Halved };

// The texels of a rectangle of pixels: where those of its first one start, how far apart rows are.
struct TexelWindow {
    Alignment alignment         = Alignment::None;
    const std::uint32_t* texels = nullptr;
    std::ptrdiff_t stride       = 0;

    template <Alignment kAlignment>
    HWY_INLINE VU load(std::ptrdiff_t x, std::ptrdiff_t y) const {
        const DU d;
        constexpr std::ptrdiff_t kScale  = kAlignment == Alignment::Halved ? 2 : 1;
        const std::uint32_t* const texel = texels + kScale * (y * stride + x);
        switch (kAlignment) {
            case Alignment::Mean:
                return mean({hn::LoadU(d, texel), hn::LoadU(d, texel + 1), hn::LoadU(d, texel + stride),
                             hn::LoadU(d, texel + stride + 1)});
            case Alignment::Halved:
                return mean_halved(texel, texel + stride);
            case Alignment::None:
            case Alignment::Texel:
                break;
        }
        return hn::LoadU(d, texel);
    }
};

// A coordinate of `count` pixels in 1/256 texel, `gain` or one more from each to the next: does it gain exactly `wanted`?
HWY_INLINE bool is_even(std::int64_t first, std::int64_t last, int count, std::int64_t gain, int wanted) {
    return (gain == wanted || gain == wanted - 1) && last - first == std::int64_t{wanted} * (count - 1);
}

// The texels under `pixels`, which lie in one tile, if they are a window of the level: in steps of 1 or 2 along both axes
// and nowhere beyond its border.
template <class Texture>
HWY_INLINE TexelWindow find_window(Texture program, const SamplePlan::Level& level,
                                   const SetUpRectangle::Texture& texture, const Rect& pixels) {
    const std::int64_t step = read_plane<kRectangleDrop>(texture.u.step);
    const int scale         = program->linear && step > 3 << 15 ? 2 : 1;
    const auto u_at         = [&](int x) {
        const int block = x & -kBlockWidth;
        return (read_plane<kRectangleDrop>(texture.u.at(block)) + (x - block) * step) >> 8;
    };
    const auto v_at = [&](int y) { return std::int64_t{read_plane<kRectangleDrop>(texture.v.at(y)) >> 8}; };

    const std::int64_t u = u_at(pixels.x0), v = v_at(pixels.y0);
    if (!is_even(v, v_at(pixels.y1 - 1), pixels.y1 - pixels.y0, static_cast<std::int64_t>(texture.v.step) >> 24,
                 256 * scale))
        return {};
    for (int x = pixels.x0; x < pixels.x1;) {
        const int end = std::min((x & -kBlockWidth) + kBlockWidth, pixels.x1);
        if (u_at(x) != u + std::int64_t{256 * scale} * (x - pixels.x0) ||
            !is_even(u_at(x), u_at(end - 1), end - x, step >> 8, 256 * scale))
            return {};
        x = end;
    }

    TexelWindow window{.stride = level.stride};
    std::int64_t i = u >> 8, j = v >> 8;
    int size = 1;  // along both axes, of what a pixel reads
    if (!program->linear ||
        (program->rule == FilterRule::Single8 && scale == 1 && (u & 255) == 128 && (v & 255) == 128)) {
        // At the centre of a texel the others have no weight.
        window.alignment = Alignment::Texel;
    } else if (program->rule == FilterRule::Single8 && ((u | v) & 255) == 0) {
        window.alignment = scale == 2 ? Alignment::Halved : Alignment::Mean;
        size             = 2;
        i -= 1;
        j -= 1;
    } else {
        return {};
    }
    const auto is_within = [&](std::int64_t first, int count, int limit) {
        return first >= 0 && first + scale * (count - 1) + size <= limit;
    };
    if (!is_within(i, pixels.x1 - pixels.x0, level.width) || !is_within(j, pixels.y1 - pixels.y0, level.last_row + 1))
        return {};
    window.texels = level.texels + j * level.stride + i;
    return window;
}

// Of one vector of pixels, of a rectangle.
struct TexelSource {
    VU color, argb;
    HWY_INLINE Pixels diffuse() const { return unpack(color); }
    HWY_INLINE Pixels specular() const { return unpack(set(Vertex{}.specular)); }
    template <int kStage>
    HWY_INLINE Pixels texel() const {
        return unpack(argb);
    }
};

// All vectors of `pixels` are whole.
template <Alignment kAlignment, class Program>
HWY_INLINE void fill_window(Program program, const FillPlan& plan, const SetUpRectangle& rectangle, const Rect& pixels,
                            const FillTarget& target, const TexelWindow& window) {
    const VU color = set(rectangle.color);
    for (int y = pixels.y0; y < pixels.y1; ++y) {
        std::uint32_t* const row = target.color->row(y);
        for (int x = pixels.x0; x < pixels.x1; x += lane_count()) {
            const VU texel = window.load<kAlignment>(x - pixels.x0, y - pixels.y0);
            VU next        = texel;
            if (!program->writes_texel())
                next = blend(program, plan.blend, make_color(program, plan, TexelSource{color, texel}),
                             hn::Load(DU(), row + x), x & (kBlockWidth - 1), y);
            hn::Store(next, DU(), row + x);
        }
    }
}

// Fills what it can of `bounds`, which lie in one tile, and returns it.
template <class Program>
HWY_INLINE Rect fill_aligned(Program program, const FillPlan& plan, const SetUpRectangle& rectangle, const Rect& bounds,
                             const FillTarget& target) {
    if constexpr (Program::kIsKnown) {
        if constexpr (Program()->is_picture()) {
            const int lanes = lane_count();
            const Rect pixels{(bounds.x0 + lanes - 1) & -lanes, bounds.y0, bounds.x1 & -lanes, bounds.y1};
            if (pixels.empty()) return {};
            const TexelWindow window =
                find_window(texture_of<0>(program), plan.samplers[0].levels[0], rectangle.textures[0], pixels);
            switch (window.alignment) {
                case Alignment::None:
                    return {};
                case Alignment::Texel:
                    fill_window<Alignment::Texel>(program, plan, rectangle, pixels, target, window);
                    break;
                case Alignment::Mean:
                    if constexpr (Program()->textures[0].linear)
                        fill_window<Alignment::Mean>(program, plan, rectangle, pixels, target, window);
                    break;
                case Alignment::Halved:
                    if constexpr (Program()->textures[0].linear)
                        fill_window<Alignment::Halved>(program, plan, rectangle, pixels, target, window);
                    break;
            }
            return pixels;
        }
    }
    return {};
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#endif  // include guard
