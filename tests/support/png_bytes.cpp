// SPDX-License-Identifier: MIT
#include "tests/support/png_bytes.h"

namespace tests {
namespace {

std::string big_endian(std::uint32_t value) {
    std::string bytes;
    for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(value >> shift & 255);
    return bytes;
}

// The remainder by 0x04c11db7, bits from the lowest (annex D).
std::uint32_t crc(const std::string& bytes) {
    std::uint32_t remainder = 0xffffffff;
    for (const char byte : bytes) {
        remainder ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) remainder = (remainder >> 1) ^ ((remainder & 1) != 0 ? 0xedb88320u : 0u);
    }
    return ~remainder;
}

std::string chunk(const std::string& type, const std::string& data) {
    return big_endian(static_cast<std::uint32_t>(data.size())) + type + data + big_endian(crc(type + data));
}

// One stored block of zlib (RFC 1950, 1951).
std::string stored(const std::string& data) {
    std::uint32_t a = 1, b = 0;
    for (const char byte : data) {
        a = (a + static_cast<unsigned char>(byte)) % 65521;
        b = (b + a) % 65521;
    }
    const auto length = static_cast<std::uint32_t>(data.size());
    std::string block("\x78\x01\x01", 3);
    for (const std::uint32_t half : {length, ~length}) {
        block += static_cast<char>(half & 255);
        block += static_cast<char>(half >> 8 & 255);
    }
    return block + data + big_endian(b << 16 | a);
}

}  // namespace

std::string png_bytes(int width, int height, PngKind kind, const std::vector<std::string>& rows,
                      const std::string& palette, const std::string& palette_alpha) {
    std::string header = big_endian(static_cast<std::uint32_t>(width)) + big_endian(static_cast<std::uint32_t>(height));
    header += static_cast<char>(kind.bits);
    header += static_cast<char>(kind.color_type);
    header += std::string(3, '\0');
    std::string data;
    for (const std::string& row : rows) data += '\0' + row;  // filter "none"
    std::string file = std::string("\x89PNG\r\n\x1a\n") + chunk("IHDR", header);
    if (!palette.empty()) file += chunk("PLTE", palette);
    if (!palette_alpha.empty()) file += chunk("tRNS", palette_alpha);
    return file + chunk("IDAT", stored(data)) + chunk("IEND", "");
}

}  // namespace tests
