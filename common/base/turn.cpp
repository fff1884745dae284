#include "common/base/turn.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <utility>

namespace lightwalk {
namespace {

std::mutex turn_mutex;
std::condition_variable turn_served;
uint64_t last_ticket = 0, served_ticket = 0;
thread_local bool has_turn = false;
thread_local Turn::Spent times;
thread_local size_t items_in_turn = 0;
thread_local std::string current_activity;
thread_local std::chrono::steady_clock::time_point asked_at, taken_at;
thread_local const std::atomic<bool>* told_to_stop = nullptr;
int turns_shared = 0;

double ms_since(std::chrono::steady_clock::time_point from) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - from).count();
}

}  // namespace

bool Turn::is_mine() { return has_turn; }

Turn::Spent& Turn::spent() { return times; }
void Turn::begins(std::string activity) { current_activity = std::move(activity); }

void Turn::works(size_t items) {
    if (!has_turn) return;
    items_in_turn += items;
    times.most_items = std::max(times.most_items, items_in_turn);
}

void Turn::take() {
    asked_at = std::chrono::steady_clock::now();
    std::unique_lock lock(turn_mutex);
    const uint64_t ticket = last_ticket++;
    turn_served.wait(lock, [&] { return served_ticket == ticket; });
    has_turn = true;
    items_in_turn = 0;
    taken_at = std::chrono::steady_clock::now();
    times.waited_ms += ms_since(asked_at);
}

void Turn::give() {
    if (const double ms = ms_since(taken_at); ms > times.longest_ms) {
        times.longest_ms = ms;
        times.longest_in = current_activity;
    }
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
