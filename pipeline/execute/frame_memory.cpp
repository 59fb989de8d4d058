// SPDX-License-Identifier: MIT
#include "pipeline/execute/frame_memory.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstring>
#include <set>

#include "pipeline/execute/lower.h"
#include "raster/fill_pass.h"

namespace pipeline {
namespace {

void expand(const Texture& texture, std::vector<std::uint32_t>& out) {
    out.resize(texture.texels.size() / static_cast<std::size_t>(bytes_per_texel(texture.format)));
    switch (texture.format) {
        case TextureFormat::A8:
            std::transform(texture.texels.begin(), texture.texels.end(), out.begin(),
                           [](std::uint8_t a) { return static_cast<std::uint32_t>(a) << 24; });
            break;
        case TextureFormat::L8:
            std::transform(texture.texels.begin(), texture.texels.end(), out.begin(),
                           [](std::uint8_t l) { return 0xff000000u | l * 0x010101u; });
            break;
        case TextureFormat::A8R8G8B8:  // B, G, R, A: a little-endian 0xAARRGGBB
            std::memcpy(out.data(), texture.texels.data(), texture.texels.size());
            break;
    }
}

std::vector<std::int32_t> bound_textures(const Frame& frame) {
    std::set<std::int32_t> bound;
    for (const Pass& pass : frame.passes)
        for (const Draw& draw : pass.draws)
            for (const TextureBinding& binding : textures_of(draw))
                if (binding.texture) bound.insert(binding.texture.index);
    return {bound.begin(), bound.end()};
}

}  // namespace

void FrameMemory::prepare(const Frame& frame, StoreFunction* stored) {
    frame_ = &frame;
    images_.resize(frame.targets.size());
    tbb::parallel_for(std::size_t{0}, images_.size(), [&](std::size_t i) {
        const Target& target = frame.targets[i];
        if (images_[i].width() == target.width && images_[i].height() == target.height)
            images_[i].clear();
        else
            images_[i] = raster::Image(target.width, target.height);
        const std::uint32_t zero = is_depth(target.format) ? 0 : stored(color_format(target.format), 0);
        if (zero != 0) raster::fill_rect(images_[i], images_[i].bounds(), zero);
    });
    texels_.resize(frame.textures.size());
    const std::vector<std::int32_t> bound = bound_textures(frame);
    tbb::parallel_for(std::size_t{0}, bound.size(),
                      [&](std::size_t i) { expand(frame.textures[bound[i]], texels_[bound[i]]); });
}

raster::Sampler FrameMemory::sampler(const TextureBinding& binding) const {
    raster::Sampler sampler;
    if (binding.target) {
        const raster::Image& target = image(binding.target);
        sampler.levels.push_back({target.row(0), target.width(), target.height(), target.stride()});
    } else if (binding.texture) {
        const Texture& texture      = frame_->textures[binding.texture.index];
        sampler.texel_bytes         = bytes_per_texel(texture.format);
        const std::uint32_t* texels = texels_[binding.texture.index].data();
        for (int level = 0; level < texture.levels; ++level) {
            const int width = std::max(1, texture.width >> level), height = std::max(1, texture.height >> level);
            sampler.levels.push_back({texels, width, height, width});
            texels += static_cast<std::ptrdiff_t>(width) * height;
        }
    }
    return sampler;
}

}  // namespace pipeline
