#include "common/base/turn.h"

#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace lightwalk {
namespace {

std::mutex mutex;
std::condition_variable changed;
uint64_t next = 0, served = 0;  // tickets: a thread that gives its turn and asks again stands behind the others
thread_local bool mine = false;
thread_local const std::atomic<bool>* stopped = nullptr;
int sharing = 0;

}  // namespace

bool Turn::is_mine() { return mine; }

void Turn::take() {
    std::unique_lock lock(mutex);
    const uint64_t ticket = next++;
    changed.wait(lock, [&] { return served == ticket; });
    mine = true;
}

void Turn::give() {
    const std::lock_guard lock(mutex);
    mine = false;
    ++served;
    changed.notify_all();
}

Turn::Shared::Shared() {
    if (sharing++ == 0) take();
}

Turn::Shared::~Shared() {
    if (--sharing == 0) give();
}

void Turn::stop_when(const std::atomic<bool>* stop) { stopped = stop; }

void Turn::check_stopped() {
    if (stopped && *stopped) throw Stopped();
}

}  // namespace lightwalk
