// SPDX-License-Identifier: MIT
// What no pass uses any more takes no memory: textures that nothing reads go. Comes last.
#pragma once

#include "pipeline/legalize/legalize.h"

namespace pipeline {

// A frame stays as it is for a profile whose memory has no limit.
Frame drop_unused(Frame frame, const Profile& profile, RewriteNotes& notes);

}  // namespace pipeline
