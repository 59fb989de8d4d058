// SPDX-License-Identifier: MIT
#include "demo/command_emit.h"

#include <filesystem>
#include <stdexcept>
#include <string_view>

#include "demo/new_file.h"
#include "demo/standard_output.h"
#include "demo/text_table.h"
#include "pipeline/emit/emit_dx7.h"
#include "pipeline/emit/emit_gs.h"
#include "pipeline/emit/emit_gx.h"
#include "pipeline/emit/emit_nv2a.h"
#include "pipeline/emit/gs_dump.h"
#include "pipeline/emit/gs_text.h"

namespace demo {
namespace {

namespace fs = std::filesystem;
using pipeline::Emitted;
using pipeline::LegalFrame;

using Emitter = Emitted (*)(const LegalFrame&, std::string_view data_file);

struct Emission {
    std::string_view profile, ending;
    Emitter emit;  // none: the dump of emit_gs
};
constexpr Emission kEmissions[] = {
    {"dx7", ".cpp", &pipeline::emit_dx7},
    {"ps2", ".gs", nullptr},
    {"gamecube", ".c", &pipeline::emit_gx},
    {"xbox", ".nv2a.txt", &pipeline::emit_nv2a},
};

const Emission& emission_of(const pipeline::Profile& profile) {
    for (const Emission& emission : kEmissions)
        if (emission.profile == profile.name) return emission;
    throw std::runtime_error("--profile " + std::string(profile.name) + ": no chip, and so without words of its own");
}

void write(const std::vector<FileToWrite>& files) {
    write_files(files);
    for (const FileToWrite& file : files) print(file.path + "  " + with_separators(file.bytes.size()) + " bytes\n");
}

std::string_view characters(const std::vector<std::uint8_t>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

void emit(const EmitOptions& options) {
    const Emission& emission = emission_of(*options.profile);
    if (options.as_text && emission.emit != nullptr)
        throw std::runtime_error("--text: " + std::string(emission.profile) + " is text in any case");
    const FrameSource source(options.scene);
    const std::string ending(options.as_text ? ".gs.txt" : emission.ending);
    const std::string path = options.output.value_or(source.name() + ending);
    const fs::path beside  = fs::path(path).replace_extension(".bin");
    check_output(path);
    if (emission.emit != nullptr) {
        if (beside == fs::path(path))
            throw std::runtime_error("-o " + path + ": .bin is the ending of the file beside it");
        check_output(beside.string());
    }

    ChipFrameOptions chip  = options;
    const LegalFrame legal = drawable_chip_frame(source, chip);
    if (emission.emit == nullptr) {
        const pipeline::GsStream stream = emit_gs(legal);
        const std::string words         = options.as_text ? gs_text(stream) : std::string(characters(gs_dump(stream)));
        return write({{path, words}});
    }
    const Emitted emitted = emission.emit(legal, beside.filename().string());
    std::vector<FileToWrite> files{{path, emitted.text}};
    if (!emitted.data.empty()) files.insert(files.begin(), {beside.string(), characters(emitted.data)});
    write(files);
}

}  // namespace demo
