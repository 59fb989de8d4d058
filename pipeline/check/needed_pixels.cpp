// SPDX-License-Identifier: MIT
#include "pipeline/check/needed_pixels.h"

#include <algorithm>
#include <cmath>

#include "pipeline/check/target_use.h"

namespace pipeline {

namespace {

PixelRect whole_of(const Target& target) {
    return {0, 0, target.width, target.height};
}

// Does a rectangle's colour replace what is there?
bool replaces(const Pass& pass, const Target& target) {
    const PipelineState& state = pass.state;
    ColorMask mask             = state.color_mask;
    if (target.format == TargetFormat::X8R8G8B8 || target.format == TargetFormat::R5G6B5 ||
        target.format == TargetFormat::Psmct24)
        mask.alpha = true;
    const bool is_tested = (pass.depth && state.depth.func != CompareFunc::Always) ||
                           state.alpha_test.func != CompareFunc::Always || state.dest_alpha_test != DestAlphaTest::Off;
    return !is_tested && mask == ColorMask{} && state.blend == kReplace && state.gs_blend == GsBlend{};
}

int first_pixel(const Arithmetic& arithmetic, float x) {
    const double sixteenths = static_cast<double>(x) * 16.0;
    const double snapped = arithmetic.snap == SnapRule::Truncate ? std::trunc(sixteenths) : std::nearbyint(sixteenths);
    return static_cast<int>(std::ceil((snapped - arithmetic.pixel_center) / 16.0));
}

// What a pass does with a target.
struct Access {
    PixelRegion touched, overwritten;
};

Access access_of(const Frame& frame, const Pass& pass, TargetId id) {
    Access access;
    const PixelRect whole = whole_of(frame.targets[static_cast<std::size_t>(id.index)]);
    if (id == pass.color) {
        access.overwritten = overwritten(frame, pass);
        access.touched     = drawn_to(frame, pass);
    }
    if (id == pass.depth) {
        if (pass.clear.depth) access.overwritten.add(limit_of(frame, pass));
        if (pass.clear.depth || uses_depth(pass)) access.touched.add(limit_of(frame, pass));
    }
    for_each_texture(pass, [&](std::size_t, std::size_t, const TextureBinding& binding) {
        if (binding.target == id) access.touched.add(whole);
    });
    for (const Draw& draw : pass.draws) {
        const auto* copy = std::get_if<CopyRectangle>(&draw);
        if (copy != nullptr && copy->source == id) access.touched.add(copy->from);
    }
    return access;
}

}  // namespace

PixelRect limit_of(const Frame& frame, const Pass& pass) {
    const Target* target = find_target(frame, pass.color ? pass.color : pass.depth);
    if (target == nullptr) return {};
    PixelRect limit = whole_of(*target);
    for (const PixelRect& rect : {pass.state.viewport, pass.state.scissor})
        if (rect != PixelRect{}) limit = common_part(limit, rect);
    return limit;
}

PixelRect written_by(const CopyRectangle& copy) {
    const int step = copy.halve ? 2 : 1;
    return {copy.x, copy.y, copy.x + (copy.from.x1 - copy.from.x0) / step,
            copy.y + (copy.from.y1 - copy.from.y0) / step};
}

PixelRect covered_pixels(const Arithmetic& arithmetic, const DrawRectangle& rectangle) {
    return {first_pixel(arithmetic, rectangle.x0), first_pixel(arithmetic, rectangle.y0),
            first_pixel(arithmetic, rectangle.x1), first_pixel(arithmetic, rectangle.y1)};
}

PixelRegion drawn_to(const Frame& frame, const Pass& pass) {
    PixelRegion region;
    const PixelRect limit = limit_of(frame, pass);
    if (pass.clear.color) region.add(limit);
    for (const Draw& draw : pass.draws) {
        if (const auto* copy = std::get_if<CopyRectangle>(&draw))
            region.add(written_by(*copy));
        else if (const auto* rectangle = std::get_if<DrawRectangle>(&draw))
            region.add(common_part(limit, covered_pixels(frame.arithmetic, *rectangle)));
        else
            region.add(limit);
    }
    return region;
}

PixelRegion overwritten(const Frame& frame, const Pass& pass) {
    PixelRegion region;
    const Target* target = find_target(frame, pass.color);
    if (target == nullptr) return region;
    const PixelRect limit = limit_of(frame, pass);
    if (pass.clear.color) region.add(limit);
    for (const Draw& draw : pass.draws) {
        const auto* copy = std::get_if<CopyRectangle>(&draw);
        if (copy != nullptr && copy->channels == CopyChannels::All) region.add(written_by(*copy));
        const auto* rectangle = std::get_if<DrawRectangle>(&draw);
        if (rectangle != nullptr && replaces(pass, *target))
            region.add(common_part(limit, covered_pixels(frame.arithmetic, *rectangle)));
    }
    return region;
}

std::vector<PixelRegion> needed_pixels(const Frame& frame, TargetId id) {
    const std::size_t passes = frame.passes.size();
    std::vector<PixelRegion> needed(passes + 1), used(passes);
    std::vector<Access> accesses;
    for (std::size_t i = 0; i < passes; ++i) {
        accesses.push_back(access_of(frame, frame.passes[i], id));
        if (i > 0) used[i] = used[i - 1];
        used[i].add(accesses[i].touched);
    }
    PixelRegion later;  // needed after the pass
    if (frame.output == id) later.add(whole_of(frame.targets[static_cast<std::size_t>(id.index)]));
    needed[passes]               = later;
    const PixelRegion from_start = passes == 0 ? later : without(later, used.back());
    for (std::size_t i = passes; i-- > 0;) {
        const auto& [touched, overwritten] = accesses[i];
        needed[i]                          = common_part(later, used[i]);
        needed[i].add(touched);
        later.remove(overwritten);
        later.add(without(touched, overwritten));
        needed[i].add(common_part(later, used[i]));
        needed[i].add(from_start);
    }
    return needed;
}

std::vector<PixelRegion> pixels_used_as_zeros(const Frame& frame, TargetId id) {
    std::vector<PixelRegion> zeros;
    PixelRegion used;
    for (const Pass& pass : frame.passes) {
        const Access access = access_of(frame, pass, id);
        zeros.push_back(without(without(access.touched, access.overwritten), used));
        used.add(access.touched);
    }
    return zeros;
}

}  // namespace pipeline
