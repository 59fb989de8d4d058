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
    text += wrapped("colour targets: ", indent, names_of(profile.color_formats));
    text += wrapped("depth targets: ", indent, names_of(profile.depth_formats));
    text += wrapped("depth functions: ", indent, names_of(profile.depth_funcs));
    text += wrapped("alpha functions: ", indent, names_of(profile.alpha_funcs));
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

std::string open_questions() {
    std::string text;
    for (const Profile& profile : pipeline::profiles())
        for (const Evidence& evidence : profile.evidence)
            if (!evidence.open.empty())
                text += wrapped("- ", "  ",
                                '`' + std::string(profile.name) + "`, " + std::string(evidence.topic) + ": " +
                                    std::string(evidence.open) + '.');
    return text;
}

}  // namespace demo
