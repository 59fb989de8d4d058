// SPDX-License-Identifier: MIT
// The tests of fragments against a model of one fragment at a time, on every instruction set: which fragments go on,
// what is written and what is counted. As compiled for any state and for the special programs.
#include <algorithm>
#include <array>
#include <bitset>
#include <catch2/catch.hpp>
#include <cstdint>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "raster/fill_plan.h"
#include "raster/reference_color.h"
#include "tests/raster/fill_steps.h"
#include "tests/raster/simd_kernels.h"
#include "tests/support/random.h"

namespace {

using namespace raster;
using fill_steps::Fragments;
using fill_steps::Targets;
using simd_kernels::kLanes;

// Does a function pass a value below the reference, the same, above?
struct Row {
    Compare func;
    bool below, same, above;
    bool passes(std::uint32_t fragment, std::uint32_t reference) const {
        return fragment < reference ? below : fragment == reference ? same : above;
    }
};
constexpr std::array<Row, 8> kCompare{{{Compare::Always, true, true, true},
                                       {Compare::LessEqual, true, true, false},
                                       {Compare::Less, true, false, false},
                                       {Compare::GreaterEqual, false, true, true},
                                       {Compare::Greater, false, false, true},
                                       {Compare::Equal, false, true, false},
                                       {Compare::NotEqual, true, false, true},
                                       {Compare::Never, false, false, false}}};
bool passes_as_reference(Compare func, std::uint32_t fragment, std::uint32_t reference) {
    const auto row = std::find_if(kCompare.begin(), kCompare.end(), [&](const Row& each) { return each.func == func; });
    const bool passes = row->passes(fragment, reference);
    if (reference::passes(func, fragment, reference) != passes) FAIL("reference: function " << static_cast<int>(func));
    return passes;
}

constexpr std::array kAlphaFails{AlphaFail::Keep, AlphaFail::ColorOnly, AlphaFail::DepthOnly, AlphaFail::RgbOnly};

// 256 fragments and what they are drawn over.
class Batch {
  public:
    // The lanes of a block are dead in every third block, and elsewhere in one lane of four.
    explicit Batch(std::uint32_t seed) : random(seed) {
        for (int i = 0; i < kLanes; ++i) fragments->set_live(i, i / kBlockWidth % 3 != 1 && !random.chance(25));
        scatter();
    }
    // Other colours and depths.
    void scatter() {
        for (int i = 0; i < kLanes; ++i) {
            fragments->color[i] = random.bits();
            fragments->depth[i] = random.bits() >> 8;
            before->color[i]    = random.bits();
            before->depth[i]    = random.bits() >> 8;
        }
    }

    // Draws with `state`, whose blend replaces, and compares with the model. see(lane): of each fragment that comes to
    // the depth test.
    template <class See>
    void check(const FillState& state, bool has_color, int depth_bits, See&& see) {
        const FillPlan plan = plan_fill(state, has_color, {}, depth_bits, true);
        *want               = *before;
        FillCounts counts{.covered = 1000, .depth_written = 2000};  // it adds to what is there
        const FillCounts start = counts;
        for (int i = 0; i < kLanes; ++i)
            if (fragments->is_live(i)) draw(state, has_color, i, counts, see);
        const auto kernels = simd_kernels::of_every_kind(
            [&](fill_steps::Kind kind) { return fill_steps::shade_step(plan.program, kind); });
        special_runs += kernels.size() - pipeline::simd_targets().size();
        for (const auto& [name, shade, fallback] : kernels) {
            *got                  = *before;
            FillCounts counts_got = start;
            shade(plan, *fragments, *got, counts_got);
            if (got->color == want->color && got->depth == want->depth && counts_got == counts) continue;
            INFO(name << ", alpha function " << static_cast<int>(state.alpha_func) << ", reference "
                      << static_cast<int>(state.alpha_reference) << ", fail " << static_cast<int>(state.alpha_fail)
                      << ", depth function " << static_cast<int>(state.depth_func) << " of " << depth_bits << " bits");
            for (int i = 0; i < kLanes; ++i) check_lane(i);
            CHECK(counts_got.covered == counts.covered);
            CHECK(counts_got.dest_alpha_tested == counts.dest_alpha_tested);
            CHECK(counts_got.alpha_passed == counts.alpha_passed);
            CHECK(counts_got.depth_passed == counts.depth_passed);
            CHECK(counts_got.depth_written == counts.depth_written);
            CHECK(counts_got.color_written == counts.color_written);
            REQUIRE(counts_got == counts);
        }
    }
    void check(const FillState& state, bool has_color) {
        check(state, has_color, 24, [](int) {});
    }

    test_support::Random random;
    std::unique_ptr<Fragments> fragments = std::make_unique<Fragments>();
    std::unique_ptr<Targets> before      = std::make_unique<Targets>();
    std::size_t special_runs             = 0;

  private:
    template <class See>
    void draw(const FillState& state, bool has_color, int i, FillCounts& counts, See&& see) const {
        const std::uint32_t color = fragments->color[i], depth = fragments->depth[i];
        ++counts.covered;
        const bool passes = passes_as_reference(state.alpha_func, color >> 24, state.alpha_reference);
        if (!passes && state.alpha_fail == AlphaFail::Keep) return;
        if (state.dest_alpha_test != DestAlphaTest::Off) {
            ++counts.dest_alpha_tested;
            if ((before->color[i] >= 0x80000000) != (state.dest_alpha_test == DestAlphaTest::One)) return;
        }
        ++counts.alpha_passed;
        see(i);
        if (!passes_as_reference(state.depth_func, depth, before->depth[i])) return;
        ++counts.depth_passed;
        if (state.depth_write && (passes || state.alpha_fail == AlphaFail::DepthOnly)) {
            ++counts.depth_written;
            want->depth[i] = depth;
        }
        std::uint32_t bits = has_color ? state.blend.write_mask : 0;
        if (!passes && state.alpha_fail == AlphaFail::DepthOnly) bits = 0;
        if (!passes && state.alpha_fail == AlphaFail::RgbOnly) bits &= 0x00ffffff;
        if (bits != 0) ++counts.color_written;
        want->color[i] = (color & bits) | (before->color[i] & ~bits);
    }

    void check_lane(int i) const {
        if (got->color[i] == want->color[i] && got->depth[i] == want->depth[i]) return;
        FAIL("lane " << i << (fragments->is_live(i) ? "" : ", dead") << std::hex << ", colour " << fragments->color[i]
                     << " over " << before->color[i] << ", depth " << fragments->depth[i] << " over "
                     << before->depth[i] << ": got " << got->color[i] << " and depth " << got->depth[i] << ", want "
                     << want->color[i] << " and depth " << want->depth[i]);
    }

    std::unique_ptr<Targets> want = std::make_unique<Targets>(), got = std::make_unique<Targets>();
};

}  // namespace

TEST_CASE("the alpha test compares every pair of bytes by every function", "[raster][exhaustive]") {
    Batch batch(1);
    for (const Row& row : kCompare)
        for (const AlphaFail fail : kAlphaFails)
            for (const int reference : simd_kernels::swept_bytes()) {
                std::bitset<256> tried;
                for (int turn = 0, alpha = 0; turn < 3; ++turn) {  // of live lanes there are about a hundred
                    for (int i = 0; i < kLanes; ++i) {
                        const int here = batch.fragments->is_live(i) ? alpha++ : i;
                        if (batch.fragments->is_live(i)) tried.set(static_cast<std::size_t>(here & 255));
                        batch.fragments->color[i] =
                            static_cast<std::uint32_t>(here & 255) << 24 | (batch.random.bits() & 0x00ffffff);
                    }
                    FillState state;
                    state.alpha_func       = row.func;
                    state.alpha_fail       = fail;
                    state.alpha_reference  = static_cast<std::uint8_t>(reference);
                    state.depth_write      = turn > 0;
                    state.blend.write_mask = batch.random.one_of({0xffffffffu, 0x00ffffffu, 0xff000000u, 0x00f8fcf8u});
                    batch.check(state, !batch.random.chance(20));
                }
                REQUIRE(tried.all());
            }
}

TEST_CASE("the destination alpha test reads the top bit of the pixel there", "[raster]") {
    Batch batch(3);
    for (const DestAlphaTest which : {DestAlphaTest::Zero, DestAlphaTest::One})
        for (const Compare alpha_func : {Compare::Always, Compare::Greater})
            for (const AlphaFail fail : kAlphaFails)
                for (int turn = 0; turn < 5; ++turn) {
                    batch.scatter();
                    for (int i = 0; i < kLanes; ++i)  // all alphas
                        batch.before->color[i] = static_cast<std::uint32_t>((i * 77 + turn) & 255) << 24 |
                                                 (batch.random.bits() & 0x00ffffff);
                    FillState state;
                    state.dest_alpha_test  = which;
                    state.alpha_func       = alpha_func;
                    state.alpha_reference  = 99;
                    state.alpha_fail       = fail;
                    state.depth_func       = batch.random.one_of({Compare::Always, Compare::Less});
                    state.depth_write      = batch.random.chance(50);
                    state.blend.write_mask = batch.random.one_of({0xffffffffu, 0x00ffffffu, 0xff000000u, 0u});
                    batch.check(state, true);
                }
}

TEST_CASE("the depth test compares all bits without sign, and writes what it is told to", "[raster]") {
    // Each value beside its neighbours, where the top bits of a format change.
    static constexpr std::array<std::uint32_t, 16> k16{0,      1,      2,      0x7f,   0x80,   0xff,   0x100,  0x3fff,
                                                       0x4000, 0x7ffe, 0x7fff, 0x8000, 0x8001, 0xc000, 0xfffe, 0xffff};
    static constexpr std::array<std::uint32_t, 16> k24{0,        1,        2,        0x7fff,   0x8000,   0xffff,
                                                       0x10000,  0x3fffff, 0x400000, 0x7ffffe, 0x7fffff, 0x800000,
                                                       0x800001, 0xc00000, 0xfffffe, 0xffffff};
    static constexpr std::array<std::uint32_t, 16> k32{
        0,          1,          2,          0xffff,     0x10000,    0xffffff,   0x1000000,  0x3fffffff,
        0x40000000, 0x7ffffffe, 0x7fffffff, 0x80000000, 0x80000001, 0xc0000000, 0xfffffffe, 0xffffffff};
    const int bits     = GENERATE(16, 24, 32);
    const auto& depths = bits == 16 ? k16 : bits == 24 ? k24 : k32;
    FillState state;
    state.depth_write     = GENERATE(false, true);
    state.alpha_func      = GENERATE(Compare::Always, Compare::Greater);
    state.alpha_fail      = GENERATE(from_range(kAlphaFails));
    state.alpha_reference = 127;
    Batch batch(4);
    for (const Row& row : kCompare) {
        std::set<std::pair<std::uint32_t, std::uint32_t>> tried;
        state.depth_func = row.func;
        for (int turn = 0; turn < 2 * kBlockWidth; ++turn) {
            batch.scatter();
            for (int i = 0; i < kLanes; ++i) {
                batch.before->depth[i]    = depths[static_cast<std::size_t>(i % kBlockWidth)];
                batch.fragments->depth[i] = depths[static_cast<std::size_t>((i / kBlockWidth + turn) % kBlockWidth)];
            }
            batch.check(state, true, bits, [&](int i) {
                tried.insert({batch.fragments->depth[i], batch.before->depth[i]});
            });
        }
        REQUIRE(tried.size() == depths.size() * depths.size());
    }
    if (bits == 24 && state.alpha_func == Compare::Always) CHECK(batch.special_runs > 0);
}

TEST_CASE("depth comes to the units of every format", "[raster]") {
    const int bits = GENERATE(16, 24, 32);
    test_support::Random random(5);
    auto depth = std::make_unique<fill_steps::Lanes<std::uint32_t>>(),
         got   = std::make_unique<fill_steps::Lanes<std::uint32_t>>();
    for (int turn = 0; turn < 200; ++turn) {
        for (int i = 0; i < kLanes; ++i) {
            const std::uint32_t edge = (1u << random.from(0, 30)) + static_cast<std::uint32_t>(random.from(-2, 1));
            (*depth)[i]              = (turn % 2 == 0 ? edge : random.bits()) & 0x3fffffff;
        }
        for (const auto& [name, convert, fallback] : simd_kernels::on_every_target(fill_steps::depth_units_step)) {
            convert(bits, *depth, *got);
            for (int i = 0; i < kLanes; ++i) {
                const std::uint32_t value = (*depth)[i];
                const std::uint32_t want  = bits == 32 ? 4 * value + value / (1u << 28) : value / (1u << (30 - bits));
                if ((*got)[i] == want) continue;
                FAIL(name << ": " << value << " in " << bits << " bits: got " << (*got)[i] << " want " << want);
            }
        }
    }
    SUCCEED();
}
