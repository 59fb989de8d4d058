// SPDX-License-Identifier: MIT
// Runs a test body once on every instruction set that this machine has; it may take the name.
#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <type_traits>

#include "pipeline/execute/execute.h"

namespace test_support {

struct RestoreSimdTarget {
    ~RestoreSimdTarget() { pipeline::force_simd_target(""); }
};

template <class Body>
void for_each_simd_target(Body&& body) {
    const RestoreSimdTarget restore;
    for (const std::string& target : pipeline::simd_targets()) {
        INFO("instruction set " << target);
        pipeline::force_simd_target(target);
        if constexpr (std::is_invocable_v<Body, const std::string&>)
            body(target);
        else
            body();
    }
}

}  // namespace test_support
