// SPDX-License-Identifier: MIT
// nimbus7 vectors: a profile's golden vectors, for other programs' tests: arrays of bytes over all inputs of its rules
// (.npy), small frames as its chip draws them (.frame, .npy), and manifest.json, which says what each file is.
#pragma once

#include <string>

#include "pipeline/profile/profile.h"

namespace demo {

struct VectorsOptions {
    const pipeline::Profile* profile = nullptr;
    std::string directory;  // made if it is not there
};

void write_vectors(const VectorsOptions& options);

}  // namespace demo
