// SPDX-License-Identifier: MIT
// In place of oneTBB where the thread sanitizer looks on. It sees what orders threads only in code that is compiled for it,
// and the system's libtbb is not: each hand-over of a task would be a race to it, and suppressions that are wide enough
// for these would hide our own. This has the few entry points that are used, on threads whose start and end it sees,
// and nothing else orders. Work is dealt out in turn, so that even a little of it is on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <thread>
#include <utility>
#include <vector>

namespace tbb {

namespace info {
// More than some machines have: fewer threads have fewer races.
inline int default_concurrency() {
    return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 4, 64);
}
}  // namespace info

class global_control {
  public:
    enum parameter { max_allowed_parallelism };
    global_control(parameter, std::size_t) {}
};

namespace seen {

// Places for threads. As with oneTBB, a place that was left is another thread's only after all that was done there.
class Places {
  public:
    explicit Places(int count) : count_(std::clamp(count, 1, 64)), free_(~std::uint64_t{0} >> (64 - count_)) {}
    int count() const { return count_; }
    // -1 if none is free.
    int take() {
        std::uint64_t free = free_.load();
        while (free != 0 && !free_.compare_exchange_weak(free, free & (free - 1))) {
        }
        return free == 0 ? -1 : std::countr_zero(free);
    }
    void leave(int place) { free_.fetch_or(std::uint64_t{1} << place); }

  private:
    int count_;
    std::atomic<std::uint64_t> free_;
};

inline Places& default_places() {
    static Places places(info::default_concurrency());
    return places;
}

// Where this thread is; nowhere before it has begun any work.
struct Here {
    Places* places = nullptr;
    int place      = 0;
};
inline thread_local Here here;

class Entered {
  public:
    explicit Entered(Places& places) : before_(here) {
        if (const int place = places.take(); place >= 0) here = {&places, place};
    }
    ~Entered() {
        if (here.places != before_.places) here.places->leave(here.place);
        here = before_;
    }
    Entered(const Entered&)            = delete;
    Entered& operator=(const Entered&) = delete;

  private:
    Here before_;
};

// part(k, n) for k from 0 to n - 1, on threads of their own where places are free; n is at most `most`.
template <class Part>
void share_out(std::size_t most, const Part& part) {
    Places& places = *here.places;
    std::vector<int> taken;
    while (taken.size() + 1 < most) {
        const int place = places.take();
        if (place < 0) break;
        taken.push_back(place);
    }
    const std::size_t count = taken.size() + 1;
    std::vector<std::exception_ptr> failures(count);
    const auto run = [&](std::size_t k) {
        try {
            part(k, count);
        } catch (...) {
            failures[k] = std::current_exception();
        }
    };
    std::vector<std::thread> threads;
    for (std::size_t k = 1; k < count; ++k)
        threads.emplace_back([&places, &run, k, place = taken[k - 1]] {
            here = {&places, place};
            run(k);
        });
    run(0);
    for (std::thread& thread : threads) thread.join();
    for (const int place : taken) places.leave(place);
    for (const std::exception_ptr& failure : failures)
        if (failure) std::rethrow_exception(failure);
}

}  // namespace seen

class task_arena {
  public:
    explicit task_arena(int threads) : places_(threads) {}
    template <class Work>
    auto execute(Work&& work) {
        const seen::Entered entered(places_);
        return std::forward<Work>(work)();
    }

  private:
    seen::Places places_;
};

namespace this_task_arena {
inline int current_thread_index() {
    return seen::here.place;
}
inline int max_concurrency() {
    return seen::here.places ? seen::here.places->count() : info::default_concurrency();
}
}  // namespace this_task_arena

template <class Index, class Body>
void parallel_for(Index first, Index end, const Body& body) {
    if (!(first < end)) return;
    if (!seen::here.places) {
        const seen::Entered entered(seen::default_places());
        return parallel_for(first, end, body);
    }
    seen::share_out(static_cast<std::size_t>(end - first), [&](std::size_t k, std::size_t count) {
        for (std::size_t i = k; i < static_cast<std::size_t>(end - first); i += count)
            body(static_cast<Index>(first + static_cast<Index>(i)));
    });
}

template <class... Work>
void parallel_invoke(const Work&... work) {
    const std::function<void()> all[] = {work...};
    parallel_for(std::size_t{0}, sizeof...(work), [&](std::size_t i) { all[i](); });
}

}  // namespace tbb
