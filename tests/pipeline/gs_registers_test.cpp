// SPDX-License-Identifier: MIT
#include "pipeline/emit/gs_registers.h"

#include <catch2/catch.hpp>

#include "pipeline/emit/gs_text.h"

using namespace pipeline;

namespace {

std::string text_of(std::string_view field, GsReg reg, std::uint64_t value) {
    for (const GsField& each : find_gs_register(static_cast<std::uint32_t>(reg))->fields)
        if (each.name == field) return field_text(each, value);
    return "no such field";
}

}  // namespace

TEST_CASE("Registers of the GS are found by their addresses, and their fields do not overlap") {
    std::uint32_t last = 0;
    for (const GsRegister& reg : gs_registers()) {
        INFO(reg.name);
        const auto address = static_cast<std::uint32_t>(reg.address);
        CHECK(find_gs_register(address) == &reg);
        CHECK((address > last || address == 0));
        last                = address;
        std::uint64_t taken = 0;
        for (const GsField& field : reg.fields) {
            INFO(field.name);
            REQUIRE(field.shift + field.width <= 64);
            const std::uint64_t bits = (~std::uint64_t{0} >> (64 - field.width)) << field.shift;
            CHECK((taken & bits) == 0);
            taken |= bits;
            CHECK(decode(reg.address, field.name, bits) == ~std::uint64_t{0} >> (64 - field.width));
            CHECK(decode(reg.address, field.name, ~bits) == 0);
        }
    }
    CHECK(find_gs_register(0x07) == nullptr);  // context 2's TEX0
}

TEST_CASE("Registers of the GS are packed as its users know them") {
    // gsKit's gsInit.h macros worked out by hand.
    CHECK(encode(GsReg::Frame, {{"FBP", 0x8c}, {"FBW", 10}, {"PSM", 2}, {"FBMSK", 0x3fff}}) == 0x00003fff020a008c);
    CHECK(encode(GsReg::Zbuf, {{"ZBP", 0x118}, {"PSM", 1}, {"ZMSK", 1}}) == 0x0000000101000118);
    CHECK(encode(GsReg::Alpha, {{"A", 0}, {"B", 1}, {"C", 0}, {"D", 1}}) == 0x44);
    CHECK(encode(GsReg::Alpha, {{"A", 0}, {"B", 2}, {"C", 2}, {"D", 1}, {"FIX", 0x80}}) == 0x8000000068);
    CHECK(encode(GsReg::Prim, {{"PRIM", 6}, {"TME", 1}, {"ABE", 1}, {"FST", 1}}) == 0x156);
    CHECK(encode(GsReg::Test, {{"ZTE", 1}, {"ZTST", 2}}) == 0x50000);
    CHECK(encode(GsReg::Tex0, {{"TBP0", 1}, {"TBW", 2}, {"PSM", 0x13}, {"TW", 7}, {"TH", 6}, {"TCC", 1}, {"CLD", 1}}) ==
          0x200000059d308001);
    CHECK(encode(GsReg::Scissor, {{"SCAX1", 639}, {"SCAY1", 447}}) == 0x01bf0000027f0000);
    CHECK(encode(GsReg::XyOffset, {{"OFX", 0x8000}, {"OFY", 0x8000}}) == 0x0000800000008000);
    CHECK(encode(GsReg::Xyz2, {{"X", 0x8010}, {"Y", 0x8020}, {"Z", 5}}) == 0x0000000580208010);
    CHECK(encode(GsReg::DispFb1, {{"FBP", 0}, {"FBW", 10}}) == 10 << 9);
    CHECK(encode(GsReg::Display1, {{"DX", 636}, {"DY", 50}, {"MAGH", 3}, {"DW", 2559}, {"DH", 447}}) ==
          (std::uint64_t{447} << 44 | std::uint64_t{2559} << 32 | 3u << 23 | 50u << 12 | 636u));
}

TEST_CASE("A value that a field of the GS does not hold is refused") {
    CHECK_THROWS_AS(encode(GsReg::Uv, {{"U", 0x4000}}), std::out_of_range);
    CHECK_NOTHROW(encode(GsReg::Uv, {{"U", 0x3fff}}));
    CHECK_THROWS_AS(encode(GsReg::Uv, {{"S", 0}}), std::out_of_range);
    CHECK_THROWS_WITH(encode(GsReg::Frame, {{"FBP", 512}}),
                      "field FBP of register FRAME_1 has 9 bits, too few for 512");
    CHECK_THROWS_AS(decode(GsReg::TexFlush, "X", 0), std::out_of_range);
}

TEST_CASE("Fields of the GS are told in words and units") {
    CHECK(text_of("FBP", GsReg::Frame, 3) == "FBP byte 24576 (colour)");
    CHECK(text_of("TBP0", GsReg::Tex0, 3) == "TBP0 byte 768 (texture)");
    CHECK(text_of("PSM", GsReg::Frame, 2 << 24) == "PSM PSMCT16 (format)");
    CHECK(text_of("PSM", GsReg::Zbuf, 1 << 24) == "PSM PSMZ24 (format)");
    CHECK(text_of("X", GsReg::Xyz2, 0x8008) == "X 2048.5 px");
    CHECK(text_of("U", GsReg::Uv, 24) == "U 1.5 texels");
    CHECK(text_of("TW", GsReg::Tex0, std::uint64_t{8} << 26) == "TW 256 texels (width)");
    CHECK(text_of("S", GsReg::St, 0x3f000000) == "S 0.5");
    CHECK(text_of("DM01", GsReg::Dimx, 7 << 4) == "DM01 -1");
    CHECK(text_of("ZTST", GsReg::Test, 2 << 17) == "ZTST GEQUAL (depth)");
    CHECK(text_of("A", GsReg::Alpha, 3) == "A reserved (minuend)");
    CHECK(gs_text(GsWrite{GsReg::Fba, 1}) == "4a FBA_1 0000000000000001: FBA yes (set bit 7 of alpha)");
    CHECK(gs_text(GsWrite{GsReg::TexFlush, 0}) == "3f TEXFLUSH 0000000000000000: forget cached texels");
    CHECK(gs_text(GsWrite{GsReg::BgColor, 0x20000}) ==
          "120000e0 BGCOLOR 0000000000020000: R 0 (red), G 0 (green), B 2 (blue)");
}
