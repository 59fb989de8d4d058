// SPDX-License-Identifier: MIT
// NumPy's file of one array, format 1.0 (numpy.org, "NEP 1: a simple file format for NumPy arrays"), for bytes in C
// order: a header of 128 bytes, then the array, the last axis fastest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace demo {

inline constexpr std::size_t kNpyHeaderBytes = 128;

// The file's bytes. `values` are as many as the product of `shape` says; at most 8 axes.
std::string to_npy(std::span<const std::size_t> shape, std::span<const std::uint8_t> values);

}  // namespace demo
