#include "common/base/shared_lock.h"

#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace lightwalk {
namespace {

std::mutex queue_mutex;
std::condition_variable served;
uint64_t last_ticket = 0, served_ticket = 0;
thread_local bool holds_lock = false;
thread_local const std::atomic<bool>* told_to_stop = nullptr;
int users = 0;

}  // namespace

bool SharedLock::is_held() { return holds_lock; }

void SharedLock::lock() {
    std::unique_lock lock(queue_mutex);
    const uint64_t ticket = last_ticket++;
    served.wait(lock, [&] { return served_ticket == ticket; });
    holds_lock = true;
}

void SharedLock::unlock() {
    const std::lock_guard lock(queue_mutex);
    holds_lock = false;
    ++served_ticket;
    served.notify_all();
}

SharedLock::InUse::InUse() {
    if (users++ == 0) lock();
}

SharedLock::InUse::~InUse() {
    if (--users == 0) unlock();
}

void SharedLock::stop_when(const std::atomic<bool>* stop) { told_to_stop = stop; }

void SharedLock::check_stopped() {
    if (told_to_stop && *told_to_stop) throw Stopped();
}

}  // namespace lightwalk
