// SPDX-License-Identifier: MIT
#include "pipeline/execute/fill_kernel_list.h"

#include <algorithm>
#include <optional>

#include "pipeline/execute/frame_memory.h"
#include "pipeline/execute/lower.h"
#include "raster/fill_plan.h"
#include "raster/special_names.h"

namespace pipeline {
namespace {

constexpr FillKernelName kGeneralTriangles{"triangles", "general"}, kGeneralRectangles{"rectangles", "general"};

template <std::size_t kCount>
FillKernelName find(const std::array<raster::FillProgram, kCount>& programs,
                    const std::array<const char*, kCount>& names, const raster::FillProgram& program,
                    const FillKernelName& general) {
    const auto found = std::find(programs.begin(), programs.end(), program);
    if (found == programs.end()) return general;
    return {general.primitive, names[static_cast<std::size_t>(found - programs.begin())], true};
}

}  // namespace

std::vector<FillKernelName> fill_kernel_names() {
    std::vector<FillKernelName> names;
    for (const char* name : raster::kTriangleNames) names.push_back({kGeneralTriangles.primitive, name, true});
    names.push_back(kGeneralTriangles);
    for (const char* name : raster::kRectangleNames) names.push_back({kGeneralRectangles.primitive, name, true});
    names.push_back(kGeneralRectangles);
    return names;
}

std::vector<FillKernelName> fill_kernels_of(const Frame& frame) {
    FrameMemory memory;
    memory.prepare(frame, &raster::stored);
    std::vector<FillKernelName> kernels;
    for (const Pass& pass : frame.passes) {
        std::optional<TargetFormat> color;
        if (pass.color) color = frame.targets[static_cast<std::size_t>(pass.color.index)].format;
        const int bits = pass.depth ? depth_bits(frame.targets[static_cast<std::size_t>(pass.depth.index)].format) : 24;
        for (const Draw& draw : pass.draws) {
            if (std::holds_alternative<CopyRectangle>(draw)) continue;
            const bool is_rectangle = std::holds_alternative<DrawRectangle>(draw);
            raster::FillState state = lower(frame.arithmetic, pass.state, color, textures_of(draw), memory);
            if (is_rectangle) state.fog = false;
            const raster::FillProgram program =
                raster::plan_fill(state, color.has_value(), color ? color_format(*color) : raster::ColorFormat{}, bits)
                    .program;
            kernels.push_back(
                is_rectangle ? find(raster::kRectanglePrograms, raster::kRectangleNames, program, kGeneralRectangles)
                             : find(raster::kTrianglePrograms, raster::kTriangleNames, program, kGeneralTriangles));
        }
    }
    return kernels;
}

}  // namespace pipeline
