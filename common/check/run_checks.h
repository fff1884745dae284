// Program that checks a chapter's exercises. It is in the library, since some two hundred programs end in it.
#pragma once

namespace lightwalk {

/// Runs the checks that are linked in, and prints one JSON object for each. Returns the exit code.
int run_checks(int argc, char** argv);

}  // namespace lightwalk
