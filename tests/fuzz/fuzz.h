// SPDX-License-Identifier: MIT
// What the fuzzers share: their inputs as text, and a check that stops with a reason.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace fuzz {

inline std::string_view as_text(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

// Stops as a sanitizer does: libFuzzer keeps the input.
inline void require(bool holds, const std::string& what) {
    if (holds) return;
    std::fprintf(stderr, "FAILED: %s\n", what.c_str());
    std::abort();
}

// A complaint is one line that says something.
inline void require_complaint(std::string_view text) {
    require(!text.empty() && text.find('\n') == std::string_view::npos, "not one line: " + std::string(text));
}

}  // namespace fuzz
