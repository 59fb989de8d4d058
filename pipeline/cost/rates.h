// SPDX-License-Identifier: MIT
// How fast a chip is, as a table: published and measured figures, each with its unit, its source and how sure it is.
// pipeline/cost/cost.h says what follows from them.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "pipeline/profile/profile.h"

namespace pipeline {

// Where a rate never keeps a frame waiting: what it would measure is not there, or another rate includes it.
inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();

// low <= high; both 0: no source gives a number, and `evidence` says what is known instead. evidence.topic is the
// field's name.
struct Rate {
    std::string_view unit;
    double low = 0.0, high = 0.0;
    Evidence evidence;
};
constexpr bool is_known(const Rate& rate) {
    return rate.low > 0.0;
}

// Pixels that leave the pipelines together, at places that are multiples of it. 1x1: not known.
struct Footprint {
    int width = 1, height = 1;
    bool operator==(const Footprint&) const = default;
};

// Clocks that the Graphics Synthesizer loses at a change of page. span: a row pair goes on in another page, or comes
// back; entry: a page is entered and stays the page for rows. one: colour or depth alone is accessed; two: both, which
// lie in pages of their own.
struct PageBreakRates {
    Rate span_one, span_two, entry_one, entry_two;
    Rate texture;  // another page of a texture
};

// Which memories stand beside each other.
//   Separate  targets and textures in one embedded memory, each with a port of its own (Graphics Synthesizer)
//   Embedded  targets are embedded; textures come from main memory through a cache, and copies go there (Flipper)
//   Shared    targets and textures share one memory and its bandwidth (cards, Xbox)
enum class MemoryKind : std::uint8_t { Separate, Embedded, Shared };
template <>
struct EnumNames<MemoryKind> {
    static constexpr std::array<std::string_view, 3> names{"separate", "embedded", "shared"};
};

struct ChipRates {
    std::string_view profile;  // the name of a Profile
    std::string_view chip;     // low and high: of which boards
    MemoryKind memory = MemoryKind::Shared;
    Rate clock;                     // MHz
    Rate pixels;                    // per clock, without texture
    Rate textured_pixels;           // per clock, with one texture
    Rate fogged_pixels;             // per clock
    Rate samples;                   // per clock: a sample is what a filter makes of one level's texels
    Rate stages;                    // texture stages that a pixel passes in one clock
    Rate frame_bandwidth;           // GB/s (10^9 bytes), of targets
    Rate texture_bandwidth;         // GB/s, of the texels that reach the filters
    Rate memory_bandwidth;          // GB/s, of the memory that is Shared, or the main memory behind Embedded
    Rate texture_cache;             // bytes of textures that the chip keeps while a pass draws
    Rate copies;                    // Mpixels/s that the copy engine reads
    Rate setup;                     // Mprimitives/s
    Rate vertices;                  // M/s, transformed and lit
    Rate upload;                    // GB/s, to where the chip reads
    bool uploads_vertices = false;  // by the same way
    Footprint footprint, textured_footprint;
    std::optional<PageBreakRates> page_breaks;
};

// Calls visit(name, rate) for each number.
template <class Visit>
void visit_rates(const ChipRates& rates, Visit&& visit) {
    visit("clock", rates.clock);
    visit("pixels", rates.pixels);
    visit("textured_pixels", rates.textured_pixels);
    visit("fogged_pixels", rates.fogged_pixels);
    visit("samples", rates.samples);
    visit("stages", rates.stages);
    visit("frame_bandwidth", rates.frame_bandwidth);
    visit("texture_bandwidth", rates.texture_bandwidth);
    visit("memory_bandwidth", rates.memory_bandwidth);
    visit("texture_cache", rates.texture_cache);
    visit("copies", rates.copies);
    visit("setup", rates.setup);
    visit("vertices", rates.vertices);
    visit("upload", rates.upload);
    if (!rates.page_breaks) return;
    visit("span_one", rates.page_breaks->span_one);
    visit("span_two", rates.page_breaks->span_two);
    visit("entry_one", rates.page_breaks->entry_one);
    visit("entry_two", rates.page_breaks->entry_two);
    visit("texture_page", rates.page_breaks->texture);
}

// dx7, ps2, gamecube, xbox.
std::span<const ChipRates> chip_rates();
const ChipRates* find_rates(std::string_view profile);  // null for ideal, and where there is no such profile

}  // namespace pipeline
