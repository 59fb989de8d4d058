// SPDX-License-Identifier: MIT
#include "demo/chip_words.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <string_view>

#include "pipeline/emit/emit_dx7.h"
#include "pipeline/emit/emit_gs.h"
#include "pipeline/emit/emit_gx.h"
#include "pipeline/emit/emit_nv2a.h"
#include "pipeline/emit/gs_text.h"

namespace demo {
namespace {

constexpr std::string_view kDataFile = "frame.bin";

bool is_of_vertices(pipeline::GsReg reg) {
    using enum pipeline::GsReg;
    constexpr pipeline::GsReg kVertexRegisters[] = {Rgbaq, St, Uv, Xyzf2, Xyz2, Fog};
    return std::find(std::begin(kVertexRegisters), std::end(kVertexRegisters), reg) != std::end(kVertexRegisters);
}

std::string gs_words(const pipeline::GsStream& stream) {
    std::string text;
    for (const pipeline::GsGroup& group : stream.groups) {
        text += group.label + '\n';
        std::set<std::string> written;
        for (const pipeline::GsStep& step : group.steps)
            for (const pipeline::GsWrite& write : step.writes) {
                if (is_of_vertices(write.reg)) continue;
                std::string line = "    " + gs_text(write) + '\n';
                if (written.insert(line).second) text += line;
            }
    }
    return text;
}

std::string nv2a_words(const std::string& methods) {
    std::string text;
    std::istringstream in(methods);
    std::set<std::string> written;
    for (std::string line; std::getline(in, line);) {
        if (line.find(" NV097_ARRAY_ELEMENT") != std::string::npos) continue;
        const bool is_comment = line.starts_with('#');
        if (is_comment) written.clear();  // a pass or a draw begins
        if (is_comment || written.insert(line).second) text += line + '\n';
    }
    return text;
}

}  // namespace

std::string chip_words(const pipeline::LegalFrame& legal, const pipeline::Profile& profile) {
    if (profile.name == "dx7") return pipeline::emit_dx7(legal, kDataFile).text;
    if (profile.name == "ps2") return gs_words(pipeline::emit_gs(legal));
    if (profile.name == "gamecube") return pipeline::emit_gx(legal, kDataFile).text;
    if (profile.name == "xbox") return nv2a_words(pipeline::emit_nv2a(legal, kDataFile).text);
    return {};
}

}  // namespace demo
