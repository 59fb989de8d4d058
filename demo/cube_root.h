// SPDX-License-Identifier: MIT
#pragma once

namespace demo {

// Of a finite value >= 0, within 2 units of the last place; + - * / in a fixed order, unlike the C library's.
double cube_root(double value);

}  // namespace demo
