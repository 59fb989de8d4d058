// SPDX-License-Identifier: MIT
#include "pipeline/cost/fill_cost.h"

#include <algorithm>
#include <cmath>

#include "pipeline/cost/page_breaks.h"

namespace pipeline {

namespace {

double ceil_to(int value, int step) {
    return std::ceil(static_cast<double>(value) / step) * step;
}
double floor_to(int value, int step) {
    return std::floor(static_cast<double>(value) / step) * step;
}

double rectangle_slots(const PixelRect& rect, Footprint footprint) {
    if (rect.x0 >= rect.x1 || rect.y0 >= rect.y1) return 0.0;
    return (ceil_to(rect.x1, footprint.width) - floor_to(rect.x0, footprint.width)) *
           (ceil_to(rect.y1, footprint.height) - floor_to(rect.y0, footprint.height));
}

double triangle_slots(double fragments, double triangles, Footprint footprint) {
    if (fragments <= 0.0 || triangles <= 0.0) return 0.0;
    const double side   = std::max(1.0, std::sqrt(2.0 * fragments / triangles));
    const double rows   = (side - 1.0) / footprint.height + 1.0;
    const double across = (std::max(1.0, side / 2.0) - 1.0) / footprint.width + 1.0;
    return triangles * rows * across * footprint.width * footprint.height;
}

// Nothing fills slower than one fragment a footprint.
double most_slots(const DrawWork& draw, Footprint footprint) {
    const double slots = draw.is_rectangle ? rectangle_slots(draw.covered, footprint)
                                           : triangle_slots(draw.fragments, draw.triangles, footprint);
    return std::clamp(slots, draw.fragments, draw.fragments * footprint.width * footprint.height);
}

Range draw_clocks(const DrawWork& draw, double texel_scale, const PipelineState& state, const ChipRates& rates) {
    const bool is_textured = !draw.textures.empty();
    const Range slots      = pixel_slots(draw, is_textured ? rates.textured_footprint : rates.footprint);
    Range clocks           = divided(slots, is_textured ? rates.textured_pixels : rates.pixels);
    double samples         = 0.0;
    for (const TextureRead& read : draw.textures) samples += draw.fragments * read.samples * texel_scale;
    clocks             = slower(clocks, divided(exactly(samples), rates.samples));
    // A pixel that has a second stage goes through its pipeline once more.
    const Range rounds = divided(slots * std::max(1, stage_count(state)), rates.stages);
    clocks             = slower(clocks, divided(rounds, rates.pixels));
    if (!draw.is_rectangle && state.fog.mode != FogMode::None)
        clocks = slower(clocks, divided(slots, rates.fogged_pixels));
    return clocks;
}

Range clocks_of(const PageBreaks& breaks, const Rate& span, const Rate& entry) {
    return Range{span.low, span.high} * breaks.spans + Range{entry.low, entry.high} * breaks.entries;
}

// Counts the breaks of one kind of page, and their clocks.
void add(const PageBreaks& least, const PageBreaks& most, const Rate& span, const Rate& entry, PageBreakCost& cost) {
    cost.count += {least.spans + least.entries, most.spans + most.entries};
    cost.clocks += {clocks_of(least, span, entry).least, clocks_of(most, span, entry).most};
}

PageShape frame_shape(const PassWork& work) {
    return page_shape(work.color_bytes > 0 ? work.color_bytes : work.depth_bytes);
}

// The frame's pages, of all draws one after the other.
PageBreakCost frame_breaks(const PassWork& work, const Rate& span, const Rate& entry) {
    PageBreakCost cost;
    const PageShape shape = frame_shape(work);
    std::optional<Page> last;
    for (const DrawWork& draw : work.draws) {
        if (draw.fragments <= 0.0) continue;
        if (draw.is_rectangle) {
            const PageBreaks breaks = rectangle_breaks(draw.covered, row_pairs(draw.covered), shape, last);
            add(breaks, breaks, span, entry, cost);
            continue;
        }
        const PageBreaks breaks = triangle_breaks(draw.fragments, draw.triangles, shape);
        add(breaks, {breaks.spans, breaks.entries + draw.triangles}, span, entry, cost);
        last.reset();
    }
    return cost;
}

// A texture within one page has none.
PageBreakCost texture_breaks(const DrawWork& draw, const TextureRead& read, const Rate& rate) {
    PageBreakCost cost;
    const PageShape shape = page_shape(read.bytes);
    if (read.width <= shape.width && read.height <= shape.height) return cost;
    if (draw.is_rectangle) {
        std::optional<Page> last;
        const PageBreaks breaks = rectangle_breaks(read.span, row_pairs(draw.covered), shape, last);
        add(breaks, breaks, rate, rate, cost);
    } else {
        const PageBreaks breaks = triangle_breaks(draw.fragments, draw.triangles, shape);
        add({}, {breaks.spans, breaks.entries + draw.triangles}, rate, rate, cost);
    }
    return cost;
}

PageBreakCost texture_breaks(const PassWork& work, const Rate& rate) {
    PageBreakCost cost;
    for (const DrawWork& draw : work.draws) {
        if (draw.fragments <= 0.0) continue;
        for (const TextureRead& read : draw.textures) {
            const PageBreakCost one = texture_breaks(draw, read, rate);
            cost.count += one.count;
            cost.clocks += one.clocks;
        }
    }
    return cost;
}

// Whether a frame's page changes while a texture's does is not known.
Range side_by_side_or_not(const Range& a, const Range& b) {
    return {std::max(a.least, b.least), a.most + b.most};
}

PageBreakCost clear_breaks(const PassWork& work, const Rate& span, const Rate& entry) {
    PageBreakCost cost;
    if (work.cleared <= 0.0) return cost;
    const PageShape shape = frame_shape(work);
    std::optional<Page> last;
    const PageBreaks paged = paged_breaks(work.limits, shape);
    const PageBreaks whole = rectangle_breaks(work.limits, row_pairs(work.limits), shape, last);
    add(paged, paged, span, entry, cost);
    PageBreakCost in_one;
    add(whole, whole, span, entry, in_one);
    // Narrow ones are as fast in one.
    cost.count  = {std::min(cost.count.least, in_one.count.least), std::max(cost.count.most, in_one.count.most)};
    cost.clocks = {std::min(cost.clocks.least, in_one.clocks.least), std::max(cost.clocks.most, in_one.clocks.most)};
    return cost;
}

}  // namespace

Range divided(const Range& amount, const Range& by_rate) {
    return {amount.least / by_rate.most, amount.most / by_rate.least};
}

Range divided(const Range& amount, const Rate& by_rate) {
    return is_known(by_rate) ? divided(amount, Range{by_rate.low, by_rate.high}) : Range{};
}

Range pixel_slots(const DrawWork& draw, Footprint footprint) {
    return {draw.fragments, most_slots(draw, footprint)};
}

Range fill_clocks(const PassWork& work, const PipelineState& state, const ChipRates& rates) {
    Range clocks = divided(exactly(work.cleared), rates.pixels);
    for (const DrawWork& draw : work.draws) clocks += draw_clocks(draw, work.texel_scale, state, rates);
    return clocks;
}

PageBreakCost page_break_cost(const PassWork& work, const PageBreakRates& rates) {
    const bool draws_two  = work.accesses_color && work.accesses_depth,
               clears_two = work.clears_color && work.clears_depth;
    const PageBreakCost frame =
        frame_breaks(work, draws_two ? rates.span_two : rates.span_one, draws_two ? rates.entry_two : rates.entry_one);
    const PageBreakCost textures = texture_breaks(work, rates.texture);
    const PageBreakCost clear    = clear_breaks(work, clears_two ? rates.span_two : rates.span_one,
                                             clears_two ? rates.entry_two : rates.entry_one);
    return {.count  = side_by_side_or_not(frame.count, textures.count) + clear.count,
            .clocks = side_by_side_or_not(frame.clocks, textures.clocks) + clear.clocks};
}

}  // namespace pipeline
