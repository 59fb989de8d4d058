// SPDX-License-Identifier: MIT
// Reads what pipeline/emit/emit_nv2a.h writes back, by the numbers alone and with none of its code: a register file that begins
// empty and is emptied at every pass, memory filled from the side file, and the textures in it. What reads a register that nobody
// wrote, or memory that nobody filled, throws.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/emit/emitted.h"

namespace test_support {

// std::runtime_error.
[[noreturn]] void fail_nv2a(const std::string& what);

class Nv2aRegisters {
  public:
    std::uint32_t at(std::uint32_t offset) const;
    float real(std::uint32_t offset) const;
    bool is_set(std::uint32_t offset) const { return words_.contains(offset); }
    void write(std::uint32_t offset, std::uint32_t value) { words_[offset] = value; }
    void clear() { words_.clear(); }

  private:
    std::map<std::uint32_t, std::uint32_t> words_;
};

class Nv2aBytes {
  public:
    // The lines `data` and `surface` of the text.
    explicit Nv2aBytes(const pipeline::Emitted& emitted);
    std::uint8_t byte(std::uint64_t address) const;
    std::uint32_t word(std::uint64_t address) const;
    float real(std::uint64_t address) const;
    bool is_surface(std::uint64_t address, std::uint64_t bytes) const;

  private:
    struct Block {
        std::uint64_t address, bytes, from;
    };
    const Block& block_of(std::uint64_t address) const;

    const std::vector<std::uint8_t>& data_;
    std::vector<Block> blocks_, surfaces_;
};

// What happens: a pass begins, a surface is cleared, primitives are drawn, pixels are copied (NV062 and NV09F in `blit`).
struct Nv2aEvent {
    enum Kind : std::uint8_t { Pass, Clear, Draw, Copy } kind;
    const Nv2aRegisters& registers;
    const Nv2aRegisters& blit;
    std::uint32_t flags     = 0;  // of CLEAR_SURFACE
    std::uint32_t primitive = 0;  // of BEGIN_END
    std::vector<std::uint32_t> elements;
};
void run_nv2a(const std::string& text, const std::function<void(const Nv2aEvent&)>& visit);

struct Nv2aTexture {
    std::uint32_t address = 0, format = 0, width = 0, height = 0, levels = 0, pitch = 0;
    bool is_linear = false;
};
// Nothing if the unit's program is none or it is not enabled.
std::optional<Nv2aTexture> texture_of(const Nv2aRegisters& registers, std::uint32_t unit);
// 0xAARRGGBB as the combiners see it.
std::uint32_t texel_of(const Nv2aTexture& texture, const Nv2aBytes& memory, std::uint32_t level, std::uint32_t x,
                       std::uint32_t y);

}  // namespace test_support
