// SPDX-License-Identifier: MIT
// Prints the table of numerical extremes, as the README quotes it.
#include <iostream>

#include "tests/extremes/extremes.h"

int main() {
    std::cout << extremes::table();
    return std::cout.flush() ? 0 : 1;
}
