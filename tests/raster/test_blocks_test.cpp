// SPDX-License-Identifier: MIT
// The tests of fragments against a model of one fragment at a time, on every instruction set: which lanes go on,
// which blocks are dropped, what is written and what is counted.
#include <algorithm>
#include <array>
#include <bitset>
#include <catch2/catch.hpp>
#include <cstdint>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "raster/reference_color.h"
#include "raster/test_blocks.h"
#include "tests/raster/simd_kernels.h"
#include "tests/support/random.h"

namespace {

using namespace raster;
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

constexpr std::array kAlphaFails{AlphaFail::Keep, AlphaFail::ColorOnly, AlphaFail::DepthOnly, AlphaFail::RgbOnly};

struct Fragment {
    int x = 0, y = 0;
    std::uint32_t mask = 0, passed = 0, depth = 0, color = 0;
};

// A batch on a target of kBatchBlocks blocks' width, as the kernels have it and as a list of fragments in its order.
class Batch {
  public:
    // The lanes of a block are dead in every third block, and elsewhere in one lane of four.
    explicit Batch(std::uint32_t seed) : random_(seed) {
        kernels->count = kBatchBlocks;
        for (int i = 0; i < kLanes; ++i)
            fragments[i] = {.x      = i,
                            .y      = i / kBlockWidth % 3,
                            .mask   = i / kBlockWidth % 3 == 1 || random_.chance(25) ? 0 : 0xffffffff,
                            .passed = random_.chance(50) ? 0xffffffff : 0,
                            .depth  = random_.bits(),
                            .color  = random_.bits()};
    }
    std::uint32_t random_bits() { return random_.bits(); }

    void load() {
        for (int i = 0; i < kLanes; ++i) {
            const Fragment& f            = fragments[i];
            kernels->at[i / kBlockWidth] = {i - i % kBlockWidth, f.y};
            kernels->mask.lanes[i]       = f.mask;
            kernels->passed.lanes[i]     = f.passed;
            kernels->depth.lanes[i]      = f.depth;
            kernels->color.lanes[i]      = f.color;
        }
        kernels->count = kBatchBlocks;
    }

    // Is what a kernel left what these fragments are, in blocks that have a live one?
    void check(const std::vector<Fragment>& want, std::uint64_t live_got) const {
        std::uint64_t live = 0;
        int block          = 0;
        for (int first = 0; first < kLanes; first += kBlockWidth) {
            const auto here = want.begin() + first;
            const auto live_lanes =
                std::count_if(here, here + kBlockWidth, [](const Fragment& f) { return f.mask != 0; });
            live += static_cast<std::uint64_t>(live_lanes);
            if (live_lanes == 0) continue;
            INFO("pixels from " << here->x << ", " << here->y);
            REQUIRE(block < kernels->count);
            REQUIRE((kernels->at[block].x == here->x && kernels->at[block].y == here->y));
            for (int lane = 0; lane < kBlockWidth; ++lane) check_lane(here[lane], block, lane);
            ++block;
        }
        REQUIRE(kernels->count == block);
        REQUIRE(live_got == live);
    }

    std::unique_ptr<FragmentBatch> kernels = std::make_unique<FragmentBatch>();
    std::vector<Fragment> fragments        = std::vector<Fragment>(kLanes);

  private:
    void check_lane(const Fragment& want, int block, int lane) const {
        const auto is = [&](const BlockRows<std::uint32_t>& rows, std::uint32_t value) {
            return rows[block][lane] == value;
        };
        if (is(kernels->mask, want.mask) &&
            (want.mask == 0 ||
             (is(kernels->passed, want.passed) && is(kernels->depth, want.depth) && is(kernels->color, want.color))))
            return;
        FAIL("lane " << lane << ", colour " << want.color << ", depth " << want.depth << ": got mask "
                     << kernels->mask[block][lane] << " passed " << kernels->passed[block][lane] << ", want mask "
                     << want.mask << " passed " << want.passed);
    }

    test_support::Random random_;
};

const std::vector<simd_kernels::Named<TestKernels>>& targets() {
    static const auto list = simd_kernels::on_every_target(test_kernels);
    return list;
}

}  // namespace

TEST_CASE("the alpha test compares every pair of bytes by every function", "[raster][exhaustive]") {
    Batch batch(1);
    for (const Row& row : kCompare)
        for (const AlphaFail fail : kAlphaFails)
            for (const int reference : simd_kernels::swept_bytes()) {
                std::bitset<256> tried;
                for (int turn = 0, alpha = 0; turn < 3; ++turn) {  // of live lanes there are about a hundred
                    for (Fragment& f : batch.fragments)
                        f.color = static_cast<std::uint32_t>((f.mask != 0 ? alpha++ : f.x) & 255) << 24 | 0x00808080;
                    std::vector<Fragment> want = batch.fragments;
                    for (Fragment& f : want) {
                        if (f.mask != 0) tried.set(f.color >> 24);
                        const bool passes = row.passes(f.color >> 24, static_cast<std::uint32_t>(reference));
                        REQUIRE(reference::passes(row.func, f.color >> 24, static_cast<std::uint32_t>(reference)) ==
                                passes);
                        if (fail != AlphaFail::Keep)
                            f.passed = passes ? 0xffffffff : 0;
                        else if (!passes)
                            f.mask = 0;
                    }
                    for (const auto& [name, test, fallback] : targets()) {
                        INFO(name << ", function " << static_cast<int>(row.func) << ", reference " << reference
                                  << ", fail " << static_cast<int>(fail));
                        batch.load();
                        const std::uint64_t live =
                            test.alpha(row.func, static_cast<std::uint8_t>(reference), fail, *batch.kernels);
                        batch.check(want, live);
                    }
                }
                REQUIRE(tried.all());
            }
}

TEST_CASE("what fails the alpha test keeps only these bits of its mask", "[raster]") {
    Batch batch(2);
    for (Fragment& f : batch.fragments)
        if (f.mask != 0) f.mask = batch.random_bits() | 1;
    for (const std::uint32_t bits : {0u, 0xffffffffu, 0x00ffffffu, 0x80000000u, 0x00f8fcf8u}) {
        std::vector<Fragment> want = batch.fragments;
        for (Fragment& f : want)
            if (f.passed == 0) f.mask &= bits;
        for (const auto& [name, test, fallback] : targets()) {
            INFO(name << ", bits " << bits);
            batch.load();
            const std::uint64_t live = test.limit_color(bits, *batch.kernels);
            batch.check(want, live);
        }
    }
}

TEST_CASE("the destination alpha test reads the top bit of the pixel there", "[raster]") {
    Batch batch(3);
    Image target(kLanes, 3);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < kLanes; ++x)  // all alphas
            target.row(y)[x] =
                static_cast<std::uint32_t>((x * 77 + y) & 255) << 24 | (batch.random_bits() & 0x00ffffff);
    for (const DestAlphaTest which : {DestAlphaTest::Zero, DestAlphaTest::One}) {
        std::vector<Fragment> want = batch.fragments;
        for (Fragment& f : want)
            if ((target.row(f.y)[f.x] >= 0x80000000) != (which == DestAlphaTest::One)) f.mask = 0;
        for (const auto& [name, test, fallback] : targets()) {
            INFO(name << ", test " << static_cast<int>(which));
            batch.load();
            const std::uint64_t live = test.dest_alpha(which, target, *batch.kernels);
            batch.check(want, live);
        }
    }
}

TEST_CASE("the depth test compares all 32 bits without sign, and writes what it is told to", "[raster]") {
    static constexpr std::array<std::uint32_t, 16> kDepths{
        0,          1,          2,          0xffff,     0x10000,    0xffffff,   0x1000000,  0x3fffffff,
        0x40000000, 0x7ffffffe, 0x7fffffff, 0x80000000, 0x80000001, 0xc0000000, 0xfffffffe, 0xffffffff};
    const bool write = GENERATE(false, true), passed_only = GENERATE(false, true);
    Batch batch(4);
    Image before(kLanes, 3), got(kLanes, 3);
    for (const Row& row : kCompare) {
        std::set<std::pair<std::uint32_t, std::uint32_t>> tried;
        for (int turn = 0; turn < kBlockWidth; ++turn) {
            for (int y = 0; y < 3; ++y)
                for (int x = 0; x < kLanes; ++x) before.row(y)[x] = kDepths[static_cast<std::size_t>(x % kBlockWidth)];
            for (int i = 0; i < kLanes; ++i)
                batch.fragments[i].depth = kDepths[static_cast<std::size_t>((i / kBlockWidth + turn) % kBlockWidth)];
            std::vector<Fragment> want = batch.fragments;
            std::uint64_t written_want = 1000;  // it adds to what is there
            std::vector<std::uint32_t> depths(kLanes);
            for (int i = 0; i < kLanes; ++i) {
                Fragment& f               = want[i];
                const std::uint32_t there = before.row(f.y)[f.x];
                if (f.mask != 0) tried.insert({f.depth, there});
                REQUIRE(reference::passes(row.func, f.depth, there) == row.passes(f.depth, there));
                if (!row.passes(f.depth, there)) f.mask = 0;
                const bool writes = f.mask != 0 && write && (!passed_only || f.passed != 0);
                depths[i]         = writes ? f.depth : there;
                written_want += writes;
            }
            for (const auto& [name, test, fallback] : targets()) {
                INFO(name << ", function " << static_cast<int>(row.func) << ", write " << write << ", passed only "
                          << passed_only);
                for (int y = 0; y < 3; ++y) std::copy_n(before.row(y), kLanes, got.row(y));
                batch.load();
                std::uint64_t written    = 1000;
                const std::uint64_t live = test.depth(row.func, write, passed_only, got, *batch.kernels, written);
                batch.check(want, live);
                REQUIRE(written == written_want);
                for (int y = 0; y < 3; ++y)
                    for (int x = 0; x < kLanes; ++x) {
                        const bool drawn              = batch.fragments[x].y == y;
                        const std::uint32_t depth_now = drawn ? depths[x] : before.row(y)[x];
                        if (got.row(y)[x] == depth_now) continue;
                        FAIL("pixel " << x << ", " << y << ": fragment " << batch.fragments[x].depth << " over "
                                      << before.row(y)[x] << ": got " << got.row(y)[x] << " want " << depth_now);
                    }
            }
        }
        REQUIRE(tried.size() == kDepths.size() * kDepths.size());
    }
}
