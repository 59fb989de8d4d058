// SPDX-License-Identifier: MIT
#include "pipeline/emit/emit_dx7.h"

#include <stdexcept>

#include "pipeline/emit/dx7_data.h"
#include "pipeline/emit/dx7_pass.h"
#include "pipeline/emit/dx7_program.h"
#include "pipeline/emit/dx7_states.h"
#include "pipeline/emit/dx7_surfaces.h"
#include "pipeline/emit/dx7_text.h"

namespace pipeline {

namespace {

using namespace dx7;

std::string number(std::size_t value) {
    return std::to_string(value);
}
std::string truth(bool value) {
    return value ? "true" : "false";
}

// An entry of a table, with what it is as a comment.
std::string entry(const std::string& values, std::size_t index, const std::string& name) {
    return "    {" + values + "},  // " + number(index) + ' ' + name + '\n';
}

void refuse_findings(const LegalFrame& legal) {
    if (legal.left.empty()) return;
    const ChipFinding& first = legal.left.front();
    throw std::invalid_argument("Direct3D 7 cannot draw this frame: " + first.where + ": uses " + first.uses +
                                "; the chip has " + first.has +
                                (legal.left.size() > 1 ? ", and " + number(legal.left.size() - 1) + " more" : ""));
}

std::string opening(const Frame& frame, std::string_view data_file) {
    std::string text =
        "// A frame of " + number(frame.passes.size()) +
        " passes for Direct3D 7. Each pass is a function, in its order, that starts from known states.\n"
        "//   x86_64-w64-mingw32-g++ THIS.cpp -o frame.exe -lddraw -ldxguid -static\n"
        "//   frame.exe [PICTURE.bmp [PREFIX]]\n"
        "// It reads " +
        quoted(data_file) + " from where it is started, draws off screen, and writes the target " +
        quoted(frame.targets[static_cast<std::size_t>(frame.output.index)].name) +
        " to PICTURE.bmp\n// (frame.bmp), B, G, R, A; with PREFIX also what each pass leaves, as PREFIX0.bmp and so "
        "on. A call that fails is\n// named with its HRESULT, and the exit status is 1.\n"
        "// Coordinates are Direct3D 7's: pixel centres at integers, so that what covers W pixels from the left goes "
        "from -0.5 to\n// W - 0.5. Matrices multiply row vectors.\n"
        "// Left to the card: how vertices snap to its subpixels, and how filters, stages, fog and blends round. What "
        "only some\n// cards have: textures of 8 bits (A8, L8; expanded to 32 where they are not), and targets with a "
        "z-buffer of other depth.\n";
    return text;
}

std::string target_table(const Surfaces& surfaces) {
    std::string text =
        "// format, width, height; used, read as a texture, starts as zeros\n"
        "static const std::vector<TargetInfo> target_infos = {\n";
    for (std::size_t i = 0; i < surfaces.all.size(); ++i) {
        const Surface& surface   = surfaces.all[i];
        // The format of what is not used need not be one of Direct3D 7's.
        const std::string format = surface.is_used ? std::string(enum_name(surface.format)) : "A8R8G8B8";
        text += entry(literal(surface.name) + ", " + format + ", " + std::to_string(surface.width) + ", " +
                          std::to_string(surface.height) + ", " + truth(surface.is_used) + ", " +
                          truth(surface.is_texture) + ", " + truth(surface.is_zeroed),
                      i,
                      surface.is_spare  ? "for passes that draw depth alone"
                      : surface.is_used ? ""
                                        : "not used");
    }
    return text + "};\n";
}

std::string texture_table(const Frame& frame, const Data& data) {
    std::string text =
        "// format, width, height, levels; byte in the side file\n"
        "static const std::vector<TextureInfo> texture_infos = {\n";
    for (std::size_t i = 0; i < frame.textures.size(); ++i) {
        const Texture& texture = frame.textures[i];
        text += entry(std::string(enum_name(texture.format)) + ", " + std::to_string(texture.width) + ", " +
                          std::to_string(texture.height) + ", " + std::to_string(texture.levels) + ", " +
                          number(data.textures[i]),
                      i, quoted(texture.name));
    }
    return text + "};\n";
}

std::string mesh_table(const Data& data) {
    std::string text =
        "// window vertices; byte in the side file and count of vertices, and of indices\n"
        "static const std::vector<MeshInfo> mesh_infos = {\n";
    for (std::size_t i = 0; i < data.meshes.size(); ++i) {
        const Mesh& mesh = data.meshes[i];
        text += entry(truth(mesh.is_window) + ", " + number(mesh.vertices) + ", " + number(mesh.vertex_count) + ", " +
                          number(mesh.indices) + ", " + number(mesh.index_count),
                      i, "from the frame's index " + std::to_string(mesh.first_index) + " on");
    }
    return text + "};\n";
}

std::string reset_function() {
    std::string text =
        "static DWORD as_dword(float value) {\n    DWORD bits;\n    std::memcpy(&bits, &value, sizeof "
        "bits);\n    return bits;\n}\n\n"
        "// Where each pass starts from.\nstatic void reset_states() {\n";
    for (const State& state : reset_states()) text += "    " + set_state(state) + '\n';
    return text + "}\n";
}

std::string pass_table(const Frame& frame, const Surfaces& surfaces) {
    std::string text =
        "// What draws it, and the target that it draws to; -1: none\n"
        "struct PassInfo {\n    void (*draw)();\n    int color;\n};\n"
        "static const std::vector<PassInfo> passes = {\n";
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        const int color    = surfaces.passes[i].color;
        const bool is_real = color >= 0 && !surfaces.all[static_cast<std::size_t>(color)].is_spare;
        text += "    {pass_" + number(i) + ", " + std::to_string(is_real ? color : -1) + "},\n";
    }
    return text + "};\n";
}

}  // namespace

Emitted emit_dx7(const LegalFrame& legal, std::string_view data_file) {
    refuse_findings(legal);
    const Frame& frame      = legal.frame;
    const Surfaces surfaces = surfaces_of(frame);
    Data data               = make_data(frame);
    std::string text        = opening(frame, data_file);
    text.append(kHead) += '\n';
    text += "static const char data_file[] = " + literal(data_file) +
            ";\nstatic const size_t data_size = " + number(data.bytes.size()) + ";\n\n" + target_table(surfaces) +
            "static const size_t output_target = " + std::to_string(frame.output.index) + ";\n\n" +
            texture_table(frame, data) + '\n' + mesh_table(data) + '\n';
    text.append(kDevice) += '\n';
    text.append(kSurfaces) += '\n';
    text += reset_function() + '\n';
    text.append(kPasses) += '\n';
    for (std::size_t i = 0; i < frame.passes.size(); ++i) text += pass_function(frame, i, surfaces, data) + '\n';
    text += pass_table(frame, surfaces) + '\n';
    text.append(kMain);
    return {.text = std::move(text), .data = std::move(data.bytes)};
}

}  // namespace pipeline
