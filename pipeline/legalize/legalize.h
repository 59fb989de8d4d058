// SPDX-License-Identifier: MIT
// A frame rewritten with what a chip has. Rewrites run in a fixed order, each on what the one before left; each has a file of
// its own and leaves alone what the chip can do. A picture may differ from the frame's by rounding, never by meaning.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/check/check.h"
#include "pipeline/profile/profile.h"

namespace pipeline {

// rewrite: its name, as its file's. where: "pass 3 'composite'", or "frame". why: what the chip lacks or does in another way.
// how: what stands there now.
struct RewriteNote {
    std::string_view rewrite;
    std::string where, why, how;
    bool operator==(const RewriteNote&) const = default;
};
using RewriteNotes = std::vector<RewriteNote>;

// A valid frame in, a valid frame out.
using Rewrite = Frame (*)(Frame frame, const Profile& profile, RewriteNotes& notes);

// left: what the rewrites did not solve (check). The frame is what the chip draws only if that is empty.
struct LegalFrame {
    Frame frame;
    RewriteNotes notes;
    std::vector<ChipFinding> left;
};

LegalFrame legalize(Frame frame, const Profile& profile);

}  // namespace pipeline
