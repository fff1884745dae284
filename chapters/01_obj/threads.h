// Distribution of work over threads.
#pragma once
#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "common/base/function_ref.h"

namespace lightwalk {

/// Threads that wait for jobs, for work in several steps.
class Team {
  public:
    using Job = FunctionRef<void(unsigned, size_t)>;

    /// `threads` with the caller's own; fewer where the system has no more.
    explicit Team(size_t threads) {
        try {
            for (unsigned thread = 1; thread < threads; ++thread)
                others_.emplace_back(&Team::wait_for_jobs, this, thread);
        } catch (const std::system_error&) {}
    }
    ~Team() {
        const std::lock_guard lock(mutex_);
        ends_ = true;
        begun_.notify_all();
    }
    Team(const Team&) = delete;
    size_t threads() const { return others_.size() + 1; }

    /// Runs job(thread, i) once for every i below `count`; each thread takes the next i that nobody has. Rethrows the
    /// exception of one job that threw; the rest is then left undone.
    void run(size_t count, Job job) {
        count_ = count;
        next_ = 0;
        if (count > 1 && !others_.empty()) {
            const std::lock_guard lock(mutex_);
            job_ = &job;
            ++step_;
            begun_.notify_all();
        }
        take_jobs(0, job);
        std::unique_lock lock(mutex_);
        job_ = nullptr;
        ended_.wait(lock, [&] { return working_ == 0; });
        if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    }

  private:
    void wait_for_jobs(unsigned thread) {
        std::unique_lock lock(mutex_);
        for (size_t last = 0;; last = step_) {
            begun_.wait(lock, [&] { return ends_ || (job_ && step_ != last); });
            if (ends_) return;
            const Job job = *job_;
            ++working_;
            lock.unlock();
            take_jobs(thread, job);
            lock.lock();
            if (--working_ == 0) ended_.notify_one();
        }
    }
    void take_jobs(unsigned thread, const Job& job) {
        try {
            for (size_t i; (i = next_++) < count_;) job(thread, i);
        } catch (...) {
            next_ = count_;
            const std::lock_guard lock(mutex_);
            failure_ = std::current_exception();
        }
    }

    std::mutex mutex_;
    std::condition_variable begun_, ended_;
    const Job* job_ = nullptr;  ///< null: nobody may begin
    size_t step_ = 0, working_ = 0, count_ = 0;
    std::atomic<size_t> next_ = 0;
    std::exception_ptr failure_;
    bool ends_ = false;
    std::vector<std::jthread> others_;
};

/// One step of a Team of up to `threads`.
template <class Job>
void on_threads(unsigned threads, size_t count, Job&& job) {
    Team(std::min<size_t>(threads, count)).run(count, job);
}

}  // namespace lightwalk
