// SPDX-License-Identifier: MIT
// Of the program, as files that others keep name it.
#pragma once

#include <string_view>

namespace demo {

inline constexpr std::string_view kVersion = "0.1.0";

}  // namespace demo
