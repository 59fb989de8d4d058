// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "pipeline/profile/tables.h"

namespace pipeline {

std::span<const Profile> profiles() {
    static const std::array<Profile, 5> all{make_ideal(), make_dx7(), make_ps2(), make_gamecube(), make_xbox()};
    return all;
}

bool go_together(const ChipFormats& formats, TargetFormat color, TargetFormat depth) {
    return !formats.pairs_depth || (bytes_per_pixel(color) == 2) == (depth == TargetFormat::D16);
}

const Profile* find_profile(std::string_view name) {
    const auto all   = profiles();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Profile& one) { return one.name == name; });
    return found == all.end() ? nullptr : &*found;
}

const Evidence* find_evidence(const Profile& profile, std::string_view topic) {
    const auto found = std::find_if(profile.evidence.begin(), profile.evidence.end(),
                                    [&](const Evidence& one) { return one.topic == topic; });
    return found == profile.evidence.end() ? nullptr : &*found;
}

}  // namespace pipeline
