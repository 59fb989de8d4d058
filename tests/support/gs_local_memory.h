// SPDX-License-Identifier: MIT
// The Graphics Synthesizer's local memory for tests, by itself: 4 MB, and where each format puts a pixel. Pages of 8192 bytes,
// in them 32 blocks of 256 bytes, in these 4 columns. A format is its number in FRAME, TEX0 and BITBLTBUF; an address is
// in blocks and a width in 64 pixels, as registers have them. It begins with noise.
#pragma once

#include <cstdint>
#include <vector>

namespace test_support {

enum GsFormat : std::uint32_t {
    kCt32 = 0,
    kCt24 = 1,
    kCt16 = 2,
    kT8   = 0x13,
    kT8h  = 0x1b,
    kZ32  = 0x30,
    kZ24  = 0x31,
    kZ16  = 0x32
};

struct GsBuffer {
    std::uint32_t format = kCt32, block = 0, width64 = 1;
};

class GsLocalMemory {
  public:
    GsLocalMemory() : bytes_(4u << 20, 0xa5) {}

    // As many bits as the format has, from bit 0. PSMCT24 and PSMZ24 leave the top byte of their word alone.
    std::uint32_t read(const GsBuffer& buffer, int x, int y) const;
    void write(const GsBuffer& buffer, int x, int y, std::uint32_t value);

  private:
    std::vector<std::uint8_t> bytes_;
};

// Throws std::runtime_error for a format that is not among these.
int gs_bits_of(std::uint32_t format);

}  // namespace test_support
