// SPDX-License-Identifier: MIT
#include "demo/command_plan.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "demo/chip_words.h"
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
    ChipFrame chip;
    MemoryMap memory;
};

Plan make_plan(const PlanOptions& options) {
    const Profile& profile = *options.profile;
    ChipFrame chip         = make_chip_frame(FrameSource(options.scene), options);
    MemoryMap memory       = pipeline::lay_out(chip.legal.frame, profile);
    return {.profile = profile, .chip = std::move(chip), .memory = std::move(memory)};
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
    const FrameCost& cost = *plan.chip.cost;
    std::vector<TextRow> rows{{"", "pass", "pixels", "texels", "bytes", "page breaks", "ms", "slowest"}};
    for (std::size_t i = 0; i < cost.passes.size(); ++i)
        rows.push_back(cost_row(std::to_string(i), plan.chip.legal.frame.passes[i].label, cost.passes[i]));
    rows.push_back(cost_row("", "total", cost.total));
    std::string text = text_table(rows, "rlrrrrrl");
    for (const pipeline::Evidence& unknown : cost.unknown)
        text += "not counted: " + std::string(unknown.topic) + ". " + std::string(unknown.open) + '\n';
    return text + verdict_text(cost) + '\n';
}

std::string plan_text(const Plan& plan, const std::string& scene) {
    std::string text = scene + " on " + std::string(plan.profile.chip) + "\n\n";
    if (plan.chip.reduction) text += "Reduced: " + reduction_text(*plan.chip.reduction) + "\n\n";
    text += "Rewritten for it\n\n" + notes_text(plan.chip.legal.notes) + "\nWhat the chip still lacks\n\n" +
            (plan.chip.legal.left.empty() ? "nothing: it can draw this frame\n"
                                          : findings_text(plan.chip.legal.left, plan.profile)) +
            "\nMemory\n\n" + memory_text(plan.memory);
    if (plan.chip.cost) text += "\nCost, at 60 frames a second\n\n" + cost_text(plan);
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
    for (const ChipFinding& finding : plan.chip.legal.left) {
        const pipeline::Evidence* evidence = find_evidence(plan.profile, finding.rule);
        findings.push_back({{"where", finding.where},
                            {"rule", finding.rule},
                            {"uses", finding.uses},
                            {"has", finding.has},
                            {"source", evidence != nullptr ? evidence->source : ""}});
    }
    return findings;
}

ordered_json reduction_json(const Plan& plan) {
    if (!plan.chip.reduction) return nullptr;
    const Reduction& reduction = *plan.chip.reduction;
    return {
        {"width", reduction.size.width}, {"height", reduction.size.height}, {"texture_halvings", reduction.halvings}};
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
    if (!plan.chip.cost) return nullptr;
    ordered_json passes = ordered_json::array(), unknown = ordered_json::array();
    for (std::size_t i = 0; i < plan.chip.cost->passes.size(); ++i)
        passes.push_back(to_json(plan.chip.legal.frame.passes[i].label, plan.chip.cost->passes[i]));
    for (const pipeline::Evidence& evidence : plan.chip.cost->unknown)
        unknown.push_back({{"topic", evidence.topic}, {"open", evidence.open}});
    return {{"passes", passes},
            {"total", to_json("total", plan.chip.cost->total)},
            {"verdict", enum_name(plan.chip.cost->verdict)},
            {"unknown", unknown}};
}

}  // namespace

void report_plan(const PlanOptions& options) {
    const Plan plan = make_plan(options);
    if (options.format == PlanFormat::Text) {
        print(plan_text(plan, options.scene));
        if (options.with_words && plan.chip.legal.left.empty())
            print("\nPasses in its own words\n\n" + chip_words(plan.chip.legal, plan.profile));
    } else {
        const ordered_json json{{"scene", options.scene},
                                {"profile", plan.profile.name},
                                {"reduction", reduction_json(plan)},
                                {"rewrites", notes_json(plan.chip.legal.notes)},
                                {"findings", findings_json(plan)},
                                {"memory", memory_json(plan.memory)},
                                {"cost", cost_json(plan)}};
        print(json.dump(2) + '\n');
    }
    if (!plan.chip.legal.left.empty())
        throw ChipCannot(std::string(plan.profile.name) + " cannot draw " + options.scene + ": " +
                         std::to_string(plan.chip.legal.left.size()) + " findings");
}

}  // namespace demo
