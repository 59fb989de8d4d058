// SPDX-License-Identifier: MIT
// What check says of a frame as a whole, and how it says it. The rules: check_targets_test.cpp, check_states_test.cpp,
// check_textures_test.cpp.
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
