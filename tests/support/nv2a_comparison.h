// SPDX-License-Identifier: MIT
// What a comparison of a frame with what emit_nv2a wrote for it has at hand, and what it finds.
#pragma once

#include <cmath>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "pipeline/check/memory_map.h"
#include "pipeline/emit/emitted.h"
#include "pipeline/frame/frame.h"
#include "tests/support/nv2a_state.h"
#include "tests/support/random.h"

namespace test_support {

template <class Of>
std::size_t index_of(pipeline::Id<Of> id) {
    return static_cast<std::size_t>(id.index);
}
template <class Enum>
requires std::is_enum_v<Enum> std::size_t index_of(Enum value) {
    return static_cast<std::size_t>(value);
}

// where: of what is looked at, for the lines of `differences`, which are 20 at most.
struct Nv2aComparison {
    Nv2aComparison(const pipeline::Frame& frame, const pipeline::Emitted& emitted);

    void differ(const std::string& what) {
        if (differences.size() < 20) differences.push_back(where + what);
    }
    void expect(bool holds, const char* what) {
        if (!holds) differ(what);
    }
    void near(double value, double wanted, double most, const std::string& what) {
        if (!(std::abs(value - wanted) <= most))
            differ(what + " is " + std::to_string(value) + ", not " + std::to_string(wanted));
    }

    // The rectangle that a pass draws within, without its scissor and with it.
    pipeline::PixelRect viewport(const pipeline::Pass& pass) const;
    pipeline::PixelRect part(const pipeline::Pass& pass) const;
    // As a number of the depth target's format.
    float greatest_depth(const pipeline::Pass& pass) const;

    const pipeline::Frame& frame;
    Nv2aBytes memory;
    pipeline::MemoryMap map;
    Random random{1};
    std::set<std::int32_t> checked_textures;  // once is enough
    std::string where;
    std::vector<std::string> differences;
};

}  // namespace test_support
