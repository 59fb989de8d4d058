// SPDX-License-Identifier: MIT
#include "pipeline/emit/gx_data.h"

#include <algorithm>
#include <bit>

namespace pipeline {

namespace {

constexpr std::size_t kAlignment    = 32;
constexpr std::uint32_t kMostSpread = 0xfffe;
constexpr std::size_t kMostIndices  = 65532;  // a multiple of 3 that GX_Begin can count

// FNV-1a.
std::uint64_t hash_of(std::span<const std::uint8_t> bytes) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const std::uint8_t byte : bytes) hash = (hash ^ byte) * 0x100000001b3u;
    return hash;
}

struct Level {
    const std::uint8_t* texels;
    std::size_t width, height, bytes_per;

    const std::uint8_t* at(std::size_t x, std::size_t y) const {
        return texels + (std::min(y, height - 1) * width + std::min(x, width - 1)) * bytes_per;
    }
};

void put_tiles_i8(const Level& level, std::vector<std::uint8_t>& out) {
    for (std::size_t ty = 0; ty < level.height; ty += 4)
        for (std::size_t tx = 0; tx < level.width; tx += 8)
            for (std::size_t i = 0; i < 32; ++i) out.push_back(*level.at(tx + i % 8, ty + i / 8));
}

// A8R8G8B8 is stored B, G, R, A.
void put_tiles_rgba8(const Level& level, std::vector<std::uint8_t>& out) {
    constexpr std::size_t kBlue = 0, kGreen = 1, kRed = 2, kAlpha = 3;
    const auto put_pairs = [&](std::size_t tx, std::size_t ty, std::size_t one, std::size_t other) {
        for (std::size_t i = 0; i < 16; ++i) {
            const std::uint8_t* texel = level.at(tx + i % 4, ty + i / 4);
            out.push_back(texel[one]);
            out.push_back(texel[other]);
        }
    };
    for (std::size_t ty = 0; ty < level.height; ty += 4) {
        for (std::size_t tx = 0; tx < level.width; tx += 4) {
            put_pairs(tx, ty, kAlpha, kRed);
            put_pairs(tx, ty, kGreen, kBlue);
        }
    }
}

}  // namespace

std::uint32_t GxData::add(std::string what, const std::vector<std::uint8_t>& bytes) {
    const std::uint64_t hash = hash_of(bytes);
    const auto [first, last] = by_hash_.equal_range(hash);
    for (auto i = first; i != last; ++i) {
        const GxBlock& block = blocks_[i->second];
        const auto at        = bytes_.begin() + block.offset;
        if (block.bytes == bytes.size() && std::equal(bytes.begin(), bytes.end(), at)) return block.offset;
    }
    bytes_.resize((bytes_.size() + kAlignment - 1) / kAlignment * kAlignment);
    by_hash_.emplace(hash, blocks_.size());
    blocks_.push_back(
        {std::move(what), static_cast<std::uint32_t>(bytes_.size()), static_cast<std::uint32_t>(bytes.size())});
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return blocks_.back().offset;
}

std::vector<std::uint8_t> gx_texels(const Texture& texture) {
    std::vector<std::uint8_t> out;
    const auto bytes_per       = static_cast<std::size_t>(bytes_per_texel(texture.format));
    const std::uint8_t* texels = texture.texels.data();
    for (int level = 0; level < texture.levels; ++level) {
        const auto size = [&](std::int32_t whole) { return static_cast<std::size_t>(std::max(1, whole >> level)); };
        const Level of{texels, size(texture.width), size(texture.height), bytes_per};
        bytes_per == 4 ? put_tiles_rgba8(of, out) : put_tiles_i8(of, out);
        texels += of.width * of.height * bytes_per;
    }
    return out;
}

void put_u16(std::vector<std::uint8_t>& out, std::uint32_t value) {
    out.push_back(static_cast<std::uint8_t>(value >> 8));
    out.push_back(static_cast<std::uint8_t>(value));
}

void put_float(std::vector<std::uint8_t>& out, float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    put_u16(out, bits >> 16);
    put_u16(out, bits & 0xffffu);
}

void put_rgba(std::vector<std::uint8_t>& out, Argb color) {
    for (const int shift : {16, 8, 0, 24}) out.push_back(static_cast<std::uint8_t>(color.value >> shift));
}

std::uint32_t GxVertices::size() const {
    return static_cast<std::uint32_t>(frame_.vertices.size() + repeated_.size());
}

const Vertex& GxVertices::vertex(std::uint32_t index) const {
    const std::size_t own = frame_.vertices.size();
    return frame_.vertices[index < own ? index : repeated_[index - own]];
}

const std::vector<GxPart>& GxVertices::parts(std::uint32_t first_index, std::uint32_t index_count) {
    const auto [place, is_new] = parts_.try_emplace({first_index, index_count});
    if (is_new) place->second = split(std::span(frame_.indices).subspan(first_index, index_count));
    return place->second;
}

std::array<std::uint32_t, 3> GxVertices::near_corners(std::span<const std::uint32_t> corners) {
    const auto [least, most] = std::minmax({corners[0], corners[1], corners[2]});
    if (most - least <= kMostSpread) return {corners[0], corners[1], corners[2]};
    const std::uint32_t first = size();
    repeated_.insert(repeated_.end(), corners.begin(), corners.end());
    return {first, first + 1, first + 2};
}

std::vector<GxPart> GxVertices::split(std::span<const std::uint32_t> indices) {
    std::vector<GxPart> parts;
    std::vector<std::uint32_t> open;
    std::uint32_t least = 0, most = 0;
    const auto close = [&] {
        if (open.empty()) return;
        GxPart& part = parts.emplace_back(GxPart{least, most - least + 1, {}});
        for (const std::uint32_t index : open) part.indices.push_back(static_cast<std::uint16_t>(index - least));
        open.clear();
    };
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const std::array corners      = near_corners(indices.subspan(i, 3));
        const auto [low, high]        = std::minmax({corners[0], corners[1], corners[2]});
        const std::uint32_t new_least = open.empty() ? low : std::min(least, low),
                            new_most  = open.empty() ? high : std::max(most, high);
        if (new_most - new_least > kMostSpread || open.size() == kMostIndices) {
            close();
            least = low, most = high;
        } else {
            least = new_least, most = new_most;
        }
        open.insert(open.end(), corners.begin(), corners.end());
    }
    close();
    return parts;
}

}  // namespace pipeline
