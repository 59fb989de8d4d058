// SPDX-License-Identifier: MIT
#include "demo/chip_frame.h"

#include <algorithm>
#include <map>
#include <vector>

#include "pipeline/execute/execute.h"
#include "pipeline/legalize/halved_textures.h"

namespace demo {
namespace {

using pipeline::ChipFinding;
using pipeline::Frame;
using pipeline::Profile;

constexpr int kSixteenths = 16, kMostHalvings = 2;

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

std::optional<pipeline::FrameCost> cost_of(const Frame& frame, const Profile& profile) {
    const pipeline::ChipRates* rates = pipeline::find_rates(profile.name);
    if (rates == nullptr) return {};
    return pipeline::cost(frame, pipeline::execute(frame, {.counts_only = true}).counts, *rates);
}

bool is_of_memory(const ChipFinding& finding) {
    return finding.rule == "memory";
}

pipeline::LegalFrame legal_frame(const FrameSource& source, const ChipFrameOptions& options) {
    Frame frame = source.frame(options.size, options.frame, options.changes);
    return pipeline::legalize(pipeline::with_halved_textures(std::move(frame), options.halvings), *options.profile);
}

// Reduces one picture step by step.
class Reducer {
  public:
    Reducer(const FrameSource& source, const ChipFrameOptions& options) : source_(source), options_(options) {
        const Frame frame            = source.frame(options.size, options.frame, options.changes);
        const pipeline::Target& full = frame.targets[static_cast<std::size_t>(frame.output.index)];
        full_                        = {full.width, full.height};
    }

    ChipFrame reduced() const {
        const int least = source_.is_dumped_frame() ? kSixteenths : kSixteenths / 2;
        ChipFrame last;
        for (int sixteenths = kSixteenths; sixteenths >= least; --sixteenths) {
            const Size size   = {even(full_.width, sixteenths), even(full_.height, sixteenths)};
            const Frame frame = source_.frame(source_.is_dumped_frame() ? std::nullopt : std::optional(size),
                                              options_.frame, options_.changes);
            last             = attempt(frame, size, kMostHalvings);
            const auto& left = last.legal.left;
            if (!std::all_of(left.begin(), left.end(), &is_of_memory)) return last;  // no size helps
            if (!fits(last)) continue;
            for (int halvings = 0; halvings < kMostHalvings; ++halvings) {
                ChipFrame finer = attempt(frame, size, halvings);
                if (fits(finer)) return finer;
            }
            return last;
        }
        return last;
    }

  private:
    static int even(int pixels, int sixteenths) { return std::max(2, pixels * sixteenths / kSixteenths / 2 * 2); }

    ChipFrame attempt(const Frame& frame, Size size, int halvings) const {
        ChipFrame chip;
        chip.legal     = pipeline::legalize(pipeline::with_halved_textures(frame, halvings), *options_.profile);
        chip.reduction = Reduction{size, full_, halvings};
        if (chip.legal.left.empty()) chip.cost = cost_of(chip.legal.frame, *options_.profile);
        return chip;
    }

    static bool fits(const ChipFrame& chip) {
        return chip.legal.left.empty() && (!chip.cost || chip.cost->verdict != pipeline::Verdict::TooLong);
    }

    const FrameSource& source_;
    const ChipFrameOptions& options_;
    Size full_;
};

}  // namespace

ChipFrame make_chip_frame(const FrameSource& source, const ChipFrameOptions& options) {
    ChipFrame chip;
    if (options.reduce)
        chip = Reducer(source, options).reduced();
    else
        chip.legal = legal_frame(source, options);
    if (!chip.cost) chip.cost = cost_of(chip.legal.frame, *options.profile);
    return chip;
}

pipeline::LegalFrame drawable_chip_frame(const FrameSource& source, ChipFrameOptions& options) {
    const bool was_reduced = options.reduce;
    pipeline::LegalFrame legal;
    if (options.reduce) {
        ChipFrame chip   = Reducer(source, options).reduced();
        legal            = std::move(chip.legal);
        options.reduce   = false;
        options.halvings = chip.reduction->halvings;
        if (!source.is_dumped_frame()) options.size = chip.reduction->size;
    } else {
        legal = legal_frame(source, options);
    }
    if (legal.left.empty()) return legal;
    std::string text = std::string(options.profile->name) + " cannot draw " + options.scene + ": " +
                       std::to_string(legal.left.size()) + " findings";
    if (!was_reduced && std::all_of(legal.left.begin(), legal.left.end(), &is_of_memory))
        text += " (--fit reduces picture and textures to the chip's memory)";
    throw ChipCannot(std::move(text), findings_text(legal.left, *options.profile));
}

std::string reduction_text(const Reduction& reduction) {
    const auto size_text = [](const Size& size) {
        return std::to_string(size.width) + 'x' + std::to_string(size.height);
    };
    const bool is_smaller =
        reduction.size.width != reduction.from.width || reduction.size.height != reduction.from.height;
    std::string text = size_text(reduction.size);
    if (is_smaller) text += " in place of " + size_text(reduction.from);
    if (reduction.halvings == 1) text += ", textures halved";
    if (reduction.halvings > 1) text += ", textures halved " + std::to_string(reduction.halvings) + " times";
    if (!is_smaller && reduction.halvings == 0) text += ", as it is";
    return text;
}

std::string findings_text(const std::vector<ChipFinding>& findings, const Profile& profile) {
    std::string text;
    std::map<std::string_view, std::string_view> sources;
    for (const Group& group : grouped(findings)) {
        const ChipFinding& finding = *group.first;
        text += (group.field.empty() ? group.owners.front() : group.field) + ": uses " + finding.uses +
                "; the chip has " + finding.has + " [" + std::string(finding.rule) + "]\n";
        if (!group.field.empty()) text += "    in " + joined(group.owners) + '\n';
        if (const pipeline::Evidence* evidence = find_evidence(profile, finding.rule))
            sources[finding.rule] = evidence->source;
    }
    if (!sources.empty()) text += '\n';
    for (const auto& [rule, source] : sources) text += '[' + std::string(rule) + "] " + std::string(source) + '\n';
    return text;
}

}  // namespace demo
