// SPDX-License-Identifier: MIT
#include "pipeline/legalize/formats.h"

#include "pipeline/frame/frame_text.h"
#include "pipeline/validate/validate.h"
#include "tests/support/small_frame.h"

using namespace pipeline;

namespace {

std::string rewritten(std::string_view chip, const std::string& text, RewriteNotes* notes = nullptr) {
    RewriteNotes own;
    const Frame frame = rewrite_formats(parse_frame(text), *find_profile(chip), notes != nullptr ? *notes : own);
    for (const Finding& finding : validate(frame)) FAIL_CHECK(finding.where << ": " << finding.what);
    return to_text(frame);
}
void check_rewrite(std::string_view chip, const std::string& before, const std::string& after) {
    INFO(chip);
    CHECK(rewritten(chip, before) == to_text(parse_frame(after)));
}

// "a" is the picture and is drawn with depth; what is drawn into "b" is then read by the stage given.
std::string frame_text(const std::string& a, const std::string& b, const std::string& depth,
                       const std::string& stage = "color_op SELECTARG1 alpha_op SELECTARG1") {
    return "nimbus7 frame 1\noutput \"a\" targets [\"a\" {format " + a + " width 4 height 4} \"b\" {format " + b +
           " width 4 height 4} \"depth\" {format " + depth +
           " width 4 height 4}] passes ["
           "\"fill\" {color \"b\" draws [rectangle {x1 4 y1 4}]}"
           "\"draw\" {color \"a\" depth \"depth\" clear {depth 1} state {depth {func LESSEQUAL write true} stages [{" +
           stage + "}]} draws [rectangle {x1 4 y1 4 textures [{target \"b\"}]}]}]";
}

}  // namespace

TEST_CASE("formats: the Graphics Synthesizer's stand for colours of 32, 24 and 16 bits", "[legalize]") {
    check_rewrite("ps2", frame_text("A8R8G8B8", "X8R8G8B8", "D24"), frame_text("PSMCT32", "PSMCT24", "D24"));
    // Beside 16 bits of colour there are 16 of depth.
    check_rewrite("ps2", frame_text("A1R5G5B5", "R5G6B5", "D32"), frame_text("PSMCT16", "PSMCT24", "D16"));
    // Its bit of alpha is not A1R5G5B5's.
    check_rewrite("ps2", frame_text("A1R5G5B5", "A1R5G5B5", "D32"), frame_text("PSMCT16", "PSMCT32", "D16"));
    check_rewrite("ps2", frame_text("A8R8G8B8", "A8R8G8B8", "D16"), frame_text("PSMCT32", "PSMCT32", "D24"));
}

TEST_CASE("formats: the GameCube spends 6 bits on alpha only where it is read", "[legalize]") {
    check_rewrite("gamecube", frame_text("A8R8G8B8", "A8R8G8B8", "D16"), frame_text("X8R8G8B8", "R6G6B6A6", "D24"));
    const std::string color_alone = "color_op SELECTARG1 alpha_op SELECTARG2";
    check_rewrite("gamecube", frame_text("A8R8G8B8", "A8R8G8B8", "D24", color_alone),
                  frame_text("X8R8G8B8", "X8R8G8B8", "D24", color_alone));
}

TEST_CASE("formats: whole bytes are not dithered", "[legalize]") {
    const auto text = [](const char* format, const char* dither) {
        return std::string("nimbus7 frame 1\noutput \"a\" targets [\"a\" {format ") + format +
               " width 4 height 4}] passes [\"p\" {color \"a\" state {" + dither + "} draws [rectangle {x1 4 y1 4}]}]";
    };
    const char* dither = "dither {mode FLIPPER_2X2}";
    check_rewrite("gamecube", text("R5G6B5", dither), text("X8R8G8B8", ""));
    check_rewrite("gamecube", text("R6G6B6A6", dither), text("R6G6B6A6", dither));
}

TEST_CASE("formats: depth has the least format with its bits", "[legalize]") {
    check_rewrite("dx7", frame_text("A8R8G8B8", "X8R8G8B8", "D32"), frame_text("A8R8G8B8", "X8R8G8B8", "D24"));
    check_rewrite("gamecube", frame_text("X8R8G8B8", "X8R8G8B8", "D32"), frame_text("X8R8G8B8", "X8R8G8B8", "D24"));
}

TEST_CASE("formats: depth does not depend on the order of the chip's formats", "[legalize]") {
    for (const std::vector<TargetFormat>& depths :
         {std::vector{TargetFormat::D16, TargetFormat::D24}, std::vector{TargetFormat::D24, TargetFormat::D16}}) {
        Profile chip       = *find_profile("xbox");
        chip.formats.depth = depths;
        for (const auto& [before, after] : {std::pair{TargetFormat::D32, TargetFormat::D24},
                                            {TargetFormat::D24, TargetFormat::D24},
                                            {TargetFormat::D16, TargetFormat::D16}}) {
            Frame frame                       = test_support::small_frame(1, 1, before);
            frame.passes[0].state.depth.write = true;
            frame.passes[0].draws             = {test_support::rectangle({0, 0, 1, 1}, 0)};
            RewriteNotes notes;
            CHECK(rewrite_formats(frame, chip, notes).targets[1].format == after);
        }
    }
}

TEST_CASE("formats: what a chip has is left alone", "[legalize]") {
    const std::array<std::pair<const char*, std::string>, 5> legal{{
        {"ideal", frame_text("R6G6B6A6", "A1R5G5B5", "D32")},
        {"dx7", frame_text("A1R5G5B5", "R5G6B5", "D16")},
        {"xbox", frame_text("R5G6B5", "A8R8G8B8", "D16")},
        {"gamecube", frame_text("R6G6B6A6", "X8R8G8B8", "D24")},
        {"ps2", frame_text("PSMCT16", "PSMCT24", "D16")},
    }};
    for (const auto& [chip, text] : legal) {
        RewriteNotes notes;
        CHECK(rewritten(chip, text, &notes) == to_text(parse_frame(text)));
        CHECK(notes.empty());
    }
    // Formats in which one of alpha is 0x80 belong to the Graphics Synthesizer's frames.
    check_rewrite("dx7", frame_text("PSMCT32", "PSMCT24", "D24"), frame_text("PSMCT32", "PSMCT24", "D24"));
    // Nothing is drawn to it.
    const std::string spare =
        "nimbus7 frame 1\noutput \"a\" targets [\"a\" {format PSMCT32 width 4 height 4} \"b\" {format R5G6B5 width 4 "
        "height 4}] passes [\"p\" {color \"a\" clear {color 0x00000000}}]";
    check_rewrite("ps2", spare, spare);
}

TEST_CASE("formats: a target stays where no format serves all its uses", "[legalize]") {
    // The GameCube draws to the frame buffer and copies to A8R8G8B8 textures.
    const std::string both =
        "nimbus7 frame 1\noutput \"a\" targets [\"a\" {width 4 height 4} \"b\" {format X8R8G8B8 width 4 height 4}] "
        "passes [\"p\" {color \"a\" clear {color 0x00000000}} \"q\" {color \"b\" clear {color 0x00000000}} "
        "\"r\" {color \"a\" draws [copy {source \"b\" from {x1 4 y1 4}}]}]";
    check_rewrite("gamecube", both, both);
    // One depth target beside 16 and 32 bits.
    const auto mixed = [](const char* a, const char* b) {
        return std::string("nimbus7 frame 1\noutput \"a\" targets [\"a\" {format ") + a +
               " width 4 height 4} \"b\" {format " + b +
               " width 4 height 4} \"d\" {format D24 width 4 height 4}] passes ["
               "\"p\" {color \"a\" depth \"d\" state {depth {write true}} draws [rectangle {x1 1 y1 1}]}"
               "\"q\" {color \"b\" depth \"d\" state {depth {write true}} draws [rectangle {x1 1 y1 1}]}]";
    };
    check_rewrite("ps2", mixed("A8R8G8B8", "A1R5G5B5"), mixed("PSMCT32", "PSMCT16"));
}

TEST_CASE("formats: notes say what became of a target", "[legalize]") {
    RewriteNotes notes;
    rewritten("ps2", frame_text("A1R5G5B5", "PSMCT24", "D24"), &notes);
    REQUIRE(notes.size() == 2);
    CHECK(notes[0] == RewriteNote{"formats", "target 0 'a'", "the chip's colours are PSMCT32 PSMCT24 PSMCT16",
                                  "A1R5G5B5 became PSMCT16"});
    CHECK(notes[1] == RewriteNote{"formats", "target 2 'depth'", "the depths beside its colours are D16 D24 D32",
                                  "D24 became D16"});
}

TEST_CASE("formats: red, green and blue keep every bit in PSMCT32 and PSMCT24", "[legalize]") {
    for (const TargetFormat format : {TargetFormat::A8R8G8B8, TargetFormat::X8R8G8B8}) {
        Frame frame             = test_support::small_frame(256, 1);
        frame.targets[0].format = format;
        for (int x = 0; x < 256; ++x)
            frame.passes[0].draws.push_back(
                test_support::rectangle({x, 0, x + 1, 1}, static_cast<std::uint32_t>(x) * 0x01010101u ^ 0x00aa5500u));
        RewriteNotes notes;
        const Frame other = rewrite_formats(frame, *find_profile("ps2"), notes);
        const auto got = execute(other).output.pixels, want = execute(frame).output.pixels;
        const std::uint32_t mask = format == TargetFormat::A8R8G8B8 ? 0xffffffff : 0x00ffffff;
        REQUIRE(other.targets[0].format != format);
        for (std::size_t i = 0; i < want.size(); ++i) CHECK((got[i] & mask) == (want[i] & mask));
    }
}
