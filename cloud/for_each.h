// SPDX-License-Identifier: MIT
// How a caller lends its threads to work that falls into independent parts.
#pragma once

#include <cstddef>
#include <functional>

namespace cloud {

// Calls work(0) .. work(count - 1), each once, in any order, several at once if it likes; returns when all are done.
using ForEach = std::function<void(std::size_t count, const std::function<void(std::size_t)>& work)>;

inline void one_by_one(std::size_t count, const std::function<void(std::size_t)>& work) {
    for (std::size_t i = 0; i < count; ++i) work(i);
}

}  // namespace cloud
