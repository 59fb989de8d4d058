// SPDX-License-Identifier: MIT
#include "raster/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/simd_targets.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

// One (empty) function per target makes Highway list the targets that are compiled in.
HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {
void probe() {}
}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raster {
HWY_EXPORT(probe);

std::vector<std::string> simd_targets() {
    hwy::SetSupportedTargetsForTest(0);
    std::vector<std::string> names;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) names.emplace_back(hwy::TargetName(target));
    return names;
}

bool force_simd_target(const std::string& name) {
    hwy::SetSupportedTargetsForTest(0);
    if (name.empty()) return true;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        if (name != hwy::TargetName(target)) continue;
        hwy::SetSupportedTargetsForTest(target);
        return true;
    }
    return false;
}
}  // namespace raster
#endif
