// SPDX-License-Identifier: MIT
// A stream as a GS dump, the file (.gs) that PCSX2 and parallel-gs replay. Little-endian:
//   u32 0xffffffff, u32 size of the header and what follows it
//   header      u32 version of the state, its size, serial's place and size, CRC, picture's width, height, place and size
//   state       u32 version 8; registers as PCSX2's GSState::Freeze orders them; 4 MB of local memory; 4 GIF tags, each with
//               a u32; float Q
//   registers   8192 bytes: those at 0x12000000
//   packets     u8 0 transfer: u8 path, u32 size, GIF packets     u8 1 vsync: u8 field
//               u8 3 registers: 8192 bytes
// State and memory are zeros, but PRMODECONT.AC and Q: the stream sets all that it needs. Vertices are packed as REGLIST, other
// registers as PACKED A+D, images as IMAGE.
// Sources: PCSX2 GSDump.cpp, GSLzma.cpp (GSDumpFile::ReadFile) and GSState.cpp (Freeze); parallel-gs gs_dump_parser.cpp; GIF
// tags: ps2tek, GIF.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/emit/gs_stream.h"

namespace pipeline {

std::vector<std::uint8_t> gs_dump(const GsStream& stream);

}  // namespace pipeline
