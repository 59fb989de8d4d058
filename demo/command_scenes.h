// SPDX-License-Identifier: MIT
// nimbus7 scenes: lists the built-in scenes, one line each.
#pragma once

namespace demo {

void list_scenes();

}  // namespace demo
