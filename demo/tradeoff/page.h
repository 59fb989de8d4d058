// SPDX-License-Identifier: MIT
// A sweep as one page of HTML that needs nothing beside it: the chart, all settings in a table, the front's pictures side by
// side, and a view in which two of them are compared. Made from page.html, where {{names}} stand for what is filled in.
#pragma once

#include <string>

#include "demo/tradeoff/sweep.h"

namespace demo {

std::string to_page(const Sweep& sweep, const std::string& title);

}  // namespace demo
