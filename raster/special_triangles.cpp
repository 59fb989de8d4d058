// SPDX-License-Identifier: MIT
#include <utility>

#include "raster/fill_kernels.h"
#include "raster/special_programs.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/special_triangles.cpp"
#include "hwy/foreach_target.h"
#include "raster/fill_triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR
// Of little use to anyone, and so not worth the time to compile them.
FillKernel::Triangle get_special_triangle(const FillProgram&) {
    return nullptr;
}
#else
template <std::size_t kIndex>
void fill_special_triangle(const FillPlan& plan, const SetUpTriangle& triangle, const Rect& tile,
                           const FillTarget& target, const TileWork& work) {
    fill_triangle(OneProgram<kTrianglePrograms[kIndex]>(), plan, triangle, tile, target, work);
}

template <std::size_t... kIndices>
FillKernel::Triangle find(const FillProgram& program, std::index_sequence<kIndices...>) {
    FillKernel::Triangle found = nullptr;
    ((program == kTrianglePrograms[kIndices] ? found = &fill_special_triangle<kIndices> : found), ...);
    return found;
}

FillKernel::Triangle get_special_triangle(const FillProgram& program) {
    return find(program, std::make_index_sequence<kTrianglePrograms.size()>());
}
#endif

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raster {

HWY_EXPORT(get_special_triangle);
FillKernel::Triangle special_triangle_kernel(const FillProgram& program) {
    return HWY_DYNAMIC_DISPATCH(get_special_triangle)(program);
}

}  // namespace raster
#endif
