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

namespace {
struct Target {
    std::string name;
    std::int64_t bit;
};
// Asked once, before any is forced.
const std::vector<Target>& all_targets() {
    static const std::vector<Target> targets = [] {
        std::vector<Target> list;
        for (const std::int64_t bit : hwy::SupportedAndGeneratedTargets()) list.push_back({hwy::TargetName(bit), bit});
        return list;
    }();
    return targets;
}
}  // namespace

std::vector<std::string> simd_targets() {
    std::vector<std::string> names;
    for (const Target& target : all_targets()) names.push_back(target.name);
    return names;
}

bool force_simd_target(const std::string& name) {
    if (name.empty()) {
        hwy::SetSupportedTargetsForTest(0);
        return true;
    }
    for (const Target& target : all_targets()) {
        if (target.name != name) continue;
        hwy::SetSupportedTargetsForTest(target.bit);
        return true;
    }
    return false;
}
}  // namespace raster
#endif
