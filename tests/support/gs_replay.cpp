// SPDX-License-Identifier: MIT
#include "tests/support/gs_replay.h"

#include <bit>
#include <span>
#include <stdexcept>
#include <string>

namespace test_support {

namespace {

using Bytes = std::span<const std::uint8_t>;

[[noreturn]] void refuse(const std::string& what) {
    throw std::runtime_error("GS dump: " + what);
}

class ByteReader {
  public:
    explicit ByteReader(Bytes bytes) : bytes_(bytes) {}
    bool at_end() const { return bytes_.empty(); }
    Bytes take(std::size_t count) {
        if (count > bytes_.size()) refuse("it ends early");
        const Bytes taken = bytes_.first(count);
        bytes_            = bytes_.subspan(count);
        return taken;
    }
    std::uint64_t number(std::size_t size) {
        std::uint64_t value = 0;
        const Bytes from    = take(size);
        for (std::size_t i = 0; i < size; ++i) value |= std::uint64_t{from[i]} << (8 * i);
        return value;
    }
    std::uint32_t u32() { return static_cast<std::uint32_t>(number(4)); }
    std::uint64_t u64() { return number(8); }

  private:
    Bytes bytes_;
};

bool is_known(std::uint64_t address) {
    static constexpr std::uint8_t kKnown[] = {0x00, 0x01, 0x02, 0x03, 0x04, 0x05, 0x06, 0x08, 0x0a, 0x14, 0x18,
                                              0x1a, 0x1c, 0x22, 0x3b, 0x3d, 0x3f, 0x40, 0x42, 0x44, 0x45, 0x46,
                                              0x47, 0x49, 0x4a, 0x4c, 0x4e, 0x50, 0x51, 0x52, 0x53};
    for (const std::uint8_t known : kKnown)
        if (known == address) return true;
    return false;
}

}  // namespace

struct GsReplayState {
    std::array<std::uint64_t, 128> registers{};  // noise at first
    std::array<std::uint32_t, 256> palette{};
    GsLocalMemory memory, texels;
    std::vector<GsVertex> queue;
    std::uint64_t pixels_sent = 0, pixels_wanted = 0;  // of a transfer from the host
    std::vector<std::uint8_t> shown;                   // registers at 0x12000000
    int vsyncs = 0;

    GsReplayState() { registers.fill(~std::uint64_t{0}); }

    void write(std::uint64_t address, std::uint64_t value);
    void image(Bytes bytes);

  private:
    GsBuffer transfer_buffer(int shift) const {
        const std::uint64_t buf = registers[0x50];
        return {bits_at(buf, shift + 24, 6), bits_at(buf, shift, 14), bits_at(buf, shift + 16, 6)};
    }
    int width() const { return static_cast<int>(bits_at(registers[0x52], 0, 12)); }
    int height() const { return static_cast<int>(bits_at(registers[0x52], 32, 12)); }
    int place(int shift) const { return static_cast<int>(bits_at(registers[0x51], shift, 11)); }

    void start_transfer(std::uint32_t direction);
    void load_palette();
    void kick(std::uint32_t x, std::uint32_t y, std::uint32_t z, std::uint32_t fog);
};

void GsReplayState::start_transfer(std::uint32_t direction) {
    if (direction == 0) {
        pixels_sent   = 0;
        pixels_wanted = static_cast<std::uint64_t>(width()) * static_cast<std::uint64_t>(height());
        return;
    }
    if (direction != 2) refuse("transfer in direction " + std::to_string(direction));
    const GsBuffer from = transfer_buffer(0), to = transfer_buffer(32);
    if (from.format != to.format) refuse("transfer from one format to another");
    std::vector<std::uint32_t> moved;
    for (int y = 0; y < height(); ++y)
        for (int x = 0; x < width(); ++x) moved.push_back(memory.read(from, place(0) + x, place(16) + y));
    for (int y = 0, i = 0; y < height(); ++y)
        for (int x = 0; x < width(); ++x)
            memory.write(to, place(32) + x, place(48) + y, moved[static_cast<std::size_t>(i++)]);
}

void GsReplayState::image(Bytes bytes) {
    const GsBuffer to       = transfer_buffer(32);
    const std::size_t pixel = static_cast<std::size_t>(gs_bits_of(to.format) / 8);
    if (pixels_sent == pixels_wanted) refuse("an image that no transfer waits for");
    for (ByteReader reader(bytes); !reader.at_end() && pixels_sent < pixels_wanted; ++pixels_sent) {
        const auto i = static_cast<int>(pixels_sent);
        memory.write(to, place(32) + i % width(), place(48) + i / width(),
                     static_cast<std::uint32_t>(reader.number(pixel)));
    }
}

// CSM1, 32 bits, all 256: rows of 16 colours, of which the second and third 8 of each 32 have changed places.
void GsReplayState::load_palette() {
    const std::uint64_t tex0 = registers[0x06];
    if (bits_at(tex0, 61, 3) == 0) return;
    if (bits_at(tex0, 61, 3) != 1 || bits_at(tex0, 51, 4) != kCt32 || bits_at(tex0, 55, 6) != 0)
        refuse("another palette");
    const GsBuffer from{kCt32, bits_at(tex0, 37, 14), 1};
    for (int i = 0; i < 256; ++i) {
        const int eighth = i / 8 % 4, placed = i / 32 * 32 + (eighth == 1 ? 2 : eighth == 2 ? 1 : eighth) * 8 + i % 8;
        palette[static_cast<std::size_t>(i)] = texels.read(from, placed % 16, placed / 16);
    }
}

void GsReplayState::kick(std::uint32_t x, std::uint32_t y, std::uint32_t z, std::uint32_t fog) {
    const std::uint64_t color = registers[0x01], st = registers[0x02], uv = registers[0x03], offset = registers[0x18];
    GsVertex vertex;
    vertex.x   = std::int64_t{x} - bits_at(offset, 0, 16);
    vertex.y   = std::int64_t{y} - bits_at(offset, 32, 16);
    vertex.z   = z;
    vertex.fog = fog;
    for (int c = 0; c < 4; ++c) vertex.rgba[static_cast<std::size_t>(c)] = static_cast<int>(bits_at(color, 8 * c, 8));
    vertex.s = std::bit_cast<float>(bits_at(st, 0, 32));
    vertex.t = std::bit_cast<float>(bits_at(st, 32, 32));
    vertex.q = std::bit_cast<float>(bits_at(color, 32, 32));
    vertex.u = bits_at(uv, 0, 14);
    vertex.v = bits_at(uv, 16, 14);
    queue.push_back(vertex);

    if ((registers[0x1a] & 1) == 0) refuse("attributes from PRMODE");
    const std::uint32_t kind = bits_at(registers[0x00], 0, 3);
    const GsDrawing drawing{registers, palette, texels, memory};
    if (kind == 3 && queue.size() == 3) {
        gs_triangle(drawing, {queue[0], queue[1], queue[2]});
        queue.clear();
    } else if (kind == 6 && queue.size() == 2) {
        gs_sprite(drawing, queue[0], queue[1]);
        queue.clear();
    } else if (kind != 3 && kind != 6) {
        refuse("primitive " + std::to_string(kind));
    }
}

void GsReplayState::write(std::uint64_t address, std::uint64_t value) {
    if (!is_known(address)) refuse("register " + std::to_string(address));
    registers[address] = value;
    if (address == 0x00) queue.clear();
    if (address == 0x04)
        kick(bits_at(value, 0, 16), bits_at(value, 16, 16), bits_at(value, 32, 24), bits_at(value, 56, 8));
    if (address == 0x05)
        kick(bits_at(value, 0, 16), bits_at(value, 16, 16), bits_at(value, 32, 32), bits_at(registers[0x0a], 56, 8));
    if (address == 0x06) load_palette();
    if (address == 0x3f) texels = memory;
    if (address == 0x53) start_transfer(bits_at(value, 0, 2));
}

namespace {

void read_gif(Bytes bytes, GsReplayState& state) {
    ByteReader reader(bytes);
    while (!reader.at_end()) {
        const std::uint64_t tag = reader.u64(), names = reader.u64();
        const std::uint32_t loops = bits_at(tag, 0, 15), format = bits_at(tag, 58, 2);
        const std::uint32_t count = bits_at(tag, 60, 4) == 0 ? 16 : bits_at(tag, 60, 4);
        if (bits_at(tag, 46, 1) != 0) refuse("PRIM in a tag");
        if (format == 2) {
            state.image(reader.take(std::size_t{16} * loops));
            continue;
        }
        for (std::uint32_t i = 0; i < loops * count; ++i) {
            const std::uint32_t name  = bits_at(names, static_cast<int>(4 * (i % count)), 4);
            const std::uint64_t value = reader.u64();
            if (format == 1) {
                state.write(name, value);
            } else if (format == 0 && name == 0xe) {
                state.write(reader.u64() & 0xff, value);
            } else {
                refuse("PACKED register " + std::to_string(name));
            }
        }
        if (format == 1 && loops * count % 2 != 0) reader.take(8);
    }
}

// The registers of the state are not read: a stream is complete without them.
void read_header(ByteReader& reader) {
    if (reader.u32() != 0xffffffff) refuse("an old header");
    ByteReader header(reader.take(reader.u32()));
    const std::uint32_t version = header.u32(), state_bytes = header.u32();
    if (version != 8) refuse("version " + std::to_string(version));
    ByteReader state(reader.take(state_bytes));
    if (state.u32() != version) refuse("a state of another version");
    state.take(15 * 8 + 2 * 12 * 8);            // registers
    state.take(8 + 8 + 4 + 4 + 8 + 8 + 4 + 4);  // a vertex, and the place of a transfer
    state.take(std::size_t{4} << 20);           // local memory
    state.take(std::size_t{4} * (16 + 4));      // paths
    if (state.u32() != 0x3f800000) refuse("Q is not one");
    if (!state.at_end()) refuse("a state of another size");
}

}  // namespace

GsReplay::GsReplay(const std::vector<std::uint8_t>& dump) : state_(std::make_unique<GsReplayState>()) {
    ByteReader reader(dump);
    read_header(reader);
    const Bytes shown = reader.take(8192);
    state_->shown.assign(shown.begin(), shown.end());
    while (!reader.at_end()) {
        switch (reader.number(1)) {
            case 0: {
                reader.take(1);  // the path
                read_gif(reader.take(reader.u32()), *state_);
                break;
            }
            case 1:
                reader.take(1);
                ++state_->vsyncs;
                break;
            default:
                refuse("a packet of another kind");
        }
    }
    if (state_->pixels_sent != state_->pixels_wanted) refuse("a transfer that is not complete");
    if (!state_->queue.empty()) refuse("a primitive that is not complete");
}

GsReplay::~GsReplay() = default;

std::vector<std::uint32_t> GsReplay::pixels(const GsBuffer& buffer, int width, int height) const {
    std::vector<std::uint32_t> argb;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) argb.push_back(gs_argb(buffer.format, state_->memory.read(buffer, x, y)));
    return argb;
}

std::vector<std::uint32_t> GsReplay::shown(int width, int height) const {
    ByteReader reader(state_->shown);
    const bool is_on = (reader.u64() & 1) != 0;
    if (!is_on) refuse("circuit 1 is off");
    reader.take(0x70 - 8);
    const std::uint64_t dispfb = reader.u64();
    return pixels({bits_at(dispfb, 15, 5), bits_at(dispfb, 0, 9) * 32, bits_at(dispfb, 9, 6)}, width, height);
}

int GsReplay::width_shown() const {
    ByteReader reader(state_->shown);
    reader.take(0x80);
    const std::uint64_t display = reader.u64();
    return static_cast<int>((bits_at(display, 32, 12) + 1) / (bits_at(display, 23, 4) + 1));
}
int GsReplay::height_shown() const {
    ByteReader reader(state_->shown);
    reader.take(0x80);
    return static_cast<int>(bits_at(reader.u64(), 44, 11) + 1);
}
int GsReplay::vsyncs() const {
    return state_->vsyncs;
}

}  // namespace test_support
