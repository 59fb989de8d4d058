// SPDX-License-Identifier: MIT
// Where memory_map puts targets and textures: sizes worked out by hand from the layouts that the chips' sources give, and
// what holds for every frame.
#include "pipeline/check/memory_map.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "pipeline/check/needed_pixels.h"
#include "tests/support/random_frame.h"

using namespace pipeline;
using enum TargetFormat;

namespace {

constexpr std::uint64_t kPage = 8192, kBlock = 256;
constexpr TextureFormat kA8 = TextureFormat::A8, kL8 = TextureFormat::L8, kRgba = TextureFormat::A8R8G8B8;

const Profile& profile(std::string_view name) {
    const Profile* found = find_profile(name);
    REQUIRE(found != nullptr);
    return *found;
}

MemoryMap map_of(std::string_view chip, const std::vector<Target>& targets, const std::vector<Texture>& textures = {}) {
    Frame frame;
    frame.targets  = targets;
    frame.textures = textures;
    return lay_out(frame, profile(chip));
}

Target target(TargetFormat format, int width, int height) {
    return {"", format, width, height};
}
Texture texture(TextureFormat format, int width, int height, int levels = 1) {
    return {"", format, width, height, levels, {}};
}

std::uint64_t target_bytes(std::string_view chip, TargetFormat format, int width, int height) {
    return map_of(chip, {target(format, width, height)}).blocks.at(0).bytes;
}
std::uint64_t pages(TargetFormat format, int width, int height) {
    const std::uint64_t bytes = target_bytes("ps2", format, width, height);
    CHECK(bytes % kPage == 0);
    return bytes / kPage;
}
std::uint64_t texture_bytes(std::string_view chip, const Texture& one) {
    return map_of(chip, {}, {one}).blocks.at(0).bytes;
}
std::uint64_t blocks(TextureFormat format, int width, int height) {
    const std::uint64_t bytes = texture_bytes("ps2", texture(format, width, height));
    CHECK(bytes % kBlock == 0);
    return bytes / kBlock;
}

}  // namespace

TEST_CASE("memory of the Graphics Synthesizer: targets in pages", "[memory_map]") {
    CHECK(pages(Psmct32, 640, 448) == 140);
    CHECK(pages(Psmct24, 640, 448) == 140);
    CHECK(pages(D24, 640, 448) == 140);
    CHECK(pages(D32, 640, 448) == 140);
    CHECK(pages(Psmct16, 640, 448) == 70);
    CHECK(pages(D16, 640, 448) == 70);
    CHECK(pages(Psmct32, 512, 448) == 112);
    CHECK(pages(Psmct32, 640, 224) == 70);
    CHECK(pages(Psmct32, 320, 224) == 35);
    CHECK(pages(Psmct32, 256, 256) == 32);
    CHECK(pages(Psmct32, 160, 112) == 12);  // 3 by 4: widths count 64 pixels
    CHECK(pages(Psmct32, 128, 128) == 8);
    CHECK(pages(Psmct32, 640, 512) == 160);
    CHECK(pages(Psmct32, 1, 1) == 1);
    CHECK(pages(Psmct16, 65, 65) == 4);
    CHECK(map_of("ps2", {target(Psmct32, 160, 112)}).blocks[0].pitch == 192);
}

TEST_CASE("memory of the Graphics Synthesizer: textures in blocks", "[memory_map]") {
    // In the order of blocks, the first powers of two of them are 1x1, 2x1, 2x2, 4x2, 4x4, 8x4 blocks.
    CHECK(blocks(kRgba, 8, 8) == 1);
    CHECK(blocks(kRgba, 16, 8) == 2);
    CHECK(blocks(kRgba, 16, 16) == 4);
    CHECK(blocks(kRgba, 32, 16) == 8);
    CHECK(blocks(kRgba, 32, 32) == 16);
    CHECK(blocks(kRgba, 64, 32) == 32);
    // Others leave gaps: the block below the first is number 2, the eighth of a row is number 21.
    CHECK(blocks(kRgba, 8, 16) == 3);
    CHECK(blocks(kRgba, 64, 8) == 22);
    CHECK(blocks(kRgba, 1, 1) == 1);
    // Two pages beside each other, or below.
    CHECK(blocks(kRgba, 65, 8) == 33);
    CHECK(blocks(kRgba, 64, 33) == 32 + 22);
    CHECK(blocks(kRgba, 256, 256) == 32 * 32);
    // PSMT8: blocks of 16x16, pages of 128x64. 256x256 of them are 64 KB.
    CHECK(blocks(kA8, 16, 16) == 1);
    CHECK(blocks(kL8, 128, 64) == 32);
    CHECK(blocks(kL8, 256, 256) * kBlock == 65536);
    CHECK(map_of("ps2", {}, {texture(kL8, 16, 16)}).blocks[0].pitch == 128);  // TBW 2
    // The chip's mip levels are no frame's.
    CHECK(texture_bytes("ps2", texture(kRgba, 64, 32, 7)) == 32 * kBlock);
}

TEST_CASE("memory of the Graphics Synthesizer: the order of blocks in a page", "[memory_map]") {
    // The number of a block has the bits x2 y1 x1 y0 x0, so that it is the last of all that are not right of it or below.
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 8; ++x) {
            const int number = (x & 1) | (y & 1) << 1 | (x & 2) << 1 | (y & 2) << 2 | (x & 4) << 2;
            INFO(x << ' ' << y);
            CHECK(blocks(kRgba, 8 * (x + 1), 8 * (y + 1)) == static_cast<std::uint64_t>(number) + 1);
            CHECK(blocks(kL8, 16 * (x + 1), 16 * (y + 1)) == static_cast<std::uint64_t>(number) + 1);
        }
    }
}

TEST_CASE("memory of the Graphics Synthesizer: one after the other", "[memory_map]") {
    Frame frame;
    frame.targets       = {{"picture", Psmct32, 640, 448}, {"depth", D24, 640, 448}};
    frame.textures      = {{"sprite", kRgba, 8, 8, 1, {}}, {"noise", kA8, 16, 32, 1, {}}, {"more", kA8, 16, 16, 1, {}}};
    const MemoryMap map = lay_out(frame, profile("ps2"));
    REQUIRE(map.blocks.size() == 6);
    const std::vector<std::pair<std::string, std::uint64_t>> expected = {
        {"target 0 'picture'", 0},
        {"target 1 'depth'", 140 * kPage},
        {"texture 0 'sprite'", 280 * kPage},
        {"texture 1 'noise'", 280 * kPage + kBlock},
        {"texture 2 'more'", 280 * kPage + 4 * kBlock},
        {"palette of A8", 280 * kPage + 5 * kBlock},  // one for both
    };
    for (std::size_t i = 0; i < expected.size(); ++i) {
        CHECK(map.blocks[i].what == expected[i].first);
        CHECK(map.blocks[i].address == expected[i].second);
        CHECK(map.blocks[i].region == 0);
    }
    CHECK(map.blocks[5].bytes == 1024);  // 256 entries of 4 bytes
    REQUIRE(map.regions.size() == 1);
    CHECK(map.regions[0].budget == 4194304);
    CHECK(map.regions[0].used == 280 * kPage + 9 * kBlock);
    CHECK(map.regions[0].over == 0);
    CHECK(map.clashes.empty());

    // A texture may end within a page; the next target would start on one, but targets come first.
    frame.targets.push_back({"small", Psmct16, 8, 8});
    CHECK(lay_out(frame, profile("ps2")).blocks[2].address == 280 * kPage);
}

TEST_CASE("memory of the Graphics Synthesizer: what does not fit", "[memory_map]") {
    // Three of 640x512 leave 32 pages; 640x448 three times leave 92.
    const auto over = [](int height, int rest) {
        return map_of("ps2", {target(Psmct32, 640, height), target(Psmct32, 640, height), target(D32, 640, height),
                              target(Psmct32, 64, 32 * rest)})
            .regions[0]
            .over;
    };
    CHECK(over(512, 32) == 0);
    CHECK(over(512, 33) == kPage);
    CHECK(over(448, 92) == 0);
    CHECK(over(448, 95) == 3 * kPage);
}

TEST_CASE("memory of a PC card and of the Xbox: rows at multiples of 64 bytes", "[memory_map]") {
    CHECK(target_bytes("dx7", A8R8G8B8, 640, 480) == 1228800);
    CHECK(target_bytes("dx7", R5G6B5, 640, 480) == 614400);
    CHECK(target_bytes("dx7", D24, 100, 10) == 4480);  // 400 bytes become 448
    CHECK(target_bytes("dx7", D16, 100, 10) == 2560);  // 200 become 256
    CHECK(target_bytes("xbox", A8R8G8B8, 17, 2) == 256);
    CHECK(map_of("dx7", {target(D24, 100, 10)}).blocks[0].pitch == 112);
    // Levels 8x2, 4x1, 2x1, 1x1: five rows with padding; without it 16 + 4 + 2 + 1 texels.
    CHECK(texture_bytes("dx7", texture(kL8, 8, 2, 4)) == 5 * 64);
    CHECK(texture_bytes("xbox", texture(kL8, 8, 2, 4)) == 23);
    CHECK(texture_bytes("xbox", texture(kRgba, 4, 4)) == 64);
    // No power of two: linear.
    CHECK(texture_bytes("xbox", texture(kL8, 12, 4)) == 4 * 64);
    CHECK(map_of("xbox", {}, {texture(kL8, 12, 4)}).blocks[0].pitch == 64);
    CHECK(map_of("xbox", {}, {texture(kL8, 16, 4)}).blocks[0].pitch == 16);
}

TEST_CASE("memory of a PC card and of the Xbox: starts and sums", "[memory_map]") {
    const std::vector<Texture> small{texture(kL8, 2, 2), texture(kL8, 2, 2)};
    const MemoryMap card = map_of("dx7", {}, small), box = map_of("xbox", {}, small);
    CHECK(card.blocks[1].address == 2 * 64);
    CHECK(card.regions[0].used == 4 * 64);
    CHECK(card.regions[0].budget == 33554432);
    CHECK(box.blocks[1].address == 128);
    CHECK(box.regions[0].used == 128 + 4);
    CHECK(box.regions[0].budget == 67108864);
    const Target four_mb = target(A8R8G8B8, 1024, 1024);
    CHECK(map_of("dx7", std::vector<Target>(8, four_mb)).regions[0].over == 0);
    CHECK(map_of("dx7", std::vector<Target>(9, four_mb)).regions[0].over == 4194304);
    CHECK(map_of("xbox", std::vector<Target>(16, four_mb)).regions[0].over == 0);
    CHECK(map_of("xbox", std::vector<Target>(17, four_mb)).regions[0].over == 4194304);
}

TEST_CASE("memory of no chip has no padding and no limit", "[memory_map]") {
    const MemoryMap map = map_of("ideal", {target(A8R8G8B8, 3, 3), target(R6G6B6A6, 5, 1)}, {texture(kL8, 2, 2, 2)});
    REQUIRE(map.blocks.size() == 3);
    CHECK(map.blocks[1].address == 36);
    CHECK(map.blocks[2].address == 36 + 15);
    CHECK(map.regions[0].used == 36 + 15 + 5);
    CHECK(map.regions[0].budget == 0);
    CHECK(map_of("ideal", std::vector<Target>(50, target(A8R8G8B8, 8192, 8192))).regions[0].over == 0);
}

TEST_CASE("main memory of the GameCube: tiles of 32 bytes", "[memory_map]") {
    CHECK(target_bytes("gamecube", A8R8G8B8, 320, 240) == 307200);
    CHECK(target_bytes("gamecube", A8R8G8B8, 640, 480) == 1228800);
    CHECK(target_bytes("gamecube", A8R8G8B8, 5, 5) == 4 * 64);  // 2x2 tiles of 4x4
    CHECK(target_bytes("gamecube", R5G6B5, 5, 4) == 2 * 32);
    CHECK(texture_bytes("gamecube", texture(kL8, 8, 4)) == 32);
    CHECK(texture_bytes("gamecube", texture(kA8, 9, 5)) == 4 * 32);  // of 8x4
    CHECK(texture_bytes("gamecube", texture(kL8, 16, 8, 5)) == 4 * 32 + 32 + 32 + 32 + 32);
    CHECK(texture_bytes("gamecube", texture(kRgba, 1, 1)) == 64);
    const MemoryMap map = map_of("gamecube", {target(A8R8G8B8, 4, 4)}, {texture(kL8, 8, 4)});
    REQUIRE(map.regions.size() == 2);
    CHECK(map.regions[1].name == "main memory");
    CHECK(map.regions[1].used == 96);
    CHECK(map.regions[1].budget == 25165824);
    CHECK(map.blocks[1].address == 64);
    CHECK(map.blocks[1].region == 1);
    // 18 full frames of 1.3 MB fit, and no more.
    const Target full = target(A8R8G8B8, 640, 528);
    CHECK(map_of("gamecube", std::vector<Target>(18, full)).regions[1].over == 0);
    CHECK(map_of("gamecube", std::vector<Target>(19, full)).regions[1].over == 19 * 1351680 - 25165824);
}

namespace {

// Frames for the frame buffer: what a pass does.
struct Step {
    int color = -1, depth = -1, copied = -1;
    bool clears = false;
};
Frame frame_of(const std::vector<Target>& targets, const std::vector<Step>& steps, int output) {
    Frame frame;
    frame.output  = {output};
    frame.targets = targets;
    for (const Step& step : steps) {
        Pass& pass = frame.passes.emplace_back();
        pass.color = {step.color};
        pass.depth = {step.depth};
        if (step.clears) pass.clear.color = Argb{0};
        if (step.copied >= 0) {
            const Target& from = targets[static_cast<std::size_t>(step.copied)];
            pass.draws         = {CopyRectangle{.source = {step.copied}, .from = {0, 0, from.width, from.height}}};
        } else {
            pass.state.depth.write = step.depth >= 0;
            pass.state.blend.dest  = BlendFactor::One;  // so that what was there is needed
            pass.draws             = {DrawRectangle{.x1 = 1000.0f, .y1 = 1000.0f}};
        }
    }
    return frame;
}
MemoryMap buffer_map(const std::vector<Target>& targets, const std::vector<Step>& steps, int output = 0) {
    return lay_out(frame_of(targets, steps, output), profile("gamecube"));
}

constexpr std::uint64_t kColorBytes = 640 * 528 * 3;

}  // namespace

TEST_CASE("frame buffer of the GameCube: colour and depth at the same pixels", "[memory_map]") {
    const MemoryMap map = buffer_map({target(R6G6B6A6, 640, 528), target(D24, 640, 528)}, {{.color = 0, .depth = 1}});
    CHECK(map.regions[0].name == "frame buffer");
    CHECK(map.regions[0].budget == 2027520);
    CHECK(map.regions[0].used == 2027520);
    CHECK(map.regions[0].over == 0);
    CHECK(map.blocks[0].address == 0);
    CHECK(map.blocks[0].bytes == kColorBytes);
    CHECK(map.blocks[0].pitch == 640);
    CHECK(map.blocks[1].address == kColorBytes);
    CHECK(map.clashes.empty());
    // 480 rows of both.
    CHECK(buffer_map({target(X8R8G8B8, 320, 480)}, {{.color = 0}}).regions[0].used == 640 * 480 * 6);
}

TEST_CASE("frame buffer of the GameCube: targets that are needed at one time lie apart", "[memory_map]") {
    // Target 1 is drawn while 0 is the picture.
    const auto two = [](int width, int height) {
        return buffer_map({target(R6G6B6A6, width, height), target(R6G6B6A6, width, height)},
                          {{.color = 0}, {.color = 1}, {.color = 0}});
    };
    const MemoryMap beside = two(320, 528), below = two(640, 264), neither = two(640, 400);
    CHECK(beside.blocks[1].address == 320 * 3);
    CHECK(beside.regions[0].over == 0);
    CHECK(below.blocks[1].address == 264 * 640 * 3);
    CHECK(below.regions[0].over == 0);
    CHECK(neither.regions[0].used == 800 * 640 * 6);
    CHECK(neither.regions[0].over == (800 - 528) * 640 * 6);
    CHECK(neither.clashes.empty());
    // Copies read from even pixels.
    CHECK(two(315, 528).blocks[1].address == 316 * 3);
}

TEST_CASE("frame buffer of the GameCube: targets in turn lie at one place", "[memory_map]") {
    // Target 0 is drawn, and saved to 2; then 1 is drawn, with the depth of 0, and it is the picture.
    const std::vector<Target> targets{target(X8R8G8B8, 640, 480), target(R6G6B6A6, 640, 480),
                                      target(A8R8G8B8, 640, 480), target(D24, 640, 480)};
    const std::vector<Step> steps{{.color = 0, .depth = 3}, {.color = 2, .copied = 0}, {.color = 1, .depth = 3}};
    const MemoryMap map = buffer_map(targets, steps, 1);
    CHECK(map.blocks[0].address == 0);
    CHECK(map.blocks[1].address == 0);
    CHECK(map.regions[0].over == 0);
    CHECK(map.clashes.empty());

    // If 0 is the picture, it is needed while 1 is drawn, and both lie where depth is.
    const MemoryMap clash = buffer_map(targets, steps, 0);
    REQUIRE(clash.clashes.size() == 1);
    CHECK(clash.clashes[0].one == TargetId{0});
    CHECK(clash.clashes[0].other == TargetId{1});
    CHECK(clash.clashes[0].pass == 2);

    // Not if a clear begins it anew.
    std::vector<Step> again = steps;
    again.push_back({.color = 2, .copied = 1});
    again.push_back({.color = 0, .depth = 3, .clears = true});
    CHECK(buffer_map(targets, again, 0).clashes.empty());
    again.back().clears = false;
    CHECK(buffer_map(targets, again, 0).clashes.size() == 1);
}

TEST_CASE("frame buffer of the GameCube: depth of two kinds for one picture", "[memory_map]") {
    const std::vector<Target> targets{target(X8R8G8B8, 64, 64), target(D24, 64, 64), target(D24, 64, 64)};
    const MemoryMap map =
        buffer_map(targets, {{.color = 0, .depth = 1}, {.color = 0, .depth = 2}, {.color = 0, .depth = 1}});
    REQUIRE(map.clashes.size() == 1);
    CHECK(map.clashes[0].one == TargetId{1});
    CHECK(map.clashes[0].other == TargetId{2});
    CHECK(map.clashes[0].pass == 1);
    CHECK(buffer_map(targets, {{.color = 0, .depth = 1}, {.color = 0, .depth = 2}}).clashes.empty());
}

TEST_CASE("frame buffer of the GameCube: targets share a place where no pixel is needed for both", "[memory_map]") {
    // 0 is drawn; a part of it is saved to 2, the same part of 1 is drawn there, with the depth of 0, copied to 2 as well,
    // and the part of 0 is brought back.
    const std::vector<Target> targets{target(X8R8G8B8, 640, 480), target(R6G6B6A6, 640, 480),
                                      target(A8R8G8B8, 640, 480), target(D24, 640, 480)};
    Frame frame = frame_of(targets,
                           {{.color = 0, .depth = 3},
                            {.color = 2, .copied = 0},
                            {.color = 1, .depth = 3},
                            {.color = 2, .copied = 1},
                            {.color = 0}},
                           0);
    const PixelRect part{8, 16, 40, 64};
    const auto copy_part = [&](std::size_t pass) {
        auto& copy = std::get<CopyRectangle>(frame.passes[pass].draws[0]);
        copy.from = part, copy.x = part.x0, copy.y = part.y0;
    };
    copy_part(1);
    copy_part(3);
    frame.passes[2].state.scissor = part;
    frame.passes[4].draws         = {DrawRectangle{.x0 = 8, .y0 = 16, .x1 = 40, .y1 = 64}};
    frame.passes[4].state.blend   = kReplace;
    const auto clashes            = [&] { return lay_out(frame, profile("gamecube")).clashes; };
    CHECK(clashes().empty());
    // A pixel more of 1 is a pixel less of the picture; so is one that is not brought back, or one that is blended over.
    frame.passes[2].state.scissor = {8, 16, 41, 64};
    REQUIRE(clashes().size() == 1);
    CHECK(clashes()[0].pass == 2);
    frame.passes[2].state.scissor = part;
    CHECK(clashes().empty());
    frame.passes[4].state.scissor = {8, 16, 40, 63};
    CHECK(clashes().size() == 1);
    frame.passes[4].state.scissor      = {};
    frame.passes[4].state.blend.source = BlendFactor::SourceAlpha;
    CHECK(clashes().size() == 1);
}

namespace {

struct Span {
    std::uint64_t first, last;
};
void check_apart(const MemoryMap& map, std::size_t region) {
    std::vector<Span> spans;
    for (const MemoryBlock& block : map.blocks) {
        if (block.region != region) continue;
        CHECK(block.address + block.bytes <= map.regions[region].used);
        spans.push_back({block.address, block.address + block.bytes});
    }
    for (std::size_t i = 1; i < spans.size(); ++i) CHECK(spans[i - 1].last <= spans[i].first);
}

// The pixels of a target in the frame buffer, colour or depth.
struct Pixels {
    std::int64_t plane, x0, y0, x1, y1;
};
Pixels pixels_of(const MemoryBlock& block, const Target& one) {
    const auto pixel         = static_cast<std::int64_t>(block.address / 3);
    const std::int64_t plane = is_depth(one.format), within = pixel - plane * 640 * 528;
    const std::int64_t x = within % 640, y = within / 640;
    return {plane, x, y, x + one.width, y + one.height};
}
bool meet(const Pixels& a, const Pixels& b) {
    return a.plane == b.plane && a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

}  // namespace

TEST_CASE("no two blocks of a random frame meet", "[memory_map]") {
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        const Frame frame = test_support::random_frame(seed);
        INFO("seed " << seed);
        for (const char* chip : {"ideal", "dx7", "ps2", "xbox"}) check_apart(lay_out(frame, profile(chip)), 0);
        check_apart(lay_out(frame, profile("gamecube")), 1);
    }
}

TEST_CASE("no two targets of a random frame meet in a frame buffer while both are needed", "[memory_map]") {
    int shared = 0, clashes = 0;
    for (std::uint32_t seed = 0; seed < 1500; ++seed) {
        Frame frame = test_support::random_frame(seed);
        for (Target& one : frame.targets) one.format = is_depth(one.format) ? D24 : X8R8G8B8;
        INFO("seed " << seed);
        const MemoryMap map = lay_out(frame, profile("gamecube"));
        for (std::size_t i = 0; i < frame.targets.size(); ++i) {
            const auto needed = [&](std::size_t target) {
                return needed_pixels(frame, {static_cast<std::int32_t>(target)});
            };
            for (std::size_t k = i + 1; k < frame.targets.size(); ++k) {
                const auto is_this = [&](const MemoryClash& clash) {
                    return clash.one.index == static_cast<int>(i) && clash.other.index == static_cast<int>(k);
                };
                const std::vector<PixelRegion> one = needed(i), other = needed(k);
                const Pixels here  = pixels_of(map.blocks[i], frame.targets[i]),
                             there = pixels_of(map.blocks[k], frame.targets[k]);
                bool both_needed   = false;
                for (std::size_t pass = 0; pass < one.size(); ++pass)
                    both_needed =
                        both_needed || meet(one[pass], other[pass], static_cast<std::int32_t>(there.x0 - here.x0),
                                            static_cast<std::int32_t>(there.y0 - here.y0));
                const bool is_clash = std::any_of(map.clashes.begin(), map.clashes.end(), is_this);
                const bool do_meet  = meet(here, there);
                CHECK((do_meet && both_needed) == is_clash);
                shared += do_meet && !both_needed;
                clashes += is_clash;
            }
        }
    }
    CHECK(shared > 20);
    CHECK(clashes > 5);
}
