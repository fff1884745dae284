// The message of a program that crashes.
#pragma once

namespace lightwalk {

/// From now on a crash says one line on stderr before it ends the program. Where memory has ended, in which drivers and
/// libraries crash, the line says so and the exit code is 1; else the signal ends the program, as ever. A sanitizer's
/// own words are left alone.
void say_crashes();

}  // namespace lightwalk
