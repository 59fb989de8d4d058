// SPDX-License-Identifier: MIT
#include "pipeline/execute/frame_memory.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "pipeline/execute/lower.h"
#include "raster/alpha_quads.h"
#include "raster/fill_pass.h"

namespace pipeline {
namespace {

void set_bound_textures(const Frame& frame, std::vector<bool>& is_bound) {
    is_bound.assign(frame.textures.size(), false);
    for (const Pass& pass : frame.passes)
        for (const Draw& draw : pass.draws)
            for (const TextureBinding& binding : textures_of(draw))
                if (binding.texture) is_bound[static_cast<std::size_t>(binding.texture.index)] = true;
}

// Of A8; nothing of other formats.
void pack_quads(const Texture& texture, std::vector<std::uint32_t>& out) {
    out.clear();
    if (texture.format != TextureFormat::A8) return;
    const std::uint8_t* texels = texture.texels.data();
    for (int level = 0; level < texture.levels; ++level) {
        const int width = std::max(1, texture.width >> level), height = std::max(1, texture.height >> level);
        const std::size_t done = out.size();
        out.resize(done + raster::alpha_quad_count(width, height));
        raster::pack_alpha_quads(texels, width, height, out.data() + done);
        texels += static_cast<std::ptrdiff_t>(width) * height;
    }
}

}  // namespace

void FrameMemory::TextureMemory::set(const Texture& texture) {
    const std::vector<std::uint8_t>& from = texture.texels;
    // A8R8G8B8 is B, G, R, A in memory, a little-endian 0xAARRGGBB, and the vector's own memory is aligned for any
    // type.
    if (texture.format == TextureFormat::A8R8G8B8) {
        texels = reinterpret_cast<const std::uint32_t*>(from.data());
        return;
    }
    if (format != texture.format || width != texture.width || height != texture.height || source != from) {
        format = texture.format;
        width  = texture.width;
        height = texture.height;
        source = from;
        expanded.resize(from.size());
        pack_quads(texture, quads);
        if (format == TextureFormat::A8)
            std::transform(from.begin(), from.end(), expanded.begin(),
                           [](std::uint8_t a) { return static_cast<std::uint32_t>(a) << 24; });
        else
            std::transform(from.begin(), from.end(), expanded.begin(),
                           [](std::uint8_t l) { return 0xff000000u | l * 0x010101u; });
    }
    texels = expanded.data();
}

void FrameMemory::prepare(const Frame& frame, StoreFunction* stored) {
    frame_ = &frame;
    targets_.resize(frame.targets.size());
    tbb::parallel_for(std::size_t{0}, targets_.size(), [&](std::size_t i) {
        const Target& target     = frame.targets[i];
        TargetMemory& memory     = targets_[i];
        const std::uint32_t zero = is_depth(target.format) ? 0 : stored(color_format(target.format), 0);
        if (memory.image.width() != target.width || memory.image.height() != target.height) {
            memory.image   = raster::Image(target.width, target.height);
            memory.written = {};
            memory.zero    = 0;
        }
        if (memory.zero != zero) memory.written = memory.image.bounds();
        memory.zero       = zero;
        memory.is_started = false;
    });
    textures_.resize(frame.textures.size());
    set_bound_textures(frame, is_bound_);
    tbb::parallel_for(std::size_t{0}, textures_.size(), [&](std::size_t i) {
        if (is_bound_[i]) textures_[i].set(frame.textures[i]);
    });
}

FrameMemory::Start FrameMemory::start(TargetId id) {
    if (!id) return {};
    TargetMemory& target = targets_[id.index];
    if (target.is_started) return {};
    target.is_started       = true;
    const raster::Rect rect = target.written;
    target.written          = {};
    return {rect, target.zero};
}

void FrameMemory::set_zeros(TargetId id) {
    if (!id) return;
    const Start zeros = start(id);
    if (zeros.rect.empty()) return;
    raster::Image& image = targets_[id.index].image;
    tbb::parallel_for(zeros.rect.y0, zeros.rect.y1, [&](int y) {
        raster::fill_rect(image, {zeros.rect.x0, y, zeros.rect.x1, y + 1}, zeros.value);
    });
}

void FrameMemory::add_drawn(TargetId id, const raster::Rect& rect) {
    if (id) targets_[id.index].written = hull(targets_[id.index].written, rect);
}

raster::Sampler FrameMemory::sampler(const TextureBinding& binding) const {
    raster::Sampler sampler;
    if (binding.target) {
        const raster::Image& target = image(binding.target);
        sampler.levels.push_back({target.row(0), target.width(), target.height(), target.stride()});
    } else if (binding.texture) {
        const Texture& texture      = frame_->textures[binding.texture.index];
        const TextureMemory& memory = textures_[binding.texture.index];
        sampler.texel_bytes         = bytes_per_texel(texture.format);
        const std::uint32_t *texels = memory.texels, *quads = memory.quads.data();
        for (int level = 0; level < texture.levels; ++level) {
            const int width = std::max(1, texture.width >> level), height = std::max(1, texture.height >> level);
            sampler.levels.push_back({texels, width, height, width});
            texels += static_cast<std::ptrdiff_t>(width) * height;
            if (texture.format != TextureFormat::A8) continue;
            sampler.alpha_quads.push_back({quads, width, height, width + 1});
            quads += raster::alpha_quad_count(width, height);
        }
    }
    return sampler;
}

}  // namespace pipeline
