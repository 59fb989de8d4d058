// SPDX-License-Identifier: MIT
// The filters of raster/sampling_rules.h once more, for tests: quotients of exact sums. kOne is the unit of the
// fractions; they come in 1/256 and are cut down to it. Half up: (2 n + d) / (2 d) floored, or else n / d floored.
#pragma once

#include <cstdint>

#include "raster/sampling_rules.h"
#include "tests/raster/exact.h"

namespace filter_formula {

using exact::Pixel;

template <int kOne, bool kHalfUp>
constexpr int quotient(int n, int times) {  // of n and kOne to that power
    const int divisor = times == 2 ? kOne * kOne : kOne;
    return kHalfUp ? exact::floor_quotient(2 * n + divisor, 2 * divisor) : exact::floor_quotient(n, divisor);
}

template <int kOne, bool kHalfUp>
constexpr int mixed(int a, int b, int f256) {
    const int f = f256 / (256 / kOne);
    return quotient<kOne, kHalfUp>((kOne - f) * a + f * b, 1);
}

// Rounded once.
template <int kOne, bool kHalfUp>
struct Single {
    static constexpr int kUnit = 256 / kOne;  // of the fractions in 1/256
    static constexpr int weigh(int t00, int t10, int t01, int t11, int fu256, int fv256) {
        const int fu = fu256 / kUnit, fv = fv256 / kUnit;
        return quotient<kOne, kHalfUp>(
            (kOne - fu) * (kOne - fv) * t00 + fu * (kOne - fv) * t10 + (kOne - fu) * fv * t01 + fu * fv * t11, 2);
    }
};

// Rounded along u, then along v.
template <int kOne, bool kHalfUp>
struct Cascade {
    static constexpr int kUnit = 256 / kOne;
    static constexpr int weigh(int t00, int t10, int t01, int t11, int fu256, int fv256) {
        return mixed<kOne, kHalfUp>(mixed<kOne, kHalfUp>(t00, t10, fu256), mixed<kOne, kHalfUp>(t01, t11, fu256),
                                    fv256);
    }
};

// use(filter)
template <class Use>
void with_filter(raster::FilterRule rule, Use&& use) {
    switch (rule) {
        case raster::FilterRule::Single8:
            return use(Single<256, true>());
        case raster::FilterRule::Single4:
            return use(Single<16, true>());
        case raster::FilterRule::Single7:
            return use(Single<128, false>());
        case raster::FilterRule::Cascade8:
            return use(Cascade<256, true>());
        case raster::FilterRule::Cascade4:
            return use(Cascade<16, false>());
    }
}

// Two mip levels.
inline int mixed_levels(raster::FilterRule rule, int a, int b, int f) {
    const bool half_up = rule == raster::FilterRule::Single8 || rule == raster::FilterRule::Cascade8;
    return half_up ? mixed<256, true>(a, b, f) : mixed<16, false>(a, b, f);
}

// i of a level of n texels, by remainders.
inline int addressed(raster::Address mode, int i, int n) {
    if (mode == raster::Address::Clamp) return i < 0 ? 0 : i >= n ? n - 1 : i;
    const int period = mode == raster::Address::Wrap ? n : 2 * n, m = i - period * exact::floor_quotient(i, period);
    return m < n ? m : period - 1 - m;
}

// A point u, v (1/256 texel) of level 0.
inline std::uint32_t sampled(const raster::Sampler& sampler, int u, int v) {
    const raster::TextureLevel& level = sampler.levels[0];
    const auto texel                  = [&](int i, int j) {
        return Pixel::of(level.texels[addressed(sampler.address_v, j, level.height) * level.stride +
                                      addressed(sampler.address_u, i, level.width)]);
    };
    if (!sampler.linear) return texel(exact::floor_quotient(u, 256), exact::floor_quotient(v, 256)).argb();
    const int i = exact::floor_quotient(u - 128, 256), j = exact::floor_quotient(v - 128, 256);
    const int fu = u - 128 - 256 * i, fv = v - 128 - 256 * j;
    const Pixel t00 = texel(i, j), t10 = texel(i + 1, j), t01 = texel(i, j + 1), t11 = texel(i + 1, j + 1);
    Pixel out;
    with_filter(sampler.rule, [&](auto filter) {
        for (int c = 0; c < 4; ++c) out.c[c] = filter.weigh(t00.c[c], t10.c[c], t01.c[c], t11.c[c], fu, fv);
    });
    return out.argb();
}

}  // namespace filter_formula
