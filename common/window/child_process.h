// Another program of the course, started and waited for.
#pragma once
#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lightwalk {

/// Runs until it ends by itself; what it says on standard error is kept and passed on.
class ChildProcess {
  public:
    /// Throws Failure where it cannot be started.
    ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& options);
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;

    /// Its exit code, or 128 plus the signal's number, once it has ended.
    std::optional<int> poll();

    /// The last line it wrote to standard error; complete after the end.
    const std::string& last_words() const { return last_words_; }

  private:
    void read_errors();
    pid_t pid_ = -1;
    int errors_ = -1;  ///< the reading end of its standard error
    std::string line_, last_words_;
};

}  // namespace lightwalk
