// SPDX-License-Identifier: MIT
#include "raster/alpha_quads.h"

#include <catch2/catch.hpp>
#include <vector>

#include "tests/raster/sample_bench.h"
#include "tests/support/random.h"

using namespace raster;

TEST_CASE("alphas are packed two by two, those at the border with themselves", "[raster][texture]") {
    const std::vector<std::uint8_t> alphas{0x01, 0x02, 0x03,  //
                                           0x11, 0x12, 0x13};
    std::vector<std::uint32_t> quads(alpha_quad_count(3, 2));
    pack_alpha_quads(alphas.data(), 3, 2, quads.data());
    CHECK(quads == std::vector<std::uint32_t>{0x01010101, 0x02010201, 0x03020302, 0x03030303,  //
                                              0x11110101, 0x12110201, 0x13120302, 0x13130303,  //
                                              0x11111111, 0x12111211, 0x13121312, 0x13131313});
}

TEST_CASE("a single alpha is packed four times", "[raster][texture]") {
    const std::uint8_t alpha = 0x7f;
    std::vector<std::uint32_t> quads(alpha_quad_count(1, 1));
    pack_alpha_quads(&alpha, 1, 1, quads.data());
    CHECK(quads == std::vector<std::uint32_t>(4, 0x7f7f7f7f));
}

TEST_CASE("a packed texture gives the texels of the plain one", "[raster][texture]") {
    test_support::Random random(11);
    for (const FilterRule rule :
         {FilterRule::Single8, FilterRule::Single4, FilterRule::Single7, FilterRule::Cascade8, FilterRule::Cascade4})
        for (const MipFilter mip : {MipFilter::None, MipFilter::Point, MipFilter::Linear})
            for (const int size : {1, 2, 8, 64}) {
                std::vector<std::vector<std::uint32_t>> texels, quads;
                Sampler sampler{
                    .linear = true, .rule = rule, .mip = mip, .address_u = Address::Clamp, .address_v = Address::Clamp};
                for (int level = size; level > 0; level /= 2) {
                    std::vector<std::uint8_t> alphas(static_cast<std::size_t>(level * level));
                    for (std::uint8_t& alpha : alphas) alpha = static_cast<std::uint8_t>(random.from(0, 255));
                    std::vector<std::uint32_t>& plain = texels.emplace_back();
                    for (const std::uint8_t alpha : alphas) plain.push_back(static_cast<std::uint32_t>(alpha) << 24);
                    quads.emplace_back(alpha_quad_count(level, level));
                    pack_alpha_quads(alphas.data(), level, level, quads.back().data());
                    sampler.levels.push_back({plain.data(), level, level, level});
                    sampler.alpha_quads.push_back({quads.back().data(), level, level, level + 1});
                }
                sample_bench::SampleBench bench(sampler);
                const int lod_max = 256 * (static_cast<int>(sampler.levels.size()) - 1);
                for (int batch = 0; batch < 8; ++batch) {
                    fill_steps::SamplePoints& points = bench.points();
                    for (int i = 0; i < simd_kernels::kLanes; ++i) {
                        const int reach = batch == 0 ? 1 << 29 : 256 * size + 512;
                        points.u[i]     = random.from(-reach, reach);
                        points.v[i]     = random.from(-reach, reach);
                        points.lod[i]   = random.from(0, lod_max);
                        bench.want()[i] = raster::reference::sample(sampler, {points.u[i], points.v[i], points.lod[i]});
                    }
                    bench.run_points(simd_kernels::kLanes / raster::kBlockWidth, true);
                }
            }
}
