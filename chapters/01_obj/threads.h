// Distribution of work over threads.
#pragma once
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace lightwalk {

/// Runs job(thread, i) once for every i below `count`; each of up to `threads` threads, the caller's among them, takes the
/// next i that nobody has. Fewer where the system has no more. Rethrows the exception of one job that threw; the rest is
/// then left undone.
template <class Job>
void on_threads(unsigned threads, size_t count, const Job& job) {
    std::atomic<size_t> next = 0;
    std::mutex mutex;
    std::exception_ptr failure;
    const auto take_jobs = [&](unsigned thread) {
        try {
            for (size_t i; (i = next++) < count;) job(thread, i);
        } catch (...) {
            next = count;
            const std::lock_guard lock(mutex);
            failure = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> others;
        try {
            for (unsigned thread = 1; thread < std::min<size_t>(threads, count); ++thread)
                others.emplace_back(take_jobs, thread);
        } catch (const std::system_error&) {}
        take_jobs(0);
    }
    if (failure) std::rethrow_exception(failure);
}

}  // namespace lightwalk
