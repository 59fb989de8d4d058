// SPDX-License-Identifier: MIT
#include "tests/bench/benchmarks.h"

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <thread>

#include "pipeline/execute/execute.h"
#include "tests/bench/child.h"
#include "tests/bench/frames.h"
#include "tests/bench/llvmpipe_child.h"

namespace bench {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::string_view kMemoryCase = "frame/canyon_1080p";

// A benchmark is called several times, until it runs for long enough. What the calls share is kept, but of one case
// only.
struct Kept {
    std::string name;
    pipeline::Frame frame;
    pipeline::Executor executor;
    pipeline::Execution execution;
};
Kept& kept_frame(const FrameCase& frame_case) {
    static std::unique_ptr<Kept> kept;
    if (!kept || kept->name != frame_case.name) {
        kept.reset();
        kept.reset(new Kept{frame_case.name, frame_case.build(), {}, {}});
    }
    return *kept;
}

LlvmpipeChild& kept_child(const FrameCase& frame_case, int threads) {
    static std::unique_ptr<LlvmpipeChild> kept;
    static std::string key;
    const std::string wanted = frame_case.name + " " + std::to_string(threads);
    if (!kept || key != wanted) {
        kept.reset();
        kept = std::make_unique<LlvmpipeChild>(frame_case.name, threads);
        key  = wanted;
    }
    return *kept;
}

void count_work(benchmark::State& state, const FrameCase& frame_case) {
    if (frame_case.size > 0.0) state.counters["size"] = frame_case.size;
    if (frame_case.work == 0.0) return;
    state.counters[std::string(frame_case.unit) + "_per_second"] =
        benchmark::Counter(frame_case.work, benchmark::Counter::kIsIterationInvariantRate);
}

double peak_memory_mb(const FrameCase& frame_case, int threads) {
    return std::stod(Child({kPeakMemoryArgument, frame_case.name, std::to_string(threads)}).read_line());
}

void time_nimbus7(benchmark::State& state, const FrameCase& frame_case, int threads) {
    Kept& kept      = kept_frame(frame_case);
    const auto draw = [&] {
        kept.executor.execute(kept.frame, kept.execution, {.threads = threads, .counts_fragments = false});
        benchmark::DoNotOptimize(kept.execution.output.pixels.data());
    };
    draw();
    for ([[maybe_unused]] auto _ : state) {
        const Clock::time_point start = Clock::now();
        draw();
        state.SetIterationTime(std::chrono::duration<double>(Clock::now() - start).count());
    }
    count_work(state, frame_case);
    if (frame_case.name == kMemoryCase) state.counters["peak_memory_mb"] = peak_memory_mb(frame_case, threads);
}

void time_llvmpipe(benchmark::State& state, const FrameCase& frame_case, int threads) {
    try {
        LlvmpipeChild& child = kept_child(frame_case, threads);
        for ([[maybe_unused]] auto _ : state) state.SetIterationTime(child.draw());
        count_work(state, frame_case);
    } catch (const std::runtime_error& error) {
        state.SkipWithError(error.what());
    }
}

using Function = void (*)(benchmark::State&, const FrameCase&, int threads);

benchmark::internal::Benchmark* add(const std::string& name, Function function, const FrameCase& frame_case,
                                    int threads) {
    return benchmark::RegisterBenchmark(
               name.c_str(), [=, &frame_case](benchmark::State& state) { function(state, frame_case, threads); })
        ->Unit(benchmark::kMillisecond)
        ->UseManualTime();
}

// Both executors, each with these many threads.
void add_both(const FrameCase& frame_case, std::initializer_list<int> thread_counts) {
    const auto suffix = [&](int threads) {
        return thread_counts.size() > 1 ? "/threads:" + std::to_string(threads) : std::string();
    };
    for (const int threads : thread_counts)
        add(frame_case.name + "/nimbus7" + suffix(threads), &time_nimbus7, frame_case, threads);
    for (const int threads : thread_counts)
        add(frame_case.name + "/llvmpipe" + suffix(threads), &time_llvmpipe, frame_case, threads);
}

// 1, 2, 4, ... and all.
void add_thread_counts(int all_cores) {
    static const FrameCase canyon = find_frame_case("growth/canyon/1080p");
    for (int threads = 1; threads < 2 * all_cores; threads *= 2) {
        const int count = std::min(threads, all_cores);
        benchmark::RegisterBenchmark(("growth/threads/" + std::to_string(count)).c_str(),
                                     [count](benchmark::State& state) {
                                         time_nimbus7(state, canyon, count);
                                         state.counters["size"] = count;
                                     })
            ->Unit(benchmark::kMillisecond)
            ->UseManualTime();
    }
}

}  // namespace

int print_peak_memory(const std::string& frame_case, int threads) {
    const pipeline::Frame frame = find_frame_case(frame_case).build();
    pipeline::Executor executor;
    pipeline::Execution execution;
    for (int i = 0; i < 3; ++i) executor.execute(frame, execution, {.threads = threads});
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    std::printf("%.1f\n", static_cast<double>(usage.ru_maxrss) / 1024.0);
    return 0;
}

void register_benchmarks(int threads) {
    const int all_cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    for (const FrameCase& each : frame_cases()) {
        if (each.name.starts_with("fill/") || each.name.starts_with("triangles/"))
            add_both(each, {threads});
        else if (each.name.starts_with("frame/"))
            add_both(each, {1, 2});
        else if (each.name.starts_with("growth/canyon/"))
            add(each.name + "/nimbus7", &time_nimbus7, each, all_cores);
        else if (each.name.starts_with("growth/"))
            add(each.name, &time_nimbus7, each, all_cores);
        else
            for (const int count : {1, 2})
                add(each.name + "/nimbus7/threads:" + std::to_string(count), &time_nimbus7, each, count);
    }
    add_thread_counts(all_cores);
    register_image_peers();
}

}  // namespace bench
