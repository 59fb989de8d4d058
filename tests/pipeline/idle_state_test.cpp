// SPDX-License-Identifier: MIT
#include "pipeline/check/idle_state.h"

#include <catch2/catch.hpp>

#include "pipeline/check/state_use.h"
#include "pipeline/validate/validate.h"
#include "tests/support/frame_agreement.h"
#include "tests/support/random.h"
#include "tests/support/random_frame.h"
#include "tests/support/random_state.h"
#include "tests/support/small_frame.h"

using namespace pipeline;
using test_support::Random;

namespace {

std::optional<TargetFormat> format_of(const Frame& frame, TargetId id) {
    if (!id) return {};
    return frame.targets[static_cast<std::size_t>(id.index)].format;
}

// Every state that does not matter becomes another, at random.
Frame with_other_idle_state(const Frame& frame, std::uint32_t seed) {
    Random random(seed);
    Frame other = frame;
    for (Pass& pass : other.passes) {
        const bool copies = std::any_of(pass.draws.begin(), pass.draws.end(),
                                        [](const Draw& draw) { return std::holds_alternative<CopyRectangle>(draw); });
        if (copies) continue;  // have no state, says validate
        pass.state = with_idle_state_of(frame, pass,
                                        test_support::random_state(frame.arithmetic, random, 32, 32,
                                                                   format_of(frame, pass.color), bool(pass.depth)));
    }
    const Arithmetic rules        = with_idle_rules_of(frame, test_support::random_arithmetic(random));
    other.arithmetic.vertex_depth = rules.vertex_depth;
    other.arithmetic.gouraud      = rules.gouraud;
    other.arithmetic.filter       = rules.filter;
    other.arithmetic.fog          = rules.fog;
    other.arithmetic.blend_source = rules.blend_source;
    return other;
}

// Which values a field has, where it matters.
std::string values_in_use(const Frame& frame, std::string_view path) {
    StateUses uses;
    add_state_uses(frame, uses);
    std::string values;
    for (std::size_t i = 0; i < state_fields().size(); ++i)
        for (std::size_t value = 0; value < uses[i].size(); ++value)
            if (state_fields()[i].path == path && uses[i][value] > 0)
                values += (values.empty() ? "" : " ") + std::string(state_fields()[i].values[value]);
    return values;
}

}  // namespace

TEST_CASE("what does not matter in a state can be anything: the picture stays", "[check]") {
    int drawn = 0;
    for (std::uint32_t seed = 0; seed < 400; ++seed) {
        CAPTURE(seed);
        const Frame frame = test_support::random_frame(seed);
        const Frame other = with_other_idle_state(frame, seed + 1000);
        // Some rules of validate tie together what one of which does not matter.
        if (other == frame || !validate(other).empty()) continue;
        ++drawn;
        const test_support::Drawn want = test_support::draw(frame), got = test_support::draw(other);
        CHECK(got.passes == want.passes);
    }
    CHECK(drawn > 300);
}

TEST_CASE("a state is in use where its value matters", "[check]") {
    Frame frame = test_support::small_frame(8, 8, TargetFormat::D24);
    Pass& pass  = frame.passes[0];
    pass.draws  = {test_support::rectangle({0, 0, 8, 8}, 0xff102030)};

    SECTION("not what a rectangle knows nothing of") {
        pass.state.cull                     = CullMode::Clockwise;
        pass.state.fog.mode                 = FogMode::Exp;
        pass.state.lighting.enabled         = true;
        pass.state.lighting.specular_enable = true;
        for (const char* path : {"state.cull", "state.fog.mode", "state.lighting.enabled", "state.shade",
                                 "state.lighting.diffuse_source", "arithmetic.fog", "arithmetic.gouraud"}) {
            CAPTURE(path);
            CHECK(values_in_use(frame, path).empty());
        }
        CHECK(values_in_use(frame, "arithmetic.snap") == "NEAREST");
        CHECK(values_in_use(frame, "state.depth.func") == "ALWAYS");
        pass.draws = {test_support::add_quad(frame, 0xff102030)};
        CHECK(values_in_use(frame, "state.cull") == "CW");
        CHECK(values_in_use(frame, "state.fog.mode") == "EXP");
        CHECK(values_in_use(frame, "state.lighting.enabled") == "true");
        CHECK(values_in_use(frame, "state.lighting.diffuse_source") == "COLOR1");
        CHECK(values_in_use(frame, "state.lighting.specular_source").empty());  // no light has a highlight
        CHECK(values_in_use(frame, "arithmetic.fog") == "NEAREST255");
        CHECK(values_in_use(frame, "arithmetic.gouraud") == "NEAREST");
    }
    SECTION("of a texture, where one is read") {
        TextureStage& stage = pass.state.stages[0];
        stage               = {.color_op   = TextureOp::Modulate,
                               .alpha_op   = TextureOp::SelectArg2,
                               .filter     = TextureFilter::Linear,
                               .mip_filter = MipFilter::Linear,
                               .address_u  = TextureAddress::Mirror};
        CHECK(values_in_use(frame, "state.stages.color_op") == "DISABLE MODULATE");
        CHECK(values_in_use(frame, "state.stages.filter").empty());
        CHECK(values_in_use(frame, "textures.format").empty());
        const TextureId texture = test_support::add_texture(frame, TextureFormat::L8, 1, 1, {9});
        CHECK(values_in_use(frame, "textures.format").empty());
        std::get<DrawRectangle>(pass.draws[0]).textures[0].texture = texture;
        CHECK(values_in_use(frame, "textures.format") == "L8");
        CHECK(values_in_use(frame, "state.stages.filter") == "LINEAR");
        CHECK(values_in_use(frame, "state.stages.mip_filter").empty());  // it has one level
        CHECK(values_in_use(frame, "state.stages.address_u") == "MIRROR");
        CHECK(values_in_use(frame, "state.stages.coords").empty());
        CHECK(values_in_use(frame, "state.stages.alpha_arg2.source") == "CURRENT");
        CHECK(values_in_use(frame, "state.stages.alpha_arg1.source").empty());
        stage.color_op = TextureOp::SelectArg2;
        CHECK(values_in_use(frame, "state.stages.filter").empty());
    }
    SECTION("of blending, where colour is written") {
        pass.state.blend = kAlphaOver;
        CHECK(values_in_use(frame, "state.blend.dest") == "INVSRCALPHA");
        CHECK(values_in_use(frame, "state.gs_blend.a").empty());
        CHECK(values_in_use(frame, "arithmetic.blend") == "NEAREST255");
        CHECK(values_in_use(frame, "arithmetic.blend_source").empty());  // the target keeps all bits
        pass.state.color_mask = {false, false, false, false};
        CHECK(values_in_use(frame, "state.blend.dest").empty());
        CHECK(values_in_use(frame, "arithmetic.blend").empty());
        CHECK(values_in_use(frame, "state.color_mask.red") == "false");
    }
    SECTION("of targets and copies") {
        frame.targets.push_back({.name = "idle", .format = TargetFormat::R5G6B5, .width = 8, .height = 8});
        CHECK(values_in_use(frame, "targets.format") == "A8R8G8B8");  // nor does anything meet the depth
        pass.state.depth = {CompareFunc::LessEqual, true};
        CHECK(values_in_use(frame, "targets.format") == "A8R8G8B8 D24");
        CHECK(values_in_use(frame, "draws.copy.halve").empty());
        frame.passes.push_back({.label = "copy",
                                .color = {2},
                                .draws = {CopyRectangle{.source = {0}, .from = {0, 0, 8, 8}, .halve = true}}});
        CHECK(values_in_use(frame, "targets.format") == "A8R8G8B8 R5G6B5 D24");
        CHECK(values_in_use(frame, "draws.copy.halve") == "true");
    }
}

TEST_CASE("vertex attributes are those that a pass needs", "[check]") {
    using Names = std::vector<std::string_view>;
    Frame frame = test_support::small_frame(8, 8, TargetFormat::D24);
    Pass& pass  = frame.passes[0];
    pass.draws  = {test_support::rectangle({0, 0, 8, 8}, 0xff102030)};
    CHECK(vertex_attributes(frame, pass) == Names{});
    DrawTriangles quad = test_support::add_quad(frame, 0xff102030);
    pass.draws         = {quad};
    CHECK(vertex_attributes(frame, pass) == Names{"position", "diffuse"});
    pass.state.color_mask = {false, false, false, false};
    CHECK(vertex_attributes(frame, pass) == Names{"position"});
    pass.state.color_mask = {};

    TextureStage& stage = pass.state.stages[0];
    stage               = {.color_op = TextureOp::SelectArg1, .alpha_op = TextureOp::SelectArg1};
    CHECK(vertex_attributes(frame, pass) == Names{"position"});  // white
    quad.textures[0].texture = test_support::add_texture(frame, TextureFormat::L8, 1, 1, {9});
    pass.draws               = {quad};
    CHECK(vertex_attributes(frame, pass) == Names{"position", "uv0"});
    stage.coords = CoordSource::CameraPosition;
    CHECK(vertex_attributes(frame, pass) == Names{"position"});
    stage.coords                        = CoordSource::Vertex1;
    stage.color_op                      = TextureOp::Modulate;
    stage.color_arg2                    = {.source = ArgSource::Diffuse};
    pass.state.lighting.specular_enable = true;
    CHECK(vertex_attributes(frame, pass) == Names{"position", "diffuse", "specular", "uv1"});
    pass.state.lighting.enabled = true;
    CHECK(vertex_attributes(frame, pass) == Names{"position", "diffuse", "uv1"});
    pass.state.lighting.lights = {{.specular = Vec3(1.0f)}};
    CHECK(vertex_attributes(frame, pass) == Names{"position", "normal", "diffuse", "specular", "uv1"});
    pass.state.lighting.diffuse_source = pass.state.lighting.specular_source = ColorSource::Material;
    CHECK(vertex_attributes(frame, pass) == Names{"position", "normal", "uv1"});
}
