// SPDX-License-Identifier: MIT
#include "raster/test_blocks.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/test_blocks.cpp"
#include "hwy/foreach_target.h"
#include "raster/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

HWY_INLINE VU passes(Compare func, VU fragment, VU reference) {
    switch (func) {
        case Compare::Always:
            return set(0xffffffff);
        case Compare::LessEqual:
            return hn::Not(hn::VecFromMask(DU(), hn::Gt(fragment, reference)));
        case Compare::Less:
            return hn::VecFromMask(DU(), hn::Lt(fragment, reference));
        case Compare::GreaterEqual:
            return hn::Not(hn::VecFromMask(DU(), hn::Lt(fragment, reference)));
        case Compare::Greater:
            return hn::VecFromMask(DU(), hn::Gt(fragment, reference));
        case Compare::Equal:
            return hn::VecFromMask(DU(), hn::Eq(fragment, reference));
        case Compare::NotEqual:
            return hn::Not(hn::VecFromMask(DU(), hn::Eq(fragment, reference)));
        case Compare::Never:
            break;
    }
    return set(0);
}

HWY_INLINE int count_lanes(VU mask) {
    return static_cast<int>(hn::CountTrue(DU(), hn::MaskFromVec(mask)));
}

// Block `from` becomes block `to`, as far as later kernels read it.
HWY_INLINE void move_block(FragmentBatch& batch, int from, int to) {
    if (from == to) return;
    batch.at[to] = batch.at[from];
    for (BlockRows<std::uint32_t>* rows : {&batch.mask, &batch.passed, &batch.depth, &batch.color})
        std::copy_n((*rows)[from], kBlockWidth, (*rows)[to]);
}

// mask = narrow(block, lane, mask) for all lanes of a batch; blocks with none left are dropped. How many are left?
// kWhole: masks are all ones or 0, which is the quicker to count.
template <bool kWhole, class Narrow>
HWY_INLINE std::uint64_t narrow_masks(FragmentBatch& batch, Narrow narrow) {
    std::uint64_t left = 0;
    int kept           = 0;
    for (int block = 0; block < batch.count; ++block) {
        int alive = 0;
        for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
            const VU mask = narrow(block, lane, hn::Load(DU(), batch.mask[block] + lane));
            hn::Store(mask, DU(), batch.mask[block] + lane);
            alive += kWhole ? count_lanes(mask) : static_cast<int>(hn::CountTrue(DU(), hn::Ne(mask, set(0))));
        }
        left += static_cast<std::uint64_t>(alive);
        if (alive > 0) move_block(batch, block, kept++);
    }
    batch.count = kept;
    return left;
}

std::uint64_t test_alpha(Compare func, std::uint8_t reference, AlphaFail fail, FragmentBatch& batch) {
    return narrow_masks<true>(batch, [&](int block, int lane, VU mask) HWY_ATTR {
        const VU alpha  = hn::ShiftRight<24>(hn::Load(DU(), batch.color[block] + lane));
        const VU passed = passes(func, alpha, set(reference));
        if (fail == AlphaFail::Keep) return hn::And(mask, passed);
        hn::Store(passed, DU(), batch.passed[block] + lane);
        return mask;
    });
}

std::uint64_t test_dest_alpha(DestAlphaTest test, const Image& target, FragmentBatch& batch) {
    return narrow_masks<true>(batch, [&](int block, int lane, VU mask) HWY_ATTR {
        const auto [x, y] = batch.at[block];
        const VU there    = hn::Load(DU(), target.row(y) + x + lane);
        const VU top_bit  = hn::BitCast(DU(), hn::ShiftRight<31>(hn::BitCast(DI(), there)));
        return test == DestAlphaTest::One ? hn::And(mask, top_bit) : hn::AndNot(top_bit, mask);
    });
}

std::uint64_t test_depth(Compare func, bool write, bool passed_only, Image& target, FragmentBatch& batch,
                         std::uint64_t& written) {
    const std::uint64_t left = narrow_masks<true>(batch, [&](int block, int lane, VU mask) HWY_ATTR {
        const auto [x, y]           = batch.at[block];
        std::uint32_t* const stored = target.row(y) + x + lane;
        const VU depth = hn::Load(DU(), batch.depth[block] + lane), there = hn::Load(DU(), stored);
        const VU tested = hn::And(mask, passes(func, depth, there));
        if (write) {
            VU change = tested;
            if (passed_only) {
                change = hn::And(tested, hn::Load(DU(), batch.passed[block] + lane));
                written += static_cast<std::uint64_t>(count_lanes(change));
            }
            hn::Store(select(change, depth, there), DU(), stored);
        }
        return tested;
    });
    if (write && !passed_only) written += left;
    return left;
}

std::uint64_t limit_color(std::uint32_t bits_if_failed, FragmentBatch& batch) {
    return narrow_masks<false>(batch, [&](int block, int lane, VU mask) HWY_ATTR {
        const VU passed = hn::Load(DU(), batch.passed[block] + lane);
        return hn::And(mask, hn::Or(passed, set(bits_if_failed)));
    });
}

TestKernels get_test_kernels() {
    return {&test_alpha, &test_dest_alpha, &test_depth, &limit_color};
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raster {
HWY_EXPORT(get_test_kernels);
TestKernels test_kernels() {
    return HWY_DYNAMIC_DISPATCH(get_test_kernels)();
}
}  // namespace raster
#endif
