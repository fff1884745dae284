// Progress and cancellation of work on another thread.
#pragma once
#include <atomic>

#include "common/base/error.h"

namespace lightwalk {

struct Cancelled : InputError {
    Cancelled() : InputError("cancelled") {}
};

/// Shared by worker and waiting thread. Work consists of stages; in each, `done` rises to `whole`.
struct Progress {
    std::atomic<const char*> stage{""};
    std::atomic<uint64_t> done{0}, whole{1};
    std::atomic<bool> cancelled{false};

    void begin(const char* name, uint64_t size) { done = 0, whole = size ? size : 1, stage = name; }
    /// Advances the stage. Throws Cancelled if cancellation was requested.
    void step(uint64_t size) {
        if (cancelled) throw Cancelled();
        done += size;
    }
    float share() const { return float(done) / float(whole); }
};

/// Receiver of this thread's progress; null: none. Long loops: `if (Progress* p = progress()) p->step(…)`.
inline Progress*& progress() {
    thread_local Progress* current = nullptr;
    return current;
}

}  // namespace lightwalk
