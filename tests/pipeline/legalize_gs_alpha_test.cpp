// SPDX-License-Identifier: MIT
#include "pipeline/legalize/gs_alpha.h"

#include <cmath>

#include "pipeline/frame/frame_text.h"
#include "pipeline/legalize/vertex_changes.h"
#include "pipeline/validate/validate.h"
#include "tests/support/small_frame.h"

using namespace pipeline;

namespace {

Frame rewritten(const Frame& frame, std::string_view chip = "ps2") {
    RewriteNotes notes;
    Frame other = rewrite_gs_alpha(frame, *find_profile(chip), notes);
    CHECK(notes.empty() == (other == frame));
    for (const Finding& finding : validate(other)) FAIL_CHECK(finding.where << ": " << finding.what);
    return other;
}
void check_rewrite(const std::string& before, const std::string& after, std::string_view chip = "ps2") {
    INFO(chip);
    CHECK(to_text(rewritten(parse_frame(before), chip)) == to_text(parse_frame(after)));
}
void check_alone(const std::string& text, std::string_view chip = "ps2") {
    check_rewrite(text, text, chip);
}

const std::string kModulate = "{color_op MODULATE alpha_op MODULATE}";
const std::string kDecal    = "{color_op SELECTARG1 alpha_op SELECTARG1}";

// A pass that clears, tests alpha, and draws one rectangle with texture "t".
std::string frame_text(const std::string& start, const std::string& color, const std::string& reference,
                       const std::string& stage, const std::string& rectangle, const std::string& texels,
                       const std::string& more_state = "") {
    return "nimbus7 frame 1\noutput \"a\" " + start +
           " targets [\"a\" {format PSMCT32 width 4 height 4}] passes [\"p\" {color \"a\" clear {color " + color +
           "} state {alpha_test {func GREATEREQUAL reference " + reference + "} stages [" + stage + "]" + more_state +
           "} draws [rectangle {x1 4 y1 4 color " + rectangle + " textures [{texture #0}]}]}] textures [\"t\" {" +
           texels + "}]";
}
const std::string kShift7 = "arithmetic {combine GS_SHIFT7}";

}  // namespace

TEST_CASE("gs_alpha: the scale keeps zero and one, and is monotone", "[legalize]") {
    CHECK(to_gs_scale(0) == 0);
    CHECK(to_gs_scale(1) == 1);  // so that alpha above zero stays so
    CHECK(to_gs_scale(127) == 64);
    CHECK(to_gs_scale(254) == 127);  // and alpha below one
    CHECK(to_gs_scale(255) == 0x80);
    for (int v = 0; v < 256; ++v)
        CHECK(to_gs_scale(static_cast<std::uint8_t>(v)) == static_cast<int>(std::lround(v * 128.0 / 255.0)));
}

TEST_CASE("gs_alpha: what is multiplied is counted to 0x80, what is selected only in alpha", "[legalize]") {
    check_rewrite(
        frame_text("", "0xff102030", "255", kModulate, "0x80ff4001", "width 1 height 1 texels [10203040]"),
        frame_text(kShift7, "0x80102030", "128", kModulate, "0x40802001", "width 1 height 1 texels [10203020]"));
    check_rewrite(frame_text("", "0x00102030", "1", kDecal, "0x80ff4001", "width 1 height 1 texels [102030ff]"),
                  frame_text(kShift7, "0x00102030", "1", kDecal, "0x40ff4001", "width 1 height 1 texels [10203080]"));
    // Twice a product is the chip's product of whole bytes.
    const std::string twice = "{color_op MODULATE2X alpha_op SELECTARG2}",
                      once  = "{color_op MODULATE alpha_op SELECTARG2}";
    check_rewrite(frame_text("", "0xff102030", "0", twice, "0xffff4001", "width 1 height 1 texels [102030ff]"),
                  frame_text(kShift7, "0x80102030", "0", once, "0x80ff4001", "width 1 height 1 texels [10203080]"));
}

TEST_CASE("gs_alpha: what no stage reads does not stand in the way", "[legalize]") {
    const std::string texels = "width 1 height 1 texels [10203000]";
    check_rewrite(frame_text("", "0x00102030", "0",
                             "{color_op SELECTARG1 color_arg2 {complement true} alpha_op SELECTARG1}"
                             "{color_arg1 {complement true}}",
                             "0x00ff4001", texels),
                  frame_text(kShift7, "0x00102030", "0", kDecal, "0x00ff4001", texels));
}

TEST_CASE("gs_alpha: textures of one channel", "[legalize]") {
    check_rewrite(
        frame_text("", "0xff000000", "0", kDecal, "0xffffffff", "format A8 width 2 height 1 texels [ff7f]"),
        frame_text(kShift7, "0x80000000", "0", kDecal, "0x80ffffff", "format A8 width 2 height 1 texels [8040]"));
    check_rewrite(
        frame_text("", "0xff000000", "0", kDecal, "0xffffffff", "format L8 width 2 height 1 texels [ff7f]"),
        frame_text(kShift7, "0x80000000", "0", kDecal, "0x80ffffff", "width 2 height 1 texels [ffffff807f7f7f80]"));
    const std::string color_alone = "{color_op MODULATE alpha_op SELECTARG2}";
    check_rewrite(
        frame_text("", "0xff000000", "0", color_alone, "0xffffffff", "format L8 width 2 height 1 texels [ff7f]"),
        frame_text(kShift7, "0x80000000", "0", color_alone, "0x80808080", "format L8 width 2 height 1 texels [ff7f]"));
}

TEST_CASE("gs_alpha: a frame that cannot be counted anew is left alone", "[legalize]") {
    const std::string texels = "width 1 height 1 texels [10203040]";
    const auto with_stage    = [&](const std::string& stages, const std::string& state = "") {
        return frame_text("", "0xff102030", "255", stages, "0x80ff4001", texels, state);
    };
    for (const char* chip : {"ideal", "dx7", "gamecube", "xbox"}) check_alone(with_stage(kModulate), chip);
    check_alone(with_stage(kModulate + kModulate));
    check_alone(with_stage("{color_op ADD alpha_op MODULATE}"));
    check_alone(with_stage("{color_op MODULATE alpha_op MODULATE2X}"));
    check_alone(with_stage("{color_op MODULATE color_arg2 {source TFACTOR} alpha_op MODULATE}"));
    check_alone(with_stage("{color_op MODULATE color_arg1 {complement true} alpha_op MODULATE}"));
    check_alone(with_stage("{color_op MODULATE color_arg1 {source DIFFUSE} alpha_op MODULATE}"));
    check_alone(with_stage("{color_op SELECTARG1 alpha_op MODULATE}"));  // DECAL's alpha is one or the other
    check_alone(with_stage(kModulate, " dest_alpha_test ONE"));
    check_alone(with_stage(kModulate, " blend {source DESTCOLOR}"));
    std::string other_format = with_stage(kModulate);
    other_format.replace(other_format.find("PSMCT32"), 7, "A8R8G8B8");
    check_alone(other_format);
    check_alone(frame_text(kShift7, "0xff102030", "255", kModulate, "0x80ff4001", texels));  // it is so already
}

TEST_CASE("gs_alpha: vertices that two kinds of draws share are doubled", "[legalize]") {
    const auto text = [](const std::string& start, const std::string& vertices, const std::string& indices,
                         const std::string& last) {
        return "nimbus7 frame 1\noutput \"a\" " + start +
               " targets [\"a\" {format PSMCT32 width 4 height 4}] cameras [{}] passes ["
               "\"plain\" {color \"a\" camera #0 draws [triangles {index_count 3}]}"
               "\"multiplied\" {color \"a\" camera #0 state {stages [" +
               kModulate + "]} draws [triangles {first_index " + last +
               " index_count 3 textures [{texture #0}]}]}] textures [\"t\" {width 1 height 1 texels [10203000]}] "
               "vertices columns (diffuse specular) [" +
               vertices + "] indices [" + indices + "]";
    };
    check_rewrite(text("", "0xffff0000 0xff000000 0xff00ff00 0xff000000 0xff0000ff 0xff000000 0xffffffff 0xff000000 ",
                       "0 1 2 2 1 3", "3"),
                  text(kShift7,
                       "0x80ff0000 0xff000000 0x8000ff00 0xff000000 0x800000ff 0xff000000 0x80808080 0xff000000 "
                       "0x80000080 0xff000000 0x80008000 0xff000000 ",
                       "0 1 2 2 1 3 4 5 3", "6"));
}

TEST_CASE("gs_alpha: lit colours are scaled by their materials", "[legalize]") {
    const auto text = [](const std::string& start, const std::string& stages, const std::string& material) {
        return "nimbus7 frame 1\noutput \"a\" " + start +
               " targets [\"a\" {format PSMCT32 width 4 height 4}] cameras [{}] passes [\"p\" {color \"a\" camera #0 "
               "state {" +
               stages + " lighting {enabled true diffuse_source MATERIAL material {" + material +
               "}}} draws [triangles {}]}]";
    };
    const std::string stages = "stages [" + kModulate + "]";
    // 128 / 255, to the nearest float.
    check_rewrite(text("", "", "diffuse (1 1 1 1) emissive (1 1 1)"),
                  text(kShift7, "", "diffuse (1 1 1 0.5019608) emissive (1 1 1)"));
    const Frame other        = rewritten(parse_frame(text("", stages, "diffuse (1 1 1 1) emissive (1 0.5 0)")));
    const Material& material = other.passes[0].state.lighting.material;
    CHECK(material.diffuse == Vec4(128.0f / 255.0f));
    CHECK(material.ambient == Vec3(128.0f / 255.0f));
    CHECK(material.emissive == Vec3(128.0f / 255.0f, 64.0f / 255.0f, 0.0f));
}

TEST_CASE("gs_alpha: nothing bound is a texel of one", "[legalize]") {
    Frame frame                = test_support::small_frame(2, 2);
    frame.targets[0].format    = TargetFormat::Psmct32;
    Pass& pass                 = frame.passes[0];
    const TextureOp op         = GENERATE(TextureOp::Modulate, TextureOp::SelectArg1);
    pass.state.stages[0]       = {.color_op = op, .alpha_op = op};
    pass.draws                 = {test_support::rectangle({0, 0, 2, 2}, 0xff80c0ff)};
    const std::uint32_t before = test_support::color_on_both(frame);
    const Frame other          = rewritten(frame);
    CHECK(before == (op == TextureOp::Modulate ? 0xff80c0ff : 0xffffffff));
    // 0x80 is 64 of 128, 0xc0 96: 255 * 64 >> 7 is 127.
    CHECK(test_support::color_on_both(other) == (op == TextureOp::Modulate ? 0x807fbfff : 0x80ffffff));
}

TEST_CASE("gs_alpha: every product of a texel and a colour is off by 2 at most", "[legalize]") {
    const TextureOp op      = GENERATE(TextureOp::Modulate, TextureOp::Modulate2X);
    Frame frame             = test_support::small_frame(256, 256);
    frame.targets[0].format = TargetFormat::Psmct32;
    std::vector<std::uint8_t> texels;
    for (int texel = 0; texel < 256; ++texel) texels.insert(texels.end(), 4, static_cast<std::uint8_t>(texel));
    const TextureId texture = test_support::add_texture(frame, TextureFormat::A8R8G8B8, 256, 1, texels);
    Pass& pass              = frame.passes[0];
    pass.state.stages[0]    = {.color_op = op, .alpha_op = TextureOp::Modulate};
    for (int y = 0; y < 256; ++y) {
        DrawRectangle draw = test_support::rectangle({0, y, 256, y + 1}, static_cast<std::uint32_t>(y) * 0x01010101u);
        draw.textures[0]   = test_support::bound(texture);
        pass.draws.push_back(draw);
    }
    const auto want = execute(frame).output.pixels, got = execute(rewritten(frame)).output.pixels;
    int worst = 0, worst_alpha = 0, brightest = 0;
    for (std::size_t i = 0; i < want.size(); ++i) {
        const auto byte = [&](std::uint32_t color, int shift) { return static_cast<int>(color >> shift & 255); };
        for (const int shift : {0, 8, 16})
            worst = std::max(worst, std::abs(byte(got[i], shift) - byte(want[i], shift)));
        worst_alpha =
            std::max(worst_alpha, std::abs(byte(got[i], 24) - to_gs_scale(static_cast<std::uint8_t>(want[i] >> 24))));
        brightest = std::max(brightest, byte(got[i], 0));
    }
    CHECK(worst <= 2);
    CHECK(worst_alpha <= 2);
    CHECK(brightest == 255);
}

TEST_CASE("vertex_changes: a vertex keeps its place for the first kind alone, and ranges are shared again",
          "[legalize]") {
    const bool is_window = GENERATE(false, true);
    Frame frame;
    frame.vertices.resize(3);
    frame.window_vertices.resize(3);
    frame.indices = {0, 1, 2};
    std::array<Draw, 4> draws;
    for (Draw& draw : draws)
        draw = is_window ? Draw(DrawWindowTriangles{.index_count = 3}) : Draw(DrawTriangles{.index_count = 3});
    const std::array<VertexChange, 2> kinds{change_of_diffuse([](Argb color) { return Argb{color.value - 1}; }),
                                            change_of_diffuse([](Argb) { return Argb{0}; })};
    const std::array<ChangedDraw, 4> all{{{&draws[0], 0}, {&draws[1], 1}, {&draws[2], 0}, {&draws[3], 1}}};
    change_vertices(frame, all, kinds);
    const auto diffuse = [&](std::size_t i) {
        return is_window ? frame.window_vertices.at(i).diffuse : frame.vertices.at(i).diffuse;
    };
    const auto first_index = [&](std::size_t i) {
        return is_window ? std::get<DrawWindowTriangles>(draws[i]).first_index
                         : std::get<DrawTriangles>(draws[i]).first_index;
    };
    CHECK(frame.indices == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5});
    CHECK(diffuse(0) == Argb{0xfffffffe});
    CHECK(diffuse(5) == Argb{0});
    CHECK(first_index(2) == 0);
    CHECK(first_index(1) == 3);
    CHECK(first_index(3) == 3);
}
