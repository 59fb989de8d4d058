// SPDX-License-Identifier: MIT
// The rules of check for what is drawn to, copied and kept in memory.
#include "tests/support/check_frame.h"

using namespace pipeline;
using namespace test_support::check_frame;

TEST_CASE("check: formats that are drawn to", "[check]") {
    using enum TargetFormat;
    const auto draw_to = [](TargetFormat format) { return [=](Frame& f) { f.targets[0].format = format; }; };
    check_refused("ps2", draw_to(R5G6B5),
                  "target 0 'picture': format | targets | R5G6B5, drawn to | PSMCT32 PSMCT24 PSMCT16\n"
                  "pass 0 'draw': depth | targets | D24 beside R5G6B5 | D16\n");
    check_refused("gamecube", draw_to(A8R8G8B8),
                  "target 0 'picture': format | targets | A8R8G8B8, drawn to | R6G6B6A6 X8R8G8B8\n");
    check_refused("xbox", draw_to(A1R5G5B5),
                  "target 0 'picture': format | targets | A1R5G5B5, drawn to | A8R8G8B8 X8R8G8B8 R5G6B5\n");
    check_allowed("dx7", draw_to(A1R5G5B5));
    check_allowed("xbox", draw_to(R5G6B5));
    // Nothing is drawn to it.
    check_allowed("ps2", [](Frame& f) { add_target(f, "spare", R5G6B5); });
    // A clear draws.
    const auto clear_only = [](Frame& f) {
        Pass& clear = f.passes.emplace_back();
        clear.color = add_target(f, "spare", R5G6B5);
        clear.clear = {.color = Argb{0}, .depth = {}};
    };
    check_refused("ps2", clear_only,
                  "target 2 'spare': format | targets | R5G6B5, drawn to | PSMCT32 PSMCT24 PSMCT16\n");
}

TEST_CASE("check: depth formats, and what they stand beside", "[check]") {
    using enum TargetFormat;
    const auto depth_of = [](TargetFormat format) { return [=](Frame& f) { f.targets[1].format = format; }; };
    check_refused("dx7", depth_of(D32), "target 1 'depth': format | depth | D32 | D16 D24\n");
    check_refused("gamecube", depth_of(D16), "target 1 'depth': format | depth | D16 | D24\n");
    check_allowed("ps2", depth_of(D32));
    check_allowed("xbox", depth_of(D16));
    check_refused("ps2", depth_of(D16), "pass 0 'draw': depth | targets | D16 beside PSMCT32 | D24 D32\n");
    check_allowed("ps2", [](Frame& f) {
        f.targets[0].format = Psmct16;
        f.targets[1].format = D16;
    });
    // What is drawn does not meet the depth buffer.
    check_allowed("ps2", [](Frame& f) {
        f.targets[1].format = D16;
        state(f).depth      = {};
    });
}

TEST_CASE("check: sizes of targets", "[check]") {
    const auto size = [](int width, int height) { return [=](Frame& f) { set_size(f, width, height); }; };
    check_allowed("gamecube", size(640, 528));
    check_refused("gamecube", size(640, 530),
                  "target 0 'picture' | limits | width 640 height 530, drawn to | up to width 640 height 528\n"
                  "target 1 'depth' | limits | width 640 height 530, drawn to | up to width 640 height 528\n"
                  "frame | memory | 2035200 bytes, 7680 over: target 0 'picture' 1017600, target 1 'depth' 1017600 | "
                  "2027520 bytes of frame buffer\n");
    check_allowed("ps2", size(2048, 64));
    check_refused("ps2", size(2049, 64),
                  "target 0 'picture' | limits | width 2049 height 64, drawn to | up to width 2048 height 2048\n"
                  "target 1 'depth' | limits | width 2049 height 64, drawn to | up to width 2048 height 2048\n");
    // No limit is known, and what is not read has any size.
    check_allowed("dx7", size(3000, 100));
    check_allowed("xbox", size(5000, 100));
}

TEST_CASE("check: a target that is read keeps to the rules for textures", "[check]") {
    const auto read = [](int width, int height) {
        return [=](Frame& f) {
            const TargetId target    = add_target(f, "cloud", f.targets[0].format, width, height);
            rectangle(f).textures[0] = {.texture = {}, .target = target};
            stage(f).address_u = stage(f).address_v = TextureAddress::Clamp;
        };
    };
    check_allowed("dx7", read(512, 256));
    check_allowed("dx7", read(640, 256));
    check_allowed("ps2", read(1024, 24));
    check_refused("ps2", read(1280, 32),
                  "target 2 'cloud' | limits | width 1280 height 32, read as a texture | up to width 1024 height "
                  "1024\n");
    // Bound, but no function reads it.
    check_allowed("dx7", [&](Frame& f) {
        read(640, 256)(f);
        stage(f).color_op = stage(f).alpha_op = TextureOp::SelectArg2;
    });
}

TEST_CASE("check: what a frame buffer holds is read as a copy", "[check]") {
    const auto read = [](TargetFormat format) {
        return [=](Frame& f) {
            const TargetId target    = add_target(f, "cloud", format);
            rectangle(f).textures[0] = {.texture = {}, .target = target};
            pass(f).draws.push_back(rectangle(f));  // once for a pass
        };
    };
    check_refused("gamecube", read(TargetFormat::X8R8G8B8),
                  "pass 0 'draw': draws[0].textures[0].target | targets | X8R8G8B8 | copies of it, A8R8G8B8\n");
    check_allowed("gamecube", read(TargetFormat::A8R8G8B8));
    check_allowed("dx7", read(TargetFormat::X8R8G8B8));
}

TEST_CASE("check: copies", "[check]") {
    using enum TargetFormat;
    const auto copy = [](TargetFormat to, const CopyRectangle& what) {
        return [=](Frame& f) { add_copy(f, {0}, add_target(f, "copied", to), what); };
    };
    const CopyRectangle all{.source = {}, .from = {0, 0, 64, 32}};
    const CopyRectangle halved{.source = {}, .from = {0, 0, 64, 32}, .halve = true};
    check_allowed("dx7", copy(A8R8G8B8, all));
    check_allowed("ps2", copy(Psmct32, all));
    check_allowed("gamecube", copy(A8R8G8B8, all));
    check_allowed("gamecube", copy(A8R8G8B8, halved));
    check_refused("gamecube", copy(X8R8G8B8, all),
                  "target 2 'copied': format | targets | X8R8G8B8, copied to | A8R8G8B8\n");
    check_refused("xbox", copy(R5G6B5, all), "pass 1 'copy': draws[0] | copy | A8R8G8B8 to R5G6B5 | one format\n");
    check_refused("ps2", copy(Psmct24, all), "pass 1 'copy': draws[0] | copy | PSMCT32 to PSMCT24 | one format\n");
    check_refused("dx7", copy(A8R8G8B8, halved), "pass 1 'copy': draws[0].halve | copy | true | false\n");

    // The copy engine reads the frame buffer alone.
    const auto copy_twice = [&](Frame& f) {
        const TargetId one = add_target(f, "one", A8R8G8B8), two = add_target(f, "two", A8R8G8B8);
        add_copy(f, {0}, one, all);
        add_copy(f, one, two, all);
    };
    check_refused("gamecube", copy_twice, "pass 2 'copy': draws[0].source | copy | A8R8G8B8 | R6G6B6A6 X8R8G8B8\n");
    check_allowed("xbox", copy_twice);
}

TEST_CASE("check: the GameCube copies from even places, whole tiles", "[check]") {
    const auto part = [](const CopyRectangle& copy, int width, int height) {
        return
            [=](Frame& f) { add_copy(f, {0}, add_target(f, "copied", TargetFormat::A8R8G8B8, width, height), copy); };
    };
    const CopyRectangle odd{.source = {}, .from = {2, 0, 10, 7}};
    check_refused("gamecube", part(odd, 8, 7),
                  "pass 1 'copy': draws[0].from | limits | x0 2 x1 10 y1 7 | multiples of 2\n");
    check_allowed("xbox", part(odd, 8, 7));
    const CopyRectangle even{.source = {}, .from = {2, 0, 8, 6}};
    check_allowed("gamecube", part(even, 6, 6));  // the last tiles go over the edge
    check_refused("gamecube", part(even, 8, 6),
                  "pass 1 'copy': draws[0] | limits | x 0 y 0 to x 6 y 6 | tiles of 4x4\n");
    CopyRectangle moved = even;
    moved.x             = 2;
    check_refused("gamecube", part(moved, 8, 6),
                  "pass 1 'copy': draws[0] | limits | x 2 y 0 to x 8 y 6 | tiles of 4x4\n");
    moved.x = 4;
    check_allowed("gamecube", part(moved, 10, 6));
    // Half of 8x8 is one tile.
    check_allowed("gamecube", part({.source = {}, .from = {0, 0, 8, 8}, .halve = true}, 64, 32));
}

TEST_CASE("check: memory", "[check]") {
    // Two targets of 640x448 at 32 bits, 140 pages each, with depth 420; 92 pages are left.
    const auto with_pages = [](int pages) {
        return [=](Frame& f) {
            set_size(f, 640, 448);
            add_target(f, "front", TargetFormat::Psmct32, 640, 448);
            add_target(f, "rest", TargetFormat::Psmct32, 64, 32 * pages);
            f.textures.resize(1);
            set_size(f.textures[0], 64, 32);  // a page
        };
    };
    check_allowed("ps2", with_pages(91));
    check_refused("ps2", with_pages(92),
                  "frame | memory | 4202496 bytes, 8192 over: target 0 'picture' 1146880, target 1 'depth' 1146880, "
                  "target 2 'front' 1146880, target 3 'rest' 753664, texture 0 'noise' 8192 | 4194304 bytes of local "
                  "memory\n");
    check_allowed("ideal", [](Frame& f) {
        for (int i = 0; i < 40; ++i) add_target(f, "large", TargetFormat::A8R8G8B8, 8192, 8192);
    });

    // 31 targets of 1 MB stay within 32 MB; with one more, what is over is the first two targets, 64 * 32 * 4 bytes each,
    // and the textures, in rows of 64 bytes, 8 and 2 + 1 + 1 of them. Only the largest are named.
    const auto with_targets = [](int count) {
        return [=](Frame& f) {
            for (int i = 0; i < count; ++i) add_target(f, "", TargetFormat::A8R8G8B8, 512, 512);
        };
    };
    check_allowed("dx7", with_targets(31));
    check_refused("dx7", with_targets(32),
                  "frame | memory | 33571584 bytes, 17152 over: target 2 1048576, target 3 1048576, target 4 1048576, "
                  "target 5 1048576, target 6 1048576, 31 more | 33554432 bytes of video memory\n");
}

TEST_CASE("check: two targets that are needed at once in one frame buffer", "[check]") {
    // The cloud is drawn with the scene's depth, while the scene is needed for the end.
    const auto with_cloud = [](Frame& f) {
        Pass cloud  = pass(f);
        cloud.label = "cloud";
        cloud.color = add_target(f, "cloud", TargetFormat::R6G6B6A6);
        f.passes.push_back(cloud);
    };
    check_refused("gamecube", with_cloud,
                  "pass 1 'cloud' | memory | target 0 'picture' and target 2 'cloud' at the same pixels | one frame "
                  "buffer\n");
    // The picture is what was copied before.
    check_allowed("gamecube", [&](Frame& f) {
        const TargetId saved = add_target(f, "saved", TargetFormat::A8R8G8B8);
        add_copy(f, {0}, saved, {.source = {}, .from = {0, 0, 64, 32}});
        with_cloud(f);
        f.output = saved;
    });
    check_allowed("xbox", [](Frame& f) {
        Pass cloud  = pass(f);
        cloud.color = add_target(f, "cloud", TargetFormat::A8R8G8B8);
        f.passes.push_back(cloud);
    });
}
