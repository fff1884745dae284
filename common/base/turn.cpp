#include "common/base/turn.h"

#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace lightwalk {
namespace {

std::mutex turn_mutex;
std::condition_variable turn_served;
uint64_t last_ticket = 0, served_ticket = 0;
thread_local bool has_turn = false;
thread_local const std::atomic<bool>* told_to_stop = nullptr;
int turns_shared = 0;

}  // namespace

bool Turn::is_mine() { return has_turn; }

void Turn::take() {
    std::unique_lock lock(turn_mutex);
    const uint64_t ticket = last_ticket++;
    turn_served.wait(lock, [&] { return served_ticket == ticket; });
    has_turn = true;
}

void Turn::give() {
    const std::lock_guard lock(turn_mutex);
    has_turn = false;
    ++served_ticket;
    turn_served.notify_all();
}

Turn::Shared::Shared() {
    if (turns_shared++ == 0) take();
}

Turn::Shared::~Shared() {
    if (--turns_shared == 0) give();
}

void Turn::stop_when(const std::atomic<bool>* stop) { told_to_stop = stop; }

void Turn::check_stopped() {
    if (told_to_stop && *told_to_stop) throw Stopped();
}

}  // namespace lightwalk
