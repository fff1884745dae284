// Main function of check programs.
#pragma once
#include <string>

namespace lightwalk {

struct CheckOptions {
    std::string nonce;    ///< grader's token that authenticates output lines
    std::string worker;   ///< pipes to the grader's process with student C++: "WRITE,READ"
    bool strict = false;  ///< exercises that cannot be instrumented fail
};

const CheckOptions& check_options();

/// Runs the linked checks and prints one JSON object each. Returns the exit code.
int run_checks(int argc, char** argv);

}  // namespace lightwalk
