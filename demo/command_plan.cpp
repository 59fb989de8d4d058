// SPDX-License-Identifier: MIT
#include "demo/command_plan.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "demo/frame_source.h"
#include "demo/standard_output.h"
#include "demo/text_table.h"
#include "pipeline/check/check.h"
#include "pipeline/check/memory_map.h"
#include "pipeline/cost/cost.h"
#include "pipeline/execute/execute.h"
#include "pipeline/frame/field_traits.h"
#include "pipeline/legalize/legalize.h"

namespace demo {
namespace {

using nlohmann::ordered_json;
using pipeline::ChipFinding;
using pipeline::Frame;
using pipeline::FrameCost;
using pipeline::MemoryMap;
using pipeline::PassCost;
using pipeline::Profile;
using pipeline::Range;

struct Plan {
    const Profile& profile;
    pipeline::LegalFrame legal;
    MemoryMap memory;
    std::optional<FrameCost> cost;  // none of a profile that is no chip
};

Plan make_plan(const PlanOptions& options) {
    Plan plan{
        .profile = *options.profile,
        .legal   = pipeline::legalize(FrameSource(options.scene).frame(options.size, options.frame), *options.profile),
        .memory  = {},
        .cost    = {}};
    const Frame& frame = plan.legal.frame;
    plan.memory        = pipeline::lay_out(frame, plan.profile);
    if (const pipeline::ChipRates* rates = pipeline::find_rates(plan.profile.name))
        plan.cost = pipeline::cost(frame, pipeline::execute(frame).counts, *rates);
    return plan;
}

// "pass 3 'composite': state.blend" in two: what is the same of several passes is one line.
struct Place {
    std::string owner, field;
};
Place place_of(const ChipFinding& finding) {
    const std::size_t colon = finding.where.find("': ");
    if (colon == std::string::npos) return {finding.where, {}};
    return {finding.where.substr(0, colon + 1), finding.where.substr(colon + 3)};
}

struct Group {
    std::string field;
    const ChipFinding* first;
    std::vector<std::string> owners;
};

std::vector<Group> grouped(const std::vector<ChipFinding>& findings) {
    std::vector<Group> groups;
    for (const ChipFinding& finding : findings) {
        const Place place = place_of(finding);
        const auto same   = [&](const Group& group) {
            return group.field == place.field && group.first->rule == finding.rule &&
                   group.first->uses == finding.uses && group.first->has == finding.has;
        };
        const auto found = std::find_if(groups.begin(), groups.end(), same);
        if (found == groups.end())
            groups.push_back({place.field, &finding, {place.owner}});
        else
            found->owners.push_back(place.owner);
    }
    return groups;
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

// A line for each rewrite and reason.
std::string notes_text(const pipeline::RewriteNotes& notes) {
    if (notes.empty()) return "nothing\n";
    struct Line {
        const pipeline::RewriteNote* note;
        std::vector<std::string> places;
    };
    std::vector<Line> lines;
    for (const pipeline::RewriteNote& note : notes) {
        const auto same = [&](const Line& line) {
            return line.note->rewrite == note.rewrite && line.note->why == note.why && line.note->how == note.how;
        };
        const auto found = std::find_if(lines.begin(), lines.end(), same);
        if (found == lines.end())
            lines.push_back({&note, {note.where}});
        else
            found->places.push_back(note.where);
    }
    std::string text;
    for (const Line& line : lines)
        text += std::string(line.note->rewrite) + ": " + line.note->why + "; now " + line.note->how + "\n    in " +
                joined(line.places) + '\n';
    return text;
}

std::string findings_text(const Plan& plan) {
    if (plan.legal.left.empty()) return "nothing: it can draw this frame\n";
    std::string text;
    std::map<std::string_view, std::string_view> sources;
    for (const Group& group : grouped(plan.legal.left)) {
        const ChipFinding& finding = *group.first;
        text += (group.field.empty() ? group.owners.front() : group.field) + ": uses " + finding.uses +
                "; the chip has " + finding.has + " [" + std::string(finding.rule) + "]\n";
        if (!group.field.empty()) text += "    in " + joined(group.owners) + '\n';
        if (const pipeline::Evidence* evidence = find_evidence(plan.profile, finding.rule))
            sources[finding.rule] = evidence->source;
    }
    text += '\n';
    for (const auto& [rule, source] : sources) text += '[' + std::string(rule) + "] " + std::string(source) + '\n';
    return text;
}

std::string memory_text(const MemoryMap& memory) {
    std::vector<TextRow> rows{{"address", "bytes", "pitch", "", ""}};
    for (const pipeline::MemoryBlock& block : memory.blocks)
        rows.push_back({with_separators(block.address), with_separators(block.bytes), std::to_string(block.pitch),
                        block.what, std::string(memory.regions[block.region].name)});
    std::string text = text_table(rows, "rrrll");
    for (const pipeline::MemoryRegion& region : memory.regions) {
        text += std::string(region.name) + ": " + with_separators(region.used) + " bytes";
        if (region.budget > 0) text += " of " + with_separators(region.budget);
        if (region.over > 0) text += ", " + with_separators(region.over) + " too many";
        text += '\n';
    }
    return text;
}

std::string number(double value, const char* format) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string range_text(const Range& range, const char* format) {
    const std::string least = number(range.least, format), most = number(range.most, format);
    return least == most ? least : least + " - " + most;
}

TextRow cost_row(const std::string& index, const std::string& label, const PassCost& cost) {
    return {index,
            label,
            with_separators(static_cast<std::uint64_t>(cost.pixels)),
            with_separators(static_cast<std::uint64_t>(cost.texels)),
            with_separators(static_cast<std::uint64_t>(cost.bytes)),
            range_text(cost.page_breaks, "%.0f"),
            range_text(cost.ms, "%.3f"),
            std::string(enum_name(slowest_unit(cost)))};
}

std::string verdict_text(const FrameCost& cost) {
    return range_text(cost.total.ms, "%.1f") + " ms of " + number(pipeline::kFrameBudgetMs, "%.1f") + ": " +
           std::string(enum_name(cost.verdict));
}

std::string cost_text(const Plan& plan) {
    const FrameCost& cost = *plan.cost;
    std::vector<TextRow> rows{{"", "pass", "pixels", "texels", "bytes", "page breaks", "ms", "slowest"}};
    for (std::size_t i = 0; i < cost.passes.size(); ++i)
        rows.push_back(cost_row(std::to_string(i), plan.legal.frame.passes[i].label, cost.passes[i]));
    rows.push_back(cost_row("", "total", cost.total));
    std::string text = text_table(rows, "rlrrrrrl");
    for (const pipeline::Evidence& unknown : cost.unknown)
        text += "not counted: " + std::string(unknown.topic) + ". " + std::string(unknown.open) + '\n';
    return text + verdict_text(cost) + '\n';
}

std::string plan_text(const Plan& plan, const std::string& scene) {
    std::string text = scene + " on " + std::string(plan.profile.chip) + "\n\nRewritten for it\n\n" +
                       notes_text(plan.legal.notes) + "\nWhat the chip still lacks\n\n" + findings_text(plan) +
                       "\nMemory\n\n" + memory_text(plan.memory);
    if (plan.cost) text += "\nCost, at 60 frames a second\n\n" + cost_text(plan);
    return text;
}

ordered_json to_json(const Range& range) {
    return {{"least", range.least}, {"most", range.most}};
}

ordered_json to_json(const std::string& label, const PassCost& cost) {
    ordered_json units;
    for (std::size_t i = 0; i < pipeline::kCostUnits; ++i)
        units[std::string(enum_name(static_cast<pipeline::CostUnit>(i)))] = to_json(cost.unit_ms[i]);
    return {{"label", label},
            {"pixels", cost.pixels},
            {"texels", cost.texels},
            {"bytes", cost.bytes},
            {"page_breaks", to_json(cost.page_breaks)},
            {"uploaded_bytes", to_json(cost.uploaded_bytes)},
            {"unit_ms", units},
            {"ms", to_json(cost.ms)}};
}

ordered_json findings_json(const Plan& plan) {
    ordered_json findings = ordered_json::array();
    for (const ChipFinding& finding : plan.legal.left) {
        const pipeline::Evidence* evidence = find_evidence(plan.profile, finding.rule);
        findings.push_back({{"where", finding.where},
                            {"rule", finding.rule},
                            {"uses", finding.uses},
                            {"has", finding.has},
                            {"source", evidence != nullptr ? evidence->source : ""}});
    }
    return findings;
}

ordered_json notes_json(const pipeline::RewriteNotes& notes) {
    ordered_json list = ordered_json::array();
    for (const pipeline::RewriteNote& note : notes)
        list.push_back({{"rewrite", note.rewrite}, {"where", note.where}, {"why", note.why}, {"how", note.how}});
    return list;
}

ordered_json memory_json(const MemoryMap& memory) {
    ordered_json regions = ordered_json::array(), blocks = ordered_json::array();
    for (const pipeline::MemoryRegion& region : memory.regions)
        regions.push_back(
            {{"name", region.name}, {"budget", region.budget}, {"used", region.used}, {"over", region.over}});
    for (const pipeline::MemoryBlock& block : memory.blocks)
        blocks.push_back({{"what", block.what},
                          {"region", memory.regions[block.region].name},
                          {"address", block.address},
                          {"bytes", block.bytes},
                          {"pitch", block.pitch}});
    return {{"regions", regions}, {"blocks", blocks}};
}

ordered_json cost_json(const Plan& plan) {
    if (!plan.cost) return nullptr;
    ordered_json passes = ordered_json::array(), unknown = ordered_json::array();
    for (std::size_t i = 0; i < plan.cost->passes.size(); ++i)
        passes.push_back(to_json(plan.legal.frame.passes[i].label, plan.cost->passes[i]));
    for (const pipeline::Evidence& evidence : plan.cost->unknown)
        unknown.push_back({{"topic", evidence.topic}, {"open", evidence.open}});
    return {{"passes", passes},
            {"total", to_json("total", plan.cost->total)},
            {"verdict", enum_name(plan.cost->verdict)},
            {"unknown", unknown}};
}

}  // namespace

void report_plan(const PlanOptions& options) {
    const Plan plan = make_plan(options);
    if (options.format == PlanFormat::Text) {
        print(plan_text(plan, options.scene));
    } else {
        const ordered_json json{{"scene", options.scene},
                                {"profile", plan.profile.name},
                                {"rewrites", notes_json(plan.legal.notes)},
                                {"findings", findings_json(plan)},
                                {"memory", memory_json(plan.memory)},
                                {"cost", cost_json(plan)}};
        print(json.dump(2) + '\n');
    }
    if (!plan.legal.left.empty())
        throw ChipCannot(std::string(plan.profile.name) + " cannot draw " + options.scene + ": " +
                         std::to_string(plan.legal.left.size()) + " findings");
}

}  // namespace demo
