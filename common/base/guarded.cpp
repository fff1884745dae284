#include "common/base/guarded.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <initializer_list>
#include <new>

#include "common/base/error.h"
#include "common/base/progress.h"
#include "common/base/sanitized.h"
#include "common/base/text.h"

namespace lightwalk {

namespace {

enum class Outcome : char { result, input_error, failure, memory };

// Last bytes of an answer, after its text and its warnings.
struct Tail {
    Outcome outcome;
    size_t warnings;
};

bool guarded_already = false;

void limit(__rlimit_resource_t what, rlim_t most) {
    rlimit one;
    getrlimit(what, &one);
    one.rlim_cur = std::min(most, one.rlim_max);
    setrlimit(what, &one);
}

size_t address_space() {
    size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<size_t>(sysconf(_SC_PAGESIZE));
}

// Detaches the process from terminal, window and device of its parent, and ends it when the parent ends.
void confine(int answer, pid_t parent, const GuardLimits& limits) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);
    for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGALRM, SIGXCPU, SIGTERM, SIGINT})
        if (!sanitized || signal > SIGALRM) std::signal(signal, SIG_DFL);
    setsid();
    if (const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC); nothing >= 0)
        for (int stream = 0; stream < (sanitized ? 2 : 3); ++stream) dup2(nothing, stream);
    if (answer > 3) close_range(3, static_cast<unsigned>(answer) - 1, 0);
    close_range(static_cast<unsigned>(answer) + 1, ~0u, 0);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(limits.cpu_s * slower)));  // a new process has used none
    // Sanitizers reserve more address space than any limit allows.
    if (!sanitized) limit(RLIMIT_AS, address_space() + limits.memory);
}

void send_all(int to, const void* from, size_t count) {
    const auto* at = static_cast<const char*>(from);
    while (count > 0) {
        const ssize_t sent = write(to, at, count);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) _exit(1);
        at += sent;
        count -= static_cast<size_t>(sent);
    }
}

// Exits without destructors, which belong to the parent.
[[noreturn]] void answer(int to, const std::function<std::string()>& work) {
    stop_guarding();
    progress() = nullptr;
    std::string text, warnings;
    collected_warnings() = &warnings;
    Tail tail{};
    try {
        text = work();
    } catch (const InputError& e) {
        tail.outcome = Outcome::input_error;
        text = e.what();
    } catch (const std::bad_alloc&) { tail.outcome = Outcome::memory; } catch (const std::exception& e) {
        tail.outcome = Outcome::failure;
        text = e.what();
    }
    tail.warnings = warnings.size();
    send_all(to, text.data(), text.size());
    send_all(to, warnings.data(), warnings.size());
    send_all(to, &tail, sizeof tail);
    _exit(0);
}

// The reader's process, which ends with this object.
class Reader {
  public:
    Reader(const GuardLimits& limits, const std::function<std::string()>& work) {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0) throw Failure("a pipe: {}", std::strerror(errno));
        fcntl(ends[1], F_SETPIPE_SZ, 1 << 20);
        std::fflush(nullptr);  // buffered output would be printed twice
        const pid_t parent = getpid();
        process_ = fork();
        if (process_ == 0) {
            confine(ends[1], parent, limits);
            answer(ends[1], work);
        }
        from_ = ends[0];
        close(ends[1]);
        if (process_ < 0) {
            close(from_);
            throw Failure("a process for a reader: {}", std::strerror(errno));
        }
    }
    ~Reader() {
        if (process_ > 0) {
            kill(process_, SIGKILL);
            status();
        }
        close(from_);
    }
    Reader(const Reader&) = delete;

    /// All bytes until the process closes the pipe; false if they are too many or come too late.
    bool read_all(std::string& bytes, const GuardLimits& limits) const {
        using Clock = std::chrono::steady_clock;
        constexpr int look_every_ms = 50;
        constexpr size_t piece = 1 << 20;
        const auto until = Clock::now() + std::chrono::duration<double>(10 * limits.cpu_s * slower);
        while (Clock::now() < until && bytes.size() <= limits.memory + sizeof(Tail)) {
            if (progress() && progress()->cancelled) throw Cancelled();
            pollfd one{.fd = from_, .events = POLLIN, .revents = 0};
            if (poll(&one, 1, look_every_ms) <= 0) continue;
            const size_t before = bytes.size();
            bytes.resize(before + piece);
            const ssize_t got = read(from_, bytes.data() + before, piece);
            bytes.resize(before + static_cast<size_t>(std::max<ssize_t>(got, 0)));
            if (got == 0) return true;
        }
        return false;
    }
    int status() {
        int status = 0;
        while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {}
        process_ = -1;
        return status;
    }

  private:
    int from_ = -1;
    pid_t process_ = -1;
};

}  // namespace

GuardLimits limits_for(size_t file_bytes) {
    return {.cpu_s = 10 + static_cast<double>(file_bytes) / 5e6, .memory = (size_t{1} << 30) + 40 * file_bytes};
}

// The grader's sandbox already isolates the process, and forbids forking.
bool guards() { return !guarded_already && !std::getenv("LIGHTWALK_SANDBOXED"); }

void stop_guarding() { guarded_already = true; }

std::string run_guarded(const std::string& file, const std::string& name, const GuardLimits& limits,
                        const std::function<std::string()>& work) {
    if (!guards()) return work();
    Reader reader(limits, work);
    std::string text;
    const bool is_whole = reader.read_all(text, limits);
    const int status = is_whole ? reader.status() : 0;
    const bool is_large = text.size() > limits.memory + sizeof(Tail);
    if ((!is_whole && !is_large) || (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU))
        throw InputError("{}: {} takes more than {:.0f} s for it", file, name, limits.cpu_s * slower);
    if (WIFSIGNALED(status)) throw InputError("{}: {} crashed on it ({})", file, name, strsignal(WTERMSIG(status)));
    Tail tail{};
    const size_t size = text.size() - std::min(text.size(), sizeof tail);
    if (text.size() >= sizeof tail) std::memcpy(&tail, text.data() + size, sizeof tail);
    if (is_large) tail = {Outcome::memory, 0};
    if (text.size() < sizeof tail || tail.warnings > size)
        throw InputError("{}: {} ended on it without an answer", file, name);
    std::fwrite(text.data() + size - tail.warnings, 1, tail.warnings, stderr);
    text.resize(size - tail.warnings);
    if (tail.outcome == Outcome::input_error) throw InputError(text);
    if (tail.outcome == Outcome::failure) throw Failure(text);
    if (tail.outcome == Outcome::memory)
        throw InputError("{}: {} needs more than {} MiB of memory for it", file, name, limits.memory >> 20);
    return text;
}

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
