// Forked process that runs untrusted file readers.
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
    std::string_view text, warnings;  ///< in shared memory, valid until the next request
};

class GuardCopy {
  public:
    /// Forks. The child runs `work` once, or serves requests if `work` is null.
    explicit GuardCopy(const GuardLimits* limits = nullptr, const std::function<std::string()>* work = nullptr);
    ~GuardCopy();
    GuardCopy(const GuardCopy&) = delete;

    bool request(GuardReader reader, const GuardLimits& limits, const GuardInput& input);

    enum class Wait { answered, ended, too_long, cancelled };
    Wait wait(const GuardLimits& limits, GuardAnswer& answer);
    int status();
    /// Releases memory of large results. True if the child can serve again.
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
    size_t from_ = 0, size_ = 0;
};

}  // namespace lightwalk
