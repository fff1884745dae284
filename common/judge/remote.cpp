#include "common/judge/remote.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cfenv>
#include <chrono>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <locale>
#include <random>

#include "common/check/guard.h"
#include "common/check/run_checks.h"
#include "common/judge/channel.h"

namespace lightwalk {
namespace {

// "record_mist" of "02.record_mist try_record_mist".
std::string name_of(const std::string& id) { return id.substr(3, std::min(id.find(' '), id.size()) - 3); }

bool writes_commas() {
    return *std::localeconv()->decimal_point == ',' ||
           std::use_facet<std::numpunct<char>>(std::locale()).decimal_point() == ',';
}

class Asking {
  public:
    Asking() {
        if (std::sscanf(check_options().worker.c_str(), "%d,%d", &to_, &from_) != 2)
            throw Failure("there is no process to ask: the grader starts this program (./course grade)");
        for (const int fd : {to_, from_}) fcntl(fd, F_SETFL, fcntl(fd, F_GETFL) | O_NONBLOCK);
        std::signal(SIGPIPE, SIG_IGN);
    }

    std::string ask(const std::string& id, const std::string& arguments) {
        if (!lost_.empty()) throw Lost(lost_);
        // A trial looks after the time of its calls itself.
        const bool trial = id.find(' ') != id.npos;
        deadline_ =
            std::chrono::steady_clock::now() + std::chrono::milliseconds(trial ? 20000 : 1000 * most_wait_s() + 1500);
        channel::Request request{.nonce = nonce(), .id = id, .commas = writes_commas(), .arguments = arguments};
        const std::string bytes = channel::packed(request);
        // A copy: guard_call changes what guarded() refers to. NOLINTNEXTLINE(performance-unnecessary-copy-initialization)
        const std::string before = guarded(), what = before.empty() ? name_of(id) : before;
        guard_call("");  // from here on the clock is this deadline
        send(bytes, what);
        channel::Reply reply;
        try {
            const std::string length = receive(8, what);
            std::string_view rest = length;
            uint64_t count = 0;
            wire::take(rest, count);
            if (count > wire::most_bytes) lose(what + " gave an answer without an end");
            const std::string body = receive(count, what);
            rest = body;
            wire::take(rest, reply);
        } catch (const Lost&) { throw; } catch (const Failure&) {
            lose(what + " gave no answer that can be read");
        }
        if (reply.nonce != request.nonce) lose(what + " gave an answer to what nobody had asked");
        if (!before.empty()) guard_call(before);
        if (reply.kind != channel::Kind::result && reply.bytes.size() > 2000) reply.bytes.resize(2000);
        switch (reply.kind) {
            case channel::Kind::result:
                std::feraiseexcept(static_cast<int>(reply.exceptions) & FE_ALL_EXCEPT);
                return reply.bytes;
            case channel::Kind::input_error:
                throw InputError("{}", reply.bytes);
            case channel::Kind::exception:
                throw std::runtime_error(reply.bytes);
            default:
                lose(what + " " + reply.bytes);
        }
    }

  private:
    static uint64_t nonce() {
        static std::random_device device;
        return uint64_t(device()) << 32 | device();
    }

    [[noreturn]] void lose(const std::string& why) {
        lost_ = why;
        throw Lost(why);
    }

    [[noreturn]] void lose_time(const std::string& what) {
        lose(what + " did not return within " + std::to_string(call_limit_s()) + " s: does a loop never end?");
    }

    // Waits until `fd` is ready; false if the time is over.
    bool ready(int fd, short events) const {
        for (;;) {
            const auto left =
                std::chrono::duration_cast<std::chrono::milliseconds>(deadline_ - std::chrono::steady_clock::now());
            pollfd one{fd, events, 0};
            const int found = left.count() > 0 ? poll(&one, 1, static_cast<int>(left.count())) : 0;
            if (found >= 0 || errno != EINTR) return found > 0;
        }
    }

    void send(const std::string& bytes, const std::string& what) {
        for (size_t at = 0; at < bytes.size();) {
            const ssize_t count = write(to_, bytes.data() + at, bytes.size() - at);
            if (count > 0) {
                at += static_cast<size_t>(count);
            } else if (errno == EAGAIN) {
                if (!ready(to_, POLLOUT)) lose_time(what);
            } else if (errno != EINTR) {
                lose(what + " cannot be called: the program ended before, by itself");
            }
        }
    }

    std::string receive(size_t count, const std::string& what) {
        std::string bytes;
        char buffer[65536];
        while (bytes.size() < count) {
            if (!ready(from_, POLLIN)) lose_time(what);
            const ssize_t got = read(from_, buffer, std::min(sizeof buffer, count - bytes.size()));
            if (got > 0)
                bytes.append(buffer, static_cast<size_t>(got));
            else if (got == 0)
                lose(what + " ended the program, or was ended: it calls exit, or takes too much memory or time");
            else if (errno != EAGAIN && errno != EINTR)
                lose(what + " gave no answer");
        }
        return bytes;
    }

    int to_ = -1, from_ = -1;
    std::chrono::steady_clock::time_point deadline_;
    std::string lost_;
};

}  // namespace

std::string ask(const std::string& id, const std::string& arguments) {
    static Asking asking;
    return asking.ask(id, arguments);
}

void refuse_to_ask(const std::string& id) {
    throw Failure("{} cannot be called in another process: its check needs a TRIAL (common/check/trial.h)", id);
}

}  // namespace lightwalk
