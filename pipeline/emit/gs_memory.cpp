// SPDX-License-Identifier: MIT
#include "pipeline/emit/gs_memory.h"

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "pipeline/check/memory_map.h"
#include "pipeline/validate/check_pass.h"

namespace pipeline {

namespace {

constexpr std::uint32_t kBlockBytes = 256, kPaletteBlocks = 4;

GsSurface surface_at(const MemoryBlock& block, GsPsm psm, std::int32_t width, std::int32_t height) {
    return {.block   = static_cast<std::uint32_t>(block.address / kBlockBytes),
            .width64 = static_cast<std::uint32_t>(block.pitch / 64),
            .psm     = psm,
            .width   = width,
            .height  = height};
}

bool any_texture(const Frame& frame, TextureFormat format) {
    return std::any_of(frame.textures.begin(), frame.textures.end(),
                       [&](const Texture& texture) { return texture.format == format; });
}

bool any_draw(const Frame& frame, const std::function<bool(const Pass&, const Draw&)>& wanted) {
    return std::any_of(frame.passes.begin(), frame.passes.end(), [&](const Pass& pass) {
        return std::any_of(pass.draws.begin(), pass.draws.end(), [&](const Draw& draw) { return wanted(pass, draw); });
    });
}

bool moves_alpha_to_color(const Pass&, const Draw& draw) {
    const auto* copy = std::get_if<CopyRectangle>(&draw);
    return copy != nullptr && copy->channels == CopyChannels::AlphaToColor;
}

bool reads_nothing_bound(const Pass& pass, const Draw& draw) {
    if (std::holds_alternative<CopyRectangle>(draw) || !reads_texture(pass.state, 0)) return false;
    const TextureBinding binding = textures_of(draw)[0];
    return !binding.texture && !binding.target;
}

// CSM1 holds 256 entries as 16 rows of 16, with bits 3 and 4 of an entry's number exchanged.
std::size_t csm1_place(std::size_t entry) {
    return (entry & ~std::size_t{0x18}) | (entry & 0x08) << 1 | (entry & 0x10) >> 1;
}

std::vector<std::uint8_t> palette(const std::function<std::uint32_t(std::uint32_t)>& abgr) {
    std::vector<std::uint8_t> bytes(1024);
    for (std::uint32_t entry = 0; entry < 256; ++entry)
        for (std::uint32_t c = 0; c < 4; ++c)
            bytes[4 * csm1_place(entry) + c] = static_cast<std::uint8_t>(abgr(entry) >> (8 * c));
    return bytes;
}
std::uint32_t alpha_entry(std::uint32_t a) {
    return a << 24;
}
std::uint32_t grey_entry(std::uint32_t l) {
    return 0xff000000u | l * 0x010101u;
}

// Host to local, the whole of a surface with rows of `row` pixels.
void transfer(const GsSurface& to, std::int32_t row, std::vector<std::uint8_t> bytes, GsBuilder& out) {
    out.set(GsReg::BitBltBuf, {{"DBP", to.block}, {"DBW", to.width64}, {"DPSM", code(to.psm)}});
    out.set(GsReg::TrxPos, std::uint64_t{0});
    out.set(GsReg::TrxReg, {{"RRW", static_cast<std::uint64_t>(row)}, {"RRH", static_cast<std::uint64_t>(to.height)}});
    out.write(GsReg::TrxDir, {{"XDIR", 0}});
    out.image(std::move(bytes));
}

void upload_palette(std::uint32_t block, std::string what, std::vector<std::uint8_t> bytes, GsBuilder& out) {
    out.step(std::move(what));
    transfer({.block = block, .width64 = 1, .psm = GsPsm::Ct32, .width = 16, .height = 16}, 16, std::move(bytes), out);
}

// Rows are padded to whole blocks, 16 texels of PSMT8 or 8 of PSMCT32, so that each is a number of quadwords: whether a
// transfer takes any width is not known. The padding lies in blocks that are the texture's.
void upload_texture(const Texture& texture, const GsSurface& to, GsBuilder& out) {
    const int texel_bytes  = bytes_per_texel(texture.format);
    const std::int32_t pad = texel_bytes == 1 ? 16 : 8, row = (texture.width + pad - 1) / pad * pad;
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(row) * static_cast<std::size_t>(texture.height) *
                                    static_cast<std::size_t>(texel_bytes));
    for (std::int32_t y = 0; y < texture.height; ++y) {
        const auto from   = texture.texels.begin() + static_cast<std::ptrdiff_t>(y) * texture.width * texel_bytes;
        const auto to_row = bytes.begin() + static_cast<std::ptrdiff_t>(y) * row * texel_bytes;
        std::copy_n(from, texture.width * texel_bytes, to_row);
        if (texel_bytes == 1) continue;
        // B, G, R, A to R, G, B, A.
        for (std::int32_t x = 0; x < texture.width; ++x) std::swap(to_row[4 * x], to_row[4 * x + 2]);
    }
    transfer(to, row, std::move(bytes), out);
}

}  // namespace

GsPsm psm_of(TargetFormat format) {
    switch (format) {
        case TargetFormat::Psmct32:
            return GsPsm::Ct32;
        case TargetFormat::Psmct24:
            return GsPsm::Ct24;
        case TargetFormat::Psmct16:
            return GsPsm::Ct16;
        case TargetFormat::D16:
            return GsPsm::Z16;
        case TargetFormat::D24:
            return GsPsm::Z24;
        case TargetFormat::D32:
            return GsPsm::Z32;
        case TargetFormat::A8R8G8B8:
        case TargetFormat::X8R8G8B8:
        case TargetFormat::R5G6B5:
        case TargetFormat::A1R5G5B5:
        case TargetFormat::R6G6B6A6:
            break;
    }
    throw std::invalid_argument("the Graphics Synthesizer has no format " + std::string(enum_name(format)));
}

GsPsm psm_of(TextureFormat format) {
    return format == TextureFormat::A8R8G8B8 ? GsPsm::Ct32 : GsPsm::T8;
}

std::string quoted_name(std::string_view kind, std::size_t index, std::string_view name) {
    std::string text = std::string(kind) + ' ' + std::to_string(index);
    if (!name.empty()) text += " '" + std::string(name) + '\'';
    return text;
}

GsMemory place_in_gs_memory(const Frame& frame) {
    const Profile& profile = *find_profile("ps2");
    const MemoryMap map    = lay_out(frame, profile);
    GsMemory memory;
    std::size_t next = 0;
    for (const Target& target : frame.targets)
        memory.targets.push_back(surface_at(map.blocks[next++], psm_of(target.format), target.width, target.height));
    for (const Texture& texture : frame.textures)
        memory.textures.push_back(
            surface_at(map.blocks[next++], psm_of(texture.format), texture.width, texture.height));
    const auto palette_of = [&](TextureFormat format) -> std::optional<std::uint32_t> {
        if (!any_texture(frame, format)) return {};
        return static_cast<std::uint32_t>(map.blocks[next++].address / kBlockBytes);
    };
    memory.a8_palette = palette_of(TextureFormat::A8);
    memory.l8_palette = palette_of(TextureFormat::L8);

    // Behind the frame's blocks, in this order.
    auto next_block = static_cast<std::uint32_t>((map.regions[0].used + kBlockBytes - 1) / kBlockBytes);
    if (any_draw(frame, moves_alpha_to_color)) {
        memory.grey_palette = memory.l8_palette.value_or(next_block);
        if (!memory.l8_palette) next_block += kPaletteBlocks;
    }
    if (any_draw(frame, reads_nothing_bound)) {
        memory.white = GsSurface{.block = next_block, .width64 = 1, .psm = GsPsm::Ct32, .width = 1, .height = 1};
        next_block += 1;
    }
    const std::uint64_t needed = std::uint64_t{next_block} * kBlockBytes;
    if (needed > profile.limits.memory)
        throw std::invalid_argument(
            "the palette of a copy between channels, or a white texel, has no room in the Graphics "
            "Synthesizer's memory: " +
            std::to_string(needed) + " bytes are needed");
    return memory;
}

void emit_uploads(const Frame& frame, const GsMemory& memory, GsBuilder& out) {
    out.group("textures and palettes");
    for (std::size_t i = 0; i < frame.textures.size(); ++i) {
        out.step(quoted_name("texture", i, frame.textures[i].name));
        upload_texture(frame.textures[i], memory.textures[i], out);
    }
    if (memory.a8_palette) upload_palette(*memory.a8_palette, "palette of A8: (0, 0, 0, i)", palette(alpha_entry), out);
    if (memory.l8_palette)
        upload_palette(*memory.l8_palette, "palette of L8: (i, i, i, 255)", palette(grey_entry), out);
    if (memory.grey_palette && memory.grey_palette != memory.l8_palette)
        upload_palette(*memory.grey_palette, "palette of copies: (i, i, i, 255)", palette(grey_entry), out);
    if (memory.white) {
        out.step("white, where no texture is bound");
        transfer(*memory.white, 8, std::vector<std::uint8_t>(32, 255), out);
    }
    out.step("make them visible");
    out.write(GsReg::TexFlush, std::uint64_t{0});
}

}  // namespace pipeline
