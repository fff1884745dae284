// Progress of long work on another thread, and the request to cancel it.
#pragma once
#include <atomic>

#include "common/base/error.h"

namespace lightwalk {

/// Thrown by work that was cancelled.
struct Cancelled : InputError {
    Cancelled() : InputError("cancelled") {}
};

// [progress]
/// Shared by the thread that works and the one that waits. Work is a sequence of stages; in each, `done` goes up to `whole`.
struct Progress {
    std::atomic<const char*> stage{""};
    std::atomic<uint64_t> done{0}, whole{1};
    std::atomic<bool> cancelled{false};

    void begin(const char* name, uint64_t size) { done = 0, whole = size ? size : 1, stage = name; }
    /// Of the stage, and the point at which work that was cancelled ends: throws Cancelled.
    void step(uint64_t size) {
        if (cancelled) throw Cancelled();
        done += size;
    }
    float share() const { return float(done) / float(whole); }
};

/// Receiver of this thread's progress; null: none. A loop that may take seconds reports with `if (Progress* p =
/// progress()) p->step(…)`; threads that it starts use the same pointer.
inline Progress*& progress() {
    thread_local Progress* current = nullptr;
    return current;
}
// [/progress]

}  // namespace lightwalk
