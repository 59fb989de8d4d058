// SPDX-License-Identifier: MIT
// A step's copies for all instruction sets that this machine has, to be run in turn on what was made once, and how
// much a test over all values of a byte takes of them.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "pipeline/execute/execute.h"
#include "tests/raster/fill_steps.h"
#include "tests/support/simd_targets.h"

namespace simd_kernels {

using fill_steps::kLanes;

template <class Kernel>
struct Named {
    std::string name;
    Kernel kernel;
    bool is_fallback =
        false;  // without vectors, beside others that have them: so slow that it sees a part of a long test
};

// get() for each instruction set, which is forced meanwhile.
template <class Get>
auto on_every_target(Get get) {
    std::vector<Named<decltype(get())>> kernels;
    const test_support::RestoreSimdTarget restore;
    for (const std::string& target : pipeline::simd_targets()) {
        pipeline::force_simd_target(target);
        kernels.push_back({target, get(), target == "SCALAR" && pipeline::simd_targets().size() > 1});
    }
    return kernels;
}

// get(kind) for each instruction set: the step for any state, and the one for this very state if there is one.
template <class Get>
auto of_every_kind(Get get) {
    auto kernels = on_every_target([&] { return get(fill_steps::Kind::General); });
    for (auto& [name, kernel, is_fallback] : on_every_target([&] { return get(fill_steps::Kind::Special); }))
        if (kernel) kernels.push_back({name + " special", kernel, is_fallback});
    return kernels;
}

// Values of a byte at which arithmetic on it changes its ways.
inline constexpr std::array kEdges{0, 1, 127, 128, 129, 254, 255};
inline bool is_edge(int value) {
    return std::find(kEdges.begin(), kEdges.end(), value) != kEdges.end();
}

// Where kernels are compiled to be slow, the long tests take the edges and every 16th value of their outermost byte,
// and one in kStride of what they step through within.
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
inline constexpr bool kIsFast = true;
#else
inline constexpr bool kIsFast = false;
#endif
inline constexpr int kStride = kIsFast ? 1 : 11;

inline std::vector<int> swept_bytes() {
    std::vector<int> bytes;
    for (int i = 0; i < 256; ++i)
        if (kIsFast || i % 16 == 0 || is_edge(i)) bytes.push_back(i);
    return bytes;
}

}  // namespace simd_kernels
