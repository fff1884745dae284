#include "common/base/guarded.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "common/base/bytes.h"
#include "common/base/error.h"
#include "common/base/progress.h"
#include "common/base/sanitized.h"
#include "common/base/text.h"

namespace lightwalk {
namespace {

bool guarded_already = false;

enum class Outcome : char { result = 'r', input_error = 'i', failure = 'f', memory = 'm' };

struct Pipe {
    int ends[2] = {-1, -1};
    Pipe() {
        if (pipe2(ends, O_CLOEXEC) != 0) throw Failure("a pipe: {}", std::strerror(errno));
        fcntl(ends[1], F_SETPIPE_SZ, 1 << 20);
    }
    ~Pipe() { shut(0), shut(1); }
    void shut(int end) {
        if (ends[end] >= 0) close(ends[end]);
        ends[end] = -1;
    }
};

void write_all(int to, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = write(to, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR) _exit(1);
        if (count > 0) bytes.remove_prefix(static_cast<size_t>(count));
    }
}

void limit(__rlimit_resource_t what, rlim_t most, rlim_t beyond = 0) {
    rlimit old;
    getrlimit(what, &old);
    const rlimit now{std::min(most, old.rlim_max), std::min(most + beyond, old.rlim_max)};
    setrlimit(what, &now);
}

size_t address_space() {
    size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<size_t>(sysconf(_SC_PAGESIZE));
}

void confine(const GuardLimits& limits) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGALRM, SIGXCPU, SIGTERM, SIGINT})
        if (!sanitized || signal > SIGALRM) std::signal(signal, SIG_DFL);
    setsid();  // no terminal to speak to
    if (const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC); nothing >= 0)
        for (int stream = 0; stream < (sanitized ? 2 : 3); ++stream) dup2(nothing, stream);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(limits.cpu_s * slower)), 1);  // a word before the end
    // A sanitizer's shadow memory takes more addresses than any limit would leave.
    if (!sanitized) limit(RLIMIT_AS, address_space() + limits.memory);
}

// The copy's whole life after fork(). It ends without destructors: they are the original's.
[[noreturn]] void live(int to, const GuardLimits& limits, const std::function<std::string()>& work) {
    guarded_already = true;
    std::string warnings, text;
    collected_warnings() = &warnings;
    confine(limits);
    Outcome outcome = Outcome::result;
    try {
        text = work();
    } catch (const InputError& e) { outcome = Outcome::input_error, text = e.what(); } catch (const std::bad_alloc&) {
        outcome = Outcome::memory;
    } catch (const std::exception& e) { outcome = Outcome::failure, text = e.what(); }
    // Large data first, so that the reader need not move it.
    ByteWriter tail;
    tail(outcome, warnings, text.size());
    tail(tail.bytes.size());
    write_all(to, text);
    write_all(to, tail.bytes);
    _exit(0);
}

using Clock = std::chrono::steady_clock;

constexpr int look_every_ms = 50;  // whether anybody still waits for the result

bool is_cancelled() { return progress() && progress()->cancelled; }

// All that the copy says until it closes its end. False if it took too long, says more than it may, or was cancelled.
bool listen(int from, Clock::time_point until, size_t most, std::string& said) {
    size_t filled = 0;
    for (;;) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
        if (left <= 0 || filled > most || is_cancelled()) return false;
        pollfd one{.fd = from, .events = POLLIN, .revents = 0};
        if (poll(&one, 1, static_cast<int>(std::min<int64_t>(left, look_every_ms))) <= 0) continue;
        if (said.size() - filled < (1 << 16)) said.resize(2 * said.size() + (1 << 16));
        const ssize_t count = read(from, said.data() + filled, said.size() - filled);
        if (count > 0) filled += static_cast<size_t>(count);
        if (count == 0) break;
    }
    said.resize(filled);
    return true;
}

[[noreturn]] void rethrow(Outcome outcome, const std::string& text, const std::string& file, const std::string& reader,
                          const GuardLimits& limits) {
    if (outcome == Outcome::input_error) throw InputError(text);
    if (outcome == Outcome::failure) throw Failure(text);
    throw InputError("{}: {} needs more than {} MiB of memory for it", file, reader, limits.memory >> 20);
}

}  // namespace

GuardLimits limits_for(size_t file_bytes) {
    return {.cpu_s = 10 + static_cast<double>(file_bytes) / 5e6, .memory = (size_t{1} << 30) + 40 * file_bytes};
}

// The grader's sandbox already contains the process, and forbids starting another.
bool guards() { return !guarded_already && !std::getenv("LIGHTWALK_SANDBOXED"); }

void stop_guarding() { guarded_already = true; }

std::string run_guarded(const std::string& file, const std::string& reader, const GuardLimits& limits,
                        const std::function<std::string()>& work) {
    if (!guards()) return work();
    Pipe pipe;
    std::fflush(nullptr);  // or the copy would say it again
    const pid_t copy = fork();
    if (copy < 0) throw Failure("a process for {}: {}", reader, std::strerror(errno));
    if (copy == 0) live(pipe.ends[1], limits, work);
    pipe.shut(1);
    const auto time = std::chrono::duration<double>(10 * limits.cpu_s * slower);
    std::string said;
    const bool in_time =
        listen(pipe.ends[0], Clock::now() + std::chrono::duration_cast<Clock::duration>(time), limits.memory, said);
    if (!in_time) kill(copy, SIGKILL);
    int status = 0;
    while (waitpid(copy, &status, 0) < 0 && errno == EINTR) {}
    if (!in_time && is_cancelled()) throw Cancelled();
    const bool out_of_time = WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU;
    if (!in_time || out_of_time)
        throw InputError("{}: {} takes more than {:.0f} s for it", file, reader, limits.cpu_s * slower);
    if (WIFSIGNALED(status)) throw InputError("{}: {} crashed on it ({})", file, reader, strsignal(WTERMSIG(status)));
    const auto unanswered = [&] { return InputError("{}: {} ended on it without an answer", file, reader); };
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw unanswered();
    size_t tail = 0, length = 0;
    if (said.size() > sizeof tail) std::memcpy(&tail, said.data() + said.size() - sizeof tail, sizeof tail);
    if (tail == 0 || tail > said.size() - sizeof tail) throw unanswered();
    ByteReader bytes(std::string_view(said).substr(said.size() - sizeof tail - tail));
    Outcome outcome{};
    std::string warnings;
    bytes(outcome, warnings, length);
    if (length != said.size() - sizeof tail - tail) throw unanswered();
    std::fputs(warnings.c_str(), stderr);
    said.resize(length);
    if (outcome != Outcome::result) rethrow(outcome, said, file, reader, limits);
    return said;
}

}  // namespace lightwalk
