// SPDX-License-Identifier: MIT
// The model that demo/scenes/models/cloud.glb holds: a cumulus of 24 empties named particle, which swells and rises
// for 3 seconds, as an artist would key it.
#pragma once

#include <string>

namespace tests {

std::string cloud_model_glb();

}  // namespace tests
