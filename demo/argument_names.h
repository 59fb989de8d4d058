// SPDX-License-Identifier: MIT
// The values of command line arguments that are one of a few names. Errors are std::runtime_error and list the names.
#pragma once

#include <string>
#include <vector>

#include "demo/command_plan.h"
#include "demo/command_render.h"
#include "demo/scene.h"
#include "pipeline/profile/profile.h"

namespace demo {

StatisticsFormat parse_statistics(const std::string& text);
PlanFormat parse_plan_format(const std::string& text);
Technique parse_technique(const std::string& text);
cloud::Mode parse_mode(const std::string& text);
Precision parse_precision(const std::string& text);
const pipeline::Profile& parse_profile(const std::string& name);
// "all", or one.
std::vector<const pipeline::Profile*> parse_profiles(const std::string& name);

}  // namespace demo
