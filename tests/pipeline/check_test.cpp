// SPDX-License-Identifier: MIT
// What check says of a frame as a whole and of its states. Other rules: check_targets_test.cpp, check_textures_test.cpp.
#include "tests/support/check_frame.h"
#include "tests/support/random_frame.h"

using namespace pipeline;
using namespace test_support::check_frame;

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
