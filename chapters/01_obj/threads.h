// Distribution of work over threads.
#pragma once
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace lightwalk {

/// Runs job(thread, i) once for every i below `count`, on up to `threads` threads, each taking the next i that nobody
/// has. `thread` is below `threads`. Rethrows the exception of one job that threw; the rest is then left undone.
template <class Job>
void on_threads(unsigned threads, size_t count, Job&& job) {
    std::atomic<size_t> next = 0;
    std::exception_ptr failure;
    std::mutex failing;
    auto work = [&](unsigned thread) {
        try {
            for (size_t i; (i = next++) < count;) job(thread, i);
        } catch (...) {
            next = count;
            const std::lock_guard lock(failing);
            failure = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> others;
        const size_t wanted = std::min<size_t>(threads, count);
        for (unsigned thread = 1; thread < wanted; ++thread) others.emplace_back(work, thread);
        work(0);
    }
    if (failure) std::rethrow_exception(failure);
}

}  // namespace lightwalk
