// SPDX-License-Identifier: MIT
// Results go to standard output at once, so that none is lost if a later step fails, and a write that fails (a full
// disk behind a redirection) is an error: std::runtime_error.
#pragma once

#include <string_view>

namespace demo {

void print(std::string_view text);

}  // namespace demo
