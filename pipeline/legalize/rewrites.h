// SPDX-License-Identifier: MIT
// The rewrites one by one, as legalize applies them.
#pragma once

#include <span>
#include <string_view>

#include "pipeline/legalize/legalize.h"

namespace pipeline {

// name: the function's.
struct NamedRewrite {
    std::string_view name;
    Rewrite rewrite;
};
// In their order.
std::span<const NamedRewrite> rewrites();

}  // namespace pipeline
