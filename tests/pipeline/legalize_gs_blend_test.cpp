// SPDX-License-Identifier: MIT
#include "pipeline/legalize/gs_blend.h"

#include <cmath>

#include "pipeline/frame/frame_text.h"
#include "pipeline/legalize/gs_alpha.h"
#include "pipeline/validate/validate.h"
#include "tests/support/small_frame.h"

using namespace pipeline;

namespace {

// Register ALPHA's low byte, A | B << 2 | C << 4 | D << 6; -1 if there is no form.
int alpha_byte(BlendFactor source, BlendFactor dest) {
    const std::optional<GsBlend> blend = gs_blend_of({source, dest});
    if (!blend) return -1;
    CHECK(blend->fix == (blend->c == GsAlpha::Fix ? 0x80 : 0));
    const auto bits = [](auto field, int shift) { return static_cast<int>(field) << shift; };
    return bits(blend->a, 0) | bits(blend->b, 2) | bits(blend->c, 4) | bits(blend->d, 6);
}

Frame rewritten(const Frame& frame, std::string_view chip = "ps2") {
    RewriteNotes notes;
    Frame other = rewrite_gs_blend(frame, *find_profile(chip), notes);
    for (const Finding& finding : validate(other)) FAIL_CHECK(finding.where << ": " << finding.what);
    return other;
}
void check_rewrite(const std::string& before, const std::string& after, std::string_view chip = "ps2") {
    INFO(chip);
    CHECK(to_text(rewritten(parse_frame(before), chip)) == to_text(parse_frame(after)));
}

std::string frame_text(const std::string& arithmetic, const std::string& state, const std::string& more = "",
                       const std::string& format = "PSMCT32") {
    return "nimbus7 frame 1\noutput \"a\" arithmetic {combine GS_SHIFT7 " + arithmetic + "} targets [\"a\" {format " +
           format +
           " width 4 height 4} \"b\" {format PSMCT32 width 4 height 4}] passes ["
           "\"p\" {color \"a\" state {" +
           state + "} draws [rectangle {x1 4 y1 4}]}" + more + "]";
}
const std::string kGs = "blend GS_SHIFT7";

}  // namespace

TEST_CASE("gs_blend: register ALPHA for each pair of factors that it can say", "[legalize]") {
    using enum BlendFactor;
    CHECK(alpha_byte(SourceAlpha, InvSourceAlpha) == 0x44);  // (Cs - Cd) As + Cd
    CHECK(alpha_byte(SourceAlpha, One) == 0x48);             // Cs As + Cd
    CHECK(alpha_byte(One, One) == 0x68);                     // Cs FIX + Cd
    CHECK(alpha_byte(DestAlpha, InvDestAlpha) == 0x54);      // (Cs - Cd) Ad + Cd
    CHECK(alpha_byte(InvDestAlpha, DestAlpha) == 0x11);      // (Cd - Cs) Ad + Cs
    CHECK(alpha_byte(DestAlpha, Zero) == 0x98);              // Cs Ad
    CHECK(alpha_byte(Zero, SourceAlpha) == 0x89);            // Cd As
    CHECK(alpha_byte(Zero, InvSourceAlpha) == 0x46);         // (0 - Cd) As + Cd
    CHECK(alpha_byte(One, Zero) == 0x00);
    CHECK(alpha_byte(Zero, One) == 0x40);  // Cd
    CHECK(alpha_byte(Zero, Zero) == 0x80);
    CHECK(alpha_byte(One, InvSourceAlpha) == -1);  // two terms without C
    CHECK(alpha_byte(InvSourceAlpha, One) == -1);
    CHECK(alpha_byte(SourceAlpha, SourceAlpha) == -1);  // Cs + Cd is no A - B
    CHECK(alpha_byte(SourceAlpha, DestAlpha) == -1);    // two alphas
    int forms = 0;
    for (const BlendFactor source : all_of<BlendFactor>())
        for (const BlendFactor dest : all_of<BlendFactor>()) {
            const auto is_color = [](BlendFactor f) { return f >= SourceColor && f <= InvDestColor; };
            const bool has_form = alpha_byte(source, dest) >= 0;
            if (is_color(source) || is_color(dest)) CHECK(!has_form);
            forms += has_form;
        }
    // Four without alpha, and for each of the two alphas: a,1-a; 1-a,a; a,0; a,1; 1-a,0; 0,a; 1,a; 0,1-a.
    CHECK(forms == 4 + 2 * 8);
}

TEST_CASE("gs_blend: factors become operands", "[legalize]") {
    check_rewrite(frame_text("", "blend {source SRCALPHA dest INVSRCALPHA}"), frame_text(kGs, "gs_blend {b CD d CD}"));
    check_rewrite(frame_text("", "blend {source ONE dest ONE}"),
                  frame_text(kGs, "gs_blend {b ZERO c FIX d CD fix 128}"));
    check_rewrite(frame_text("", ""), frame_text(kGs, ""));
    // Alpha stays too, which only the mask can say.
    check_rewrite(frame_text("", "blend {source ZERO dest ONE}"),
                  frame_text(kGs, "gs_blend {d CD} color_mask {alpha false}"));
}

TEST_CASE("gs_blend: white by the target's colours is twice what is there", "[legalize]") {
    const auto pass = [](const std::string& state, const std::string& color) {
        return "\"q\" {color \"a\" state {" + state + "} draws [rectangle {x1 4 y1 4 color " + color + "}]}";
    };
    const std::string by_one_more = "blend {source DESTCOLOR dest ONE}",
                      twice       = "gs_blend {a CD b ZERO c FIX d CD fix 128}";
    check_rewrite(frame_text("", "", pass(by_one_more, "0x80ffffff")), frame_text(kGs, "", pass(twice, "0x80ffffff")));
    for (const std::string& refused :
         {frame_text("", "", pass(by_one_more, "0x80fffffe")),
          frame_text("", "", pass(by_one_more + " stages [{color_op SELECTARG1 alpha_op SELECTARG1}]", "0x80ffffff"))})
        check_rewrite(refused, refused);

    Frame frame             = test_support::small_frame(256, 1);
    frame.targets[0].format = TargetFormat::Psmct32;
    for (int x = 0; x < 256; ++x)
        frame.passes[0].draws.push_back(
            test_support::rectangle({x, 0, x + 1, 1}, static_cast<std::uint32_t>(x) * 0x010101u));
    frame.passes.push_back(frame.passes[0]);
    frame.passes[1].draws       = {test_support::rectangle({0, 0, 256, 1}, 0x00ffffff)};
    frame.passes[1].state.blend = {BlendFactor::DestColor, BlendFactor::One};
    RewriteNotes notes;
    const Frame other = rewritten(rewrite_gs_alpha(frame, *find_profile("ps2"), notes));
    REQUIRE(other.arithmetic.blend == BlendRule::GsShift7);
    CHECK(execute(other).output.pixels == execute(frame).output.pixels);
}

TEST_CASE("gs_blend: alpha that is read must not be blended", "[legalize]") {
    const std::string over = "blend {source SRCALPHA dest INVSRCALPHA}";
    const auto reader      = [](const char* alpha_op) {
        return std::string("\"q\" {color \"b\" state {stages [{color_op MODULATE alpha_op ") + alpha_op +
               "}]} draws [rectangle {x1 4 y1 4 textures [{target \"a\"}]}]}";
    };
    const std::string refused = frame_text("", over, reader("MODULATE"));
    check_rewrite(refused, refused);
    check_rewrite(frame_text("", over, reader("SELECTARG2")),
                  frame_text(kGs, "gs_blend {b CD d CD}", reader("SELECTARG2")));
    check_rewrite(frame_text("", over + " color_mask {alpha false}", reader("MODULATE")),
                  frame_text(kGs, "gs_blend {b CD d CD} color_mask {alpha false}", reader("MODULATE")));
    check_rewrite(frame_text("", over, reader("MODULATE"), "PSMCT24"),
                  frame_text(kGs, "gs_blend {b CD d CD}", reader("MODULATE"), "PSMCT24"));
    check_rewrite(frame_text("", "", reader("MODULATE")), frame_text(kGs, "", reader("MODULATE")));
}

TEST_CASE("gs_blend: a frame is left alone as a whole", "[legalize]") {
    const std::string over = "blend {source SRCALPHA dest INVSRCALPHA}",
                      multiply =
                          "\"q\" {color \"b\" state {blend {source ZERO dest SRCCOLOR}} draws [rectangle {x1 4 y1 4}]}";
    const std::string one_refused = frame_text("", over, multiply);
    check_rewrite(one_refused, one_refused);
    const std::string text = frame_text("", over);
    for (const char* chip : {"ideal", "dx7", "gamecube", "xbox"}) check_rewrite(text, text, chip);
    std::string to_255 = text;
    to_255.replace(to_255.find("combine GS_SHIFT7"), 17, "");
    check_rewrite(to_255, to_255);
    const std::string done = frame_text(kGs, "gs_blend {b CD d CD}");
    check_rewrite(done, done);
}

TEST_CASE("gs_blend: with gs_alpha every colour on every colour is off by 2 at most", "[legalize]") {
    using enum BlendFactor;
    const auto [source, dest] = GENERATE(table<BlendFactor, BlendFactor>({{SourceAlpha, InvSourceAlpha},
                                                                          {InvSourceAlpha, SourceAlpha},
                                                                          {SourceAlpha, One},
                                                                          {SourceAlpha, Zero},
                                                                          {InvSourceAlpha, Zero},
                                                                          {Zero, SourceAlpha},
                                                                          {Zero, InvSourceAlpha},
                                                                          {One, SourceAlpha},
                                                                          {One, One},
                                                                          {Zero, One},
                                                                          {DestAlpha, InvDestAlpha},
                                                                          {InvDestAlpha, DestAlpha},
                                                                          {DestAlpha, One},
                                                                          {One, DestAlpha},
                                                                          {DestAlpha, Zero},
                                                                          {Zero, InvDestAlpha}}));
    CAPTURE(enum_name(source), enum_name(dest));
    int worst = 0;
    for (std::uint32_t alpha = 0; alpha <= 255; alpha += 5) {
        Frame frame             = test_support::small_frame(256, 256);
        frame.targets[0].format = TargetFormat::Psmct32;
        frame.passes.push_back(frame.passes[0]);
        const std::uint32_t own = alpha << 24;
        for (int i = 0; i < 256; ++i) {
            const std::uint32_t color = own | static_cast<std::uint32_t>(i) * 0x010101u;
            frame.passes[0].draws.push_back(test_support::rectangle({i, 0, i + 1, 256}, color));
            frame.passes[1].draws.push_back(test_support::rectangle({0, i, 256, i + 1}, color));
        }
        frame.passes[1].state.blend            = {source, dest};
        frame.passes[1].state.color_mask.alpha = false;
        RewriteNotes notes;
        const Frame other = rewritten(rewrite_gs_alpha(frame, *find_profile("ps2"), notes));
        REQUIRE(other.arithmetic.blend == BlendRule::GsShift7);
        const auto want = execute(frame).output.pixels, got = execute(other).output.pixels;
        for (std::size_t i = 0; i < want.size(); ++i)
            worst = std::max(worst, std::abs(static_cast<int>(got[i] & 255) - static_cast<int>(want[i] & 255)));
    }
    CHECK(worst <= ((source == One || source == Zero) && dest == One ? 0 : 2));
}
