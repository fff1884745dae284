// Crash messages.
#pragma once

namespace lightwalk {

/// Prints one line on stderr for a crash, with exit code 1 if memory ran out. Disabled under sanitizers.
void say_crashes();

}  // namespace lightwalk
