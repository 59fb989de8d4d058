// SPDX-License-Identifier: MIT
#include "pipeline/emit/gs_packets.h"

#include <algorithm>
#include <span>

namespace pipeline {

namespace {

constexpr std::uint64_t kPacked = 0, kRegList = 1, kImage = 2, kAddressAndData = 0xe;
constexpr std::size_t kTagBytes = 16, kQuadword = 16;

void append_tag(GifPacket& packet, std::size_t loops, std::uint64_t format, std::size_t registers,
                std::uint64_t numbers) {
    constexpr std::uint64_t kEndOfPacket = 1u << 15;
    append_u64(packet, loops | kEndOfPacket | format << 58 | std::uint64_t{registers & 15} << 60);
    append_u64(packet, numbers);
}

// Registers that a REGLIST can name, and that vertices are made of.
bool is_of_vertex(GsReg reg) {
    return reg == GsReg::Rgbaq || reg == GsReg::St || reg == GsReg::Uv || reg == GsReg::Fog || reg == GsReg::Xyz2 ||
           reg == GsReg::Xyzf2;
}
bool kicks(GsReg reg) {
    return reg == GsReg::Xyz2 || reg == GsReg::Xyzf2;
}

using Writes = std::span<const GsWrite>;

// Writes of one vertex from the first on: up to a kick. Empty if these are not a vertex.
Writes vertex_at(Writes writes) {
    constexpr std::size_t kLargest = 16;
    for (std::size_t i = 0; i < std::min(writes.size(), kLargest); ++i) {
        if (!is_of_vertex(writes[i].reg)) return {};
        if (kicks(writes[i].reg)) return writes.first(i + 1);
    }
    return {};
}

bool same_registers(Writes a, Writes b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const GsWrite& one, const GsWrite& other) { return one.reg == other.reg; });
}

// All vertices from the first on that have the first's registers; how many writes these are.
std::size_t append_vertices(Writes writes, Writes vertex, std::vector<GifPacket>& packets) {
    const std::size_t most = (kMaxPacketBytes - kTagBytes) / 8 / vertex.size();
    std::size_t count      = 1;
    while (count < most && same_registers(vertex, vertex_at(writes.subspan(count * vertex.size())))) ++count;
    std::uint64_t numbers = 0;
    for (std::size_t i = 0; i < vertex.size(); ++i) numbers |= static_cast<std::uint64_t>(vertex[i].reg) << (4 * i);
    GifPacket& packet = packets.emplace_back();
    append_tag(packet, count, kRegList, vertex.size(), numbers);
    for (const GsWrite& write : writes.first(count * vertex.size())) append_u64(packet, write.value);
    packet.resize((packet.size() + kQuadword - 1) / kQuadword * kQuadword);
    return count * vertex.size();
}

// Up to the next vertex.
std::size_t append_registers(Writes writes, std::vector<GifPacket>& packets) {
    const std::size_t most = std::min(writes.size(), (kMaxPacketBytes - kTagBytes) / kQuadword);
    std::size_t count      = 1;
    while (count < most && vertex_at(writes.subspan(count)).empty()) ++count;
    GifPacket& packet = packets.emplace_back();
    append_tag(packet, count, kPacked, 1, kAddressAndData);
    for (const GsWrite& write : writes.first(count)) {
        append_u64(packet, write.value);
        append_u64(packet, static_cast<std::uint64_t>(write.reg));
    }
    return count;
}

void append_image(std::span<const std::uint8_t> image, std::vector<GifPacket>& packets) {
    while (!image.empty()) {
        const std::size_t size = std::min(image.size(), kMaxPacketBytes - kTagBytes);
        GifPacket& packet      = packets.emplace_back();
        append_tag(packet, size / kQuadword, kImage, 0, 0);
        packet.insert(packet.end(), image.begin(), image.begin() + static_cast<std::ptrdiff_t>(size));
        image = image.subspan(size);
    }
}

}  // namespace

void append_u32(std::vector<std::uint8_t>& bytes, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}
void append_u64(std::vector<std::uint8_t>& bytes, std::uint64_t value) {
    for (int shift = 0; shift < 64; shift += 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

std::vector<GifPacket> gif_packets(const GsStep& step) {
    std::vector<GifPacket> packets;
    for (Writes writes = step.writes; !writes.empty();) {
        const Writes vertex = vertex_at(writes);
        writes              = writes.subspan(vertex.empty() ? append_registers(writes, packets)
                                                            : append_vertices(writes, vertex, packets));
    }
    append_image(step.image, packets);
    return packets;
}

}  // namespace pipeline
