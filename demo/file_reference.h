// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace demo {

// A file that the scene names: where it is, and where it is named ("scenes/x.toml:12:8: terrain.height_map") for
// complaints.
struct FileReference {
    std::string path, named_at;
};

}  // namespace demo
