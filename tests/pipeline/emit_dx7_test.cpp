// SPDX-License-Identifier: MIT
#include "pipeline/emit/emit_dx7.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <sstream>

#include "pipeline/emit/dx7_data.h"
#include "pipeline/frame/frame_text.h"

using namespace pipeline;

namespace {

Frame parsed(const std::string& text) {
    return parse_frame("nimbus7 frame 1\n" + text);
}

// Of a frame that the chip can draw.
Emitted emitted(const Frame& frame) {
    const std::vector<ChipFinding> left = check(frame, *find_profile("dx7"));
    CHECK(left == std::vector<ChipFinding>{});
    return emit_dx7({.frame = frame, .notes = {}, .left = {}}, "frame.bin");
}

// From its first words to the brace that ends it.
std::string part_of(const std::string& text, const std::string& start, const std::string& end = "\n}\n") {
    const std::size_t from = text.find(start), to = text.find(end, from);
    REQUIRE(from != std::string::npos);
    REQUIRE(to != std::string::npos);
    return text.substr(from, to + end.size() - from);
}
std::string pass_text(const std::string& text, int pass) {
    return part_of(text, "// Pass " + std::to_string(pass) + ' ');
}

int count_of(const std::string& text, const std::string& words) {
    int count = 0;
    for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
    return count;
}

const std::string kRender = "TRY(device->SetRenderState(D3DRENDERSTATE_", kStage = "TRY(device->SetTextureStageState(";

constexpr const char* kDrawing = R"(
arithmetic { snap TRUNCATE pixel_center 0 }
output "picture"
targets [ "picture" { width 16 height 8 } "depth" { format D16 width 16 height 8 } ]
cameras [ "eye" {} ]
textures [ "paint" { format L8 width 1 height 1 texels [80] } ]
vertices columns (position) [ (0 0 0) (1 0 0) (0 1 0) ]
indices [0 1 2]
passes [
    "all" {
        color "picture" depth "depth" camera "eye"
        draws [ triangles { index_count 3 textures [ { texture "paint" } { texture "paint" } ] } ]
    }
]
)";

// Each value of an enum gives a pass one line that sets `state`; the one that resetting leaves gives none.
template <NamedEnum Enum, std::size_t count>
void check_each(const std::string& state, const std::array<const char*, count>& constants,
                const std::function<void(PipelineState&, Enum)>& set) {
    static_assert(count == EnumNames<Enum>::names.size(), "a value has no row in this table");
    const std::string start = (state.find(',') == std::string::npos ? kRender : kStage) + state + ", ";
    int set_by_reset        = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (constants[i] == nullptr) continue;  // never legal
        const std::string line = start + constants[i] + "));\n";
        Frame frame            = parsed(kDrawing);
        set(frame.passes[0].state, static_cast<Enum>(i));
        const std::string text = emitted(frame).text;
        const bool is_reset    = count_of(part_of(text, "static void reset_states() {"), line) == 1;
        INFO(line);
        CHECK(count_of(pass_text(text, 0), line) == (is_reset ? 0 : 1));
        CHECK(count_of(pass_text(text, 0), start) == (is_reset ? 0 : 1));
        set_by_reset += is_reset;
    }
    CHECK(set_by_reset == 1);
}

constexpr std::array kCompares{"D3DCMP_ALWAYS",  "D3DCMP_LESSEQUAL", "D3DCMP_LESS",     "D3DCMP_GREATEREQUAL",
                               "D3DCMP_GREATER", "D3DCMP_EQUAL",     "D3DCMP_NOTEQUAL", "D3DCMP_NEVER"};
constexpr std::array kFactors{"D3DBLEND_ZERO",        "D3DBLEND_ONE",         "D3DBLEND_SRCCOLOR",
                              "D3DBLEND_INVSRCCOLOR", "D3DBLEND_DESTCOLOR",   "D3DBLEND_INVDESTCOLOR",
                              "D3DBLEND_SRCALPHA",    "D3DBLEND_INVSRCALPHA", "D3DBLEND_DESTALPHA",
                              "D3DBLEND_INVDESTALPHA"};
constexpr std::array kOps{"D3DTOP_DISABLE",
                          "D3DTOP_SELECTARG1",
                          "D3DTOP_SELECTARG2",
                          "D3DTOP_MODULATE",
                          "D3DTOP_MODULATE2X",
                          "D3DTOP_MODULATE4X",
                          "D3DTOP_ADD",
                          "D3DTOP_ADDSIGNED",
                          "D3DTOP_ADDSIGNED2X",
                          "D3DTOP_SUBTRACT",
                          "D3DTOP_BLENDDIFFUSEALPHA",
                          "D3DTOP_BLENDTEXTUREALPHA",
                          "D3DTOP_BLENDFACTORALPHA",
                          "D3DTOP_BLENDCURRENTALPHA",
                          "D3DTOP_MODULATECOLOR_ADDALPHA"};
constexpr std::array kSources{"D3DTA_DIFFUSE", "D3DTA_CURRENT", "D3DTA_TEXTURE", "D3DTA_TFACTOR", "D3DTA_SPECULAR"};
constexpr std::array kAddresses{"D3DTADDRESS_WRAP", "D3DTADDRESS_CLAMP", "D3DTADDRESS_MIRROR"};
constexpr std::array kMaterialSources{"D3DMCS_MATERIAL", "D3DMCS_COLOR1", "D3DMCS_COLOR2"};

// Stages 0 and 1 that read both arguments and a texture.
void use_stages(PipelineState& state, TextureOp op = TextureOp::Modulate) {
    for (TextureStage& stage : state.stages) stage.color_op = stage.alpha_op = op;
}

template <class Set>
std::function<void(PipelineState&, std::decay_t<std::invoke_result_t<Set, TextureStage&>>)> in_stage(int index,
                                                                                                     Set set) {
    return [=](PipelineState& state, auto value) {
        use_stages(state);
        set(state.stages[static_cast<std::size_t>(index)]) = value;
    };
}

}  // namespace

TEST_CASE("Direct3D 7: each value of a render state has its line", "[emit]") {
    check_each<CompareFunc>("ZFUNC", kCompares, [](PipelineState& s, CompareFunc func) { s.depth.func = func; });
    check_each<CompareFunc>("ALPHAFUNC", kCompares,
                            [](PipelineState& s, CompareFunc func) { s.alpha_test = {.func = func, .reference = 3}; });
    check_each<BlendFactor>("SRCBLEND", kFactors, [](PipelineState& s, BlendFactor f) {
        s.blend = {.source = f, .dest = BlendFactor::InvDestColor};
    });
    check_each<BlendFactor>("DESTBLEND", kFactors, [](PipelineState& s, BlendFactor f) {
        s.blend = {.source = BlendFactor::InvDestColor, .dest = f};
    });
    check_each<CullMode>("CULLMODE", std::array{"D3DCULL_NONE", "D3DCULL_CW", "D3DCULL_CCW"},
                         [](PipelineState& s, CullMode mode) { s.cull = mode; });
    check_each<ShadeMode>("SHADEMODE", std::array{"D3DSHADE_FLAT", "D3DSHADE_GOURAUD"},
                          [](PipelineState& s, ShadeMode mode) { s.shade = mode; });
    check_each<FogMode>("FOGVERTEXMODE", std::array{"D3DFOG_NONE", "D3DFOG_LINEAR", "D3DFOG_EXP", "D3DFOG_EXP2"},
                        [](PipelineState& s, FogMode mode) { s.fog.mode = mode; });
    const auto set_source = [](ColorSource LightingState::*source) {
        return [=](PipelineState& s, ColorSource value) { s.lighting.enabled = true, s.lighting.*source = value; };
    };
    check_each<ColorSource>("DIFFUSEMATERIALSOURCE", kMaterialSources, set_source(&LightingState::diffuse_source));
    check_each<ColorSource>("AMBIENTMATERIALSOURCE", kMaterialSources, set_source(&LightingState::ambient_source));
    check_each<ColorSource>("SPECULARMATERIALSOURCE", kMaterialSources, set_source(&LightingState::specular_source));
    check_each<ColorSource>("EMISSIVEMATERIALSOURCE", kMaterialSources, set_source(&LightingState::emissive_source));
}

TEST_CASE("Direct3D 7: each value of a texture stage state has its line", "[emit]") {
    for (const int i : {0, 1}) {
        const std::string stage = std::to_string(i) + ", D3DTSS_";
        const auto set_op       = [=](TextureOp TextureStage::*which) {
            return [=](PipelineState& s, TextureOp op) {
                if (i == 1) use_stages(s);
                TextureStage& changed = s.stages[static_cast<std::size_t>(i)];
                changed.color_op = changed.alpha_op = op == TextureOp::Disable ? op : TextureOp::Add;
                changed.*which                      = op;
            };
        };
        check_each<TextureOp>(stage + "COLOROP", kOps, set_op(&TextureStage::color_op));
        check_each<TextureOp>(stage + "ALPHAOP", kOps, set_op(&TextureStage::alpha_op));
        check_each<ArgSource>(stage + "COLORARG1", kSources,
                              in_stage(i, [](TextureStage& s) -> ArgSource& { return s.color_arg1.source; }));
        check_each<ArgSource>(stage + "COLORARG2", kSources,
                              in_stage(i, [](TextureStage& s) -> ArgSource& { return s.color_arg2.source; }));
        check_each<ArgSource>(stage + "ALPHAARG1", kSources,
                              in_stage(i, [](TextureStage& s) -> ArgSource& { return s.alpha_arg1.source; }));
        check_each<ArgSource>(stage + "ALPHAARG2", kSources,
                              in_stage(i, [](TextureStage& s) -> ArgSource& { return s.alpha_arg2.source; }));
        const auto filter = [](TextureStage& s) -> TextureFilter& { return s.filter; };
        check_each<TextureFilter>(stage + "MAGFILTER", std::array{"D3DTFG_POINT", "D3DTFG_LINEAR"},
                                  in_stage(i, filter));
        check_each<TextureFilter>(stage + "MINFILTER", std::array{"D3DTFN_POINT", "D3DTFN_LINEAR"},
                                  in_stage(i, filter));
        check_each<MipFilter>(stage + "MIPFILTER", std::array{"D3DTFP_NONE", "D3DTFP_POINT", "D3DTFP_LINEAR"},
                              in_stage(i, [](TextureStage& s) -> MipFilter& { return s.mip_filter; }));
        check_each<TextureAddress>(stage + "ADDRESSU", kAddresses,
                                   in_stage(i, [](TextureStage& s) -> TextureAddress& { return s.address_u; }));
        check_each<TextureAddress>(stage + "ADDRESSV", kAddresses,
                                   in_stage(i, [](TextureStage& s) -> TextureAddress& { return s.address_v; }));
        check_each<CoordSource>(stage + "TEXCOORDINDEX", std::array{"0", "1", "D3DTSS_TCI_CAMERASPACEPOSITION"},
                                in_stage(i, [](TextureStage& s) -> CoordSource& { return s.coords; }));
    }
}

TEST_CASE("Direct3D 7: states that are no enums", "[emit]") {
    struct Row {
        const char* state;
        std::vector<std::string> lines;  // without what they start with
    };
    const Row row = GENERATE(
        Row{"depth { write true }", {"ZENABLE, D3DZB_TRUE", "ZWRITEENABLE, TRUE"}},
        Row{"depth { func EQUAL }", {"ZENABLE, D3DZB_TRUE", "ZFUNC, D3DCMP_EQUAL"}},
        Row{"alpha_test { func LESS reference 200 }",
            {"ALPHATESTENABLE, TRUE", "ALPHAREF, 200", "ALPHAFUNC, D3DCMP_LESS"}},
        Row{"alpha_test { reference 200 }", {}},
        Row{"blend { dest ONE }", {"ALPHABLENDENABLE, TRUE", "DESTBLEND, D3DBLEND_ONE"}},
        Row{"texture_factor 0x80402010", {"TEXTUREFACTOR, 0x80402010"}}, Row{"fog { color 0xff102030 start 2 }", {}},
        Row{"fog { mode LINEAR color 0xff102030 start 2.5 end 1e9 range true }",
            {"FOGENABLE, TRUE", "FOGCOLOR, 0xff102030", "FOGVERTEXMODE, D3DFOG_LINEAR", "FOGSTART, as_dword(2.5f)",
             "FOGEND, as_dword(1e+09f)", "RANGEFOGENABLE, TRUE"}},
        Row{"fog { mode EXP density 0.1 }",
            {"FOGENABLE, TRUE", "FOGVERTEXMODE, D3DFOG_EXP", "FOGDENSITY, as_dword(0.1f)"}},
        Row{"lighting { specular_enable true }", {"SPECULARENABLE, TRUE"}},
        Row{"lighting { normalize_normals true }", {}},
        Row{"stages [{ color_op SELECTARG1 alpha_op SELECTARG2 color_arg1 { source DIFFUSE complement true } color_arg2 "
            "{ source TFACTOR } alpha_arg1 { source TFACTOR } alpha_arg2 { source DIFFUSE alpha_replicate true } "
            "filter LINEAR }]",
            {"0, D3DTSS_COLOROP, D3DTOP_SELECTARG1", "0, D3DTSS_COLORARG1, D3DTA_DIFFUSE | D3DTA_COMPLEMENT",
             "0, D3DTSS_ALPHAOP, D3DTOP_SELECTARG2", "0, D3DTSS_ALPHAARG2, D3DTA_DIFFUSE | D3DTA_ALPHAREPLICATE"}},
        Row{"stages [{ color_op ADD alpha_op ADD coords CAMERAPOSITION }]",
            {"0, D3DTSS_COLOROP, D3DTOP_ADD", "0, D3DTSS_ALPHAOP, D3DTOP_ADD",
             "0, D3DTSS_TEXCOORDINDEX, D3DTSS_TCI_CAMERASPACEPOSITION",
             "0, D3DTSS_TEXTURETRANSFORMFLAGS, D3DTTFF_COUNT3 | D3DTTFF_PROJECTED"}});
    INFO(row.state);
    std::string text = kDrawing;
    text.replace(text.find("camera \"eye\"\n"), 12, "camera \"eye\" state { " + std::string(row.state) + " }");
    std::vector<std::string> lines;
    std::istringstream in(pass_text(emitted(parsed(text)).text, 0));
    for (std::string line; std::getline(in, line);)
        for (const std::string& start : {kRender, kStage})
            if (line.starts_with("    " + start)) lines.push_back(line.substr(4 + start.size()));
    std::vector<std::string> expected;
    for (const std::string& line : row.lines) expected.push_back(line + "));");
    CHECK(lines == expected);
}

TEST_CASE("Direct3D 7: a pass of triangles, word for word", "[emit]") {
    const Emitted out = emitted(parsed(R"(
arithmetic { snap TRUNCATE pixel_center 0 }
output "picture"
targets [ "depth" { format D24 width 16 height 8 } "picture" { width 16 height 8 } ]
cameras [ "eye" { view ((1 0 0 5) (0 1 0 6) (0 0 1 7) (0 0 0 1)) projection ((2 0 0.25 0) (0 3 0 0) (0 0 1 -0.1) (0 0 1 0)) } ]
textures [ "paint" { format L8 width 1 height 1 texels [80] } ]
vertices columns (position) [ (0 0 0) (1 0 0) (0 1 0) ]
indices [0 1 2 2 1 0]
passes [
    "first\npass\\" {
        color "picture" depth "depth" camera "eye"
        clear { color 0x01020304 depth 0.5 }
        state { depth { func LESS } viewport { x0 2 y0 1 x1 12 y1 5 } stages [{ color_op MODULATE alpha_op SELECTARG2 }] }
        draws [
            triangles { index_count 3 textures [{ texture "paint" }] }
            triangles { first_index 3 index_count 3 textures [{ texture "paint" }] }
            triangles { index_count 3 world ((1 0 0 0) (0 1 0 0) (0 0 1 -0) (0 0 0 1)) }
            triangles { index_count 3 world ((2 0 0 0) (0 1 0 0) (0 0 1 0) (0 0 0 1)) }
        ]
    }
]
)"));
    CHECK(pass_text(out.text, 0) == R"(// Pass 0 'first pass/'
static void pass_0() {
    // to 'picture' with 'depth'
    begin_pass(targets[1], targets[0], 2, 1, 10, 4);
    TRY(device->Clear(0, nullptr, D3DCLEAR_TARGET | D3DCLEAR_ZBUFFER, 0x01020304, 0.5f, 0));
    // camera 'eye'
    set_transform(D3DTRANSFORMSTATE_VIEW, {1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 5.0f, 6.0f, 7.0f, 1.0f});
    set_transform(D3DTRANSFORMSTATE_PROJECTION, {2.0f, 0.0f, 0.0f, 0.0f, 0.0f, 3.0f, 0.0f, 0.0f, 0.25f, 0.0f, 1.0f, 1.0f, 0.0f, 0.0f, -0.1f, 0.0f});
    TRY(device->SetRenderState(D3DRENDERSTATE_ZENABLE, D3DZB_TRUE));
    TRY(device->SetRenderState(D3DRENDERSTATE_ZFUNC, D3DCMP_LESS));
    TRY(device->SetTextureStageState(0, D3DTSS_COLOROP, D3DTOP_MODULATE));
    TRY(device->SetTextureStageState(0, D3DTSS_ALPHAOP, D3DTOP_SELECTARG2));
    TRY(device->BeginScene());
    TRY(device->SetTexture(0, textures[0]));  // 'paint'
    set_transform(D3DTRANSFORMSTATE_WORLD, {1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f});
    draw_mesh(0);
    draw_mesh(1);
    TRY(device->SetTexture(0, white));  // nothing is bound
    draw_mesh(0);
    set_transform(D3DTRANSFORMSTATE_WORLD, {2.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f});
    draw_mesh(0);
    TRY(device->EndScene());
}
)");
    CHECK(count_of(out.text, "    {\"picture\", A8R8G8B8, 16, 8, true, false, true},  // 1 \n") == 1);
    CHECK(count_of(out.text, "    {\"depth\", D24, 16, 8, true, false, true},  // 0 \n") == 1);
    CHECK(count_of(out.text, "static const size_t output_target = 1;\n") == 1);
    CHECK(count_of(out.text, "    {pass_0, 1},\n") == 1);
    CHECK(count_of(out.text, "static const char data_file[] = \"frame.bin\";\n") == 1);
}
