// SPDX-License-Identifier: MIT
#include "pipeline/emit/gs_dump.h"

#include <bit>

#include "pipeline/emit/gs_packets.h"

namespace pipeline {

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint32_t kStateVersion = 8, kMemoryBytes = 4u << 20, kRegistersBytes = 8192;
constexpr std::uint8_t kTransfer = 0, kVsync = 1, kPath3 = 3;

// version 8: PRIM, PRMODECONT, TEXCLUT, SCANMSK, TEXA, FOGCOL, DIMX, DTHE, COLCLAMP, PABE, BITBLTBUF, TRXDIR, TRXPOS, TRXREG and
// one unused; of each context XYOFFSET, TEX0, TEX1, CLAMP, MIPTBP1, MIPTBP2, SCISSOR, ALPHA, TEST, FBA, FRAME, ZBUF; RGBAQ,
// ST, UV and FOG of 32 bits, XYZ, one unused, and the place of a transfer, two of 32 bits.
Bytes state_of_zeros() {
    constexpr std::size_t kGlobals = 15, kOfContext = 12, kVertex = 6;
    Bytes state;
    append_u32(state, kStateVersion);
    append_u64(state, 0);  // PRIM
    append_u64(state, 1);  // PRMODECONT.AC
    state.resize(4 + 8 * (kGlobals + 2 * kOfContext + kVertex));
    state.resize(state.size() + kMemoryBytes);
    constexpr std::size_t kPaths = 4, kPathBytes = 16 + 4;
    state.resize(state.size() + kPaths * kPathBytes);
    append_u32(state, std::bit_cast<std::uint32_t>(1.0f));  // Q
    return state;
}

void append_header(Bytes& dump, std::uint32_t state_bytes) {
    constexpr std::uint32_t kHeaderBytes = 9 * 4;
    append_u32(dump, 0xffffffff);
    append_u32(dump, kHeaderBytes);
    append_u32(dump, kStateVersion);
    append_u32(dump, state_bytes);
    append_u32(dump, kHeaderBytes);  // the serial would begin here
    append_u32(dump, 0);
    append_u32(dump, 0);  // CRC of a game
    for (int i = 0; i < 2; ++i) append_u32(dump, 0);
    append_u32(dump, kHeaderBytes);  // and a picture here
    append_u32(dump, 0);
}

void append_display(Bytes& dump, const std::vector<GsWrite>& display) {
    const std::size_t first = dump.size();
    dump.resize(first + kRegistersBytes);
    for (const GsWrite& write : display) {
        const std::size_t at = first + (static_cast<std::uint32_t>(write.reg) & (kRegistersBytes - 1));
        for (std::size_t i = 0; i < 8; ++i) dump[at + i] = static_cast<std::uint8_t>(write.value >> (8 * i));
    }
}

void append_transfer(Bytes& dump, const GifPacket& packet) {
    dump.push_back(kTransfer);
    dump.push_back(kPath3);
    append_u32(dump, static_cast<std::uint32_t>(packet.size()));
    dump.insert(dump.end(), packet.begin(), packet.end());
}

}  // namespace

std::vector<std::uint8_t> gs_dump(const GsStream& stream) {
    const Bytes state = state_of_zeros();
    Bytes dump;
    append_header(dump, static_cast<std::uint32_t>(state.size()));
    dump.insert(dump.end(), state.begin(), state.end());
    append_display(dump, stream.display);
    for (const GsGroup& group : stream.groups)
        for (const GsStep& step : group.steps)
            for (const GifPacket& packet : gif_packets(step)) append_transfer(dump, packet);
    dump.push_back(kVsync);
    dump.push_back(0);  // the field that is shown
    return dump;
}

}  // namespace pipeline
