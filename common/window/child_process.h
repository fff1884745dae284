// Another program of the course, started beside this one.
#pragma once
#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lightwalk {

class ChildProcess {
  public:
    enum class Kind {
        program,  ///< a person's: it has our terminal, and its end is waited for
        job,  ///< ours: no input, all that it says is kept, and it ends, with all that it started, when we let go of it
        detached  ///< nobody's: no input, no output, and it goes on without us
    };

    /// A name without a slash is looked for in $PATH. Throws Failure if it cannot be started.
    ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& options,
                 Kind kind = Kind::program);
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;

    /// Its exit code, or 128 plus the signal's number, once it has ended.
    std::optional<int> poll();

    /// Its output: standard error of a program, both streams of a job. Complete after the end.
    const std::string& said() const { return said_; }

    /// The last non-empty line of it.
    std::string last_words() const;

  private:
    void read_output();
    void stop();
    Kind kind_;
    pid_t pid_ = -1;
    int output_ = -1;  ///< reading end of the pipe
    std::string said_;
};

}  // namespace lightwalk
