// SPDX-License-Identifier: MIT
// Where counting to 0x80 needs passes of its own: alpha above one, alpha that becomes colour and colour that becomes alpha; and
// tests of alpha that is known.
#include <cmath>

#include "pipeline/legalize/gs_alpha.h"
#include "pipeline/legalize/gs_blend.h"
#include "tests/support/rewritten.h"

using namespace pipeline;
using namespace test_support;

namespace {

const std::string kShift7 = "arithmetic { combine GS_SHIFT7 } ";
const std::string kOver   = "blend { source SRCALPHA dest INVSRCALPHA } ";

void check_ps2(const std::string& before, const std::string& after) {
    check_rewrite(&rewrite_gs_alpha, "ps2", before, after);
}
void check_alone(const std::string& text) {
    check_left_alone(&rewrite_gs_alpha, "ps2", text);
}

std::string stage(const std::string& alpha_op) {
    return "stages [ { color_op MODULATE alpha_op " + alpha_op + " } ] ";
}
std::string pass(const std::string& label, const std::string& clear, const std::string& state, const std::string& color,
                 const std::string& texture = "t") {
    return '"' + label + "\" { color \"a\" " + clear + " state { " + state + "} draws [ rectangle { x1 4 y1 4 color " +
           color + " textures [ { texture \"" + texture + "\" } ] } ] } ";
}
std::string frame_text(const std::string& start, const std::string& passes, const std::string& textures) {
    return start + "targets [ \"a\" { format PSMCT32 width 4 height 4 } ] passes [ " + passes + "] textures [ " +
           textures + "]";
}
std::string texture(const std::string& name, const std::string& texel) {
    return '"' + name + "\" { width 1 height 1 texels [" + texel + "] } ";
}
const std::string kClear = "clear { color 0xff000000 }", kGsClear = "clear { color 0x80000000 }";

Frame with_gs_rules(const Frame& frame) {
    const Frame other = rewritten(rewritten(frame, &rewrite_gs_alpha, "ps2"), &rewrite_gs_blend, "ps2");
    REQUIRE(other.arithmetic.blend == BlendRule::GsShift7);
    return other;
}

int worst_green(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    int worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        worst = std::max(worst, std::abs(static_cast<int>(a[i] >> 8 & 255) - static_cast<int>(b[i] >> 8 & 255)));
    return worst;
}

// White over black by all products of a texel's alpha (columns) and a vertex's (rows), times 2 or 4, and for the other times
// colours.
Frame products_frame(TextureOp op, std::uint32_t color = 0x00ffffff, std::uint32_t dest = 0xff000000) {
    Frame frame             = small_frame(256, 256);
    frame.targets[0].format = TargetFormat::Psmct32;
    std::vector<std::uint8_t> texels;
    for (int texel = 0; texel < 256; ++texel)
        for (const int c : {255, 255, 255, texel}) texels.push_back(static_cast<std::uint8_t>(c));
    const TextureId row  = add_texture(frame, TextureFormat::A8R8G8B8, 256, 1, texels);
    Pass& pass           = frame.passes[0];
    pass.clear.color     = Argb{dest};
    pass.state.blend     = kAlphaOver;
    pass.state.stages[0] = {.color_op = TextureOp::Modulate, .alpha_op = op};
    for (int y = 0; y < 256; ++y) {
        DrawRectangle draw = rectangle({0, y, 256, y + 1}, static_cast<std::uint32_t>(y) << 24 | color);
        draw.textures[0]   = bound(row);
        pass.draws.push_back(draw);
    }
    return frame;
}

// Greys 0..255 in columns, copied by `channels` from target 1 to the picture and, if `back`, on to target 2.
Frame copied_frame(bool back) {
    Frame frame = small_frame(256, 1);
    frame.targets.push_back({.name = "greys", .width = 256, .height = 1});
    frame.targets.push_back({.name = "alpha", .width = 256, .height = 1});
    frame.passes[0].camera = {};
    frame.cameras.clear();
    for (Target& target : frame.targets) target.format = TargetFormat::Psmct32;
    for (int x = 0; x < 256; ++x)
        frame.passes[0].draws.push_back(
            rectangle({x, 0, x + 1, 1}, static_cast<std::uint32_t>(x) * (back ? 0x00010101u : 0x01000000u)));
    frame.passes[0].color = {1};
    const auto copy       = [&](int from, int to, CopyChannels channels) {
        Pass& pass       = frame.passes.emplace_back();
        pass.color       = {to};
        pass.clear.color = Argb{0xff000000};
        pass.draws       = {CopyRectangle{.source = {from}, .from = {0, 0, 256, 1}, .channels = channels}};
    };
    if (back) copy(1, 2, CopyChannels::GreenToAlpha);
    copy(back ? 2 : 1, 0, CopyChannels::AlphaToColor);
    return frame;
}

}  // namespace

TEST_CASE("gs_alpha: twice a product is cut at one by two passes, with vertices' alpha as it is", "[legalize]") {
    check_ps2(frame_text("", pass("p", kClear, kOver + stage("MODULATE2X"), "0xc8ff4001"), texture("t", "10203040")),
              frame_text(kShift7,
                         pass("p", kGsClear, kOver + "alpha_test { func LESS reference 128 } " + stage("MODULATE"),
                              "0xc8802001") +
                             pass("p: alpha of one", "",
                                  "alpha_test { func GREATEREQUAL reference 128 } " + stage("MODULATE"), "0xc8802001"),
                         texture("t", "10203020")));
}

TEST_CASE("gs_alpha: four times a product has texels' alpha as it is too, in a texture of its own", "[legalize]") {
    const auto cut = [](const std::string& label, const std::string& clear, const std::string& texture) {
        return pass(label, clear, kOver + "alpha_test { func LESS reference 128 } " + stage("MODULATE"), "0xc8802001",
                    texture) +
               pass(label + ": alpha of one", "", "alpha_test { func GREATEREQUAL reference 128 } " + stage("MODULATE"),
                    "0xc8802001", texture);
    };
    check_ps2(frame_text("", pass("p", kClear, kOver + stage("MODULATE4X"), "0xc8ff4001"), texture("t", "10203040")),
              frame_text(kShift7, cut("p", kGsClear, "t"), texture("t", "10203040")));
    check_ps2(frame_text("",
                         pass("p", kClear, kOver + stage("MODULATE4X"), "0xc8ff4001") +
                             pass("q", "", kOver + stage("MODULATE"), "0xc8ff4001"),
                         texture("t", "10203040")),
              frame_text(kShift7,
                         cut("p", kGsClear, "t, alpha to 255") + pass("q", "", kOver + stage("MODULATE"), "0x64802001"),
                         texture("t", "10203020") + texture("t, alpha to 255", "10203040")));
}

TEST_CASE("gs_alpha: alpha above one has no form unless a pass just blends by it", "[legalize]") {
    const auto text = [](const std::string& state) {
        return frame_text("", pass("p", kClear, state, "0xc8ff4001"), texture("t", "10203040"));
    };
    for (const char* op : {"MODULATE2X", "MODULATE4X"}) {
        check_alone(text(stage(op)));
        check_alone(text("blend { source SRCALPHA dest ONE } " + stage(op)));
        check_alone(text(kOver + "alpha_test { func GREATER } " + stage(op)));
    }
    Frame frame = products_frame(TextureOp::Modulate2X);
    frame.targets.push_back({.name = "depth", .format = TargetFormat::D24, .width = 256, .height = 256});
    frame.passes[0].depth       = {1};
    frame.passes[0].state.depth = {.func = CompareFunc::GreaterEqual, .write = false};
    CHECK(rewritten(frame, &rewrite_gs_alpha, "ps2") != frame);
    frame.passes[0].state.depth.write = true;
    CHECK(rewritten(frame, &rewrite_gs_alpha, "ps2") == frame);
}

TEST_CASE("gs_alpha: every product that is cut at one is off by less than 4 of 255, and so is what it blends",
          "[legalize][exhaustive]") {
    const TextureOp op = GENERATE(TextureOp::Modulate2X, TextureOp::Modulate4X);
    CAPTURE(enum_name(op));
    for (const auto& [color, dest] :
         {std::pair{0x00ffffffu, 0xff000000u}, {0x00000000u, 0xffffffffu}, {0x00c8c8c8u, 0xff646464u}}) {
        CAPTURE(color, dest);
        const Frame frame                       = products_frame(op, color, dest);
        const std::vector<std::uint32_t> pixels = pixels_of(with_gs_rules(frame));
        CHECK(worst_green(pixels_of(frame), pixels) <= 4);
        double worst = 0.0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const double product = (op == TextureOp::Modulate2X ? 2.0 : 4.0) *
                                   static_cast<double>((i % 256) * (i / 256)) / 255.0,
                         alpha = std::min(128.0, static_cast<double>(pixels[i] >> 24)) * 255.0 / 128.0;
            worst              = std::max(worst, std::abs(std::min(255.0, product) - alpha));
        }
        CAPTURE(worst);
        CHECK(worst < 4.0);
        // What is one replaces all, as far as MODULATE keeps the colour.
        CHECK(std::abs(static_cast<int>(pixels.back() & 255) - static_cast<int>(color & 255)) <= 1);
    }
}

TEST_CASE("gs_alpha: green is halved before it becomes alpha, and alpha doubled once it is colour", "[legalize]") {
    const std::string targets =
        "targets [ \"a\" { format PSMCT32 width 8 height 4 } \"b\" { format PSMCT32 width 8 height 4 } ] ";
    const auto copy = [](const std::string& channels) {
        return "copy { source \"b\" from { x0 2 y0 1 x1 5 y1 3 } x 4 y 2 channels " + channels + " } ";
    };
    const auto passes = [](const std::string& text) { return "passes [ " + text + "] "; };
    const auto over   = [](const std::string& label, const std::string& target, const std::string& blend,
                         const std::string& rectangle) {
        return '"' + label + "\" { color \"" + target + "\" state { blend { " + blend +
               " } color_mask { alpha false } } draws [ rectangle { " + rectangle + " } ] } ";
    };
    check_ps2(
        targets + passes("\"p\" { color \"a\" draws [ " + copy("GREEN_TO_ALPHA") + "] } "),
        kShift7 + targets +
            passes(over("p: half", "b", "source ZERO dest SRCALPHA", "x0 2 y0 1 x1 5 y1 3 color 0x40000000") +
                   over("p: 128 for one", "b", "source DESTCOLOR dest ONE", "x0 2 y0 1 x1 5 y1 3 color 0x02040404") +
                   "\"p\" { color \"a\" draws [ " + copy("GREEN_TO_ALPHA") + "] } "));
    check_ps2(targets + passes("\"p\" { color \"a\" draws [ " + copy("ALPHA_TO_COLOR") + "] } "),
              kShift7 + targets +
                  passes("\"p\" { color \"a\" draws [ " + copy("ALPHA_TO_COLOR") + "] } " +
                         over("p: twice", "a", "source DESTCOLOR dest ONE", "x0 4 y0 2 x1 7 y1 4 color 0x80ffffff")));
    check_ps2(targets + passes("\"p\" { color \"a\" draws [ " + copy("ALL") + "] } "),
              kShift7 + targets + passes("\"p\" { color \"a\" draws [ " + copy("ALL") + "] } "));
}

TEST_CASE("gs_alpha: every alpha becomes the colour that it would, and every green through alpha",
          "[legalize][exhaustive]") {
    const bool back = GENERATE(false, true);
    CAPTURE(back);
    const Frame frame                       = copied_frame(back);
    const std::vector<std::uint32_t> pixels = pixels_of(with_gs_rules(frame));
    CHECK(worst_green(pixels_of(frame), pixels) <= (back ? 2 : 1));
    CHECK(pixels.front() << 8 == 0);
    CHECK(pixels.back() << 8 == 0xffffff00);
    for (std::size_t i = 1; i < pixels.size(); ++i) CHECK((pixels[i] & 255) >= (pixels[i - 1] & 255));
}

TEST_CASE("gs_alpha: green that is needed after it became alpha stands in the way", "[legalize]") {
    const auto text = [](const std::string& later, const std::string& source = "b") {
        return "targets [ \"a\" { format PSMCT32 width 8 height 4 } \"b\" { format PSMCT32 width 8 height 4 } "
               "\"c\" { format PSMCT32 width 8 height 4 } ] passes [ \"p\" { color \"" +
               std::string(source == "a" ? "b" : "a") + "\" draws [ copy { source \"" + source +
               "\" from { x1 8 y1 4 } channels GREEN_TO_ALPHA } ] } " + later + "] ";
    };
    const auto changes = [](const std::string& before) {
        return rewritten(parsed(before), &rewrite_gs_alpha, "ps2") != parsed(before);
    };
    const auto copy = [](const std::string& target, const std::string& source, const std::string& channels) {
        return "\"q\" { color \"" + target + "\" draws [ copy { source \"" + source +
               "\" from { x1 8 y1 4 } channels " + channels + " } ] } ";
    };
    CHECK(changes(text("")));
    CHECK(!changes(text("", "a")));  // the picture
    CHECK(!changes(text(copy("c", "b", "ALL"))));
    CHECK(!changes(text(copy("c", "b", "GREEN_TO_ALPHA"))));
    CHECK(!changes(text("\"q\" { color \"b\" draws [ rectangle { x1 8 y1 4 } ] } ")));
    CHECK(!changes(text(
        "\"q\" { color \"c\" state { stages [ { color_op SELECTARG1 alpha_op SELECTARG1 } ] } draws [ rectangle { x1 "
        "8 y1 4 textures [ { target \"b\" } ] } ] } ")));
    // Written anew before.
    CHECK(changes(text(copy("b", "c", "ALPHA_TO_COLOR") + copy("c", "b", "ALL"))));
    CHECK(!changes(text(copy("b", "c", "GREEN_TO_ALPHA") + copy("c", "b", "ALL"))));
}

TEST_CASE("gs_alpha: a test of alpha that is 0 or 255 is one of bit 7", "[legalize]") {
    const auto frame = [](std::uint32_t alpha, DestAlphaTest test = DestAlphaTest::One) {
        Frame result             = small_frame(8, 2);
        result.targets[0].format = TargetFormat::Psmct32;
        Pass base                = result.passes[0];
        base.camera              = {};
        result.passes.clear();
        Pass color                   = base;
        color.draws                  = {rectangle({0, 0, 8, 2}, 0xff204060)};
        Pass mask                    = base;
        mask.state.color_mask        = {.red = false, .green = false, .blue = false, .alpha = true};
        Pass part                    = mask;
        mask.draws                   = {rectangle({0, 0, 8, 2}, 0x00000000)};
        part.draws                   = {rectangle({2, 0, 5, 2}, alpha << 24)};
        Pass layer                   = base;
        layer.state.dest_alpha_test  = test;
        layer.state.blend            = kAlphaOver;
        layer.state.color_mask.alpha = false;
        layer.draws                  = {rectangle({0, 0, 8, 2}, 0x80e0c0a0)};
        result.passes                = {color, mask, part, layer};
        return result;
    };
    for (const DestAlphaTest test : {DestAlphaTest::One, DestAlphaTest::Zero}) {
        const Frame before                      = frame(255, test);
        const std::vector<std::uint32_t> pixels = pixels_of(with_gs_rules(before));
        CHECK(worst_green(pixels_of(before), pixels) <= 1);
        for (const std::size_t x : {0, 1, 5, 7})
            CHECK(((pixels[x] & 0xffffff) == 0x204060) == (test == DestAlphaTest::One));
        for (const std::size_t x : {2, 4}) CHECK(((pixels[x] & 0xffffff) == 0x204060) == (test == DestAlphaTest::Zero));
    }
    CHECK(rewritten(frame(0), &rewrite_gs_alpha, "ps2") != frame(0));
    for (const std::uint32_t alpha : {1u, 127u, 128u, 254u})  // 128 to 254 have bit 7 of 255, and not of 0x80
        CHECK(rewritten(frame(alpha), &rewrite_gs_alpha, "ps2") == frame(alpha));
}
