// SPDX-License-Identifier: MIT
// nimbus7 profiles: the chips, how one of them computes, or what is not known of all of them.
#pragma once

#include <string>

#include "pipeline/profile/profile.h"

namespace demo {

void list_profiles();
void print_profile(const pipeline::Profile& profile);

// As a list in Markdown, for the README.
std::string open_questions();

}  // namespace demo
