// SPDX-License-Identifier: MIT
#include "pipeline/legalize/copies.h"

#include "pipeline/legalize/arithmetic.h"
#include "pipeline/legalize/pixel_center.h"
#include "tests/support/random.h"
#include "tests/support/random_frame.h"
#include "tests/support/rewritten.h"

using namespace pipeline;
using namespace test_support;

namespace {

// Target 0 gets a copy of target 1, which holds the bytes of an A8R8G8B8 texture.
struct CopiedBytes {
    std::vector<std::uint8_t> texels;
    int width, height;
    TargetFormat from = TargetFormat::A8R8G8B8, to = TargetFormat::A8R8G8B8;
    bool halve = false;
};
Frame copying(const CopiedBytes& bytes) {
    const auto [texels, width, height, from, to, halve] = bytes;
    Frame frame             = small_frame(halve ? width / 2 : width, halve ? height / 2 : height);
    frame.targets[0].format = to;
    frame.targets.push_back({.name = "source", .format = from, .width = width, .height = height});
    DrawRectangle show             = rectangle({0, 0, width, height}, 0xffffffff);
    show.textures[0]               = bound(add_texture(frame, TextureFormat::A8R8G8B8, width, height, texels));
    Pass& fill                     = frame.passes[0];
    fill.color                     = {1};
    fill.state.stages[0]           = kTextureOnly;
    fill.state.stages[0].address_u = fill.state.stages[0].address_v = TextureAddress::Clamp;
    fill.draws                                                      = {show};
    Pass& copy                                                      = frame.passes.emplace_back();
    copy.color                                                      = {0};
    copy.draws = {CopyRectangle{.source = {1}, .from = {0, 0, width, height}, .halve = halve}};
    return frame;
}

// Blocks of 2x2 texels, block S with the sum S in each channel, 0..1020.
std::vector<std::uint8_t> all_sums() {
    constexpr int kBlocks = 1021;
    std::vector<std::uint8_t> texels(2 * 2 * kBlocks * 4);
    for (int sum = 0; sum < kBlocks; ++sum)
        for (int i = 0; i < 4; ++i) {
            const auto texel = static_cast<std::uint8_t>(sum / 4 + (i < sum % 4 ? 1 : 0));
            const int at     = (i / 2 * 2 * kBlocks + 2 * sum + i % 2) * 4;
            for (int channel = 0; channel < 4; ++channel) texels[static_cast<std::size_t>(at + channel)] = texel;
        }
    return texels;
}

std::uint32_t grey(int value) {
    return static_cast<std::uint32_t>(value) * 0x01010101u;
}

}  // namespace

TEST_CASE("a copy that halves or converts becomes a rectangle that shows the whole source, limited to what is copied") {
    check_rewrite(&draw_copies, "dx7", R"(
targets [
    "picture" { width 32 height 16 }
    "same" { width 64 height 32 }
    "565" { format R5G6B5 width 8 height 8 }
    "depth" { format D24 width 32 height 16 }
]
passes [
    "copy" {
        color "picture"
        depth "depth"
        clear { color 0x00000000 depth 1 }
        state { scissor { x0 1 y0 1 x1 3 y1 3 } }
        draws [
            copy { source "same" from { x0 8 y0 4 x1 20 y1 10 } x 5 y 7 halve true }
            copy { source "same" from { x1 2 y1 2 } }
            copy { source "same" from { x1 2 y1 2 } x 2 }
            copy { source "565" from { x0 3 x1 8 y1 2 } x 1 y 2 }
        ]
    }
]
)",
                  R"(
targets [
    "picture" { width 32 height 16 }
    "same" { width 64 height 32 }
    "565" { format R5G6B5 width 8 height 8 }
    "depth" { format D24 width 32 height 16 }
]
passes [
    "copy" {
        color "picture"
        depth "depth"
        clear { color 0x00000000 depth 1 }
        state { scissor { x0 1 y0 1 x1 3 y1 3 } }
    }
    "copy" {
        color "picture"
        state {
            stages [{ color_op SELECTARG1 alpha_op SELECTARG1 filter LINEAR address_u CLAMP address_v CLAMP }]
            viewport { x0 5 y0 7 x1 11 y1 10 }
        }
        draws [ rectangle { x0 1 y0 5 x1 33 y1 21 textures [{ target "same" }] } ]
    }
    "copy" {
        color "picture"
        depth "depth"
        state { scissor { x0 1 y0 1 x1 3 y1 3 } }
        draws [
            copy { source "same" from { x1 2 y1 2 } }
            copy { source "same" from { x1 2 y1 2 } x 2 }
        ]
    }
    "copy" {
        color "picture"
        state {
            stages [{ color_op SELECTARG1 alpha_op SELECTARG1 address_u CLAMP address_v CLAMP }]
            viewport { x0 1 y0 2 x1 6 y1 4 }
        }
        draws [ rectangle { x0 -2 y0 2 x1 6 y1 10 textures [{ target "565" }] } ]
    }
]
)");
}

TEST_CASE("with pixel centres at integers the rectangle lies half a pixel to the left and up") {
    check_rewrite(&draw_copies, "dx7", R"(
arithmetic { pixel_center 0 }
targets [ "picture" { width 32 height 16 } "source" { width 64 height 32 } ]
passes [ "copy" { color "picture" draws [ copy { source "source" from { x1 64 y1 32 } halve true } ] } ]
)",
                  R"(
arithmetic { pixel_center 0 }
targets [ "picture" { width 32 height 16 } "source" { width 64 height 32 } ]
passes [
    "copy" {
        color "picture"
        state {
            stages [{ color_op SELECTARG1 alpha_op SELECTARG1 filter LINEAR address_u CLAMP address_v CLAMP }]
            viewport { x1 32 y1 16 }
        }
        draws [ rectangle { x0 -0.5 y0 -0.5 x1 31.5 y1 15.5 textures [{ target "source" }] } ]
    }
]
)");
}

TEST_CASE("copies that the chip has are left alone") {
    constexpr std::string_view kHalve = R"(
targets [ "picture" { format A8R8G8B8 width 8 height 8 } "source" { format X8R8G8B8 width 8 height 8 } ]
passes [ "copy" { color "picture" draws [ copy { source "source" from { x1 8 y1 8 } halve true } ] } ]
)";
    check_left_alone(&draw_copies, "ideal", kHalve);
    check_left_alone(&draw_copies, "gamecube", kHalve);
    for (const std::string_view chip : {"dx7", "ps2", "xbox"})
        check_left_alone(&draw_copies, chip, R"(
targets [ "picture" { format PSMCT32 width 8 height 8 } "source" { format PSMCT32 width 8 height 8 } ]
passes [
    "copy" { color "picture" draws [ copy { source "source" from { x1 8 y1 8 } } ] }
    "no copy" { color "picture" state { alpha_test { func LESS } } draws [ rectangle { x1 4 y1 4 } ] }
]
)");
}

TEST_CASE("a drawn copy gives each byte of each channel as a copy does, from all formats to all") {
    std::vector<std::uint8_t> texels;
    for (int i = 0; i < 256; ++i)
        for (const int byte : {i, (i + 64) % 256, (i + 128) % 256, (i + 192) % 256})
            texels.push_back(static_cast<std::uint8_t>(byte));
    const auto from = static_cast<TargetFormat>(GENERATE(range(0, 8)));
    for (int format = 0; format < 8; ++format) {
        const auto to = static_cast<TargetFormat>(format);
        INFO(enum_name(from) << " to " << enum_name(to));
        const Frame frame = copying({texels, 64, 4, from, to});
        const Frame drawn = rewritten(frame, &draw_copies, "dx7");
        CHECK((drawn != frame) == (from != to));
        CHECK(pixels_of(drawn) == pixels_of(frame));
    }
}

TEST_CASE("a drawn copy halves to (S + 2) >> 2, where a copy gives S >> 2, for all sums of four bytes") {
    const Frame frame = copying({all_sums(), 2 * 1021, 2, TargetFormat::A8R8G8B8, TargetFormat::A8R8G8B8, true});
    const Frame drawn = rewritten(frame, &draw_copies, "dx7");
    const Frame moved = rewritten(drawn, &move_to_pixel_centers, "dx7");
    const Frame later = rewritten(rewritten(frame, &move_to_pixel_centers, "dx7"), &draw_copies, "dx7");
    std::vector<std::uint32_t> copied, rounded;
    for (int sum = 0; sum <= 1020; ++sum) {
        copied.push_back(grey(sum >> 2));
        rounded.push_back(grey((sum + 2) >> 2));
    }
    CHECK(pixels_of(frame) == copied);
    CHECK(pixels_of(drawn) == rounded);
    CHECK(pixels_of(moved) == rounded);
    CHECK(pixels_of(later) == rounded);
}

TEST_CASE("the Graphics Synthesizer's filter halves as a copy does, for all sums of four bytes") {
    const Frame frame = copying({all_sums(), 2 * 1021, 2, TargetFormat::Psmct32, TargetFormat::Psmct32, true});
    const Frame drawn = rewritten(rewritten(rewritten(frame, &draw_copies, "ps2"), &move_to_pixel_centers, "ps2"),
                                  &use_chip_arithmetic, "ps2");
    CHECK(drawn.arithmetic.filter == FilterRule::GsFloor4);
    CHECK(pixels_of(drawn) == pixels_of(frame));
}

TEST_CASE("parts of targets of all sizes are drawn as copies would: plain to the bit, halved to at most 1 more") {
    int halved = 0;
    for (std::uint32_t seed = 1; seed <= 300; ++seed) {
        INFO("seed " << seed);
        Random random(seed);
        CopiedBytes bytes{.width = random.from(2, 330), .height = random.from(2, 40), .halve = random.chance(50)};
        if (!bytes.halve) bytes.to = TargetFormat::X8R8G8B8;
        for (int i = 0; i < bytes.width * bytes.height * 4; ++i)
            bytes.texels.push_back(static_cast<std::uint8_t>(random.bits() >> 24));
        Frame frame       = copying(bytes);
        frame.arithmetic  = find_profile("dx7")->arithmetic;
        auto& copy        = std::get<CopyRectangle>(frame.passes[1].draws[0]);
        const int step    = bytes.halve ? 2 : 1;
        const int columns = random.from(1, bytes.width / step), rows = random.from(1, bytes.height / step);
        copy.from.x0                          = step * random.from(0, bytes.width / step - columns);
        copy.from.y0                          = step * random.from(0, bytes.height / step - rows);
        copy.from.x1                          = copy.from.x0 + step * columns;
        copy.from.y1                          = copy.from.y0 + step * rows;
        copy.x                                = random.from(0, frame.targets[0].width - columns);
        copy.y                                = random.from(0, frame.targets[0].height - rows);
        const std::vector<std::uint32_t> want = pixels_of(frame),
                                         got  = pixels_of(rewritten(frame, &draw_copies, "dx7"));
        bool same                             = true;
        for (std::size_t i = 0; i < want.size(); ++i)
            for (int shift = 0; shift < 32; shift += 8) {
                const int more = static_cast<int>(got[i] >> shift & 255) - static_cast<int>(want[i] >> shift & 255);
                same           = same && (more == 0 || (bytes.halve && more == 1));
            }
        REQUIRE(same);
        halved += bytes.halve;
    }
    CHECK(halved > 100);
}

TEST_CASE("no copy is left that the chip lacks, whatever the frame") {
    const std::string_view chip = GENERATE("dx7", "ps2");
    int lacked                  = 0;
    for (std::uint32_t seed = 1; seed <= 300; ++seed) {
        INFO(chip << ", seed " << seed);
        const Frame frame = random_frame(seed);
        lacked += is_found(frame, chip, "copy");
        REQUIRE(!is_found(rewritten(frame, &draw_copies, chip), chip, "copy"));
    }
    CHECK(lacked >= 20);
}
