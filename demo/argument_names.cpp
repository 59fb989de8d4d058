// SPDX-License-Identifier: MIT
#include "demo/argument_names.h"

#include <stdexcept>

namespace demo {

StatisticsFormat parse_statistics(const std::string& text) {
    if (text == "text") return StatisticsFormat::Text;
    if (text == "json") return StatisticsFormat::Json;
    throw std::runtime_error("--stats " + text + ": expected text or json");
}

Technique parse_technique(const std::string& text) {
    if (text == "mega") return Technique::MegaParticles;
    if (text == "sprites") return Technique::Sprites;
    if (text == "slices") return Technique::Slices;
    throw std::runtime_error("--technique " + text + ": expected mega, sprites or slices");
}

cloud::Mode parse_mode(const std::string& text) {
    if (text == "skirt") return cloud::Mode::Skirt;
    if (text == "article") return cloud::Mode::Article;
    if (text == "premultiplied") return cloud::Mode::Premultiplied;
    if (text == "black") return cloud::Mode::Black;
    throw std::runtime_error("--mode " + text + ": expected skirt, article, premultiplied or black");
}

Precision parse_precision(const std::string& text) {
    if (text == "exact") return Precision::Exact;
    if (text == "fast") return Precision::Fast;
    throw std::runtime_error("--precision " + text + ": expected exact or fast");
}

const pipeline::Profile& parse_profile(const std::string& name) {
    if (const pipeline::Profile* profile = pipeline::find_profile(name)) return *profile;
    std::string known;
    for (const pipeline::Profile& profile : pipeline::profiles())
        known += (known.empty() ? "" : ", ") + std::string(profile.name);
    throw std::runtime_error(name + ": no such profile (there are: " + known + ")");
}

PlanFormat parse_plan_format(const std::string& text) {
    if (text == "text") return PlanFormat::Text;
    if (text == "json") return PlanFormat::Json;
    throw std::runtime_error("--format " + text + ": expected text or json");
}

std::vector<const pipeline::Profile*> parse_profiles(const std::string& name) {
    if (name != "all") return {&parse_profile(name)};
    std::vector<const pipeline::Profile*> all;
    for (const pipeline::Profile& profile : pipeline::profiles()) all.push_back(&profile);
    return all;
}

}  // namespace demo
