// SPDX-License-Identifier: MIT
// nimbus7 profiles: what it prints of the chips. The README quotes some of it.
#pragma once

#include <string>

#include "pipeline/profile/profile.h"

namespace demo {

// The chips, and a table of their arithmetic.
std::string list_of_profiles();
// Formats, states, and each rule with its formula, source, evidence and what is open.
std::string description(const pipeline::Profile& profile);
// What is not known of one, or of all, as a list in Markdown.
std::string open_questions(const pipeline::Profile* profile = nullptr);

}  // namespace demo
