// SPDX-License-Identifier: MIT
// SHA-256 (FIPS 180-4) by the library Nettle, as sha256sum prints it.
#pragma once

#include <string>
#include <string_view>

namespace demo {

std::string sha256(std::string_view bytes);  // 64 hexadecimal digits, lower case

}  // namespace demo
