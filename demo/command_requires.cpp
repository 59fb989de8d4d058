// SPDX-License-Identifier: MIT
#include "demo/command_requires.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "demo/chip_frame.h"
#include "demo/frame_needs.h"
#include "demo/frame_source.h"
#include "demo/standard_output.h"
#include "demo/text_table.h"

namespace demo {
namespace {

using nlohmann::ordered_json;
using pipeline::Profile;

struct Report {
    const Profile& profile;
    FrameNeeds needs;
    std::size_t findings = 0;  // what the chip still lacks
};

Report make_report(const FrameSource& source, const RequiresOptions& options, const Profile& profile) {
    Report report{.profile = profile, .needs = {}};
    for (int index = options.frames.first; index <= options.frames.last; ++index) {
        const pipeline::LegalFrame legal = pipeline::legalize(source.frame(options.size, index), profile);
        report.needs.add(legal.frame);
        report.needs.add(legal.notes);
        report.findings += legal.left.size();
    }
    return report;
}

std::string counted(std::size_t count, const char* one, const char* several) {
    return with_separators(count) + ' ' + (count == 1 ? one : several);
}

std::string section(const char* heading, const std::vector<TextRow>& rows, std::string_view columns) {
    return rows.size() < 2 ? std::string() : std::string("\n") + heading + "\n\n" + text_table(rows, columns);
}

std::string states_text(const FrameNeeds& needs) {
    std::vector<TextRow> rows{{"field", "values, and in how many places"}};
    const std::vector<pipeline::StateField>& fields = pipeline::state_fields();
    for (std::size_t i = 0; i < fields.size(); ++i) {
        std::string values;
        for (std::size_t value = 0; value < fields[i].values.size(); ++value)
            if (const std::size_t places = needs.states[i][value]; places > 0)
                values +=
                    (values.empty() ? "" : ", ") + std::string(fields[i].values[value]) + ' ' + with_separators(places);
        if (!values.empty()) rows.push_back({fields[i].path, values});
    }
    return section("States", rows, "ll");
}

std::string uses_text(const char* heading, const char* what, const FrameNeeds::Uses& uses, const char* of) {
    std::vector<TextRow> rows{{what, of}};
    for (const auto& [name, count] : uses) rows.push_back({name, with_separators(count)});
    return section(heading, rows, "lr");
}

std::string size_text(int width, int height) {
    return std::to_string(width) + 'x' + std::to_string(height);
}

std::string targets_text(const FrameNeeds& needs) {
    std::vector<TextRow> rows{{"name", "format", "size", "bytes", "frames"}};
    for (const auto& [target, frames] : needs.targets)
        rows.push_back({target.name, target.format, size_text(target.width, target.height),
                        with_separators(target.bytes), with_separators(frames)});
    return section("Targets", rows, "llrrr");
}

std::string textures_text(const FrameNeeds& needs) {
    std::vector<TextRow> rows{{"name", "format", "size", "levels", "bytes", "frames", "filter, mip_filter, address"}};
    for (const auto& [texture, frames] : needs.textures)
        rows.push_back({texture.name, texture.format, size_text(texture.width, texture.height),
                        std::to_string(texture.levels), with_separators(texture.bytes), with_separators(frames),
                        texture.sampling});
    return section("Textures", rows, "llrrrrl");
}

std::string kernels_text(const FrameNeeds& needs) {
    std::vector<TextRow> rows{{"of", "kernel", "draws"}};
    for (const auto& [kernel, draws] : needs.kernels)
        rows.push_back({std::string(kernel.primitive), std::string(kernel.name), with_separators(draws)});
    return section("Fill kernels", rows, "llr");
}

std::string memory_text(const MemoryNeeds& memory) {
    std::vector<TextRow> rows{{"of", "bytes"}};
    rows.push_back({"targets", with_separators(memory.targets)});
    rows.push_back({"textures", with_separators(memory.textures)});
    rows.push_back({"vertices", with_separators(memory.vertices)});
    rows.push_back({"indices", with_separators(memory.indices)});
    return section("Memory of the largest frame", rows, "lr");
}

std::string to_text(const Report& report, const RequiresOptions& options) {
    const FrameNeeds& needs = report.needs;
    std::string draws;
    for (const auto& [kind, count] : needs.draws)
        draws += (draws.empty() ? "" : ", ") + std::string(kind) + ' ' + with_separators(count);
    return options.scene + ", " + std::string(report.profile.chip) + ": " + counted(needs.frames, "frame", "frames") +
           ", " + counted(needs.passes, "pass", "passes") + "; draws: " + draws + '\n' +
           uses_text("Rewritten", "rewrite", needs.rewrites, "places") + states_text(needs) +
           uses_text("Blends", "blend", needs.blends, "passes") + targets_text(needs) + textures_text(needs) +
           uses_text("Vertices", "attribute", needs.attributes, "passes") + kernels_text(needs) +
           memory_text(needs.memory);
}

ordered_json to_json(const FrameNeeds::Uses& uses) {
    ordered_json json = ordered_json::object();
    for (const auto& [name, count] : uses) json[name] = count;
    return json;
}

ordered_json states_json(const FrameNeeds& needs) {
    ordered_json json                               = ordered_json::object();
    const std::vector<pipeline::StateField>& fields = pipeline::state_fields();
    for (std::size_t i = 0; i < fields.size(); ++i)
        for (std::size_t value = 0; value < fields[i].values.size(); ++value)
            if (const std::size_t places = needs.states[i][value]; places > 0)
                json[fields[i].path][std::string(fields[i].values[value])] = places;
    return json;
}

ordered_json to_json(const Report& report) {
    const FrameNeeds& needs = report.needs;
    ordered_json draws = ordered_json::object(), targets = ordered_json::array(), textures = ordered_json::array(),
                 kernels = ordered_json::array();
    for (const auto& [kind, count] : needs.draws) draws[std::string(kind)] = count;
    for (const auto& [target, frames] : needs.targets)
        targets.push_back({{"name", target.name},
                           {"format", target.format},
                           {"width", target.width},
                           {"height", target.height},
                           {"bytes", target.bytes},
                           {"frames", frames}});
    for (const auto& [texture, frames] : needs.textures)
        textures.push_back({{"name", texture.name},
                            {"format", texture.format},
                            {"width", texture.width},
                            {"height", texture.height},
                            {"levels", texture.levels},
                            {"bytes", texture.bytes},
                            {"frames", frames},
                            {"sampling", texture.sampling}});
    for (const auto& [kernel, count] : needs.kernels)
        kernels.push_back(
            {{"primitive", kernel.primitive}, {"name", kernel.name}, {"special", kernel.is_special}, {"draws", count}});
    return {{"profile", report.profile.name},
            {"frames", needs.frames},
            {"passes", needs.passes},
            {"draws", draws},
            {"rewrites", to_json(needs.rewrites)},
            {"findings", report.findings},
            {"states", states_json(needs)},
            {"blends", to_json(needs.blends)},
            {"targets", targets},
            {"textures", textures},
            {"attributes", to_json(needs.attributes)},
            {"kernels", kernels},
            {"memory",
             {{"targets", needs.memory.targets},
              {"textures", needs.memory.textures},
              {"vertices", needs.memory.vertices},
              {"indices", needs.memory.indices}}}};
}

}  // namespace

void report_requirements(const RequiresOptions& options) {
    const FrameSource source(options.scene);
    std::string cannot;
    ordered_json json{{"scene", options.scene}, {"reports", ordered_json::array()}};
    for (const Profile* profile : options.profiles) {
        const Report report = make_report(source, options, *profile);
        if (report.findings > 0)
            cannot += (cannot.empty() ? "" : "; ") + std::string(profile->name) + " cannot draw " + options.scene +
                      ": " + counted(report.findings, "finding", "findings");
        if (options.format == RequiresFormat::Json)
            json["reports"].push_back(to_json(report));
        else
            print((profile == options.profiles.front() ? "" : "\n") + to_text(report, options));
    }
    // A name may be any bytes; JSON is UTF-8.
    if (options.format == RequiresFormat::Json)
        print(json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n');
    if (!cannot.empty()) throw ChipCannot(cannot);
}

}  // namespace demo
