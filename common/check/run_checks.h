// Program that checks a chapter's exercises. It is in the library, since some two hundred programs end in it.
#pragma once
#include <string>

namespace lightwalk {

/// Of the command line.
struct CheckOptions {
    std::string nonce;    ///< the grader's word, which says that a line is of this program
    std::string worker;   ///< the grader's pipes to the process that has the student's C++: "WRITE,READ"
    bool strict = false;  ///< an exercise that cannot be instrumented is a failure
};

const CheckOptions& check_options();

/// Runs the checks that are linked in, and prints one JSON object for each. Returns the exit code.
int run_checks(int argc, char** argv);

}  // namespace lightwalk
