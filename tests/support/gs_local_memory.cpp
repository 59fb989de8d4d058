// SPDX-License-Identifier: MIT
#include "tests/support/gs_local_memory.h"

#include <stdexcept>
#include <string>

namespace test_support {

namespace {

// The number of a block in its page is made of its row's and column's bits in turn: x0 y0 x1 y1 x2 where it has 8 columns and
// 4 rows, and y0 x0 y1 x1 y2 where it has 4 columns and 8 rows.
std::uint32_t bit(int value, int i) {
    return static_cast<std::uint32_t>(value >> i & 1);
}
std::uint32_t block_of_8x4(int column, int row) {
    return bit(column, 0) | bit(row, 0) << 1 | bit(column, 1) << 2 | bit(row, 1) << 3 | bit(column, 2) << 4;
}
std::uint32_t block_of_4x8(int column, int row) {
    return bit(row, 0) | bit(column, 0) << 1 | bit(row, 1) << 2 | bit(column, 1) << 3 | bit(row, 2) << 4;
}

// Depth formats exchange the halves and quarters of a page.
constexpr std::uint32_t kDepthTurn = 24;

std::uint32_t byte_in_memory(const GsBuffer& buffer, std::uint32_t page, std::uint32_t block, std::uint32_t byte) {
    const std::uint32_t turned = buffer.format >= kZ32 ? block ^ kDepthTurn : block;
    return (buffer.block * 256 + page * 8192 + turned * 256 + byte) & ((4u << 20) - 1);
}

std::uint32_t place32(const GsBuffer& buffer, int x, int y) {
    const std::uint32_t page = static_cast<std::uint32_t>(y / 32) * buffer.width64 + static_cast<std::uint32_t>(x / 64);
    // A column is 8 by 2 pixels: pairs of one row, then of the other.
    const std::uint32_t word = static_cast<std::uint32_t>(y % 8 / 2) * 16 + static_cast<std::uint32_t>(x % 8 / 2) * 4 +
                               bit(y, 0) * 2 + bit(x, 0);
    return byte_in_memory(buffer, page, block_of_8x4(x % 64 / 8, y % 32 / 8), word * 4);
}

std::uint32_t place16(const GsBuffer& buffer, int x, int y) {
    const std::uint32_t page = static_cast<std::uint32_t>(y / 64) * buffer.width64 + static_cast<std::uint32_t>(x / 64);
    // The word is that of a 32 bit pixel (x % 8, y); pixels 8 and more to the right are its high half.
    const std::uint32_t word = static_cast<std::uint32_t>(y % 8 / 2) * 16 + static_cast<std::uint32_t>(x % 8 / 2) * 4 +
                               bit(y, 0) * 2 + bit(x, 0);
    return byte_in_memory(buffer, page, block_of_4x8(x % 64 / 16, y % 64 / 8), word * 4 + bit(x, 3) * 2);
}

std::uint32_t place8(const GsBuffer& buffer, int x, int y) {
    const std::uint32_t page =
        static_cast<std::uint32_t>(y / 64) * (buffer.width64 / 2) + static_cast<std::uint32_t>(x / 128);
    // A column is 16 by 4. Rows 2 and 3 are the odd bytes; their words begin 4 texels on in even columns, and those of rows 0
    // and 1 do so in odd ones.
    const int column     = y % 16 / 4;
    const bool is_turned = bit(y, 1) != bit(column, 0);
    const int at         = (x % 8) ^ (is_turned ? 4 : 0);
    const std::uint32_t word =
        static_cast<std::uint32_t>(column) * 16 + static_cast<std::uint32_t>(at / 2) * 4 + bit(y, 0) * 2 + bit(at, 0);
    return byte_in_memory(buffer, page, block_of_8x4(x % 128 / 16, y % 64 / 16), word * 4 + bit(x, 3) * 2 + bit(y, 1));
}

}  // namespace

int gs_bits_of(std::uint32_t format) {
    switch (format) {
        case kCt32:
        case kZ32:
            return 32;
        case kCt24:
        case kZ24:
            return 24;
        case kCt16:
        case kZ16:
            return 16;
        case kT8:
        case kT8h:
            return 8;
        default:
            throw std::runtime_error("pixel format " + std::to_string(format) + " is not known");
    }
}

std::uint32_t GsLocalMemory::read(const GsBuffer& buffer, int x, int y) const {
    const auto bytes_at = [&](std::uint32_t place, int count) {
        std::uint32_t value = 0;
        for (int i = 0; i < count; ++i) value |= static_cast<std::uint32_t>(bytes_[place + i]) << (8 * i);
        return value;
    };
    if (buffer.format == kT8) return bytes_at(place8(buffer, x, y), 1);
    if (buffer.format == kT8h) return bytes_at(place32(buffer, x, y) + 3, 1);
    const int bits = gs_bits_of(buffer.format);
    return bits == 16 ? bytes_at(place16(buffer, x, y), 2) : bytes_at(place32(buffer, x, y), bits / 8);
}

void GsLocalMemory::write(const GsBuffer& buffer, int x, int y, std::uint32_t value) {
    const auto set = [&](std::uint32_t place, int count) {
        for (int i = 0; i < count; ++i) bytes_[place + i] = static_cast<std::uint8_t>(value >> (8 * i));
    };
    if (buffer.format == kT8) return set(place8(buffer, x, y), 1);
    if (buffer.format == kT8h) return set(place32(buffer, x, y) + 3, 1);
    const int bits = gs_bits_of(buffer.format);
    if (bits == 16) return set(place16(buffer, x, y), 2);
    set(place32(buffer, x, y), bits / 8);
}

}  // namespace test_support
