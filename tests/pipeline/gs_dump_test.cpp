// SPDX-License-Identifier: MIT
#include "pipeline/emit/gs_dump.h"

#include <catch2/catch.hpp>
#include <cstring>

#include "pipeline/emit/gs_packets.h"
#include "pipeline/emit/gs_text.h"
#include "tests/support/gs_frames.h"
#include "tests/support/gs_replay.h"

using namespace pipeline;
using namespace test_support;

namespace {

std::uint32_t word(const std::vector<std::uint8_t>& bytes, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, &bytes.at(at), 4);
    return value;
}
std::uint64_t number(const std::vector<std::uint8_t>& bytes, std::size_t at) {
    return word(bytes, at) | std::uint64_t{word(bytes, at + 4)} << 32;
}

GsStep step_of(std::vector<GsWrite> writes, std::vector<std::uint8_t> image = {}) {
    return {.what = {}, .writes = std::move(writes), .image = std::move(image)};
}

}  // namespace

TEST_CASE("A GS dump has header, state, registers, transfers and a vsync") {
    GsStream stream;
    stream.groups.push_back({"pass", {step_of({{GsReg::Fba, 1}})}});
    stream.display                       = {{GsReg::DispFb1, 0x1234}, {GsReg::BgColor, 0x55}};
    const std::vector<std::uint8_t> dump = gs_dump(stream);

    CHECK(word(dump, 0) == 0xffffffff);
    CHECK(word(dump, 4) == 36);
    CHECK(word(dump, 8) == 8);  // the state's version
    // 4 of version; 45 registers; UV and FOG in one of these; 4 MB; 4 paths of 20; Q.
    const std::size_t state = 4 + 45 * 8 + (4u << 20) + 80 + 4;
    CHECK(word(dump, 12) == state);
    CHECK(word(dump, 44) == 8);
    CHECK(number(dump, 48 + 8) == 1);  // PRMODECONT.AC
    CHECK(word(dump, 44 + state - 4) == 0x3f800000);
    const std::size_t registers = 44 + state;
    CHECK(number(dump, registers + 0x70) == 0x1234);
    CHECK(number(dump, registers + 0xe0) == 0x55);
    const std::size_t packet = registers + 8192;
    REQUIRE(dump.size() == packet + 1 + 1 + 4 + 32 + 2);
    CHECK(dump[packet] == 0);
    CHECK(dump[packet + 1] == 3);
    CHECK(word(dump, packet + 2) == 32);
    CHECK(number(dump, packet + 6) == 0x1000000000008001);  // one loop of one register, PACKED, the end
    CHECK(number(dump, packet + 14) == 0xe);
    CHECK(number(dump, packet + 22) == 1);
    CHECK(number(dump, packet + 30) == 0x4a);
    CHECK(dump[packet + 38] == 1);
    CHECK(dump[packet + 39] == 0);
}

TEST_CASE("Vertices are packed as lists, all else by address") {
    const std::vector<GsWrite> vertex{{GsReg::St, 1}, {GsReg::Rgbaq, 2}, {GsReg::Xyz2, 3}};
    std::vector<GsWrite> writes{{GsReg::Prim, 6}};
    for (int i = 0; i < 3; ++i) writes.insert(writes.end(), vertex.begin(), vertex.end());
    const std::vector<GifPacket> packets = gif_packets(step_of(writes));
    REQUIRE(packets.size() == 2);
    CHECK(number(packets[0], 0) == 0x1000000000008001);
    // 3 loops of ST, RGBAQ, XYZ2: 9 values and one to fill the quadword.
    CHECK(number(packets[1], 0) == 0x3400000000008003);
    CHECK(number(packets[1], 8) == 0x512);
    CHECK(packets[1].size() == 16 + 10 * 8);
    CHECK(number(packets[1], 16 + 8 * 8) == 3);
}

TEST_CASE("Vertices with other registers are another list") {
    const std::vector<GifPacket> packets =
        gif_packets(step_of({{GsReg::Rgbaq, 2}, {GsReg::Xyz2, 3}, {GsReg::Xyz2, 4}, {GsReg::Xyz2, 5}}));
    REQUIRE(packets.size() == 2);
    CHECK(number(packets[0], 8) == 0x51);
    CHECK(number(packets[1], 0) == 0x1400000000008002);
    CHECK(number(packets[1], 8) == 0x5);
}

TEST_CASE("Images are quadwords, and long ones are several packets") {
    const std::vector<GifPacket> packets = gif_packets(step_of({}, std::vector<std::uint8_t>(kMaxPacketBytes, 7)));
    REQUIRE(packets.size() == 2);
    CHECK(number(packets[0], 0) == (0x0800000000008000 | (kMaxPacketBytes / 16 - 1)));
    CHECK(packets[0].size() == kMaxPacketBytes);
    CHECK(number(packets[1], 0) == 0x0800000000008001);
    CHECK(packets[1].size() == 32);
}

TEST_CASE("The output is what a dump shows") {
    Frame frame = gs_frame(320, 240);
    frame.targets.push_back({.name = "other", .format = TargetFormat::Psmct16, .width = 100, .height = 40});
    frame.output                         = {1};
    const std::vector<std::uint8_t> dump = gs_dump(emit_gs(legal_gs_frame(frame)));
    const GsReplay replay(dump);
    CHECK(replay.vsyncs() == 1);
    CHECK(replay.width_shown() == 100);
    CHECK(replay.height_shown() == 40);
    CHECK(replay.shown(100, 40) == std::vector<std::uint32_t>(4000, 0));
}

TEST_CASE("The replay refuses what it does not know") {
    const auto run = [](std::vector<GsWrite> writes, std::vector<std::uint8_t> image = {}) {
        GsStream stream;
        stream.groups.push_back({"pass", {step_of(std::move(writes), std::move(image))}});
        GsReplay replay(gs_dump(stream));
    };
    CHECK_NOTHROW(run({{GsReg::Fba, 1}}));
    CHECK_THROWS(run({{static_cast<GsReg>(0x48), 1}}));
    CHECK_THROWS(run({{GsReg::Prim, 3}, {GsReg::Xyz2, 0}}));                // a triangle of one corner
    CHECK_THROWS(run({{GsReg::Prim, 4}, {GsReg::Xyz2, 0}}));                // a strip
    CHECK_THROWS(run({}, std::vector<std::uint8_t>(16)));                   // an image without a transfer
    CHECK_THROWS(run({{GsReg::TrxReg, 0x800000008}, {GsReg::TrxDir, 0}}));  // a transfer without an image
    std::vector<std::uint8_t> cut = gs_dump({});
    cut.pop_back();
    CHECK_THROWS(GsReplay(cut));
}

TEST_CASE("A stream is told by pass and draw") {
    Frame frame                 = gs_frame(8, 8);
    frame.passes[0].label       = "sky";
    frame.passes[0].clear.color = Argb{0x80ff0000};
    DrawRectangle draw;
    draw.x1 = draw.y1 = 4.0f;
    frame.passes[0].draws.push_back(draw);
    const std::string text = gs_text(emit_gs(legal_gs_frame(frame)));
    const auto position    = [&](std::string_view part) { return text.find(part); };
    CHECK(position("// == registers that stay\n") < position("// == pass 0 'sky'\n// clear\n"));
    CHECK(position("// rectangle 0\n") != std::string::npos);
    CHECK(position("01 RGBAQ 3f800000800000ff: R 255, G 0, B 0, A 128 (alpha, 0x80 is one), Q 1\n") !=
          std::string::npos);
    CHECK(position("targets that start at zero") == std::string::npos);  // the pass clears all of it
    CHECK(text.ends_with("120000e0 BGCOLOR 0000000000000000: R 0 (red), G 0 (green), B 0 (blue)\n"));
}
