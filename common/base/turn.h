// Cooperative threads: one at a time uses shared state, the others compute.
#pragma once
#include <atomic>

namespace lightwalk {

/// Global lock with a fair queue. No effect until a Shared exists.
class Turn {
  public:
    static bool is_mine();
    static void take();
    static void give();

    /// Enables the lock: the creating thread holds the turn until the last Shared is destroyed.
    class Shared {
      public:
        Shared();
        ~Shared();
        Shared(const Shared&) = delete;
    };

    struct Stopped {};
    /// Makes aside() in this thread throw Stopped once `stop` is true; null: never.
    static void stop_when(const std::atomic<bool>* stop);
    static void check_stopped();

    /// Releases the turn within a scope, if this thread holds it.
    class Aside {
      public:
        Aside() : given_(is_mine()) {
            if (given_) give();
        }
        ~Aside() {
            if (given_) take();
        }
        Aside(const Aside&) = delete;

      private:
        const bool given_;
    };
};

/// Runs `work` without the turn: files, noise, compilation, waits. `work` must not touch shared state.
template <class Work>
decltype(auto) aside(const Work& work) {
    Turn::check_stopped();
    const Turn::Aside others;
    return work();
}

}  // namespace lightwalk
