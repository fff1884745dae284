// The checks of exercises, run beside the window by the program that ./course check is.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "common/window/child_process.h"

namespace lightwalk {

/// What a check has said of an exercise.
struct CheckVerdict {
    enum class State {
        running,
        passed,
        open,     ///< something is wrong still
        invalid,  ///< it does not compile
        failed    ///< there is no verdict: it could not be built or started
    };
    State state = State::running;
    uint64_t of = 0;  ///< answer_digest() when the check began
    int passed = 0, cases = 0;
    std::string words;  ///< what is wrong, or why there is no verdict; empty where all is said
    std::string hint;   ///< empty where there is none
};

class ExerciseChecks {
  public:
    /// Starts a check, anew where one is running. It builds first what it needs.
    void start(const std::string& exercise);

    /// True where one has ended since the last call.
    bool poll();

    /// The last check of an exercise; null where there was none.
    const CheckVerdict* find(const std::string& exercise) const;

  private:
    std::map<std::string, CheckVerdict> checks_;
    std::map<std::string, std::unique_ptr<ChildProcess>> jobs_;  ///< those that run
};

/// The verdict in what ./course check --json printed for an exercise when it ended with `code`.
CheckVerdict read_check(const std::string& exercise, const std::string& said, int code);

}  // namespace lightwalk
