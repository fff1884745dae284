#include "common/check/guard.h"

#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <ctime>
#include <utility>

namespace lightwalk {
namespace {

// Sanitizers have better handlers, and slow everything down.
#ifdef __SANITIZE_ADDRESS__
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

std::string current;
std::function<void(const std::string&)> tell;

std::string words_for(int signal) {
    switch (signal) {
        case SIGALRM:
            return "did not return within " + std::to_string(call_limit_s()) + " s: does a loop never end?";
        case SIGSEGV:
        case SIGBUS:
            return "crashed: it reads or writes memory that is not its own, as a loop does that never ends, or calls "
                   "itself "
                   "without an end";
        case SIGFPE:
            return "crashed: it divides an integer by 0";
        default:
            return "gave up: an exception that nobody caught, an index outside a checked container, or memory freed "
                   "twice";
    }
}

// Of all threads of this process.
double processor_s() {
    timespec used{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    return double(used.tv_sec) + 1e-9 * double(used.tv_nsec);
}

double began_s = 0;  ///< processor_s() when the call began
int waited_s = 0;

// A busy machine gives a call little of its processors: the clock alone ends only a call that sleeps.
constexpr int clock_factor = 6;

// Not async-signal-safe, which is acceptable since the program exits.
void give_up(int signal) {
    if (signal == SIGALRM && processor_s() - began_s < 0.9 * call_limit_s() &&
        waited_s < clock_factor * call_limit_s()) {
        ++waited_s;
        alarm(1);
        return;
    }
    std::signal(signal, SIG_DFL);
    std::signal(SIGALRM, SIG_DFL);
    alarm(2);
    tell((current.empty() ? "the check" : current) + " " + words_for(signal));
    _exit(1);
}

}  // namespace

int most_wait_s() { return clock_factor * call_limit_s(); }

int call_limit_s() {
    static const char* const given = std::getenv("LIGHTWALK_TIMEOUT_S");
    static const int limit = given ? std::atoi(given) : 0;
    return limit > 0 ? limit : 5;
}

void guard_calls(std::function<void(const std::string&)> report) {
    tell = std::move(report);
    if (sanitized) return;
    static char stack[1 << 16];
    const stack_t other{.ss_sp = stack, .ss_flags = 0, .ss_size = sizeof stack};
    sigaltstack(&other, nullptr);
    struct sigaction action = {};
    action.sa_handler = give_up;
    action.sa_flags = SA_ONSTACK;
    for (const int signal : {SIGALRM, SIGSEGV, SIGBUS, SIGFPE, SIGABRT, SIGILL}) sigaction(signal, &action, nullptr);
}

void guard_call(std::string what) {
    current = std::move(what);
    began_s = processor_s();
    waited_s = call_limit_s();
    if (!sanitized) alarm(current.empty() ? 0u : static_cast<unsigned>(call_limit_s()));
}

const std::string& guarded() { return current; }

}  // namespace lightwalk
