// SPDX-License-Identifier: MIT
// The Graphics Synthesizer's registers as tables: 64 bits each, at an address of the GIF's A+D format, or, of those that a
// program writes by the CPU, at one in its memory (0x12000000 and above). Fields count bits from the lowest. Context 1
// alone: nothing here needs the second.
// Sources: bit positions PCSX2 GSRegs.h and parallel-gs gs_registers.hpp, which agree; addresses ps2tek, GS registers.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace pipeline {

enum class GsReg : std::uint32_t {
    Prim       = 0x00,
    Rgbaq      = 0x01,
    St         = 0x02,
    Uv         = 0x03,
    Xyzf2      = 0x04,
    Xyz2       = 0x05,
    Tex0       = 0x06,
    Clamp      = 0x08,
    Fog        = 0x0a,
    Tex1       = 0x14,
    XyOffset   = 0x18,
    PrModeCont = 0x1a,
    TexClut    = 0x1c,
    ScanMsk    = 0x22,
    TexA       = 0x3b,
    FogCol     = 0x3d,
    TexFlush   = 0x3f,
    Scissor    = 0x40,
    Alpha      = 0x42,
    Dimx       = 0x44,
    Dthe       = 0x45,
    ColClamp   = 0x46,
    Test       = 0x47,
    Pabe       = 0x49,
    Fba        = 0x4a,
    Frame      = 0x4c,
    Zbuf       = 0x4e,
    BitBltBuf  = 0x50,
    TrxPos     = 0x51,
    TrxReg     = 0x52,
    TrxDir     = 0x53,
    Pmode      = 0x12000000,
    Smode1     = 0x12000010,
    Smode2     = 0x12000020,
    Srfsh      = 0x12000030,
    Synch1     = 0x12000040,
    Synch2     = 0x12000050,
    SyncV      = 0x12000060,
    DispFb1    = 0x12000070,
    Display1   = 0x12000080,
    BgColor    = 0x120000e0,
};

// What a field's value counts.
enum class GsUnit : std::uint8_t {
    Number,
    Flag,
    Byte,
    Hex,
    Pixels,
    Pixels4,  // 1/16 pixel
    Texels,
    Texels4,  // 1/16 texel
    Log2Texels,
    Float,     // IEEE single precision
    Width64,   // 64 pixels
    Page,      // 8192 bytes
    Block,     // 256 bytes
    Psm,       // pixel storage format
    DepthPsm,  // the same without its bits 4 and 5, which are set
    Signed3,   // two's complement
    Choice,    // one of `choices`
};

struct GsField {
    std::string_view name;
    int shift = 0, width = 1;
    GsUnit unit = GsUnit::Number;
    std::string_view meaning;
    std::span<const std::string_view> choices = {};
};

struct GsRegister {
    GsReg address = GsReg::Prim;
    std::string_view name, meaning;
    std::span<const GsField> fields;
};

std::span<const GsRegister> gs_registers();
const GsRegister* find_gs_register(std::uint32_t address);  // null if there is none

// Throws std::out_of_range, with the names, for a field that the register lacks or a value that the field does not hold.
struct GsFieldValue {
    std::string_view name;
    std::uint64_t value = 0;
};
std::uint64_t encode(GsReg address, std::initializer_list<GsFieldValue> fields);
std::uint64_t decode(GsReg address, std::string_view field, std::uint64_t value);

// "PSMCT32"; empty if there is no such format.
std::string_view psm_name(std::uint64_t psm);

// "X 33024 (2064 px)": a field of a register with what its value means.
std::string field_text(const GsField& field, std::uint64_t register_value);

}  // namespace pipeline
