// SPDX-License-Identifier: MIT
// The two tests that may reject a fragment. Both compare as "fragment FUNC reference": an unsigned byte of alpha with
// `reference`, and unsigned depth units with the depth buffer. ALWAYS is "test off". A pass without a depth target
// must leave the depth test ALWAYS and not write.
#pragma once

#include <cstdint>

#include "pipeline/frame/fields.h"

namespace pipeline {

enum class CompareFunc : std::uint8_t { Always, LessEqual, Less, GreaterEqual, Greater, Equal };
template <>
struct EnumNames<CompareFunc> {
    static constexpr std::array<std::string_view, 6> names{"ALWAYS",       "LESSEQUAL", "LESS",
                                                           "GREATEREQUAL", "GREATER",   "EQUAL"};
};

struct DepthState {
    CompareFunc func                         = CompareFunc::Always;
    bool write                               = false;
    bool operator==(const DepthState&) const = default;
};
template <SameStruct<DepthState> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [func, write] = state;
    visit("func", func);
    visit("write", write);
}

struct AlphaTestState {
    CompareFunc func                             = CompareFunc::Always;
    std::uint8_t reference                       = 0;
    bool operator==(const AlphaTestState&) const = default;
};
template <SameStruct<AlphaTestState> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [func, reference] = state;
    visit("func", func);
    visit("reference", reference);
}

}  // namespace pipeline
