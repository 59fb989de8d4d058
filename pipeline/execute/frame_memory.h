// SPDX-License-Identifier: MIT
// A frame's targets and textures as the rasterizer sees them. What one frame has allocated, and left alone, serves the
// next: of a target only what was written is set back to zeros, when something first uses it, and a texture that has
// not changed is not expanded again. What no pass uses has no memory: nor has a depth target that nothing tests or writes.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/frame/frame.h"
#include "raster/color_format.h"
#include "raster/image.h"
#include "raster/sampling_rules.h"

namespace pipeline {

using StoreFunction = std::uint32_t(const raster::ColorFormat& format, std::uint32_t argb);

// What drawing reads. Without colours only those targets have memory that hold depth, or serve as the one image that a pass
// must have; textures have none, and samplers have sizes alone. alpha_quads: may raster/alpha_quads.h be read in place of
// texels?
struct FrameReads {
    bool colors = true, alpha_quads = true;
};

class FrameMemory {
  public:
    // The frame must outlive its drawing. Uses the threads of the arena it is called in. `stored`: see
    // raster/color_format.h.
    void prepare(const Frame& frame, StoreFunction* stored, const FrameReads& reads = {});

    // Null if it is not used; what it would hold then is zero().
    raster::Image* image(TargetId id) { return has_memory(id) ? &targets_[id.index].image : nullptr; }
    std::uint32_t zero(TargetId id) const { return targets_[id.index].zero; }

    // Of all targets and textures.
    std::size_t bytes() const;

    // Targets start as if zeros had been written. `start` is called before a target is first drawn to: the caller
    // sets `rect` to `value` then, and the rest is so already; the rectangle is empty from the second call on.
    // `set_zeros` does all of it at once.
    struct Start {
        raster::Rect rect;
        std::uint32_t value = 0;
    };
    Start start(TargetId id);
    void set_zeros(TargetId id);

    // Must be told of all that is drawn.
    void add_drawn(TargetId id, const raster::Rect& rect);

    // The levels of what is bound, with the filters left at their defaults; none if nothing is, or nothing reads it.
    raster::Sampler sampler(const TextureBinding& binding) const;

  private:
    bool has_memory(TargetId id) const { return id && targets_[id.index].image.width() > 0; }

    struct TargetMemory {
        raster::Image image;
        raster::Rect written;    // all else is `zero`
        std::uint32_t zero = 0;  // what a target holds once zeros have been written
        bool is_started    = false;
    };
    struct TextureUse {
        bool texels = false, quads = false;
        bool any() const { return texels || quads; }
    };
    struct TextureMemory {
        const std::uint32_t* texels = nullptr;  // 0xAARRGGBB, whatever the texture's format; null if none is used
        TextureFormat format        = TextureFormat::A8R8G8B8;
        // What was expanded, and to what.
        std::int32_t width = 0, height = 0;
        std::vector<std::uint8_t> source;
        std::vector<std::uint32_t> expanded;
        std::vector<std::uint32_t> quads;  // raster/alpha_quads.h, level by level
        void set(const Texture& texture, const TextureUse& use);
    };
    std::vector<TargetMemory> targets_;
    static void set_uses(const Frame& frame, bool by_quads, std::vector<TextureUse>& uses);
    std::vector<TextureMemory> textures_;  // only those in use are up to date
    std::vector<TextureUse> uses_;
    const Frame* frame_ = nullptr;
    bool has_colors_    = true;
};

}  // namespace pipeline
