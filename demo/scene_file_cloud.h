// SPDX-License-Identifier: MIT
// The [[cloud]] tables of a scene file.
#pragma once

#include "demo/toml_reader.h"

namespace demo {

inline constexpr Range kLight{0.0, 4.0};

CloudPlan read_cloud(TableReader reader);

// `at`, in seconds, of one in a list of keys: later than last_s, which it becomes; start with -1.
double read_time(TableReader& reader, double& last_s);

}  // namespace demo
