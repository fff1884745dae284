// Turns of threads on what they share: one makes and records, the others compute meanwhile.
#pragma once
#include <atomic>

namespace lightwalk {

// [turn]
/// The process's turn. While no Shared exists no thread has it, and nothing below does anything.
class Turn {
  public:
    static bool is_mine();
    static void take();  ///< waits behind all threads that asked before
    static void give();

    /// Held by those who start further threads: their own thread has the turn until the last of these goes.
    class Shared {
      public:
        Shared();
        ~Shared();
        Shared(const Shared&) = delete;
    };

    /// Thrown by aside() in a thread that shall end.
    struct Stopped {};
    /// In this thread, aside() throws Stopped once `stop` is true; null: never.
    static void stop_when(const std::atomic<bool>* stop);
    static void check_stopped();

    /// The turn is given for as long as this lives, if this thread has it.
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

/// Runs `work` while others have the turn: files, noise, compilation, waits. It touches nothing that threads share.
template <class Work>
decltype(auto) aside(const Work& work) {
    Turn::check_stopped();
    const Turn::Aside others;
    return work();
}
// [/turn]

}  // namespace lightwalk
