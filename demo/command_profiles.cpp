// SPDX-License-Identifier: MIT
#include "demo/command_profiles.h"

#include <algorithm>
#include <map>

#include "pipeline/frame/field_traits.h"

namespace demo {
namespace {

using pipeline::Evidence;
using pipeline::Profile;

constexpr std::size_t kLineWidth = 118;

// `text` in lines that begin with `indent`, the first with `lead`.
std::string wrapped(std::string_view lead, std::string_view indent, std::string_view text) {
    std::string out(lead);
    std::size_t line_start = 0;
    bool at_start          = true;
    while (!text.empty()) {
        const std::size_t length    = std::min(text.find(' '), text.size());
        const std::string_view word = text.substr(0, length);
        if (!at_start && out.size() - line_start + 1 + length > kLineWidth) {
            out += '\n';
            line_start = out.size();
            out += indent;
        } else if (!at_start) {
            out += ' ';
        }
        out += word;
        at_start = false;
        text.remove_prefix(std::min(length + 1, text.size()));
    }
    return out + '\n';
}

// What stands in each field of the arithmetic: the enumerator or the number, and its formula if it has one.
struct Rule {
    std::string value;
    std::string_view formula;
};
std::map<std::string_view, Rule> rules_of(const Profile& profile) {
    std::map<std::string_view, Rule> rules;
    visit_fields(profile.arithmetic, [&](std::string_view name, const auto& value) {
        if constexpr (pipeline::NamedEnum<std::remove_cvref_t<decltype(value)>>)
            rules[name] = {std::string(enum_name(value)), pipeline::formula(value)};
        else
            rules[name] = {std::to_string(value), {}};
    });
    return rules;
}

constexpr std::size_t kNameWidth = 10, kFieldWidth = 14, kRuleWidth = 18;

std::string padded(std::string_view text, std::size_t width) {
    std::string out(text);
    out.resize(std::max(width, text.size() + 1), ' ');
    return out;
}

// Without the blanks that a last column leaves.
void end_line(std::string& text) {
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
}

template <class Enum>
std::string names_of(const std::vector<Enum>& values) {
    std::string names;
    for (const Enum value : values) {
        if (!names.empty()) names += ' ';
        names += enum_name(value);
    }
    return names;
}

std::string yes_or_no(bool value) {
    return value ? "yes" : "no";
}

std::string copies_of(const pipeline::ChipFormats& formats) {
    if (!formats.copies && !formats.copies_halve) return "no";
    return "to " + names_of(formats.copy_targets) + (formats.copies_convert ? "" : ", within one format") +
           (formats.copies_halve ? ", whole or halved" : ", whole");
}

// 0: no limit, or none that is known.
std::string size_of(std::int32_t width, std::int32_t height) {
    return width == 0 ? "not known" : "up to " + std::to_string(width) + 'x' + std::to_string(height);
}

std::string memory_of(const pipeline::ChipLimits& limits) {
    std::string text = std::to_string(limits.memory >> 20) + " MB, in " + std::string(enum_name(limits.layout));
    if (limits.frame_buffer_width != 0)
        text += "; a frame buffer of " + std::to_string(limits.frame_buffer_width) + 'x' +
                std::to_string(limits.frame_buffer_height);
    return text;
}

std::vector<pipeline::TextureOp> functions_of(pipeline::CombineRule rule) {
    std::vector<pipeline::TextureOp> ops = pipeline::all_of<pipeline::TextureOp>();
    std::erase_if(ops, [&](pipeline::TextureOp op) { return !has_rule(rule, op); });
    return ops;
}

}  // namespace

std::string list_of_profiles() {
    std::string text;
    for (const Profile& profile : pipeline::profiles())
        text += padded(profile.name, kNameWidth) + std::string(profile.chip) + '\n';
    text += '\n' + padded("", kFieldWidth);
    for (const Profile& profile : pipeline::profiles()) text += padded(profile.name, kRuleWidth);
    end_line(text);
    const pipeline::Arithmetic fields;
    visit_fields(fields, [&](std::string_view name, const auto&) {
        text += padded(name, kFieldWidth);
        for (const Profile& profile : pipeline::profiles()) text += padded(rules_of(profile)[name].value, kRuleWidth);
        end_line(text);
    });
    return text;
}

std::string description(const Profile& profile) {
    std::string text              = std::string(profile.name) + ": " + std::string(profile.chip) + "\n\n";
    const std::string_view indent = "    ";
    const auto add                = [&](std::string_view name, const std::string& value) {
        text += wrapped(std::string(name) + ": ", indent, value);
    };
    const pipeline::ChipFormats& formats = profile.formats;
    const pipeline::ChipStates& states   = profile.states;
    add("draws to", names_of(formats.draw));
    add("depth", names_of(formats.depth) + (formats.pairs_depth ? "; D16 with 16 bit colours alone" : ""));
    add("copies", copies_of(formats));
    add("reads as a texture what it draws to", yes_or_no(formats.reads_targets));
    add("depth functions", names_of(states.depth_funcs));
    if (profile.arithmetic.blend == pipeline::BlendRule::GsShift7) {
        add("blends", "(A - B) * C + D, of register ALPHA");
    } else {
        add("source blend factors", names_of(states.source_factors));
        add("destination blend factors", names_of(states.dest_factors));
    }
    add("dithers", names_of(states.dithers));
    add("colour mask", std::string(enum_name(states.color_mask)));
    add("test of the target's alpha", yes_or_no(states.dest_alpha_test));
    add("alpha test failed", names_of(states.alpha_fails));
    add("scissor", yes_or_no(states.scissor));
    add("culling", yes_or_no(states.culling));
    add("flat shading by vertex", std::string(enum_name(states.flat)));
    add("second colour added", yes_or_no(states.specular_addition));
    add("texture stages", std::to_string(states.stages));
    add("stage arguments", names_of(states.arguments) + (states.complement ? ", complemented" : "") +
                               (states.alpha_replicate ? ", alpha in every channel" : ""));
    add("texture functions", profile.arithmetic.combine == pipeline::CombineRule::GsShift7
                                 ? "MODULATE DECAL HIGHLIGHT HIGHLIGHT2, of register TEX0"
                                 : names_of(functions_of(profile.arithmetic.combine)));
    add("texture addresses", names_of(states.addresses));
    add("mip filters", names_of(states.mip_filters));
    const pipeline::ChipLimits& limits = profile.limits;
    add("texture formats", names_of(limits.texture_formats));
    if (limits.memory != 0) {
        add("texture sizes", size_of(limits.texture_width, limits.texture_height));
        add("target sizes", size_of(limits.target_width, limits.target_height));
        add("memory", memory_of(limits));
    }
    const auto rules = rules_of(profile);
    for (const Evidence& evidence : profile.evidence) {
        text += '\n';
        text += evidence.topic;
        const auto rule = rules.find(evidence.topic);
        if (rule != rules.end()) text += ' ' + rule->second.value;
        text += " (";
        text += enum_name(evidence.grade);
        text += ")\n";
        if (rule != rules.end() && !rule->second.formula.empty()) text += wrapped(indent, indent, rule->second.formula);
        text += wrapped("    source: ", "        ", evidence.source);
        if (!evidence.open.empty()) text += wrapped("    open: ", "        ", evidence.open);
    }
    return text;
}

std::string open_questions(const Profile* only) {
    std::string text;
    for (const Profile& profile : pipeline::profiles()) {
        if (only != nullptr && only != &profile) continue;
        for (const Evidence& evidence : profile.evidence)
            if (!evidence.open.empty())
                text += wrapped("- ", "  ",
                                '`' + std::string(profile.name) + "`, " + std::string(evidence.topic) + ": " +
                                    std::string(evidence.open) + '.');
    }
    return text;
}

}  // namespace demo
