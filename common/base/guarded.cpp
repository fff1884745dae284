#include "common/base/guarded.h"

#include <sys/wait.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <mutex>
#include <vector>

#include "common/base/error.h"
#include "common/base/guard_copy.h"
#include "common/base/progress.h"
#include "common/base/sanitized.h"

namespace lightwalk {
namespace {

bool guarded_already = false;

std::mutex idle_mutex;

// Never destroyed: children exit with this process.
std::vector<std::unique_ptr<GuardCopy>>& idle() {
    static auto& all = *new std::vector<std::unique_ptr<GuardCopy>>;
    return all;
}

std::unique_ptr<GuardCopy> take_idle() {
    const std::lock_guard lock(idle_mutex);
    if (idle().empty()) return nullptr;
    std::unique_ptr<GuardCopy> one = std::move(idle().back());
    idle().pop_back();
    return one;
}

void give_back(std::unique_ptr<GuardCopy> copy) {
    const std::lock_guard lock(idle_mutex);
    idle().push_back(std::move(copy));
}

struct Asked {
    const std::string &name, &reader;
    const GuardLimits& limits;
};

GuardAnswer answer_of(GuardCopy& copy, const Asked& file) {
    GuardAnswer answer;
    const GuardCopy::Wait waited = copy.wait(file.limits, answer);
    if (waited == GuardCopy::Wait::answered) return answer;
    if (waited == GuardCopy::Wait::cancelled) throw Cancelled();
    const int status = waited == GuardCopy::Wait::ended ? copy.status() : 0;
    const bool out_of_time = WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU;
    if (waited == GuardCopy::Wait::too_long || out_of_time)
        throw InputError("{}: {} takes more than {:.0f} s for it", file.name, file.reader, file.limits.cpu_s * slower);
    if (WIFSIGNALED(status))
        throw InputError("{}: {} crashed on it ({})", file.name, file.reader, strsignal(WTERMSIG(status)));
    throw InputError("{}: {} ended on it without an answer", file.name, file.reader);
}

void throw_unless_result(const GuardAnswer& answer, const Asked& file) {
    std::fwrite(answer.warnings.data(), 1, answer.warnings.size(), stderr);
    if (answer.outcome == GuardOutcome::result) return;
    const std::string text(answer.text);
    if (answer.outcome == GuardOutcome::input_error) throw InputError(text);
    if (answer.outcome == GuardOutcome::failure) throw Failure(text);
    throw InputError("{}: {} needs more than {} MiB of memory for it", file.name, file.reader,
                     file.limits.memory >> 20);
}

struct ReplyHere : GuardReply {
    std::string bytes;
    void append(std::string_view more) override { bytes += more; }
};

}  // namespace

GuardLimits limits_for(size_t file_bytes) {
    return {.cpu_s = 10 + static_cast<double>(file_bytes) / 5e6, .memory = (size_t{1} << 30) + 40 * file_bytes};
}

// The grader's sandbox already isolates the process, and forbids forking.
bool guards() { return !guarded_already && !std::getenv("LIGHTWALK_SANDBOXED"); }

void stop_guarding() { guarded_already = true; }

std::string run_guarded(const std::string& file, const std::string& reader, const GuardLimits& limits,
                        const std::function<std::string()>& work) {
    if (!guards()) return work();
    const Asked of{file, reader, limits};
    GuardCopy copy(&limits, &work);
    const GuardAnswer answer = answer_of(copy, of);
    throw_unless_result(answer, of);
    return std::string(answer.text);
}

void read_guarded(const GuardJob& reader, const GuardLimits& limits, const GuardInput& input,
                  const std::function<void(std::string_view)>& receive) {
    if (!guards()) {
        std::string whole;
        for (const std::string_view part : input) whole += part;
        ReplyHere reply;
        reader.read(whole, reply);
        return receive(reply.bytes);
    }
    std::unique_ptr<GuardCopy> copy = take_idle();
    if (!copy || !copy->request(reader.read, limits, input)) {
        copy = std::make_unique<GuardCopy>();
        copy->request(reader.read, limits, input);
    }
    const Asked of{reader.file, reader.name, limits};
    const GuardAnswer answer = answer_of(*copy, of);
    const auto end = [&] {
        if (copy->tidy(answer.outcome)) give_back(std::move(copy));
    };
    try {
        throw_unless_result(answer, of);
        receive(answer.text);
    } catch (...) {
        end();
        throw;
    }
    end();
}

void prepare_guard() {
    if (guards()) give_back(std::make_unique<GuardCopy>());
}

}  // namespace lightwalk
