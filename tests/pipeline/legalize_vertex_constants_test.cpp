// SPDX-License-Identifier: MIT
#include "pipeline/legalize/vertex_constants.h"

#include "pipeline/check/check.h"
#include "pipeline/frame/frame_text.h"
#include "pipeline/validate/validate.h"
#include "tests/support/small_frame.h"

using namespace pipeline;

namespace {

Frame rewritten(const Frame& frame, std::string_view chip = "ps2") {
    RewriteNotes notes;
    Frame other = rewrite_vertex_constants(frame, *find_profile(chip), notes);
    CHECK(notes.empty() == (other == frame));
    for (const Finding& finding : validate(other)) FAIL_CHECK(finding.where << ": " << finding.what);
    return other;
}

// One rectangle of `color` with a texture of one texel.
std::string frame_text(const std::string& stage, const std::string& color, const std::string& state = "") {
    return "nimbus7 frame 1\noutput \"a\" targets [\"a\" {width 4 height 4}] passes [\"p\" {color \"a\" state {" +
           state + " texture_factor 0x40608020 stages [{" + stage + "}]} draws [rectangle {x1 4 y1 4 color " + color +
           " textures [{texture #0}]}]}] textures [\"t\" {width 1 height 1 texels [80c0ff80]}]";
}
// And the picture is the same, to the bit.
void check_rewrite(const std::string& before, const std::string& after, std::string_view chip = "ps2") {
    INFO(chip);
    const Frame frame = parse_frame(before), other = rewritten(frame, chip);
    CHECK(to_text(other) == to_text(parse_frame(after)));
    CHECK(test_support::color_on_both(other) == test_support::color_on_both(frame));
}
void check_alone(const std::string& text, std::string_view chip = "ps2") {
    check_rewrite(text, text, chip);
}

}  // namespace

TEST_CASE("vertex_constants: TFACTOR goes where the vertices' colours are not read", "[legalize]") {
    // Alpha alone: red, green and blue are the vertices'.
    check_rewrite(frame_text("color_op MODULATE alpha_op SELECTARG2 alpha_arg2 {source TFACTOR}", "0xff112233"),
                  frame_text("color_op MODULATE alpha_op SELECTARG2 alpha_arg2 {source DIFFUSE}", "0x40112233"));
    check_rewrite(frame_text("color_op MODULATE color_arg2 {source TFACTOR} alpha_op SELECTARG2", "0xff112233"),
                  frame_text("color_op MODULATE color_arg2 {source DIFFUSE} alpha_op SELECTARG2", "0xff608020"));
    check_rewrite(frame_text("color_op MODULATE color_arg2 {source TFACTOR} alpha_op MODULATE "
                             "alpha_arg2 {source TFACTOR}",
                             "0xff112233"),
                  frame_text("color_op MODULATE color_arg2 {source DIFFUSE} alpha_op MODULATE "
                             "alpha_arg2 {source DIFFUSE}",
                             "0x40608020"));
}

TEST_CASE("vertex_constants: a product for alpha beside the texel's colour is MODULATE by white", "[legalize]") {
    check_rewrite(frame_text("color_op SELECTARG1 alpha_op MODULATE alpha_arg2 {source TFACTOR}", "0xff112233"),
                  frame_text("color_op MODULATE color_arg2 {source DIFFUSE} alpha_op MODULATE "
                             "alpha_arg2 {source DIFFUSE}",
                             "0x40ffffff"));
    check_rewrite(frame_text("color_op SELECTARG1 alpha_op MODULATE", "0x77112233"),
                  frame_text("color_op MODULATE color_arg2 {source DIFFUSE} alpha_op MODULATE", "0x77ffffff"));
    check_alone(frame_text("color_op SELECTARG1 alpha_op SELECTARG1", "0x77112233"));
}

TEST_CASE("vertex_constants: what it cannot say, and what the chip can, is left alone", "[legalize]") {
    const std::string constant =
        frame_text("color_op MODULATE color_arg2 {source TFACTOR} alpha_op SELECTARG2", "0xff112233");
    for (const char* chip : {"ideal", "dx7", "gamecube", "xbox"}) check_alone(constant, chip);
    // Both are read.
    check_alone(frame_text("color_op MODULATE color_arg1 {source TFACTOR} alpha_op SELECTARG2", "0xff112233"));
    // The vertex's alpha is read as a colour.
    check_alone(
        frame_text("color_op MODULATE color_arg1 {alpha_replicate true source DIFFUSE} alpha_op SELECTARG2 "
                   "alpha_arg2 {source TFACTOR}",
                   "0xff112233"));
    check_alone(frame_text("color_op BLENDFACTORALPHA color_arg2 {source TFACTOR} alpha_op SELECTARG2", "0xff112233"));
    Frame lit                            = parse_frame(constant);
    lit.passes[0].state.lighting.enabled = true;
    CHECK(rewritten(lit) == lit);
}

TEST_CASE("vertex_constants: triangles that share vertices with other passes get their own", "[legalize]") {
    Frame frame           = test_support::small_frame(2, 2);
    const auto quad       = test_support::add_quad(frame, 0xff112233);
    frame.passes[0].draws = {quad};
    Pass second           = frame.passes[0];
    second.color          = {1};
    frame.targets.push_back(frame.targets[0]);
    second.state.texture_factor = {0x40608020};
    second.state.stages[0]      = {.color_op   = TextureOp::SelectArg1,
                                   .color_arg1 = {.source = ArgSource::TFactor},
                                   .alpha_op   = TextureOp::SelectArg1,
                                   .alpha_arg1 = {.source = ArgSource::TFactor}};
    frame.passes.push_back(second);
    for (const std::int32_t output : {0, 1}) {
        frame.output      = {output};
        const Frame other = rewritten(frame);
        CHECK(other.vertices.size() == 8);
        CHECK(other.indices.size() == 12);
        CHECK(test_support::color_on_both(other) == (output == 0 ? 0xff112233 : 0x40608020));
    }
    CHECK(rewritten(frame).passes[1].state.stages[0].color_arg1.source == ArgSource::Diffuse);
}
