// SPDX-License-Identifier: MIT
#include "pipeline/check/check.h"

#include "pipeline/check/chip_findings.h"

namespace pipeline {

namespace {

// One finding for all of it, under the topic of the first field that differs.
void check_arithmetic(const Frame& frame, ChipFindings& findings) {
    const Arithmetic &uses = frame.arithmetic, &has = findings.profile().arithmetic;
    std::string_view rule;
    visit_pairs(uses, has, [&](std::string_view name, const auto& field, const auto& chip_field) {
        if (rule.empty() && field != chip_field) rule = name;
    });
    if (!rule.empty())
        findings.add(Place("arithmetic"), rule, differing_fields(uses, has), differing_fields(has, uses));
}

}  // namespace

std::vector<ChipFinding> check(const Frame& frame, const Profile& profile) {
    ChipFindings findings(profile);
    check_arithmetic(frame, findings);
    check_targets_and_textures(frame, findings);
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        const Pass& pass = frame.passes[i];
        const Place place("pass", i, pass.label);
        check_pass_formats(frame, pass, place, findings);
        check_states(frame, pass, place, findings);
        check_stages(frame, pass, place, findings);
    }
    check_memory(frame, findings);
    return findings.take();
}

}  // namespace pipeline
