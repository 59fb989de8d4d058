// SPDX-License-Identifier: MIT
#include "raster/fill_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/fill_kernels.cpp"
#include "hwy/foreach_target.h"
#include "raster/fill_rectangle-inl.h"
#include "raster/fill_triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

void fill_triangle_generally(const FillPlan& plan, const SetUpTriangle& triangle, const Rect& tile,
                             const FillTarget& target, const TileWork& work) {
    fill_triangle(AnyProgram{&plan.program}, plan, triangle, tile, target, work);
}
void fill_rectangle_generally(const FillPlan& plan, const SetUpRectangle& rectangle, const Rect& tile,
                              const FillTarget& target, const TileWork& work) {
    fill_rectangle(AnyProgram{&plan.program}, plan, rectangle, tile, target, work);
}

FillKernel get_general_kernel() {
    return {.triangle = &fill_triangle_generally, .rectangle = &fill_rectangle_generally};
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raster {

HWY_EXPORT(get_general_kernel);
FillKernel fill_kernel(const FillProgram& program, bool general) {
    FillKernel kernel = HWY_DYNAMIC_DISPATCH(get_general_kernel)();
    if (general) return kernel;
    if (const FillKernel::Triangle triangle = special_triangle_kernel(program)) {
        kernel.triangle         = triangle;
        kernel.special_triangle = true;
    }
    if (const FillKernel::Rectangle rectangle = special_rectangle_kernel(program)) {
        kernel.rectangle         = rectangle;
        kernel.special_rectangle = true;
    }
    return kernel;
}

}  // namespace raster
#endif
