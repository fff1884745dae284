#include "common/base/guard_copy.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>
#include <thread>

#include "common/base/error.h"
#include "common/base/freed_memory.h"
#include "common/base/progress.h"
#include "common/base/sanitized.h"
#include "common/base/text.h"

namespace lightwalk {

struct GuardCopy::Request {
    GuardReader reader;
    GuardLimits limits;
    size_t folder, input;  // bytes in shared memory: working folder, then the reader's input
};

struct GuardCopy::Head {
    GuardOutcome outcome;
    size_t text, warnings;
};

namespace {

size_t aligned(size_t bytes) { return (bytes + 63) / 64 * 64; }

// Soft limits only: a reused child needs new ones.
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

void begin_limits(const GuardLimits& limits) {
    rusage used;
    getrusage(RUSAGE_SELF, &used);
    const double used_s = static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
                          1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
    limit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(used_s + limits.cpu_s * slower)));
    // Sanitizers reserve more address space than any limit allows.
    if (!sanitized) limit(RLIMIT_AS, address_space() + limits.memory);
}

void end_memory_limit() { limit(RLIMIT_AS, RLIM_INFINITY); }

// Detaches from terminal, window and device of the parent, which the child may outlive.
void confine(int socket, int memory) {
    for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGALRM, SIGXCPU, SIGTERM, SIGINT})
        if (!sanitized || signal > SIGALRM) std::signal(signal, SIG_DFL);
    setsid();
    if (const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC); nothing >= 0)
        for (int stream = 0; stream < (sanitized ? 2 : 3); ++stream) dup2(nothing, stream);
    const auto first = static_cast<unsigned>(std::min(socket, memory)),
               last = static_cast<unsigned>(std::max(socket, memory));
    if (first > 3) close_range(3, first - 1, 0);
    if (last > first + 1) close_range(first + 1, last - 1, 0);
    close_range(last + 1, ~0u, 0);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
}

// Exits when the parent does. PR_SET_PDEATHSIG would react to the end of the forking thread.
void end_with_original(int socket) {
    std::thread([socket] {
        pollfd one{.fd = socket, .events = POLLRDHUP, .revents = 0};
        while (poll(&one, 1, -1) < 0 && errno == EINTR) {}
        _exit(0);
    }).detach();
}

bool receive_all(int socket, void* to, size_t count) {
    auto* at = static_cast<char*>(to);
    while (count > 0) {
        const ssize_t got = recv(socket, at, count, 0);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        at += got;
        count -= static_cast<size_t>(got);
    }
    return true;
}

bool send_all(int socket, const void* from, size_t count) {
    const auto* at = static_cast<const char*>(from);
    while (count > 0) {
        const ssize_t sent = send(socket, at, count, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return false;
        at += sent;
        count -= static_cast<size_t>(sent);
    }
    return true;
}

class SharedReply : public GuardReply {
  public:
    SharedReply(SharedBytes& shared, size_t from, size_t most) : shared_(shared), from_(from), most_(most) {}
    void append(std::string_view bytes) override {
        if (bytes.size() > most_ - count_) throw std::bad_alloc();
        if (count_ == 0) end_memory_limit();  // bounded by the mapping from here on
        // std::ranges::copy compiles to a byte loop with GCC 12.
        std::copy(bytes.begin(), bytes.end(), shared_.reach(from_ + count_ + bytes.size()) + from_ + count_);
        count_ += bytes.size();
    }
    void replace(std::string_view bytes) {
        count_ = 0;
        append(bytes.substr(0, most_));
    }
    size_t count() const { return count_; }

  private:
    SharedBytes& shared_;
    size_t from_, most_, count_ = 0;
};

}  // namespace

GuardCopy::GuardCopy(const GuardLimits* limits, const std::function<std::string()>* work) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        throw Failure("a socket: {}", std::strerror(errno));
    if (limits) shared_.grow(size_ = limits->memory);
    std::fflush(nullptr);  // buffered output would be printed twice
    copy_ = fork();
    socket_ = ends[copy_ == 0];
    if (copy_ == 0) live(limits, work);
    close(ends[1]);
    if (copy_ < 0) {
        close(socket_);
        throw Failure("a process for a reader: {}", std::strerror(errno));
    }
}

GuardCopy::~GuardCopy() {
    if (copy_ > 0) {
        kill(copy_, SIGKILL);
        status();
    }
    close(socket_);
}

// Never returns: exits without destructors, which belong to the parent.
void GuardCopy::live(const GuardLimits* limits, const std::function<std::string()>* work) {
    stop_guarding();
    progress() = nullptr;
    confine(socket_, shared_.file());
    end_with_original(socket_);
    if (work) {
        answer([&](GuardReply& reply) { reply.append((*work)()); }, *limits, 0);
    } else {
        keep_freed_memory();
        while (serve_next()) {}
    }
    _exit(0);
}

bool GuardCopy::serve_next() {
    Request one;
    if (!receive_all(socket_, &one, sizeof one)) return false;
    const char* const begin = shared_.reach(one.folder + one.input);
    std::error_code gone;
    std::filesystem::current_path(std::string(begin, one.folder), gone);
    size_ = one.limits.memory + aligned(one.folder + one.input);
    // Copied, since shared memory moves when it grows.
    const std::string input(begin + one.folder, one.input);
    answer([&](GuardReply& reply) { one.reader(input, reply); }, one.limits, aligned(one.folder + one.input));
    return true;
}

void GuardCopy::answer(const std::function<void(GuardReply&)>& work, const GuardLimits& limits, size_t from) {
    std::string warnings;
    collected_warnings() = &warnings;
    SharedReply reply(shared_, from, size_ - from);
    Head head{};
    head.outcome = GuardOutcome::result;
    begin_limits(limits);
    try {
        work(reply);
    } catch (const InputError& e) {
        head.outcome = GuardOutcome::input_error;
        reply.replace(e.what());
    } catch (const std::bad_alloc&) {
        head.outcome = GuardOutcome::memory;
        reply.replace("");
    } catch (const std::exception& e) {
        head.outcome = GuardOutcome::failure;
        reply.replace(e.what());
    }
    end_memory_limit();
    limit(RLIMIT_CPU, RLIM_INFINITY);
    head.text = reply.count();
    head.warnings = std::min(warnings.size(), size_ - from - head.text);
    reply.append(std::string_view(warnings).substr(0, head.warnings));
    collected_warnings() = nullptr;
    if (!send_all(socket_, &head, sizeof head)) _exit(0);
}

bool GuardCopy::request(GuardReader reader, const GuardLimits& limits, const GuardInput& input) {
    std::error_code gone;
    const std::string folder = std::filesystem::current_path(gone).string();
    size_t bytes = 0;
    for (const std::string_view part : input) bytes += part.size();
    from_ = aligned(folder.size() + bytes);
    shared_.grow(size_ = from_ + limits.memory);
    char* at = shared_.reach(folder.size() + bytes);
    at = std::copy(folder.begin(), folder.end(), at);
    for (const std::string_view part : input) at = std::copy(part.begin(), part.end(), at);
    const Request one{reader, limits, folder.size(), bytes};
    return send_all(socket_, &one, sizeof one);
}

GuardCopy::Wait GuardCopy::wait(const GuardLimits& limits, GuardAnswer& answer) {
    using Clock = std::chrono::steady_clock;
    constexpr int look_every_ms = 50;
    const auto time = std::chrono::duration<double>(10 * limits.cpu_s * slower);
    const auto until = Clock::now() + std::chrono::duration_cast<Clock::duration>(time);
    for (;;) {
        if (progress() && progress()->cancelled) return Wait::cancelled;
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
        if (left <= 0) return Wait::too_long;
        pollfd one{.fd = socket_, .events = POLLIN, .revents = 0};
        if (poll(&one, 1, static_cast<int>(std::min<int64_t>(left, look_every_ms))) > 0) break;
    }
    Head head;
    if (!receive_all(socket_, &head, sizeof head)) return Wait::ended;
    if (head.text > size_ - from_ || head.warnings > size_ - from_ - head.text) return Wait::ended;
    const char* const begin = shared_.reach(from_ + head.text + head.warnings) + from_;
    answer = {head.outcome, {begin, head.text}, {begin + head.text, head.warnings}};
    return Wait::answered;
}

int GuardCopy::status() {
    int status = 0;
    while (waitpid(copy_, &status, 0) < 0 && errno == EINTR) {}
    copy_ = -1;
    return status;
}

bool GuardCopy::tidy(GuardOutcome outcome) {
    shared_.release(size_t{64} << 20);
    return outcome == GuardOutcome::result || outcome == GuardOutcome::input_error;
}

}  // namespace lightwalk
