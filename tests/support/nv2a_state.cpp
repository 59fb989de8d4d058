// SPDX-License-Identifier: MIT
#include "tests/support/nv2a_state.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <stdexcept>

namespace test_support {

void fail_nv2a(const std::string& what) {
    throw std::runtime_error("NV2A: " + what);
}

namespace {

// Words between spaces.
std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    while (true) {
        const std::size_t start = line.find_first_not_of(' ');
        if (start == std::string_view::npos) return words;
        line.remove_prefix(start);
        words.push_back(line.substr(0, line.find(' ')));
        line.remove_prefix(words.back().size());
    }
}

std::uint64_t number(std::string_view text) {
    const bool is_hex = text.starts_with("0x");
    if (is_hex) text.remove_prefix(2);
    std::uint64_t value     = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, is_hex ? 16 : 10);
    if (error != std::errc{} || end != text.data() + text.size()) fail_nv2a("no number: " + std::string(text));
    return value;
}

template <class Body>
void for_each_line(std::string_view text, Body&& body) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        body(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

}  // namespace

std::uint32_t Nv2aRegisters::at(std::uint32_t offset) const {
    const auto found = words_.find(offset);
    if (found == words_.end()) fail_nv2a("method " + std::to_string(offset) + " is read before it is written");
    return found->second;
}

float Nv2aRegisters::real(std::uint32_t offset) const {
    return std::bit_cast<float>(at(offset));
}

Nv2aBytes::Nv2aBytes(const pipeline::Emitted& emitted) : data_(emitted.data) {
    for_each_line(emitted.text, [&](std::string_view line) {
        const auto words = words_of(line.substr(0, line.find(';')));
        if (words.empty()) return;
        if (words[0] == "data") blocks_.push_back({number(words[1]), number(words[2]), number(words[3])});
        if (words[0] == "surface") surfaces_.push_back({number(words[1]), number(words[2]), 0});
    });
    std::vector<Block> all = blocks_;
    all.insert(all.end(), surfaces_.begin(), surfaces_.end());
    std::sort(all.begin(), all.end(), [](const Block& a, const Block& b) { return a.address < b.address; });
    for (std::size_t i = 1; i < all.size(); ++i)
        if (all[i - 1].address + all[i - 1].bytes > all[i].address) fail_nv2a("blocks overlap");
    if (!all.empty() && all.back().address + all.back().bytes > 64u << 20) fail_nv2a("blocks do not fit into 64 MB");
    std::sort(blocks_.begin(), blocks_.end(), [](const Block& a, const Block& b) { return a.address < b.address; });
}

const Nv2aBytes::Block& Nv2aBytes::block_of(std::uint64_t address) const {
    const auto after = std::upper_bound(blocks_.begin(), blocks_.end(), address,
                                        [](std::uint64_t a, const Block& block) { return a < block.address; });
    if (after == blocks_.begin() || address >= (after - 1)->address + (after - 1)->bytes)
        fail_nv2a("nothing is at address " + std::to_string(address));
    return *(after - 1);
}

std::uint8_t Nv2aBytes::byte(std::uint64_t address) const {
    const Block& block = block_of(address);
    return data_.at(block.from + (address - block.address));
}

std::uint32_t Nv2aBytes::word(std::uint64_t address) const {
    const Block& block       = block_of(address);
    const std::uint64_t from = block.from + (address - block.address);
    if (address + 4 > block.address + block.bytes) fail_nv2a("a word goes beyond its block");
    std::uint32_t value = 0;
    for (int i = 3; i >= 0; --i) value = value << 8 | data_.at(from + static_cast<std::uint64_t>(i));
    return value;
}

float Nv2aBytes::real(std::uint64_t address) const {
    return std::bit_cast<float>(word(address));
}

bool Nv2aBytes::is_surface(std::uint64_t address, std::uint64_t bytes) const {
    return std::any_of(surfaces_.begin(), surfaces_.end(),
                       [&](const Block& surface) { return surface.address == address && surface.bytes == bytes; });
}

void run_nv2a(const std::string& text, const std::function<void(const Nv2aEvent&)>& visit) {
    Nv2aRegisters registers, blit;
    Nv2aEvent drawing{Nv2aEvent::Draw, registers, blit};
    const auto write = [&](std::string_view name, std::uint32_t offset, std::uint32_t value) {
        if (!name.starts_with("NV097_")) {
            blit.write(offset, value);
            if (name == "NV09F_SIZE") visit({Nv2aEvent::Copy, registers, blit});
            return;
        }
        switch (offset) {
            case 0x1d94:
                visit({Nv2aEvent::Clear, registers, blit, value});
                break;
            case 0x17fc:
                if ((value != 0) == (drawing.primitive != 0)) fail_nv2a("BEGIN and END do not alternate");
                if (value == 0) visit(drawing);
                drawing.elements.clear();
                drawing.primitive = value;
                break;
            case 0x1800:
                drawing.elements.push_back(value & 0xffff);
                drawing.elements.push_back(value >> 16);
                break;
            case 0x1808:
                drawing.elements.push_back(value);
                break;
            case 0x1810:
                for (std::uint32_t i = 0; i <= value >> 24; ++i) drawing.elements.push_back((value & 0xffffff) + i);
                break;
            default:
                if (drawing.primitive != 0) fail_nv2a("state is set between BEGIN and END");
                registers.write(offset, value);
        }
    };
    for_each_line(text, [&](std::string_view line) {
        if (line.starts_with("# pass ")) {
            registers.clear();
            visit({Nv2aEvent::Pass, registers, blit});
        }
        if (line.empty() || line[0] == '#' || line.starts_with("data ") || line.starts_with("surface ")) return;
        const auto words = words_of(line.substr(0, line.find(';')));
        if (words.size() < 3) fail_nv2a("no method: " + std::string(line));
        const bool same_offset = words[0].ends_with('*');
        auto offset            = static_cast<std::uint32_t>(number("0x" + std::string(words[0].substr(0, 4))));
        for (std::size_t i = 2; i < words.size(); ++i) {
            write(words[1], offset, static_cast<std::uint32_t>(number(words[i])));
            if (!same_offset) offset += 4;
        }
    });
    if (drawing.primitive != 0) fail_nv2a("no END");
}

std::optional<Nv2aTexture> texture_of(const Nv2aRegisters& registers, std::uint32_t unit_index) {
    const std::uint32_t program = registers.at(0x1e70) >> (5 * unit_index) & 31, base = 0x1b00 + 64 * unit_index;
    const bool is_enabled = (registers.at(base + 0xc) >> 30 & 1) != 0;
    if (program > 1) fail_nv2a("unknown texture program");
    if (is_enabled != (program == 1)) fail_nv2a("a texture is enabled without a program, or the other way");
    if (!is_enabled) return std::nullopt;
    const std::uint32_t format = registers.at(base + 4);
    if ((format & 0xff) != 0x29) fail_nv2a("not a texture of two dimensions by DMA A without border");
    Nv2aTexture texture{.address = registers.at(base), .format = format >> 8 & 255, .levels = format >> 16 & 15};
    texture.is_linear = texture.format >= 0x10 && texture.format != 0x19;
    if (texture.is_linear) {
        texture.pitch  = registers.at(base + 0x10) >> 16;
        texture.width  = registers.at(base + 0x1c) >> 16;
        texture.height = registers.at(base + 0x1c) & 0xffff;
    } else {
        texture.width  = 1u << (format >> 20 & 15);
        texture.height = 1u << (format >> 24 & 15);
    }
    return texture;
}

std::uint32_t texel_of(const Nv2aTexture& texture, const Nv2aBytes& memory, std::uint32_t level, std::uint32_t x,
                       std::uint32_t y) {
    const bool is_byte       = texture.format != 0x06 && texture.format != 0x12;
    const std::uint32_t size = is_byte ? 1 : 4;
    std::uint64_t place      = texture.address;
    if (texture.is_linear) {
        place += std::uint64_t{y} * texture.pitch + std::uint64_t{x} * size;
    } else {
        std::uint32_t width = texture.width, height = texture.height;
        for (std::uint32_t i = 0; i < level; ++i) {
            place += std::uint64_t{width} * height * size;
            width = std::max(1u, width / 2), height = std::max(1u, height / 2);
        }
        std::uint64_t index = 0, bit = 1;
        for (std::uint32_t mask = 1; mask < std::max(width, height); mask *= 2) {
            if (mask < width) {
                if (x & mask) index |= bit;
                bit *= 2;
            }
            if (mask < height) {
                if (y & mask) index |= bit;
                bit *= 2;
            }
        }
        place += index * size;
    }
    if (!is_byte) return memory.word(place);
    const std::uint32_t value = memory.byte(place);
    switch (texture.format) {
        case 0x00:
        case 0x13:
            return 0xff000000 | value * 0x10101;
        case 0x19:
        case 0x1f:
            return value << 24 | 0xffffff;
        default:
            fail_nv2a("unknown texture format");
    }
}

}  // namespace test_support
