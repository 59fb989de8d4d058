// SPDX-License-Identifier: MIT
// Which passes are filled together. A tile that stays in the cache while all passes that draw to it go by costs the
// memory one way and back; so consecutive passes make a group as long as
//   - between them they draw to one colour and one depth target of one size (a pass may lack either),
//   - none reads the group's colour target as a texture,
//   - none copies: that is a group by itself.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/frame/frame.h"

namespace pipeline {

struct PassGroup {
    std::size_t first = 0, end = 0;  // of Frame::passes
    TargetId color, depth;           // what they draw to between them
    bool copies                             = false;
    bool operator==(const PassGroup&) const = default;
};

// one_by_one: a group for each pass.
std::vector<PassGroup> schedule_passes(const Frame& frame, bool one_by_one = false);

// A line for each group: "0-4: color 0, depth 1", for tests.
std::string to_text(const std::vector<PassGroup>& groups);

// Does a pass copy?
bool copies(const Pass& pass);

}  // namespace pipeline
