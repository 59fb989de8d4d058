// SPDX-License-Identifier: MIT
#include <utility>

#include "raster/fill_kernels.h"
#include "raster/special_programs.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/special_rectangles.cpp"
#include "hwy/foreach_target.h"
#include "raster/fill_rectangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR
// Of little use to anyone, and so not worth the time to compile them.
FillKernel::Rectangle get_special_rectangle(const FillProgram&) {
    return nullptr;
}
#else
template <std::size_t kIndex>
void fill_special_rectangle(const FillPlan& plan, const SetUpRectangle& rectangle, const Rect& tile,
                            const FillTarget& target, const TileWork& work) {
    fill_rectangle(OneProgram<kRectanglePrograms[kIndex]>(), plan, rectangle, tile, target, work);
}

template <std::size_t... kIndices>
FillKernel::Rectangle find(const FillProgram& program, std::index_sequence<kIndices...>) {
    FillKernel::Rectangle found = nullptr;
    ((program == kRectanglePrograms[kIndices] ? found = &fill_special_rectangle<kIndices> : found), ...);
    return found;
}

FillKernel::Rectangle get_special_rectangle(const FillProgram& program) {
    return find(program, std::make_index_sequence<kRectanglePrograms.size()>());
}
#endif

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raster {

HWY_EXPORT(get_special_rectangle);
FillKernel::Rectangle special_rectangle_kernel(const FillProgram& program) {
    return HWY_DYNAMIC_DISPATCH(get_special_rectangle)(program);
}

}  // namespace raster
#endif
