// Process copied from this one that runs foreign readers.
#pragma once
#include <sys/types.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "common/base/guarded.h"
#include "common/base/shared_bytes.h"

namespace lightwalk {

enum class GuardOutcome : char { result = 'r', input_error = 'i', failure = 'f', memory = 'm' };

struct GuardAnswer {
    GuardOutcome outcome{};
    std::string_view text, warnings;  ///< in the shared memory, until the next request
};

class GuardCopy {
  public:
    /// Copies this process (fork). The copy runs `work` once, or serves requests while `work` is null.
    explicit GuardCopy(const GuardLimits* limits = nullptr, const std::function<std::string()>* work = nullptr);
    ~GuardCopy();  ///< Ends the copy.
    GuardCopy(const GuardCopy&) = delete;

    /// False where the copy has ended meanwhile.
    bool request(GuardReader reader, const GuardLimits& limits, const GuardInput& input);

    enum class Wait { answered, ended, too_long, cancelled };
    Wait wait(const GuardLimits& limits, GuardAnswer& answer);
    /// Of waitpid(), for a copy that ended.
    int status();
    /// Gives large results' memory back; true where the copy may serve again.
    bool tidy(GuardOutcome outcome);

  private:
    struct Request;
    struct Head;
    [[noreturn]] void live(const GuardLimits* limits, const std::function<std::string()>* work);
    bool serve_next();
    void answer(const std::function<void(GuardReply&)>& work, const GuardLimits& limits, size_t from);

    SharedBytes shared_;
    int socket_ = -1;
    pid_t copy_ = -1;
    size_t from_ = 0, size_ = 0;  ///< of the answer in the shared memory
};

}  // namespace lightwalk
