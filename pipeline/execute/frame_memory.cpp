// SPDX-License-Identifier: MIT
#include "pipeline/execute/frame_memory.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "pipeline/check/state_use.h"
#include "pipeline/check/target_use.h"
#include "pipeline/execute/lower.h"
#include "raster/alpha_quads.h"
#include "raster/fill_pass.h"

namespace pipeline {
namespace {

void expand(const Texture& texture, std::vector<std::uint32_t>& out) {
    out.resize(texture.texels.size());
    if (texture.format == TextureFormat::A8)
        std::transform(texture.texels.begin(), texture.texels.end(), out.begin(),
                       [](std::uint8_t a) { return static_cast<std::uint32_t>(a) << 24; });
    else
        std::transform(texture.texels.begin(), texture.texels.end(), out.begin(),
                       [](std::uint8_t l) { return 0xff000000u | l * 0x010101u; });
}

template <class Use>
void for_each_level(const Texture& texture, Use&& use) {
    for (int level = 0; level < texture.levels; ++level)
        use(std::max(1, texture.width >> level), std::max(1, texture.height >> level));
}

void pack_quads(const Texture& texture, std::vector<std::uint32_t>& out) {
    std::size_t count = 0;
    for_each_level(texture, [&](int width, int height) { count += raster::alpha_quad_count(width, height); });
    out.resize(count);
    const std::uint8_t* texels = texture.texels.data();
    std::uint32_t* quads       = out.data();
    for_each_level(texture, [&](int width, int height) {
        raster::pack_alpha_quads(texels, width, height, quads);
        texels += static_cast<std::ptrdiff_t>(width) * height;
        quads += raster::alpha_quad_count(width, height);
    });
}

}  // namespace

// By quads those of A8 that are read as raster/fill_plan.cpp wants them for.
void FrameMemory::set_uses(const Frame& frame, bool by_quads, std::vector<TextureUse>& uses) {
    uses.assign(frame.textures.size(), {});
    for (const Pass& pass : frame.passes)
        for_each_texture(pass, [&](std::size_t, std::size_t index, const TextureBinding& binding) {
            if (!binding.texture) return;
            const TextureStage& stage = pass.state.stages[index];
            TextureUse& use           = uses[binding.texture.index];
            const bool is_by_quads    = by_quads && frame.textures[binding.texture.index].format == TextureFormat::A8 &&
                                     stage.filter == TextureFilter::Linear &&
                                     stage.address_u == TextureAddress::Clamp &&
                                     stage.address_v == TextureAddress::Clamp;
            (is_by_quads ? use.quads : use.texels) = true;
        });
}

void FrameMemory::TextureMemory::set(const Texture& texture, const TextureUse& use) {
    const std::vector<std::uint8_t>& from = texture.texels;
    // A8R8G8B8 is B, G, R, A in memory, a little-endian 0xAARRGGBB, and the vector's own memory is aligned for any
    // type.
    if (texture.format == TextureFormat::A8R8G8B8) {
        const std::uint32_t* const as_they_are = reinterpret_cast<const std::uint32_t*>(from.data());
        if (!source.empty()) *this = {};
        texels = as_they_are;
        return;
    }
    if (format != texture.format || width != texture.width || height != texture.height || source != from) {
        format = texture.format;
        width  = texture.width;
        height = texture.height;
        source = from;
        expanded.clear();
        quads.clear();
    }
    if (!use.texels) expanded = std::vector<std::uint32_t>();  // {} would keep the memory
    if (use.texels && expanded.empty()) expand(texture, expanded);
    if (!use.quads) quads = std::vector<std::uint32_t>();
    if (use.quads && quads.empty()) pack_quads(texture, quads);
    texels = use.texels ? expanded.data() : nullptr;
}

void FrameMemory::prepare(const Frame& frame, StoreFunction* stored, const FrameReads& reads) {
    frame_                 = &frame;
    has_colors_            = reads.colors;
    std::vector<bool> used = targets_in_use(frame);
    if (frame.output) used[frame.output.index] = true;
    if (!reads.colors)
        for (std::size_t i = 0; i < used.size(); ++i) used[i] = used[i] && is_depth(frame.targets[i].format);
    // The rasterizer is given one image at least.
    for (const Pass& pass : frame.passes) {
        if (!pass.color) used[pass.depth.index] = true;
        if (!reads.colors && draws(pass) && !(pass.depth && used[pass.depth.index])) used[pass.color.index] = true;
    }
    targets_.resize(frame.targets.size());
    tbb::parallel_for(std::size_t{0}, targets_.size(), [&](std::size_t i) {
        const Target& target     = frame.targets[i];
        TargetMemory& memory     = targets_[i];
        const std::uint32_t zero = is_depth(target.format) ? 0 : stored(color_format(target.format), 0);
        const bool is_used       = used[i];
        const int width = is_used ? target.width : 0, height = is_used ? target.height : 0;
        if (memory.image.width() != width || memory.image.height() != height) {
            memory.image   = is_used ? raster::Image(width, height) : raster::Image();
            memory.written = {};
            memory.zero    = 0;
        }
        if (memory.zero != zero) memory.written = memory.image.bounds();
        memory.zero       = zero;
        memory.is_started = false;
    });
    textures_.resize(frame.textures.size());
    set_uses(frame, reads.alpha_quads, uses_);
    tbb::parallel_for(std::size_t{0}, textures_.size(), [&](std::size_t i) {
        if (uses_[i].any() && reads.colors)
            textures_[i].set(frame.textures[i], uses_[i]);
        else
            textures_[i] = {};
    });
}

FrameMemory::Start FrameMemory::start(TargetId id) {
    if (!has_memory(id)) return {};
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

std::size_t FrameMemory::bytes() const {
    std::size_t bytes = 0;
    for (const TargetMemory& target : targets_)
        bytes += sizeof(std::uint32_t) * static_cast<std::size_t>(target.image.stride() * target.image.height());
    for (const TextureMemory& texture : textures_)
        bytes += texture.source.capacity() +
                 sizeof(std::uint32_t) * (texture.expanded.capacity() + texture.quads.capacity());
    return bytes;
}

void FrameMemory::add_drawn(TargetId id, const raster::Rect& rect) {
    if (has_memory(id)) targets_[id.index].written = hull(targets_[id.index].written, rect);
}

raster::Sampler FrameMemory::sampler(const TextureBinding& binding) const {
    raster::Sampler sampler;
    if (has_memory(binding.target)) {
        const raster::Image& target = targets_[binding.target.index].image;
        sampler.levels.push_back({target.row(0), target.width(), target.height(), target.stride()});
    } else if (binding.target && !has_colors_) {
        const Target& target = frame_->targets[binding.target.index];
        sampler.levels.push_back({nullptr, target.width, target.height, target.width});
    } else if (binding.texture && uses_[binding.texture.index].any()) {
        const Texture& texture      = frame_->textures[binding.texture.index];
        const TextureMemory& memory = textures_[binding.texture.index];
        sampler.texel_bytes         = bytes_per_texel(texture.format);
        const std::uint32_t *texels = memory.texels, *quads = memory.quads.data();
        for_each_level(texture, [&](int width, int height) {
            sampler.levels.push_back({texels, width, height, width});
            if (texels) texels += static_cast<std::ptrdiff_t>(width) * height;
            if (memory.quads.empty()) return;
            sampler.alpha_quads.push_back({quads, width, height, width + 1});
            quads += raster::alpha_quad_count(width, height);
        });
    }
    return sampler;
}

}  // namespace pipeline
