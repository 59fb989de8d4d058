// SPDX-License-Identifier: MIT
#include "pipeline/legalize/second_alpha.h"

#include <cmath>

#include "tests/support/rewritten.h"

using namespace pipeline;
using namespace test_support;

namespace {

const std::string kFirst   = "{ color_op SELECTARG1 alpha_op SELECTARG1 address_u CLAMP }";
const std::string kProduct = "{ color_op SELECTARG2 alpha_op MODULATE alpha_arg2 { source TFACTOR } filter LINEAR }";
const std::string kSum     = "{ color_op SELECTARG2 alpha_op ADDSIGNED2X filter LINEAR }";
const std::string kOver    = "blend { source SRCALPHA dest INVSRCALPHA } ";

const std::string kVertices =
    "{ x 0 diffuse 0x00112233 uv0 (0 0 1) uv1 (1 2 3) } { x 4 uv0 (1 0 1) uv1 (4 5 1) } { y 4 uv0 (0 1 1) uv1 (0 6 1) } ";
// As first coordinates, of white.
const std::string kSecondVertices =
    "{ x 0 uv0 (1 2 3) uv1 (1 2 3) } { x 4 uv0 (4 5 1) uv1 (4 5 1) } { y 4 uv0 (0 6 1) uv1 (0 6 1) } ";

std::string text(const std::string& passes, const std::string& targets = "", const std::string& textures = "",
                 const std::string& vertices = "", const std::string& indices = "") {
    return "targets [ \"a\" { width 4 height 4 } \"t\" { width 4 height 4 } " + targets + "] passes [ " + passes +
           " ] textures [ \"f\" { format A8 width 1 height 1 texels [40] } " + textures + "] window_vertices [ " +
           kVertices + vertices + "] indices [ 0 1 2 " + indices + "]";
}
std::string before(const std::string& state, const std::string& second, const std::string& first = kFirst) {
    return text("\"p\" { color \"a\" clear { color 0x00334455 } state { " + state + "stages [ " + first + second +
                " ] } draws [ window_triangles { index_count 3 textures [ { target \"t\" } { texture \"f\" } ] } ] }");
}

// Alpha x of the first texture, the target's, in column x, and texel y of the second in row y: all pairs. The second pass writes to
// the picture, over a colour.
constexpr int kWidth = 256;
Frame pairs_frame(int rows, const TextureStage& first, const TextureStage& second, const BlendState& blend,
                  std::uint32_t factor, std::uint32_t color, std::uint32_t clear, int drawn_width = kWidth) {
    Frame frame = small_frame(kWidth, rows);
    frame.targets.push_back({.name = "source", .width = kWidth, .height = rows});
    frame.passes[0].color  = {1};
    frame.passes[0].camera = {};
    frame.cameras.clear();
    for (int x = 0; x < kWidth; ++x)
        frame.passes[0].draws.push_back(rectangle({x, 0, x + 1, rows}, static_cast<std::uint32_t>(x) << 24 | color));
    std::vector<std::uint8_t> texels;
    for (int y = 0; y < rows; ++y) texels.push_back(static_cast<std::uint8_t>(y));
    const TextureId column = add_texture(frame, TextureFormat::A8, 1, rows, texels);

    Pass& pass                = frame.passes.emplace_back();
    pass.color                = {0};
    pass.clear.color          = Argb{clear};
    pass.state.blend          = blend;
    pass.state.texture_factor = {factor};
    pass.state.stages         = {first, second};
    const float w = static_cast<float>(drawn_width), h = static_cast<float>(rows);
    for (const auto& [x, y] : {std::pair{0.0f, 0.0f}, {w, 0.0f}, {w, h}, {0.0f, h}})
        frame.window_vertices.push_back({.x = x, .y = y, .uv0 = {x / kWidth, y / h, 1.0f}, .uv1 = {0.5f, y / h, 1.0f}});
    frame.indices = {0, 1, 2, 0, 2, 3};
    pass.draws    = {DrawWindowTriangles{
           .index_count = 6, .textures = {{{.texture = {}, .target = {1}}, {.texture = column, .target = {}}}}}};
    return frame;
}

constexpr TextureStage kTexel{.color_op  = TextureOp::SelectArg1,
                              .alpha_op  = TextureOp::SelectArg1,
                              .address_u = TextureAddress::Clamp,
                              .address_v = TextureAddress::Clamp};
constexpr TextureStage kSignedSum{.color_op  = TextureOp::SelectArg2,
                                  .alpha_op  = TextureOp::AddSigned2X,
                                  .address_u = TextureAddress::Clamp,
                                  .address_v = TextureAddress::Clamp};
constexpr TextureStage kTimesFactor{.color_op   = TextureOp::SelectArg2,
                                    .alpha_op   = TextureOp::Modulate,
                                    .alpha_arg2 = {.source = ArgSource::TFactor},
                                    .address_u  = TextureAddress::Clamp,
                                    .address_v  = TextureAddress::Clamp};
TextureStage first_stage(TextureOp alpha_op) {
    TextureStage stage = kTexel;
    stage.alpha_op     = alpha_op;
    stage.alpha_arg2   = {.source = ArgSource::TFactor};
    return stage;
}

Frame sums_frame(const BlendState& blend, const TextureStage& first = kTexel, std::uint32_t factor = 0xffffffff) {
    return pairs_frame(128, first, kSignedSum, blend, factor, 0x00c86432, 0x00204060);
}
Frame products_frame(std::uint32_t factor) {
    return pairs_frame(256, kTexel, kTimesFactor, kAlphaOver, factor, 0x00c86432, 0x00204060);
}

Frame rewritten_ps2(const Frame& frame) {
    return rewritten(frame, &rewrite_second_alpha, "ps2");
}

// The greatest difference of any byte that the mask leaves.
int worst_difference(const Frame& a, const Frame& b, std::uint32_t mask) {
    const std::vector<std::uint32_t> of_a = pixels_of(a), of_b = pixels_of(b);
    REQUIRE(of_a.size() == of_b.size());
    int worst = 0;
    for (std::size_t i = 0; i < of_a.size(); ++i)
        for (int shift = 0; shift < 32; shift += 8) {
            const auto byte = [&](std::uint32_t color) { return static_cast<int>((color & mask) >> shift & 255); };
            worst           = std::max(worst, std::abs(byte(of_a[i]) - byte(of_b[i])));
        }
    return worst;
}
constexpr std::uint32_t kRgb = 0x00ffffff, kAlpha = 0xff000000;

Frame legal_on_ps2(const Frame& frame) {
    const LegalFrame legal = legalize(frame, *find_profile("ps2"));
    for (const ChipFinding& finding : legal.left) FAIL_CHECK(finding.where << ": " << finding.uses);
    return legal.frame;
}

}  // namespace

TEST_CASE("second_alpha: a product is written as alpha alone, and blends the colour", "[legalize]") {
    check_rewrite(
        &rewrite_second_alpha, "ps2", before(kOver + "texture_factor 0x80102030 ", kProduct),
        text(
            R"("p: alpha" { color "a" clear { color 0x00334455 } state { color_mask { red false green false blue false }
                    texture_factor 0x80ffffff
                    stages [ { color_op SELECTARG1 alpha_op MODULATE alpha_arg2 { source TFACTOR } filter LINEAR } ] }
                    draws [ window_triangles { first_index 3 index_count 3 textures [ { texture "f" } ] } ] }
                "p: colour" { color "a" state { blend { source DESTALPHA dest INVDESTALPHA } color_mask { alpha false }
                    texture_factor 0xff102030
                    stages [ { color_op SELECTARG1 alpha_op SELECTARG2 alpha_arg2 { source TFACTOR } address_u CLAMP } ] }
                    draws [ window_triangles { index_count 3 textures [ { target "t" } ] } ] })",
            "", "", kSecondVertices, "3 4 5"));
}

TEST_CASE("second_alpha: a signed sum is made in colour, and copied back to alpha", "[legalize]") {
    const std::string mask = "color_mask { alpha false } ";
    check_rewrite(
        &rewrite_second_alpha, "ps2", before(kOver, kSum),
        text(
            R"("p: alpha as colour" { color "sums of alpha" draws [ copy { source "t" from { x1 4 y1 4 } channels ALPHA_TO_COLOR } ] }
                "p: the other way round" { color "sums of alpha" state { blend { source INVDESTCOLOR dest ZERO } )" +
                mask + R"( }
                    draws [ rectangle { x1 4 y1 4 } ] }
                "p: the texture off" { color "sums of alpha" state { blend { source ONE dest ONE } )" +
                mask + R"(
                    stages [ { color_op SELECTARG1 alpha_op SELECTARG2 alpha_arg2 { source DIFFUSE } filter LINEAR } ] }
                    draws [ window_triangles { first_index 3 index_count 3 textures [ { texture "f, from one half" } ] } ] }
                "p: back again" { color "sums of alpha" state { blend { source INVDESTCOLOR dest ZERO } )" +
                mask + R"( }
                    draws [ rectangle { x1 4 y1 4 } ] }
                "p: twice" { color "sums of alpha" state { blend { source DESTCOLOR dest ONE } )" +
                mask + R"( }
                    draws [ rectangle { x1 4 y1 4 } ] }
                "p: colour as alpha" { color "a" clear { color 0x00334455 } draws [ copy { source "sums of alpha" from { x1 4 y1 4 }
                    channels GREEN_TO_ALPHA } ] }
                "p: colour" { color "a" state { blend { source DESTALPHA dest INVDESTALPHA } )" +
                mask + R"(
                    stages [ { color_op SELECTARG1 alpha_op SELECTARG2 alpha_arg2 { source TFACTOR } address_u CLAMP } ] }
                    draws [ window_triangles { index_count 3 textures [ { target "t" } ] } ] })",
            "\"sums of alpha\" { width 4 height 4 } ",
            "\"f, from one half\" { format L8 width 1 height 1 texels [3f] } ", kSecondVertices, "3 4 5"));
}

TEST_CASE("second_alpha: the factor is multiplied in or taken off first, where it changes something", "[legalize]") {
    const auto labels = [](TextureOp alpha_op, std::uint32_t factor) {
        std::string all;
        for (const Pass& pass : rewritten_ps2(sums_frame(kAlphaOver, first_stage(alpha_op), factor)).passes)
            all += pass.label + '|';
        return all;
    };
    const std::string start = "|: alpha as colour|", rest =
                                                         ": the other way round|: the texture off|: back again|: twice|"
                                                         ": colour as alpha|: colour|";
    CHECK(labels(TextureOp::SelectArg1, 0x80ffffff) == start + rest);
    CHECK(labels(TextureOp::Modulate, 0xffffffff) == start + rest);
    CHECK(labels(TextureOp::Modulate, 0xfeffffff) == start + ": times the factor|" + rest);
    CHECK(labels(TextureOp::Subtract, 0x00ffffff) == start + rest);
    CHECK(labels(TextureOp::Subtract, 0x01ffffff) ==
          start + ": the other way round|: the factor off|" + rest.substr(rest.find(": the texture")));
}

TEST_CASE("second_alpha: all sums of alpha and texel are those of the stages, or 1 more", "[legalize][exhaustive]") {
    const auto [op, factor] = GENERATE(table<TextureOp, std::uint32_t>({{TextureOp::SelectArg1, 0xffffffff},
                                                                        {TextureOp::Modulate, 0xffffffff},
                                                                        {TextureOp::Modulate, 0x99ffffff},
                                                                        {TextureOp::Subtract, 0x00ffffff},
                                                                        {TextureOp::Subtract, 0x30ffffff}}));
    CAPTURE(enum_name(op), factor);
    const Frame frame = sums_frame(kReplace, first_stage(op), factor), other = rewritten_ps2(frame);
    CHECK(other.passes.size() > 2);
    CHECK(worst_difference(frame, other, kAlpha) <= 1);
    CHECK(worst_difference(frame, other, kRgb) == 0);
    const std::vector<std::uint32_t> pixels = pixels_of(other);
    CHECK((pixels.front() >> 24) == 0);
    CHECK((pixels.back() >> 24) > 60);
}

TEST_CASE("second_alpha: known sums", "[legalize]") {
    const std::vector<std::uint32_t> pixels = pixels_of(rewritten_ps2(sums_frame(kReplace)));
    const auto alpha                        = [&](int first, int second) {
        return pixels[static_cast<std::size_t>(second * kWidth + first)] >> 24;
    };
    CHECK(alpha(255, 127) == 255);  // 2 (255 - 0) is cut at one
    CHECK(alpha(255, 0) == 255);    // 2 (255 - 127) is 256
    CHECK(alpha(254, 0) == 254);
    CHECK(alpha(127, 0) == 0);
    CHECK(alpha(128, 0) == 2);
    CHECK(alpha(100, 64) == 74);  // 2 (100 - 63)
    CHECK(alpha(0, 127) == 0);
}

TEST_CASE("second_alpha: what replaces has alpha where it draws, and 0 elsewhere as it was cleared", "[legalize]") {
    const Frame frame = pairs_frame(128, kTexel, kSignedSum, kReplace, 0xffffffff, 0x00c86432, 0x00204060, 100),
                other = rewritten_ps2(frame);
    CHECK(worst_difference(frame, other, kAlpha) <= 1);
    CHECK(worst_difference(frame, other, kRgb) == 0);
    const std::vector<std::uint32_t> pixels = pixels_of(other);
    CHECK(pixels[127 * kWidth + 99] == 0xc6c86432);  // 2 * 99
    for (std::size_t x = 100; x < kWidth; ++x) CHECK(pixels[127 * kWidth + x] == 0x00204060);
}

TEST_CASE("second_alpha: blends by sums are off by 1, and by products the same", "[legalize][exhaustive]") {
    CHECK(worst_difference(sums_frame(kAlphaOver), rewritten_ps2(sums_frame(kAlphaOver)), kRgb) <= 1);
    const std::uint32_t factor = GENERATE(0x00ffffffu, 0x01ffffffu, 0x80ffffffu, 0xc8102030u, 0xffffffffu);
    CHECK(worst_difference(products_frame(factor), rewritten_ps2(products_frame(factor)), kRgb) == 0);
}

TEST_CASE("second_alpha: the Graphics Synthesizer blends by all sums and products, but for roundings",
          "[legalize][exhaustive]") {
    // Alpha off by 1, counted to 0x80 by halves and back: 2 of 255 and 1. Of colours 168, 36 and 46 apart; a blend's floor.
    const auto [op, factor] = GENERATE(table<TextureOp, std::uint32_t>(
        {{TextureOp::SelectArg1, 0xffffffff}, {TextureOp::Modulate, 0x99ffffff}, {TextureOp::Subtract, 0x30ffffff}}));
    CAPTURE(enum_name(op), factor);
    const Frame sums = sums_frame(kAlphaOver, first_stage(op), factor);
    CHECK(worst_difference(sums, legal_on_ps2(sums), kRgb) <= 3);
    const Frame products = products_frame(factor);
    CHECK(worst_difference(products, legal_on_ps2(products), kRgb) <= 3);
}

TEST_CASE("second_alpha: a product of vertices that draws share is made once for both", "[legalize]") {
    Frame frame = products_frame(0x80ffffff);
    frame.passes[1].draws.push_back(frame.passes[1].draws[0]);
    const Frame other = rewritten_ps2(frame);
    CHECK(other.window_vertices.size() == 4 + 4);
    CHECK(other.passes[1].draws.size() == 2);
    CHECK(other.passes[1].draws[0] == other.passes[1].draws[1]);
}

TEST_CASE("second_alpha: what it has no form for is left alone", "[legalize]") {
    struct Case {
        const char* name;
        std::function<void(Frame&, Pass&)> change;
        bool of_products = true;  // too
    };
    const auto add_texture_pass = [](Frame& frame, TextureOp alpha_op) {
        frame.targets.push_back({.name = "shown", .width = kWidth, .height = frame.targets[0].height});
        Pass& reader                      = frame.passes.emplace_back();
        reader.color                      = {2};
        reader.state.stages[0]            = kTexel;
        reader.state.stages[0].alpha_op   = alpha_op;
        reader.state.stages[0].alpha_arg2 = {.source = ArgSource::Diffuse};
        DrawRectangle draw                = rectangle({0, 0, 8, 8}, 0xffffffff);
        draw.textures[0].target           = {0};
        reader.draws                      = {draw};
    };
    const std::vector<Case> refused{
        {"depth test",
         [](Frame& f, Pass& p) {
             f.targets.push_back(
                 {.name = "depth", .format = TargetFormat::D24, .width = kWidth, .height = f.targets[0].height});
             p.depth            = {2};
             p.state.depth.func = CompareFunc::LessEqual;
         }},
        {"alpha test", [](Frame&, Pass& p) { p.state.alpha_test = {.func = CompareFunc::Greater, .reference = 1}; }},
        {"destination alpha test", [](Frame&, Pass& p) { p.state.dest_alpha_test = DestAlphaTest::One; }},
        {"fog", [](Frame&, Pass& p) { p.state.fog.mode = FogMode::Linear; }},
        {"specular", [](Frame&, Pass& p) { p.state.lighting.specular_enable = true; }},
        {"other blend", [](Frame&, Pass& p) { p.state.blend.dest = BlendFactor::One; }},
        {"mask", [](Frame&, Pass& p) { p.state.color_mask.red = false; }},
        {"a target without alpha", [](Frame& f, Pass&) { f.targets[0].format = TargetFormat::X8R8G8B8; }},
        {"alpha read later", [&](Frame& f, Pass&) { add_texture_pass(f, TextureOp::SelectArg1); }},
        {"a rectangle too",
         [](Frame&, Pass& p) {
             p.draws.push_back(rectangle({0, 0, 4, 4}, 0xffffffff));
         }},
        {"nothing drawn", [](Frame&, Pass& p) { p.draws.clear(); }},
        {"first texture no target",
         [](Frame&, Pass& p) { (*bindings_of(p.draws[0]))[0] = (*bindings_of(p.draws[0]))[1]; }},
        {"two first targets",
         [](Frame& f, Pass& p) {
             f.targets.push_back(f.targets[1]);
             p.draws.push_back(p.draws[0]);
             (*bindings_of(p.draws[1]))[0].target = {2};
         }},
        {"a first target of another size", [](Frame& f, Pass&) { f.targets[1].width = 128; }},
        {"first colour of vertices", [](Frame&, Pass& p) { p.state.stages[0].color_arg1.source = ArgSource::Diffuse; }},
        {"first colour complemented", [](Frame&, Pass& p) { p.state.stages[0].color_arg1.complement = true; }},
        {"second colour", [](Frame&, Pass& p) { p.state.stages[1].color_op = TextureOp::SelectArg1; }},
        {"other second alpha", [](Frame&, Pass& p) { p.state.stages[1].alpha_op = TextureOp::Add; }},
        {"second alpha complemented", [](Frame&, Pass& p) { p.state.stages[1].alpha_arg1.complement = true; }},
        {"one stage", [](Frame&, Pass& p) { p.state.stages[1] = {}; }},
        {"other first alpha", [](Frame&, Pass& p) { p.state.stages[0].alpha_op = TextureOp::Add; }, false},
        {"a texel of one half", [](Frame& f, Pass&) { f.textures[0].texels[5] = 128; }, false},
        {"a texture of colours",
         [](Frame& f, Pass&) {
             f.textures[0].format = TextureFormat::A8R8G8B8;
             f.textures[0].texels.resize(4 * f.textures[0].texels.size());
         },
         false},
    };
    const auto check_alone = [](const Case& each, Frame frame) {
        INFO(each.name);
        each.change(frame, frame.passes[1]);
        CHECK(rewritten_ps2(frame) == frame);
    };
    for (const Case& each : refused) {
        check_alone(each, sums_frame(kAlphaOver));
        if (each.of_products) check_alone(each, products_frame(0x80ffffff));
    }
    Frame frame                 = products_frame(0x80ffffff);
    frame.passes[1].state.blend = kReplace;
    CHECK(rewritten_ps2(frame) == frame);
    // But not for these.
    frame = sums_frame(kAlphaOver);
    add_texture_pass(frame, TextureOp::SelectArg2);  // reads colour alone
    CHECK(rewritten_ps2(frame) != frame);
    frame                       = sums_frame(kAlphaOver);
    frame.textures[0].texels[5] = 127;
    CHECK(rewritten_ps2(frame) != frame);
    for (const char* chip : {"ideal", "dx7", "gamecube", "xbox"}) {
        CHECK(rewritten(sums_frame(kAlphaOver), &rewrite_second_alpha, chip) == sums_frame(kAlphaOver));
        CHECK(rewritten(products_frame(0x80ffffff), &rewrite_second_alpha, chip) == products_frame(0x80ffffff));
    }
}

TEST_CASE("second_alpha: alpha outside of what replaces must be 0, which a clear says", "[legalize]") {
    // Half is drawn; the rest keeps alpha of the clear, or of what was there.
    const auto frame = [](std::uint32_t clear) {
        return pairs_frame(128, kTexel, kSignedSum, kReplace, 0xffffffff, 0x00c86432, clear, 100);
    };
    CHECK(rewritten_ps2(frame(0x00204060)) != frame(0x00204060));
    CHECK(worst_difference(frame(0xff204060), rewritten_ps2(frame(0xff204060)), kAlpha) <= 1);
    Frame kept           = frame(0);
    kept.passes[1].clear = {};
    kept.passes.insert(kept.passes.begin(), kept.passes[0]);
    kept.passes[0].color = {0};
    CHECK(worst_difference(kept, rewritten_ps2(kept), kAlpha) <= 1);
}

TEST_CASE("second_alpha: viewport and culling hold for all passes", "[legalize]") {
    const auto check_same = [](const auto& change) {
        for (Frame frame : {sums_frame(kAlphaOver), sums_frame(kReplace), products_frame(0x80ffffff)}) {
            change(frame.passes[1].state);
            CHECK(worst_difference(frame, rewritten_ps2(frame), kRgb) <= 1);
        }
    };
    check_same([](PipelineState& state) { state.scissor = {10, 20, 200, 100}; });
    check_same([](PipelineState& state) { state.viewport = {10, 20, 200, 100}; });
    check_same([](PipelineState& state) { state.viewport = {10, 20, 200, 100}, state.scissor = {0, 40, 180, 128}; });
    check_same([](PipelineState& state) { state.cull = CullMode::Clockwise; });
}
