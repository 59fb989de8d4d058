// SPDX-License-Identifier: MIT
// Where the replay's local memory has pixels: places read off PCSX2's tables (GSTables.cpp), and what formats share.
#include "tests/support/gs_local_memory.h"

#include <catch2/catch.hpp>
#include <set>

using namespace test_support;

namespace {

// The word of memory, and the byte in it, that a pixel of an 8 bit format or the low byte of another has.
int byte_of(const GsBuffer& buffer, int x, int y) {
    GsLocalMemory memory;
    // A buffer of PSMCT32 as wide as one page names words in a known order; found by writing two values there.
    std::set<int> changed;
    const int bits = gs_bits_of(buffer.format);
    memory.write(buffer, x, y, 0);
    GsLocalMemory before = memory;
    memory.write(buffer, x, y, 1);
    for (int wy = 0; wy < 64; ++wy)
        for (int wx = 0; wx < 64; ++wx) {
            const std::uint32_t change = memory.read({kCt32, 0, 1}, wx, wy) ^ before.read({kCt32, 0, 1}, wx, wy);
            for (int i = 0; i < 4; ++i)
                if ((change >> (8 * i) & 255) != 0) changed.insert((wy * 64 + wx) * 4 + i);
        }
    REQUIRE(changed.size() == 1);
    REQUIRE(bits > 0);
    return *changed.begin();
}
int pixel32(int x, int y, int byte = 0) {
    return (y * 64 + x) * 4 + byte;
}

}  // namespace

TEST_CASE("Halves of 32 bit pixels are 16 bit pixels 8 apart, in blocks exchanged across the diagonal") {
    const GsBuffer view{kCt16, 0, 1};
    CHECK(byte_of(view, 0, 0) == pixel32(0, 0));
    CHECK(byte_of(view, 8, 0) == pixel32(0, 0, 2));
    CHECK(byte_of(view, 3, 5) == pixel32(3, 5));
    CHECK(byte_of(view, 16, 0) == pixel32(0, 8));  // block column 1 is block row 1
    CHECK(byte_of(view, 0, 8) == pixel32(8, 0));
    CHECK(byte_of(view, 16 * 3 + 8 + 7, 8 * 7 + 6) == pixel32(63, 30, 2));
}

TEST_CASE("PSMT8 has the bytes of 32 bit pixels by columns of 16 by 4") {
    const GsBuffer view{kT8, 0, 2};
    CHECK(byte_of(view, 0, 0) == pixel32(0, 0, 0));
    CHECK(byte_of(view, 8, 0) == pixel32(0, 0, 2));   // blue
    CHECK(byte_of(view, 4, 2) == pixel32(0, 0, 1));   // green, its halves exchanged
    CHECK(byte_of(view, 12, 2) == pixel32(0, 0, 3));  // alpha
    CHECK(byte_of(view, 4, 4) == pixel32(0, 2, 0));   // red of the next column, exchanged
    CHECK(byte_of(view, 0, 6) == pixel32(0, 2, 1));
    CHECK(byte_of(view, 16, 0) == pixel32(8, 0, 0));
    CHECK(byte_of(view, 0, 16) == pixel32(0, 8, 0));
}

TEST_CASE("PSMT8H is alpha, and PSMCT24 leaves it alone") {
    CHECK(byte_of({kT8h, 0, 1}, 13, 21) == pixel32(13, 21, 3));
    GsLocalMemory memory;
    memory.write({kCt32, 0, 1}, 5, 6, 0x12345678);
    memory.write({kCt24, 0, 1}, 5, 6, 0xffabcdef);
    CHECK(memory.read({kCt32, 0, 1}, 5, 6) == 0x12abcdef);
    CHECK(memory.read({kCt24, 0, 1}, 5, 6) == 0xabcdef);
}

TEST_CASE("Depth has its blocks elsewhere in a page") {
    CHECK(byte_of({kZ32, 0, 1}, 0, 0) == pixel32(32, 16));  // block 24
    CHECK(byte_of({kZ24, 0, 1}, 32, 0) == pixel32(0, 16));  // block 8
    CHECK(byte_of({kZ16, 0, 1}, 0, 0) == pixel32(32, 16));
    CHECK(byte_of({kZ16, 0, 1}, 32, 0) == pixel32(32, 0));  // block 16
}

TEST_CASE("Each format fills whole pages, each pixel at a place of its own") {
    for (const auto& [format, width, height] :
         {std::tuple{kCt32, 128, 64}, {kZ24, 128, 64}, {kCt16, 128, 128}, {kT8, 128, 128}}) {
        INFO("format " << format);
        GsLocalMemory memory;
        const std::uint32_t mask = gs_bits_of(format) == 32 ? ~0u : (1u << gs_bits_of(format)) - 1;
        const auto value_at      = [&](int x, int y) { return static_cast<std::uint32_t>(y * 251 + x * 7 + 1) & mask; };
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) memory.write({format, 32, 2}, x, y, value_at(x, y));
        int wrong = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) wrong += memory.read({format, 32, 2}, x, y) != value_at(x, y);
        CHECK(wrong == 0);
        // The page before is as it was.
        CHECK(memory.read({kCt32, 0, 1}, 63, 31) == 0xa5a5a5a5);
    }
}
