// SPDX-License-Identifier: MIT
#include "pipeline/legalize/stages.h"

#include "pipeline/check/check.h"
#include "pipeline/frame/frame_text.h"
#include "pipeline/legalize/formats.h"
#include "pipeline/legalize/gs_alpha.h"
#include "pipeline/legalize/gs_blend.h"
#include "pipeline/legalize/reversed_depth.h"
#include "pipeline/legalize/vertex_constants.h"
#include "pipeline/legalize/window_triangles.h"
#include "pipeline/validate/validate.h"
#include "tests/support/small_frame.h"

using namespace pipeline;

namespace {

// A card with one stage and all blend factors.
Profile one_stage() {
    Profile profile       = *find_profile("dx7");
    profile.states.stages = 1;
    return profile;
}

Frame rewritten(const Frame& frame, const Profile& profile) {
    RewriteNotes notes;
    Frame other = rewrite_stages(frame, profile, notes);
    CHECK(notes.empty() == (other == frame));
    for (const Finding& finding : validate(other)) FAIL_CHECK(finding.where << ": " << finding.what);
    return other;
}
void check_rewrite(const Profile& profile, const std::string& before, const std::string& after) {
    INFO(profile.name);
    CHECK(to_text(rewritten(parse_frame(before), profile)) == to_text(parse_frame(after)));
}

const std::string kFirst  = "{color_op MODULATE alpha_op MODULATE}";
const std::string kSecond = "{color_op MODULATE alpha_op SELECTARG2 filter LINEAR}";

std::string pass_text(const std::string& name, const std::string& state, const std::string& uv_and_textures,
                      const std::string& clear = "") {
    return '"' + name + "\" {color \"a\" depth \"d\" " + clear + " state {" + state +
           "} draws [rectangle {x1 4 y1 4 depth 0.5 " + uv_and_textures + "}]}";
}
std::string frame_text(const std::string& passes, const std::string& texels = "texels [804020ff]",
                       const std::string& more_textures = "") {
    return "nimbus7 frame 1\noutput \"a\" targets [\"a\" {width 4 height 4} \"d\" {format D24 width 4 height 4}"
           "\"t\" {width 4 height 4}] passes [" +
           passes + "] textures [\"one\" {width 1 height 1 texels [ffffffff]} \"two\" {width 1 height 1 " + texels +
           "}" + more_textures + "]";
}
const std::string kBound = "uv [{u1 2}{u1 3}] textures [{texture #0}{texture #1}]";
// The picture's depth is cleared, so that the frame says all.
const std::string kClear = "clear {color 0xff000000 depth 1}";

std::string split_me(const std::string& state, const std::string& second = kSecond) {
    return frame_text(pass_text("p", state + " stages [" + kFirst + second + "]", kBound, kClear));
}
const std::string kDepth = "depth {func LESS write true}";
const std::string kLater = "depth {func LESSEQUAL} color_mask {alpha false}";

}  // namespace

TEST_CASE("stages: a second texture is multiplied in by a blend", "[legalize]") {
    const std::string first =
        pass_text("p", kDepth + " stages [" + kFirst + "]", "uv [{u1 2}{u1 3}] textures [{texture #0}]", kClear);
    const auto second = [](const char* factor) {
        return pass_text("p: second texture",
                         kLater + " blend {source " + factor +
                             " dest SRCCOLOR} stages [{color_op SELECTARG1 "
                             "alpha_op SELECTARG1 filter LINEAR}]",
                         "uv [{u1 3}{u1 3}] textures [{texture #1}]");
    };
    check_rewrite(one_stage(), split_me(kDepth), frame_text(first + second("ZERO")));
    check_rewrite(one_stage(), split_me(kDepth, "{color_op MODULATE2X alpha_op SELECTARG2 filter LINEAR}"),
                  frame_text(first + second("DESTCOLOR")));
}

TEST_CASE("stages: fog comes last", "[legalize]") {
    const std::string fog = " fog {mode LINEAR color 0xff336699 end 9}";
    const std::string after =
        pass_text("p", kDepth + " fog {mode LINEAR end 9} stages [" + kFirst + "]",
                  "uv [{u1 2}{u1 3}] textures [{texture #0}]", kClear) +
        pass_text("p: second texture",
                  kLater +
                      " blend {source ZERO dest SRCCOLOR} stages [{color_op SELECTARG1 alpha_op SELECTARG1 filter "
                      "LINEAR}]",
                  "uv [{u1 3}{u1 3}] textures [{texture #1}]") +
        pass_text("p: fog",
                  kLater + fog +
                      " blend {dest ONE} texture_factor 0xff000000 stages [{color_op SELECTARG1 color_arg1 "
                      "{source TFACTOR} alpha_op SELECTARG1 alpha_arg1 {source TFACTOR}}]",
                  "uv [{u1 2}{u1 3}]");
    check_rewrite(one_stage(), split_me(kDepth + fog), frame_text(after));

    // Twice a product is cut before it fades.
    const auto constant = [](const char* name, const std::string& state, const char* color) {
        return pass_text(name,
                         kLater + state + " texture_factor " + color +
                             " stages [{color_op SELECTARG1 color_arg1 {source TFACTOR} alpha_op SELECTARG1 "
                             "alpha_arg1 {source TFACTOR}}]",
                         "uv [{u1 2}{u1 3}]");
    };
    const std::string twice =
        pass_text("p", kDepth + " stages [" + kFirst + "]", "uv [{u1 2}{u1 3}] textures [{texture #0}]", kClear) +
        pass_text("p: second texture",
                  kLater +
                      " blend {source DESTCOLOR dest SRCCOLOR} stages [{color_op SELECTARG1 alpha_op SELECTARG1 "
                      "filter LINEAR}]",
                  "uv [{u1 3}{u1 3}] textures [{texture #1}]") +
        constant("p: fade", " fog {mode LINEAR end 9} blend {source ZERO dest SRCCOLOR}", "0xffffffff") +
        constant("p: fog", fog + " blend {dest ONE}", "0xff000000");
    check_rewrite(one_stage(), split_me(kDepth + fog, "{color_op MODULATE2X alpha_op SELECTARG2 filter LINEAR}"),
                  frame_text(twice));
}

TEST_CASE("stages: the Graphics Synthesizer multiplies by alpha, channel by channel", "[legalize]") {
    const Profile& ps2 = *find_profile("ps2");
    const std::string first =
        pass_text("p", kDepth + " stages [" + kFirst + "]", "uv [{u1 2}{u1 3}] textures [{texture #0}]", kClear);
    const auto channel = [](const std::string& name, const std::string& mask, const std::string& texture) {
        return pass_text(name,
                         "depth {func LESSEQUAL} color_mask {" + mask +
                             " alpha false} blend {source ZERO dest SRCALPHA} stages [{color_op SELECTARG1 alpha_op "
                             "SELECTARG1 filter LINEAR}]",
                         "uv [{u1 3}{u1 3}] textures [{texture #" + texture + "}]");
    };
    const auto alpha = [](const std::string& name, const std::string& texels) {
        return "\"two, " + name + "\" {format A8 width 1 height 1 texels [" + texels + "]}";
    };
    // Texels are blue, green, red, alpha.
    check_rewrite(ps2, split_me(kDepth),
                  frame_text(first + channel("p: second texture, red", "green false blue false", "2") +
                                 channel("p: second texture, green", "red false blue false", "3") +
                                 channel("p: second texture, blue", "red false green false", "4"),
                             "texels [804020ff]", alpha("red", "20") + alpha("green", "40") + alpha("blue", "80")));
    const std::string grey = "format L8 texels [60]";
    check_rewrite(ps2, frame_text(pass_text("p", kDepth + " stages [" + kFirst + kSecond + "]", kBound, kClear), grey),
                  frame_text(first + channel("p: second texture", "", "2"), grey, alpha("blue", "60")));
}

TEST_CASE("stages: what is not a product over depth is left alone", "[legalize]") {
    const auto check_alone = [](const Profile& profile, const std::string& text) {
        check_rewrite(profile, text, text);
    };
    for (const char* chip : {"ideal", "dx7", "gamecube", "xbox"}) check_alone(*find_profile(chip), split_me(kDepth));
    for (const Profile& profile : {one_stage(), *find_profile("ps2")}) {
        check_alone(profile, split_me("depth {func LESS}"));
        check_alone(profile, split_me("depth {write true}"));
        check_alone(profile, split_me(kDepth + " blend {source SRCALPHA dest INVSRCALPHA}"));
        check_alone(profile, split_me(kDepth + " alpha_test {func GREATER}"));
        std::string few_bits = split_me(kDepth);
        few_bits.replace(few_bits.find("{width"), 1, "{format R5G6B5 ");
        check_alone(profile, few_bits);
        check_alone(profile, split_me(kDepth, "{color_op ADD alpha_op SELECTARG2}"));
        check_alone(profile, split_me(kDepth, "{color_op MODULATE alpha_op MODULATE}"));
        check_alone(profile, split_me(kDepth, "{color_op MODULATE color_arg2 {source DIFFUSE} alpha_op SELECTARG2}"));
    }
    const std::string from_target = frame_text(
        pass_text("p", kDepth + " stages [" + kFirst + kSecond + "]", "textures [{texture #0}{target \"t\"}]", kClear));
    check_alone(*find_profile("ps2"), from_target);
    CHECK(rewritten(parse_frame(from_target), one_stage()).passes.size() == 2);
    check_alone(*find_profile("ps2"),
                split_me(kDepth + " fog {mode LINEAR}", "{color_op MODULATE2X alpha_op SELECTARG2}"));
    Profile no_products             = one_stage();
    no_products.states.dest_factors = {BlendFactor::Zero, BlendFactor::One};
    check_alone(no_products, split_me(kDepth));
}

namespace {

// Two quads through each other in perspective, each with two textures of noise, over a cleared target.
Frame crossing_quads(TextureOp op, bool fog) {
    Frame frame                 = test_support::small_frame(64, 64, TargetFormat::D24);
    frame.targets[0].format     = TargetFormat::A8R8G8B8;
    frame.cameras[0].projection = Mat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1.5f, 1, 0, 0, -1.5f, 0);
    std::vector<std::uint8_t> texels;
    for (std::uint32_t i = 0; i < 2 * 16 * 16 * 4; ++i)
        texels.push_back(static_cast<std::uint8_t>((i * 2654435761u) >> 13));
    for (std::size_t i = 0; i < 2; ++i) {
        const auto first = texels.begin() + static_cast<std::ptrdiff_t>(i * 1024);
        test_support::add_texture(frame, TextureFormat::A8R8G8B8, 16, 16, {first, first + 1024});
    }
    Pass& pass           = frame.passes[0];
    pass.clear           = {.color = Argb{0xff406080}, .depth = 1.0f};
    pass.state.depth     = {.func = CompareFunc::LessEqual, .write = true};
    pass.state.stages[0] = {.color_op = TextureOp::Modulate, .alpha_op = TextureOp::SelectArg2};
    pass.state.stages[1] = {.color_op = op, .alpha_op = TextureOp::SelectArg2, .coords = CoordSource::Vertex1};
    if (fog) pass.state.fog = {.mode = FogMode::Linear, .color = {0xff2040ff}, .start = 1.0f, .end = 3.0f};
    for (const std::uint32_t color : {0xfff0c080u, 0xff60ffe0u}) {
        DrawTriangles draw      = test_support::add_quad(frame, color);
        const std::size_t first = frame.vertices.size() - 4;
        for (std::size_t i = 0; i < 4; ++i) {
            Vertex& vertex     = frame.vertices[first + i];
            const bool is_near = (vertex.position.x > 0.0f) == (color == 0xfff0c080u);
            vertex.uv0         = Vec2(vertex.position.x, vertex.position.y);
            vertex.uv1         = 1.5f * vertex.uv0;
            vertex.position    = Vec3(vertex.position.x, vertex.position.y, 1.0f) * (is_near ? 1.25f : 2.75f);
        }
        draw.textures = {test_support::bound({0}), test_support::bound({1})};
        pass.draws.push_back(draw);
    }
    return frame;
}

int worst_difference(const Frame& got, const Frame& want) {
    const auto a = execute(got).output.pixels, b = execute(want).output.pixels;
    int worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (const int shift : {0, 8, 16})
            worst = std::max(worst,
                             std::abs(static_cast<int>(a[i] >> shift & 255) - static_cast<int>(b[i] >> shift & 255)));
    return worst;
}

}  // namespace

TEST_CASE("stages: passes give the picture of the stages", "[legalize]") {
    const TextureOp op = GENERATE(TextureOp::Modulate, TextureOp::Modulate2X);
    CHECK(worst_difference(rewritten(crossing_quads(op, false), one_stage()), crossing_quads(op, false)) == 0);
    CHECK(worst_difference(rewritten(crossing_quads(op, true), one_stage()), crossing_quads(op, true)) <= 3);
}

TEST_CASE("stages: with the other rewrites the Graphics Synthesizer draws it, but for roundings", "[legalize]") {
    const Profile& ps2          = *find_profile("ps2");
    const auto [op, fog, bound] = GENERATE(table<TextureOp, bool, int>({{TextureOp::Modulate, false, 4},
                                                                        {TextureOp::Modulate, true, 6},
                                                                        {TextureOp::Modulate2X, false, 8},
                                                                        {TextureOp::Modulate2X, true, 9}}));
    const Frame before          = crossing_quads(op, fog);
    Frame frame                 = before;
    RewriteNotes notes;
    for (const Rewrite rewrite : {&rewrite_window_triangles, &rewrite_stages, &rewrite_vertex_constants,
                                  &rewrite_formats, &rewrite_gs_alpha, &rewrite_gs_blend}) {
        frame = rewrite(frame, ps2, notes);
        for (const Finding& finding : validate(frame)) FAIL_CHECK(finding.where << ": " << finding.what);
    }
    CHECK(frame.arithmetic.blend == BlendRule::GsShift7);
    // Depth turns where two quads meet may fall to the other by rounding, so that it is not turned here.
    CHECK(worst_difference(frame, before) <= bound);

    frame            = rewrite_reversed_depth(frame, ps2, notes);
    frame.arithmetic = ps2.arithmetic;
    for (const Finding& finding : validate(frame)) FAIL_CHECK(finding.where << ": " << finding.what);
    for (const ChipFinding& finding : check(frame, ps2)) FAIL_CHECK(finding.where << ": " << finding.uses);
}
