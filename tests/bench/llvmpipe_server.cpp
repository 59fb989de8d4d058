// SPDX-License-Identifier: MIT
#include <cstdio>

#include "tests/bench/llvmpipe_child.h"

#ifndef NIMBUS7_BENCH_GL

namespace bench {

int serve_llvmpipe(const std::string&, int) {
    std::puts("built without EGL and OpenGL");
    return 1;
}

}  // namespace bench

#else

#include <malloc.h>

#include <chrono>
#include <climits>
#include <cstdlib>
#include <optional>
#include <stdexcept>

#include "pipeline/execute/execute.h"
#include "tests/bench/frames.h"
#include "tests/peers/expressible.h"
#include "tests/peers/gl_context.h"
#include "tests/peers/gl_prepared.h"

namespace bench {

namespace {

void say(const std::string& line) {
    std::printf("%s\n", line.c_str());
    std::fflush(stdout);
}

double timed_draw(peers::GlPreparedFrame& prepared) {
    using Clock      = std::chrono::steady_clock;
    const auto start = Clock::now();
    prepared.draw();
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// What the driver frees at the end of a frame stays in the process for the next: triangles are up to an eighth faster.
void keep_freed_memory() {
    mallopt(M_TRIM_THRESHOLD, INT_MAX);
    mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the greatest there is
    mallopt(M_TOP_PAD, 64 << 20);
}

// Only the same work is worth timing. Means over all channels, in units of 255: the fast paths' filters and what
// rounding leaves after 32 layers are below 2; anything left out is far above.
void check_picture(const pipeline::Frame& frame, const pipeline::ColorImage& picture) {
    constexpr double kGreatestMean      = 3.0;
    const pipeline::ColorImage expected = pipeline::execute(frame).output;
    double sum                          = 0.0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        for (const int shift : {0, 8, 16, 24}) {
            const auto channel = [&](std::uint32_t color) { return static_cast<int>(color >> shift & 255); };
            sum += std::abs(channel(picture.pixels[i]) - channel(expected.pixels[i]));
        }
    const double mean = sum / static_cast<double>(4 * picture.pixels.size());
    if (mean > kGreatestMean)
        throw std::runtime_error("llvmpipe draws another picture, off by " + std::to_string(mean));
}

void serve(const std::string& frame_case, int threads) {
    keep_freed_memory();
    // The count is of threads that rasterize, beside the one that OpenGL is called from. With 0 that one does all.
    setenv("LP_NUM_THREADS", std::to_string(threads == 1 ? 0 : threads).c_str(), 1);
    const peers::GlContext context(peers::Driver::Llvmpipe, peers::FastPaths::On);
    if (frame_case.empty()) return say("ready " + context.description());
    const pipeline::Frame frame = find_frame_case(frame_case).build();
    if (const auto reason = peers::cannot_express(frame)) throw std::runtime_error("OpenGL has " + *reason);
    peers::GlPreparedFrame prepared(frame);
    for (int i = 0; i < 2; ++i) prepared.draw();
    check_picture(frame, prepared.read());
    say("ready " + context.description());
    while (std::getchar() != EOF) {
        char seconds[32];
        std::snprintf(seconds, sizeof seconds, "%.9f", timed_draw(prepared));
        say(seconds);
    }
}

}  // namespace

int serve_llvmpipe(const std::string& frame_case, int threads) {
    try {
        serve(frame_case, threads);
        return 0;
    } catch (const std::exception& error) {
        say(error.what());
        return 1;
    }
}

}  // namespace bench

#endif
