// Cooperative threads: one at a time uses shared state, the others compute.
#pragma once
#include <atomic>

namespace lightwalk {

/// Global lock with a fair queue. No effect until an InUse exists.
class SharedLock {
  public:
    static bool is_held();
    static void lock();
    static void unlock();

    /// Enables the lock: the creating thread holds it until the last InUse is destroyed.
    class InUse {
      public:
        InUse();
        ~InUse();
        InUse(const InUse&) = delete;
    };

    struct Stopped {};
    /// Makes unlocked() in this thread throw Stopped once `stop` is true; null: never.
    static void stop_when(const std::atomic<bool>* stop);
    static void check_stopped();

    /// Releases the lock within a scope, if this thread holds it.
    class Unlocked {
      public:
        Unlocked() : given_(is_held()) {
            if (given_) unlock();
        }
        ~Unlocked() {
            if (given_) lock();
        }
        Unlocked(const Unlocked&) = delete;

      private:
        const bool given_;
    };
};

/// Runs `work` without the lock: files, noise, compilation, waits. `work` must not touch shared state.
template <class Work>
decltype(auto) unlocked(const Work& work) {
    SharedLock::check_stopped();
    const SharedLock::Unlocked others;
    return work();
}

}  // namespace lightwalk
