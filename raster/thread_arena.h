// SPDX-License-Identifier: MIT
// Runs work on a given number of threads, which may be more than there are cores. 0: as many as there are cores.
#pragma once

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <utility>

namespace raster {

class ThreadArena {
  public:
    explicit ThreadArena(int threads)
        : threads_(threads > 0 ? threads : tbb::info::default_concurrency()),
          limit_(tbb::global_control::max_allowed_parallelism,
                 static_cast<std::size_t>(std::max(threads_, tbb::info::default_concurrency()))),
          arena_(threads_) {}

    template <class Work>
    auto run(Work&& work) {
        return arena_.execute(std::forward<Work>(work));
    }

  private:
    int threads_;
    tbb::global_control limit_;
    tbb::task_arena arena_;
};

}  // namespace raster
