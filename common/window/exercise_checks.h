// The checks of exercises, run beside the window by the program that ./course check is.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "common/window/child_process.h"

namespace lightwalk {

/// Verdict of a check on an exercise.
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
    std::string words;  ///< the fault, or the reason for a missing verdict; empty: none
    std::string hint;   ///< empty if there is none
};

class ExerciseChecks {
  public:
    /// Starts or restarts a check; it builds its programs first.
    void start(const std::string& exercise);

    /// True if one has ended since the last call.
    bool poll();

    /// The last check of an exercise; null if there was none.
    const CheckVerdict* find(const std::string& exercise) const;

  private:
    std::map<std::string, CheckVerdict> checks_;
    std::map<std::string, std::unique_ptr<ChildProcess>> jobs_;  ///< running jobs
};

/// Reads the verdict of ./course check --json for an exercise from its output and exit code.
CheckVerdict read_check(const std::string& exercise, const std::string& said, int code);

/// Hash of the student's file, ignoring white space; 0 if missing. Cached by modification time and size.
uint64_t answer_digest(std::string_view id);

/// Last verdict on the student's file as it is, by a check from anywhere (./course check, a page); empty: not checked.
std::optional<bool> kept_verdict(std::string_view id);

/// Number of a chapter's exercises ("02_lambert"), and of those that are solved.
struct Solved {
    int solved = 0, exercises = 0;
};
Solved solved_of(std::string_view chapter);

/// True if the file equals the starter in tests/starters.txt, ignoring white space; false if none is recorded.
bool is_untouched(std::string_view id);

}  // namespace lightwalk
