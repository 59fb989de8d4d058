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
    for (BlockRows<std::uint32_t>* rows : {&batch.mask, &batch.depth, &batch.color})
        std::copy_n((*rows)[from], kBlockWidth, (*rows)[to]);
}

std::uint64_t test_alpha(Compare func, std::uint8_t reference, FragmentBatch& batch) {
    std::uint64_t passed = 0;
    int kept             = 0;
    for (int block = 0; block < batch.count; ++block) {
        int alive = 0;
        for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
            const VU alpha = hn::ShiftRight<24>(hn::Load(DU(), batch.color[block] + lane));
            const VU mask  = hn::And(hn::Load(DU(), batch.mask[block] + lane), passes(func, alpha, set(reference)));
            hn::Store(mask, DU(), batch.mask[block] + lane);
            alive += count_lanes(mask);
        }
        passed += static_cast<std::uint64_t>(alive);
        if (alive > 0) move_block(batch, block, kept++);
    }
    batch.count = kept;
    return passed;
}

std::uint64_t test_depth(Compare func, bool write, Image& target, FragmentBatch& batch) {
    std::uint64_t passed = 0;
    int kept             = 0;
    for (int block = 0; block < batch.count; ++block) {
        std::uint32_t* const stored = target.row(batch.at[block].y) + batch.at[block].x;
        int alive                   = 0;
        for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
            const VU depth = hn::Load(DU(), batch.depth[block] + lane), there = hn::Load(DU(), stored + lane);
            const VU mask = hn::And(hn::Load(DU(), batch.mask[block] + lane), passes(func, depth, there));
            hn::Store(mask, DU(), batch.mask[block] + lane);
            if (write) hn::Store(select(mask, depth, there), DU(), stored + lane);
            alive += count_lanes(mask);
        }
        passed += static_cast<std::uint64_t>(alive);
        if (alive > 0) move_block(batch, block, kept++);
    }
    batch.count = kept;
    return passed;
}

TestKernels get_test_kernels() {
    return {&test_alpha, &test_depth};
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
