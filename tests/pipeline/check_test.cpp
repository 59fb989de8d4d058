// SPDX-License-Identifier: MIT
// Each rule of check by a frame that a chip may draw and one change to it: exactly the findings that it must give, or
// none where the chip has what is asked or where nothing comes of it.
#include "pipeline/check/check.h"

#include <functional>

#include "pipeline/validate/validate.h"
#include "tests/support/random_frame.h"
#include "tests/support/small_frame.h"

using namespace pipeline;

namespace {

const Profile& profile(std::string_view name) {
    const Profile* found = find_profile(name);
    REQUIRE(found != nullptr);
    return *found;
}

// Targets: 0 "picture", which keeps alpha, and 1 "depth", 64x32. Textures: 0 "noise", one level, and 1 "mips". Pass 0
// "draw" has a rectangle with "noise" and a triangle, and a state that all chips have.
Frame frame_for(const Profile& chip) {
    Frame frame;
    frame.output     = {0};
    frame.arithmetic = chip.arithmetic;
    frame.targets    = {{"picture", chip.formats.with_alpha, 64, 32}, {"depth", TargetFormat::D24, 64, 32}};
    frame.cameras.resize(1);
    frame.vertices.resize(3);
    frame.indices                 = {0, 1, 2};
    frame.textures                = {{"noise", TextureFormat::A8R8G8B8, 8, 8, 1, {}},
                                     {"mips", TextureFormat::L8, 4, 2, 3, std::vector<std::uint8_t>(8 + 2 + 1)}};
    frame.textures[0].texels      = std::vector<std::uint8_t>(8 * 8 * 4);
    Pass& pass                    = frame.passes.emplace_back();
    pass.label                    = "draw";
    pass.color                    = {0};
    pass.depth                    = {1};
    pass.camera                   = {0};
    pass.state.depth              = {.func = CompareFunc::GreaterEqual, .write = true};
    pass.state.stages[0].color_op = TextureOp::Modulate;
    pass.state.stages[0].alpha_op = TextureOp::Modulate;
    DrawRectangle rectangle       = {.x1 = 8.0f, .y1 = 8.0f};
    rectangle.textures[0].texture = {0};
    pass.draws                    = {rectangle, DrawTriangles{.index_count = 3}};
    if (chip.states.transforms) return frame;
    pass.draws[1] = DrawWindowTriangles{.index_count = 3};
    frame.window_vertices.resize(3);
    frame.vertices.clear();
    frame.cameras.clear();
    pass.camera = {};
    return frame;
}

Pass& pass(Frame& frame) {
    return frame.passes[0];
}
PipelineState& state(Frame& frame) {
    return frame.passes[0].state;
}
TextureStage& stage(Frame& frame) {
    return state(frame).stages[0];
}
DrawRectangle& rectangle(Frame& frame) {
    return std::get<DrawRectangle>(pass(frame).draws[0]);
}
void drop_triangles(Frame& frame) {
    pass(frame).draws.pop_back();
}
TargetId add_target(Frame& frame, const char* name, TargetFormat format, int width = 64, int height = 32) {
    frame.targets.push_back({name, format, width, height});
    return {static_cast<std::int32_t>(frame.targets.size()) - 1};
}
void set_size(Texture& texture, int width, int height) {
    texture.width  = width;
    texture.height = height;
    texture.texels.resize(static_cast<std::size_t>(width * height * bytes_per_texel(texture.format)));
}
void set_size(Frame& frame, int width, int height) {
    for (Target& target : frame.targets) {
        target.width  = width;
        target.height = height;
    }
}
Pass& add_copy(Frame& frame, TargetId from, TargetId to, const CopyRectangle& copy) {
    Pass& added                                    = frame.passes.emplace_back();
    added.label                                    = "copy";
    added.color                                    = to;
    added.draws                                    = {copy};
    std::get<CopyRectangle>(added.draws[0]).source = from;
    return added;
}

// A line for each finding: where | rule | uses | has.
std::string text_of(const std::vector<ChipFinding>& findings) {
    std::string text;
    for (const ChipFinding& finding : findings)
        text += finding.where + " | " + std::string(finding.rule) + " | " + finding.uses + " | " + finding.has + "\n";
    return text;
}

using Change = std::function<void(Frame&)>;

std::string found(std::string_view chip, const Change& change) {
    Frame frame = frame_for(profile(chip));
    change(frame);
    const std::vector<ChipFinding> findings = check(frame, profile(chip));
    for (const ChipFinding& finding : findings) CHECK(find_evidence(profile(chip), finding.rule) != nullptr);
    return text_of(findings);
}

// On a chip that refuses, what it says; on one that does not, the frame being valid, nothing.
void check_refused(std::string_view chip, const Change& change, const std::string& findings) {
    INFO(chip);
    CHECK(found(chip, change) == findings);
}
void check_allowed(std::string_view chip, const Change& change) {
    INFO(chip);
    Frame frame = frame_for(profile(chip));
    change(frame);
    for (const Finding& finding : validate(frame)) FAIL_CHECK(finding.where << ": " << finding.what);
    CHECK(text_of(check(frame, profile(chip))) == "");
}

}  // namespace

TEST_CASE("check: the frame that the rules are tried on may be drawn by every chip", "[check]") {
    for (const Profile& chip : profiles()) check_allowed(chip.name, [](Frame&) {});
}

TEST_CASE("check: arithmetic is one finding, of the fields that differ", "[check]") {
    const auto other_filter = [](Frame& f) { f.arithmetic.filter = FilterRule::GsNearest4; };
    check_refused("ps2", other_filter, "arithmetic | filter | filter GS_NEAREST4 | filter GS_FLOOR4\n");
    check_refused(
        "xbox", [](Frame& f) { f.arithmetic = {}; },
        "arithmetic | snap | snap NEAREST filter REFERENCE8 blend_source BYTES | snap TRUNCATE filter "
        "NV2A_HALFUP8 blend_source TARGET_BITS\n");
}

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

TEST_CASE("check: sizes of textures", "[check]") {
    const auto size = [](int width, int height) { return [=](Frame& f) { set_size(f.textures[0], width, height); }; };
    const auto clamped = [&](int width, int height) {
        return [=](Frame& f) {
            set_size(f.textures[0], width, height);
            stage(f).address_u = stage(f).address_v = TextureAddress::Clamp;
        };
    };
    check_allowed("ps2", size(1024, 512));
    check_refused("ps2", size(2048, 8),
                  "texture 0 'noise' | limits | width 2048 height 8 | up to width 1024 height 1024\n");
    check_allowed("gamecube", size(8, 1024));
    check_refused("gamecube", size(8, 2048),
                  "texture 0 'noise' | limits | width 8 height 2048 | up to width 1024 height 1024\n");
    check_allowed("dx7", size(2048, 8));
    check_refused("dx7", size(4096, 8),
                  "texture 0 'noise' | limits | width 4096 height 8 | up to width 2048 height 2048\n");
    check_allowed("xbox", size(4096, 8));
    check_refused("xbox", size(8192, 8),
                  "texture 0 'noise' | limits | width 8192 height 8 | up to width 4096 height 4096\n");
    for (const char* chip : {"dx7", "ps2", "gamecube", "xbox", "ideal"}) check_allowed(chip, clamped(48, 8));
    check_allowed("ideal", size(8192, 8));
}

TEST_CASE("check: formats of textures", "[check]") {
    // All chips have all that frames have; a chip that had less would say so.
    Profile chip                = profile("dx7");
    chip.limits.texture_formats = {TextureFormat::A8R8G8B8};
    CHECK(text_of(check(frame_for(chip), chip)) == "texture 1 'mips': format | limits | L8 | A8R8G8B8\n");
    for (const Profile& one : profiles())
        check_allowed(one.name, [](Frame& f) {
            f.textures[0].format = TextureFormat::A8;
            set_size(f.textures[0], 8, 8);
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

TEST_CASE("check: blends", "[check]") {
    const auto blend = [](BlendFactor source, BlendFactor dest) {
        return [=](Frame& f) { state(f).blend = {.source = source, .dest = dest}; };
    };
    using enum BlendFactor;
    check_allowed("gamecube", blend(DestColor, SourceColor));
    check_refused("gamecube", blend(SourceColor, InvDestColor),
                  "pass 0 'draw': state.blend.source | states | SRCCOLOR | ZERO ONE SRCALPHA INVSRCALPHA DESTALPHA "
                  "INVDESTALPHA DESTCOLOR INVDESTCOLOR\n"
                  "pass 0 'draw': state.blend.dest | states | INVDESTCOLOR | ZERO ONE SRCALPHA INVSRCALPHA DESTALPHA "
                  "INVDESTALPHA SRCCOLOR INVSRCCOLOR\n");
    check_allowed("dx7", blend(SourceColor, InvDestColor));
    check_refused("ps2", blend(SourceAlpha, InvSourceAlpha),
                  "pass 0 'draw': state.blend | states | source SRCALPHA dest INVSRCALPHA | gs_blend\n");

    // ALPHA 0x44, over.
    const auto gs_blend = [](Frame& f) { state(f).gs_blend = {.b = GsColor::Cd, .d = GsColor::Cd}; };
    check_allowed("ps2", gs_blend);
    check_refused("xbox", gs_blend, "pass 0 'draw': state.gs_blend | states | b CD d CD | blend\n");
    // A pass without a colour target blends nothing.
    check_allowed("gamecube", [&](Frame& f) {
        blend(SourceColor, InvDestColor)(f);
        pass(f).color = {};
    });
}

TEST_CASE("check: dithers", "[check]") {
    const auto dither = [](DitherMode mode) { return [=](Frame& f) { state(f).dither.mode = mode; }; };
    check_allowed("gamecube", dither(DitherMode::Flipper2x2));
    check_refused("gamecube", dither(DitherMode::GsDimx),
                  "pass 0 'draw': state.dither.mode | dither | GS_DIMX | NONE FLIPPER_2X2\n");
    check_refused("xbox", dither(DitherMode::Flipper2x2),
                  "pass 0 'draw': state.dither.mode | states | FLIPPER_2X2 | NONE\n");
    check_allowed("ps2", [](Frame& f) {
        f.targets[0].format  = TargetFormat::Psmct16;
        f.targets[1].format  = TargetFormat::D16;
        state(f).dither.mode = DitherMode::GsDimx;
    });
}

TEST_CASE("check: colour masks", "[check]") {
    const auto mask = [](const ColorMask& channels) { return [=](Frame& f) { state(f).color_mask = channels; }; };
    const ColorMask no_alpha{.alpha = false}, no_color{.red = false, .green = false, .blue = false},
        no_red{.red = false};
    check_refused("dx7", mask(no_alpha), "pass 0 'draw': state.color_mask | states | alpha false | none\n");
    check_refused("dx7", mask(no_color),
                  "pass 0 'draw': state.color_mask | states | red false green false blue false | none\n");
    check_allowed("gamecube", mask(no_alpha));
    check_allowed("gamecube", mask(no_color));
    check_refused("gamecube", mask(no_red),
                  "pass 0 'draw': state.color_mask | states | red false | colour and alpha\n");
    check_allowed("ps2", mask(no_red));
    check_allowed("xbox", mask(no_red));
    // A target without alpha has none to mask.
    check_allowed("dx7", [&](Frame& f) {
        mask(no_alpha)(f);
        f.targets[0].format = TargetFormat::X8R8G8B8;
    });
    // Clears know no mask.
    check_allowed("dx7", [&](Frame& f) {
        mask(no_color)(f);
        pass(f).draws.clear();
        pass(f).clear.color = Argb{0};
    });
}

TEST_CASE("check: tests", "[check]") {
    const auto func = [](CompareFunc depth) { return [=](Frame& f) { state(f).depth.func = depth; }; };
    check_refused("ps2", func(CompareFunc::LessEqual),
                  "pass 0 'draw': state.depth.func | depth | LESSEQUAL | NEVER ALWAYS GREATEREQUAL GREATER\n");
    check_allowed("ps2", func(CompareFunc::Greater));
    check_allowed("gamecube", func(CompareFunc::LessEqual));

    const auto fail = [](CompareFunc alpha) {
        return [=](Frame& f) { state(f).alpha_test = {.func = alpha, .fail = AlphaFail::ZbOnly}; };
    };
    check_refused("dx7", fail(CompareFunc::Less),
                  "pass 0 'draw': state.alpha_test.fail | alpha_test | ZB_ONLY | KEEP\n");
    check_allowed("dx7", fail(CompareFunc::Always));  // nothing fails
    check_allowed("ps2", fail(CompareFunc::Less));

    const auto dest_alpha = [](Frame& f) { state(f).dest_alpha_test = DestAlphaTest::One; };
    check_refused("xbox", dest_alpha, "pass 0 'draw': state.dest_alpha_test | states | ONE | none\n");
    check_allowed("ps2", dest_alpha);
    check_allowed("ideal", dest_alpha);
}

TEST_CASE("check: scissor", "[check]") {
    const auto scissor = [](const PixelRect& pixels) { return [=](Frame& f) { state(f).scissor = pixels; }; };
    check_refused("dx7", scissor({0, 8, 64, 16}), "pass 0 'draw': state.scissor | states | y0 8 x1 64 y1 16 | none\n");
    check_allowed("dx7", scissor({0, 0, 64, 32}));
    for (const char* chip : {"ps2", "gamecube", "xbox"}) check_allowed(chip, scissor({0, 8, 64, 16}));
    // The viewport lies within.
    check_allowed("dx7", [&](Frame& f) {
        scissor({0, 8, 64, 16})(f);
        state(f).viewport = {4, 8, 60, 16};
    });
    // It limits clears as well.
    check_refused(
        "dx7",
        [&](Frame& f) {
            scissor({1, 0, 64, 32})(f);
            pass(f).draws.clear();
            pass(f).clear.color = Argb{0};
        },
        "pass 0 'draw': state.scissor | states | x0 1 x1 64 y1 32 | none\n");
}

TEST_CASE("check: what is for triangles", "[check]") {
    const auto cull = [](Frame& f) { state(f).cull = CullMode::Clockwise; };
    const auto flat = [](Frame& f) { state(f).shade = ShadeMode::Flat; };
    const auto add  = [](Frame& f) { state(f).lighting.specular_enable = true; };
    check_refused("ps2", cull, "pass 0 'draw': state.cull | states | CW | NONE\n");
    check_refused("ps2", flat,
                  "pass 0 'draw': state.shade | flat | FLAT, by the first vertex | FLAT, by the last vertex\n");
    check_refused("gamecube", flat, "pass 0 'draw': state.shade | flat | FLAT, by the first vertex | GOURAUD\n");
    check_refused("ps2", add, "pass 0 'draw': state.lighting.specular_enable | states | true | false\n");
    for (const char* chip : {"dx7", "xbox"}) {
        check_allowed(chip, cull);
        check_allowed(chip, flat);
        check_allowed(chip, add);
    }
    for (const Change& change : {Change(cull), Change(flat), Change(add)}) {
        check_allowed("ps2", [&](Frame& f) {
            change(f);
            drop_triangles(f);
        });
    }
}

TEST_CASE("check: the number of stages", "[check]") {
    const auto two = [](Frame& f) {
        state(f).stages[1].color_op = TextureOp::SelectArg2;
        state(f).stages[1].alpha_op = TextureOp::SelectArg2;
    };
    check_refused("ps2", two, "pass 0 'draw': state.stages | stages | 2 | 1\n");
    for (const char* chip : {"dx7", "gamecube", "xbox", "ideal"}) check_allowed(chip, two);
}

TEST_CASE("check: arguments of stages", "[check]") {
    const auto argument = [](const TextureArg& arg) { return [=](Frame& f) { stage(f).color_arg2 = arg; }; };
    const TextureArg factor{.source = ArgSource::TFactor}, inverse{.complement = true}, alpha{.alpha_replicate = true};
    check_refused("ps2", argument(factor),
                  "pass 0 'draw': state.stages[0].color_arg2.source | stages | TFACTOR | DIFFUSE CURRENT TEXTURE\n");
    check_refused("ps2", argument(alpha),
                  "pass 0 'draw': state.stages[0].color_arg2.alpha_replicate | stages | true | false\n");
    check_refused("gamecube", argument(inverse),
                  "pass 0 'draw': state.stages[0].color_arg2.complement | stages | true | false\n");
    check_allowed("gamecube", argument(factor));
    check_allowed("gamecube", argument(alpha));
    check_allowed("dx7", argument(inverse));
    // An argument that the function does not read.
    check_allowed("ps2", [&](Frame& f) {
        argument(factor)(f);
        stage(f).color_op = TextureOp::SelectArg1;
        stage(f).alpha_op = TextureOp::SelectArg1;
    });
    // Every one of both functions is looked at.
    check_refused(
        "ps2",
        [&](Frame& f) {
            stage(f).color_arg2 = factor;
            stage(f).alpha_arg2 = factor;
            state(f).stages[1]  = stage(f);
        },
        "pass 0 'draw': state.stages | stages | 2 | 1\n"
        "pass 0 'draw': state.stages[0].color_arg2.source | stages | TFACTOR | DIFFUSE CURRENT TEXTURE\n"
        "pass 0 'draw': state.stages[0].alpha_arg2.source | stages | TFACTOR | DIFFUSE CURRENT TEXTURE\n"
        "pass 0 'draw': state.stages[1].color_arg2.source | stages | TFACTOR | DIFFUSE CURRENT TEXTURE\n"
        "pass 0 'draw': state.stages[1].alpha_arg2.source | stages | TFACTOR | DIFFUSE CURRENT TEXTURE\n");
}

TEST_CASE("check: functions of stages", "[check]") {
    using enum TextureOp;
    const auto ops = [](TextureOp color, TextureOp alpha) {
        return [=](Frame& f) {
            stage(f).color_op = color;
            stage(f).alpha_op = alpha;
        };
    };
    const std::string has = " | DISABLE SELECTARG1 SELECTARG2 MODULATE ADD MODULATECOLOR_ADDALPHA\n";
    check_refused("ps2", ops(AddSigned, Modulate2X),
                  "pass 0 'draw': state.stages[0].color_op | stages | ADDSIGNED" + has +
                      "pass 0 'draw': state.stages[0].alpha_op | stages | MODULATE2X" + has);
    for (const char* chip : {"dx7", "gamecube", "xbox"}) check_allowed(chip, ops(AddSigned, Modulate2X));

    // TFX and TCC. ARG1 is the texel, ARG2 the vertex's colour.
    check_allowed("ps2", ops(Modulate, Modulate));      // MODULATE, TCC 1
    check_allowed("ps2", ops(Modulate, SelectArg2));    // TCC 0
    check_allowed("ps2", ops(SelectArg1, SelectArg1));  // DECAL
    check_allowed("ps2", ops(SelectArg1, SelectArg2));
    check_allowed("ps2", ops(SelectArg2, SelectArg2));  // no texture
    const auto refused = [&](TextureOp color, TextureOp alpha, const std::string& uses) {
        check_refused("ps2", ops(color, alpha),
                      "pass 0 'draw': state.stages[0] | stages | " + uses + " | MODULATE DECAL HIGHLIGHT HIGHLIGHT2\n");
    };
    refused(Modulate, SelectArg1, "color_op MODULATE alpha_op SELECTARG1");
    refused(SelectArg1, Modulate, "color_op SELECTARG1 alpha_op MODULATE");
    refused(SelectArg2, SelectArg1, "color_op SELECTARG2 alpha_op SELECTARG1");
    refused(Add, Add, "color_op ADD alpha_op ADD");
    refused(ModulateColorAddAlpha, Add, "color_op MODULATECOLOR_ADDALPHA alpha_op ADD");  // adds the texel's alpha

    // HIGHLIGHT adds the vertex's alpha, so that it is ARG1 of the colour.
    const auto highlight = [&](TextureOp alpha) {
        return [=](Frame& f) {
            ops(ModulateColorAddAlpha, alpha)(f);
            stage(f).color_arg1 = {.source = ArgSource::Diffuse};
            stage(f).color_arg2 = {.source = ArgSource::Texture};
        };
    };
    check_allowed("ps2", highlight(Add));         // HIGHLIGHT
    check_allowed("ps2", highlight(SelectArg1));  // HIGHLIGHT2
    check_allowed("ps2", highlight(SelectArg2));
    check_refused("ps2", highlight(Modulate),
                  "pass 0 'draw': state.stages[0] | stages | color_op MODULATECOLOR_ADDALPHA color_arg1 { source "
                  "DIFFUSE } color_arg2 { source TEXTURE } alpha_op MODULATE | MODULATE DECAL HIGHLIGHT HIGHLIGHT2\n");
}

TEST_CASE("check: addresses and mip filters", "[check]") {
    const auto mirror = [](Frame& f) { stage(f).address_u = TextureAddress::Mirror; };
    check_refused("ps2", mirror, "pass 0 'draw': state.stages[0].address_u | stages | MIRROR | WRAP CLAMP\n");
    check_refused(
        "ps2", [](Frame& f) { stage(f).address_v = TextureAddress::Mirror; },
        "pass 0 'draw': state.stages[0].address_v | stages | MIRROR | WRAP CLAMP\n");
    check_allowed("gamecube", mirror);
    check_allowed("ps2", [&](Frame& f) {
        mirror(f);
        rectangle(f).textures = {};
    });

    const auto mips = [](Frame& f) {
        stage(f).mip_filter              = MipFilter::Point;
        rectangle(f).textures[0].texture = {1};
    };
    check_refused("ps2", mips, "pass 0 'draw': state.stages[0].mip_filter | lod | POINT | NONE\n");
    check_allowed("xbox", mips);
    // A texture with one level.
    check_allowed("ps2", [&](Frame& f) {
        mips(f);
        rectangle(f).textures[0].texture = {0};
    });
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

TEST_CASE("check: every finding is there, not only the first", "[check]") {
    const auto spoil = [](Frame& f) {
        f.arithmetic.pixel_center = 1;
        state(f).blend            = kAlphaOver;
        state(f).cull             = CullMode::Clockwise;
        stage(f).address_v        = TextureAddress::Mirror;
        f.passes.push_back(pass(f));
    };
    const std::string of_a_pass =
        "': state.blend | states | source SRCALPHA dest INVSRCALPHA | gs_blend\n#': state.cull | states | CW | "
        "NONE\n#': state.stages[0].address_v | stages | MIRROR | WRAP CLAMP\n";
    std::string expected = "arithmetic | pixel_center | pixel_center 1 | pixel_center 0\n";
    for (const char* name : {"pass 0 'draw", "pass 1 'draw"}) {
        std::string lines = "#" + of_a_pass;
        for (std::size_t at = lines.find('#'); at != std::string::npos; at = lines.find('#'))
            lines.replace(at, 1, name);
        expected += lines;
    }
    check_refused("ps2", spoil, expected);
}

TEST_CASE("check: the ideal profile refuses no frame with its arithmetic", "[check]") {
    int of_ideal = 0;
    for (std::uint32_t seed = 0; seed < 500; ++seed) {
        Frame frame = test_support::random_frame(seed);
        if (frame.arithmetic != Arithmetic{}) continue;
        for (Pass& one : frame.passes) one.state.dither = {};  // a chip's own
        ++of_ideal;
        INFO("seed " << seed);
        CHECK(text_of(check(frame, profile("ideal"))) == "");
    }
    CHECK(of_ideal > 50);
}

TEST_CASE("check: every finding on a random frame has a source", "[check]") {
    std::size_t count = 0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        const Frame frame = test_support::random_frame(seed);
        for (const Profile& chip : profiles()) {
            for (const ChipFinding& finding : check(frame, chip)) {
                INFO(seed << ' ' << chip.name << ' ' << finding.where);
                CHECK(find_evidence(chip, finding.rule) != nullptr);
                CHECK(!finding.uses.empty());
                CHECK(!finding.has.empty());
                ++count;
            }
        }
    }
    CHECK(count > 1000);
}
