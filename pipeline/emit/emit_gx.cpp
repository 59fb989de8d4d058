// SPDX-License-Identifier: MIT
#include "pipeline/emit/emit_gx.h"

#include <algorithm>
#include <stdexcept>

#include "pipeline/emit/gx_names.h"
#include "pipeline/emit/gx_passes.h"
#include "pipeline/emit/gx_program.h"

namespace pipeline {

namespace {

void require_legal(const LegalFrame& legal) {
    if (legal.left.empty()) return;
    const ChipFinding& first = legal.left.front();
    throw std::invalid_argument("the GameCube cannot draw this frame: " + std::to_string(legal.left.size()) +
                                " findings are left, the first: " + first.where + ": uses " + first.uses +
                                "; the chip has " + first.has);
}

void require_plain_name(std::string_view data_file) {
    const auto is_plain = [](char c) {
        return static_cast<unsigned char>(c) >= 0x20 && c != '"' && c != '\\' && c != 0x7f;
    };
    if (data_file.empty() || !std::all_of(data_file.begin(), data_file.end(), is_plain))
        throw std::invalid_argument("the name of the data must be plain: no quotes, backslashes or control characters");
}

bool is_in_memory(const GxFrame& gx, std::size_t target) {
    return !gx.is_in_buffer[target];
}

void emit_targets(const GxFrame& gx, CText& text) {
    for (std::size_t i = 0; i < gx.frame.targets.size(); ++i) {
        const Target& target = gx.frame.targets[i];
        text.comment("target " + c_int(static_cast<std::int64_t>(i)) + " '" + target.name + "', " +
                     std::string(enum_name(target.format)) + ' ' + c_int(target.width) + 'x' + c_int(target.height) +
                     (is_in_memory(gx, i) ? ", a texture in main memory"
                                          : ", in the frame buffer at (" + c_int(gx.places.spots[i]->x) + ", " +
                                                c_int(gx.places.spots[i]->y) + ")"));
        if (is_in_memory(gx, i))
            text.line("static u8 " + gx_target_name(i) + "[" + std::to_string(gx_target_bytes(target)) +
                      "] __attribute__((aligned(32)));");
    }
}

void emit_zeros(const GxFrame& gx, CText& text) {
    for (std::size_t i = 0; i < gx.frame.targets.size(); ++i) {
        if (!is_in_memory(gx, i)) continue;
        const std::string name = gx_target_name(i);
        text.call("memset", {name, "0", "sizeof " + name});
        text.call("DCFlushRange", {name, "sizeof " + name});
    }
}

void emit_undrawn_output(const GxFrame& gx, CText& text) {
    const auto output = static_cast<std::size_t>(gx.frame.output.index);
    if (is_in_memory(gx, output) || target_uses(gx.frame)[output].drawn) return;
    const Target& target   = gx.frame.targets[output];
    const BufferSpot& spot = *gx.places.spots[output];
    text.comment("the output, which no pass draws to");
    text.call("GX_SetPixelFmt", {gx_pixel_format(target.format), "GX_ZC_LINEAR"});
    text.call("clear_pixels", {c_int(spot.x), c_int(spot.y), c_int(target.width), c_int(target.height), "GX_TRUE", "0u",
                               "GX_FALSE", "0.0f"});
}

// Copies, as textures do, come from main memory: the picture is drawn once more then.
void emit_picture(const GxFrame& gx, CText& text) {
    const auto output       = static_cast<std::size_t>(gx.frame.output.index);
    const Target& target    = gx.frame.targets[output];
    const BufferSpot spot   = is_in_memory(gx, output) ? BufferSpot{} : *gx.places.spots[output];
    const auto even         = [](std::int32_t size) { return (size + 1) / 2 * 2; };
    const std::string width = c_int(target.width), height = c_int(target.height);
    text.line();
    text.comment("Output: target " + c_int(gx.frame.output.index) + " '" + target.name +
                 "', to the top left of the display.");
    text.line("static void show_picture(GXRModeObj *mode, void *picture)");
    text.open("{");
    text.line("const u16 height = " + c_int(even(target.height)) + " < mode->xfbHeight ? " +
              c_int(even(target.height)) + " : mode->xfbHeight;");
    if (is_in_memory(gx, output)) {
        text.call("GX_SetPixelFmt", {"GX_PF_RGB8_Z24", "GX_ZC_LINEAR"});
        text.call("plain_pixels", {"GX_TRUE", "GX_FALSE"});
        text.line("plain_color();");
        text.call("window_space", {"0", "0", width, height});
        text.call("GX_SetScissor", {"0", "0", width, height});
        text.call("bind_texture", {"GX_TEXMAP0", gx_target_name(output), width, height, "GX_TF_RGBA8", "GX_CLAMP",
                                   "GX_CLAMP", "1", "GX_NEAR", "GX_NEAR"});
        text.call("GX_SetNumTexGens", {"1"});
        text.call("GX_SetTexCoordGen", {"GX_TEXCOORD0", "GX_TG_MTX2x4", "GX_TG_TEX0", "GX_IDENTITY"});
        text.call("GX_SetTevOrder", {"GX_TEVSTAGE0", "GX_TEXCOORD0", "GX_TEXMAP0", "GX_COLORNULL"});
        text.call("GX_SetTevColorIn", {"GX_TEVSTAGE0", "GX_CC_ZERO", "GX_CC_ZERO", "GX_CC_ZERO", "GX_CC_TEXC"});
        text.call("GX_SetTevAlphaIn", {"GX_TEVSTAGE0", "GX_CA_ZERO", "GX_CA_ZERO", "GX_CA_ZERO", "GX_CA_TEXA"});
        text.call("rectangle", {"0.0f", "0.0f", c_float(static_cast<float>(target.width)),
                                c_float(static_cast<float>(target.height)), "0.0f", "0xffffffffu",
                                "(const f32[]){ 0.0f, 0.0f, 1.0f, 1.0f }", "NULL"});
    }
    text.call("GX_SetDispCopySrc", {c_int(spot.x), c_int(spot.y), c_int(even(target.width)), "height"});
    text.call("GX_SetDispCopyDst", {"mode->fbWidth", "height"});
    text.call("GX_SetDispCopyYScale", {"1.0f"});
    text.call("GX_CopyDisp", {"picture", "GX_FALSE"});
    text.close();
}

void emit_passes(GxFrame& gx, CText& text) {
    text.line();
    text.line("static void draw_frame(void)");
    text.open("{");
    emit_zeros(gx, text);
    emit_undrawn_output(gx, text);
    std::string_view pixel_format;
    for (std::size_t i = 0; i < gx.frame.passes.size(); ++i) emit_gx_pass(gx, i, pixel_format, text);
    text.close();
}

// After the passes: they say which arrays are used, and how many vertices there are.
GxArray add_array(GxFrame& gx, std::string_view name, bool is_used,
                  void (*put)(std::vector<std::uint8_t>&, const Vertex&)) {
    if (!is_used) return {name, 0, false};
    std::vector<std::uint8_t> bytes;
    for (std::uint32_t i = 0; i < gx.vertices.size(); ++i) put(bytes, gx.vertices.vertex(i));
    return {name, gx.data.add(std::string(name) + " of all vertices", bytes), true};
}

template <Vec3 Vertex::*vector>
void put_vec3(std::vector<std::uint8_t>& out, const Vertex& vertex) {
    for (int i = 0; i < 3; ++i) put_float(out, (vertex.*vector)[i]);
}
template <Vec2 Vertex::*pair>
void put_vec2(std::vector<std::uint8_t>& out, const Vertex& vertex) {
    for (int i = 0; i < 2; ++i) put_float(out, (vertex.*pair)[i]);
}
template <Argb Vertex::*color>
void put_color(std::vector<std::uint8_t>& out, const Vertex& vertex) {
    put_rgba(out, vertex.*color);
}

std::vector<GxArray> add_arrays(GxFrame& gx, std::string_view passes) {
    return {
        add_array(gx, "POSITIONS", passes.find("POSITIONS") != std::string_view::npos, &put_vec3<&Vertex::position>),
        add_array(gx, "NORMALS", gx.uses_normals, &put_vec3<&Vertex::normal>),
        add_array(gx, "COLORS0", gx.uses_colors0, &put_color<&Vertex::diffuse>),
        add_array(gx, "COLORS1", gx.uses_colors1, &put_color<&Vertex::specular>),
        add_array(gx, "UV0", gx.uses_uv[0], &put_vec2<&Vertex::uv0>),
        add_array(gx, "UV1", gx.uses_uv[1], &put_vec2<&Vertex::uv1>)};
}

}  // namespace

Emitted emit_gx(const LegalFrame& legal, std::string_view data_file) {
    require_legal(legal);
    require_plain_name(data_file);
    GxFrame gx(legal.frame);
    CText passes;
    emit_passes(gx, passes);
    emit_picture(gx, passes);
    CText targets;
    targets.line();
    emit_targets(gx, targets);

    const std::string body = passes.take();
    GxProgramFacts facts{.data_file = data_file, .blocks = {}, .arrays = add_arrays(gx, body)};
    facts.blocks     = gx.data.blocks();
    facts.data_bytes = gx.data.size();
    for (std::size_t i = 0; i < gx.frame.targets.size(); ++i)
        if (is_in_memory(gx, i)) facts.target_bytes += gx_target_bytes(gx.frame.targets[i]);

    Emitted out;
    out.text = gx_program_head(facts);
    out.text += targets.take();
    const std::string_view main = gx_program_main();
    out.text += gx_program_functions(body + std::string(main));
    out.text += body;
    out.text += main;
    out.data = gx.data.take();
    return out;
}

}  // namespace pipeline
