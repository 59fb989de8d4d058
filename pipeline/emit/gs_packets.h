// SPDX-License-Identifier: MIT
// GIF packets: a tag of 128 bits, then NLOOP times NREG values.
//   tag       NLOOP 0-14, EOP 15, PRE 46, PRIM 47-57, FLG 58-59 (0 PACKED, 1 REGLIST, 2 IMAGE), NREG 60-63 (0 is 16), and
//             above these 64 bits a register's number each 4 bits
//   PACKED    here of A+D alone, number 0xe: 64 bits of value, then the address in 8
//   REGLIST   64 bits a value; the list is padded to 128 bits
//   IMAGE     NLOOP quadwords to HWREG
// Source: ps2tek, GIF.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/emit/gs_stream.h"

namespace pipeline {

// A step as packets, each with one tag and of at most so many bytes.
inline constexpr std::size_t kMaxPacketBytes = 1 << 16;
using GifPacket                              = std::vector<std::uint8_t>;
std::vector<GifPacket> gif_packets(const GsStep& step);

void append_u32(std::vector<std::uint8_t>& bytes, std::uint32_t value);
void append_u64(std::vector<std::uint8_t>& bytes, std::uint64_t value);

}  // namespace pipeline
