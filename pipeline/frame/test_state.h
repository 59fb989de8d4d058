// SPDX-License-Identifier: MIT
// The three tests that may reject a fragment, in their order: its alpha, the alpha already in the colour target, its depth. Alpha
// and depth compare as "fragment FUNC reference": an unsigned byte of alpha with `reference`, and unsigned depth units
// with the depth buffer. ALWAYS is "test off". A pass without a depth target must leave the depth test ALWAYS and not
// write.
#pragma once

#include <cstdint>

#include "pipeline/frame/fields.h"

namespace pipeline {

enum class CompareFunc : std::uint8_t { Always, LessEqual, Less, GreaterEqual, Greater, Equal, NotEqual, Never };
template <>
struct EnumNames<CompareFunc> {
    static constexpr std::array<std::string_view, 8> names{"ALWAYS",  "LESSEQUAL", "LESS",     "GREATEREQUAL",
                                                           "GREATER", "EQUAL",     "NOTEQUAL", "NEVER"};
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

// What a fragment that fails the alpha test may still write, as the Graphics Synthesizer's AFAIL: nothing; colour but no depth;
// depth but no colour; red, green and blue alone. On a target whose alpha has not 8 bits RGB_ONLY is FB_ONLY.
enum class AlphaFail : std::uint8_t { Keep, FbOnly, ZbOnly, RgbOnly };
template <>
struct EnumNames<AlphaFail> {
    static constexpr std::array<std::string_view, 4> names{"KEEP", "FB_ONLY", "ZB_ONLY", "RGB_ONLY"};
};

struct AlphaTestState {
    CompareFunc func                             = CompareFunc::Always;
    std::uint8_t reference                       = 0;
    AlphaFail fail                               = AlphaFail::Keep;
    bool operator==(const AlphaTestState&) const = default;
};
template <SameStruct<AlphaTestState> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [func, reference, fail] = state;
    visit("func", func);
    visit("reference", reference);
    visit("fail", fail);
}

// Off, or the value that bit 7 of the alpha in the colour target must have (the Graphics Synthesizer's DATE and DATM). On a
// target without alpha nothing passes.
enum class DestAlphaTest : std::uint8_t { Off, Zero, One };
template <>
struct EnumNames<DestAlphaTest> {
    static constexpr std::array<std::string_view, 3> names{"OFF", "ZERO", "ONE"};
};

}  // namespace pipeline
