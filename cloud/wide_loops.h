// SPDX-License-Identifier: MIT
// Loops in vectors of eight floats, on processors that have them and were not assumed to. The compiler makes the vectors, and
// fuses no product with a sum, so the bits are those of the loops as written.
#pragma once

namespace cloud {

// As std::min and std::max, whose references are in the vectors' way.
inline float least(float a, float b) {
    return b < a ? b : a;
}
inline float greatest(float a, float b) {
    return a < b ? b : a;
}

#if defined(__x86_64__) && defined(__GNUC__)

template <class Work>
[[gnu::target("avx2"), gnu::flatten, gnu::noinline]] void run_wide(const Work& work) {
    work();
}

// Calls work() once.
template <class Work>
void with_wide_loops(const Work& work) {
    if (__builtin_cpu_supports("avx2"))
        run_wide(work);
    else
        work();
}

#else

template <class Work>
void with_wide_loops(const Work& work) {
    work();
}

#endif

}  // namespace cloud
