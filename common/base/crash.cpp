#include "common/base/crash.h"

#include <sys/mman.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <exception>
#include <initializer_list>
#include <new>

#include "common/base/sanitized.h"

namespace lightwalk {
namespace {

constexpr size_t little = size_t{256} << 20;  // bytes; failing to allocate this many means out of memory

// Async-signal-safe.
void say(const char* text) { [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text, std::strlen(text)); }

[[noreturn]] void end_without_memory() {
    say("error: there is not enough memory for this\n");
    _exit(1);
}

const char* words_for(int signal) {
    switch (signal) {
        case SIGSEGV:
            return "error: crashed (Segmentation fault)\n";
        case SIGBUS:
            return "error: crashed (Bus error)\n";
        case SIGFPE:
            return "error: crashed (Arithmetic exception)\n";
        case SIGILL:
            return "error: crashed (Illegal instruction)\n";
        default:
            return "error: crashed (Aborted)\n";
    }
}

void on_crash(int signal) {
    void* const memory = mmap(nullptr, little, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) end_without_memory();
    say(words_for(signal));
    std::signal(signal, SIG_DFL);
    raise(signal);  // delivered after the handler returns
}

std::terminate_handler terminate_otherwise = nullptr;

// Code without exceptions, such as LLVM, terminates when memory runs out.
void on_terminate() {
    try {
        if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
    } catch (const std::bad_alloc&) { end_without_memory(); } catch (...) {
    }
    terminate_otherwise();
}

}  // namespace

void say_crashes() {
    if (sanitized) return;
    static char stack[1 << 16];  // separate stack, in case of stack overflow
    const stack_t other{.ss_sp = stack, .ss_flags = 0, .ss_size = sizeof stack};
    sigaltstack(&other, nullptr);
    struct sigaction action = {};
    action.sa_handler = on_crash;
    action.sa_flags = SA_ONSTACK;
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGABRT, SIGILL}) sigaction(signal, &action, nullptr);
    terminate_otherwise = std::set_terminate(on_terminate);
}

}  // namespace lightwalk
