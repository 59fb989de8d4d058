// SPDX-License-Identifier: MIT
#include "pipeline/emit/nv2a_memory.h"

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "pipeline/check/memory_layouts.h"
#include "pipeline/validate/check_pass.h"

namespace pipeline {
namespace {

constexpr std::uint64_t kMemory = 64u << 20, kAlignment = 128;

std::string size_text(std::int32_t width, std::int32_t height) {
    return std::to_string(width) + 'x' + std::to_string(height);
}

Nv2aPlace place_of(const MemoryBlock& block, int bytes_per) {
    return {static_cast<std::uint32_t>(block.address),
            static_cast<std::uint32_t>(block.pitch) * static_cast<std::uint32_t>(bytes_per), block.what};
}

std::string described(const Texture& texture, const Nv2aPlace& place) {
    return place.what + ", " + std::string(enum_name(texture.format)) + ' ' + size_text(texture.width, texture.height) +
           (is_swizzled(texture) ? ", " + std::to_string(texture.levels) + " levels, swizzled"
                                 : ", rows of " + std::to_string(place.pitch) + " bytes");
}

// For each coordinate along an axis of `size` texels its bits of the place, `other` being the other axis's size.
std::vector<std::size_t> spread(std::size_t size, std::size_t other, bool is_first) {
    std::vector<std::size_t> places(size, 0);
    std::size_t place = 0;
    for (std::size_t bit = 0; std::size_t{1} << bit < size; ++bit) {
        const bool beside = std::size_t{1} << bit < other;
        if (beside && !is_first) ++place;
        for (std::size_t i = 0; i < size; ++i) places[i] |= (i >> bit & 1) << place;
        ++place;
        if (beside && is_first) ++place;
    }
    return places;
}

void append_swizzled(std::vector<std::uint8_t>& out, const std::uint8_t* texels, std::size_t width, std::size_t height,
                     std::size_t bytes) {
    const std::size_t start                = out.size();
    const std::vector<std::size_t> along_x = spread(width, height, true), along_y = spread(height, width, false);
    out.resize(start + width * height * bytes);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x, texels += bytes)
            std::copy_n(texels, bytes,
                        out.begin() + static_cast<std::ptrdiff_t>(start + (along_x[x] | along_y[y]) * bytes));
}

}  // namespace

bool is_swizzled(const Texture& texture) {
    return is_power_of_two(texture.width) && is_power_of_two(texture.height);
}

std::vector<std::uint8_t> nv2a_texels(const Texture& texture, std::uint32_t pitch) {
    const auto bytes = static_cast<std::size_t>(bytes_per_texel(texture.format));
    const auto width = static_cast<std::size_t>(texture.width), height = static_cast<std::size_t>(texture.height);
    std::vector<std::uint8_t> out;
    if (!is_swizzled(texture)) {
        for (std::size_t y = 0; y < height; ++y) {
            const auto row = texture.texels.begin() + static_cast<std::ptrdiff_t>(y * width * bytes);
            out.insert(out.end(), row, row + static_cast<std::ptrdiff_t>(width * bytes));
            out.resize((y + 1) * pitch);
        }
        return out;
    }
    const std::uint8_t* texels = texture.texels.data();
    for (int level = 0; level < texture.levels; ++level) {
        const std::size_t w = std::max<std::size_t>(1, width >> level), h = std::max<std::size_t>(1, height >> level);
        append_swizzled(out, texels, w, h, bytes);
        texels += w * h * bytes;
    }
    return out;
}

Nv2aMemory::Nv2aMemory(const Frame& frame) {
    const MemoryMap map = lay_out(frame, *find_profile("xbox"));
    end_                = map.regions.front().used;
    for (std::size_t i = 0; i < frame.targets.size(); ++i) {
        const Target& target  = frame.targets[i];
        const Nv2aPlace place = place_of(map.blocks[i], bytes_per_pixel(target.format));
        table_.line("surface " + hex(place.address) + ' ' + std::to_string(map.blocks[i].bytes) + " ; " + place.what +
                    ", " + std::string(enum_name(target.format)) + ' ' + size_text(target.width, target.height) +
                    ", rows of " + std::to_string(place.pitch) + " bytes");
        targets_.push_back(place);
    }
    for (std::size_t i = 0; i < frame.textures.size(); ++i) {
        const Texture& texture = frame.textures[i];
        const Nv2aPlace place  = place_of(map.blocks[frame.targets.size() + i], bytes_per_texel(texture.format));
        this->place(place.address, nv2a_texels(texture, place.pitch), described(texture, place));
        textures_.push_back(place);
    }
}

void Nv2aMemory::place(std::uint32_t address, const std::vector<std::uint8_t>& bytes, std::string_view what) {
    table_.line("data " + hex(address) + ' ' + std::to_string(bytes.size()) + ' ' + std::to_string(data_.size()) +
                " ; " + std::string(what));
    data_.insert(data_.end(), bytes.begin(), bytes.end());
    end_ = std::max<std::uint64_t>(end_, address + bytes.size());
}

std::uint32_t Nv2aMemory::add(const std::vector<std::uint8_t>& bytes, std::string_view what) {
    const std::uint64_t address = rounded_up(end_, kAlignment);
    if (address + bytes.size() > kMemory)
        throw std::invalid_argument("the NV2A's memory ends before " + std::string(what) + ": " +
                                    std::to_string(address + bytes.size()) + " of " + std::to_string(kMemory) +
                                    " bytes");
    place(static_cast<std::uint32_t>(address), bytes, what);
    return static_cast<std::uint32_t>(address);
}

void append_word(std::vector<std::uint8_t>& bytes, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

void append_float(std::vector<std::uint8_t>& bytes, float value) {
    append_word(bytes, std::bit_cast<std::uint32_t>(value));
}

}  // namespace pipeline
