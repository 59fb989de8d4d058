// SPDX-License-Identifier: MIT
// A small generator of random numbers for tests: the same numbers from a seed everywhere, which the distributions of
// the standard library do not promise. Braces, not parentheses, around several of them: only braces fix the order in
// which they are drawn. PCG XSH-RR 64/32 (O'Neill 2014, pcg-random.org).
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "pipeline/frame/fields.h"

namespace test_support {

class Random {
  public:
    explicit Random(std::uint32_t seed) : state_(seed * kMultiplier + kIncrement) { bits(); }

    std::uint32_t bits() {
        const std::uint64_t old = state_;
        state_                  = old * kMultiplier + kIncrement;
        const auto mixed        = static_cast<std::uint32_t>((old >> 18 ^ old) >> 27);
        const auto turn         = static_cast<std::uint32_t>(old >> 59);
        return mixed >> turn | mixed << (-turn & 31);
    }

    // least..greatest, both included.
    int from(int least, int greatest) {
        const auto count = static_cast<std::uint32_t>(greatest - least) + 1;
        return least + static_cast<int>(std::uint64_t{bits()} * count >> 32);
    }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(from(0, static_cast<int>(count) - 1)); }
    float real(float least, float greatest) {
        return least + (greatest - least) * (static_cast<float>(bits() >> 8) * 0x1p-24f);
    }
    bool chance(int percent) { return from(0, 99) < percent; }

    template <class T>
    T one_of(std::initializer_list<T> choices) {
        return choices.begin()[below(choices.size())];
    }
    template <pipeline::NamedEnum Enum>
    Enum any() {
        return static_cast<Enum>(below(pipeline::EnumNames<Enum>::names.size()));
    }

  private:
    static constexpr std::uint64_t kMultiplier = 6364136223846793005u;
    static constexpr std::uint64_t kIncrement  = 1442695040888963407u;
    std::uint64_t state_;
};

}  // namespace test_support
