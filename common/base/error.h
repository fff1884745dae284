// The two ways a program ends early. main() turns each into one line and an exit code.
#pragma once
#include <stdexcept>
#include <string>

namespace lightwalk {

/// Bad input from outside: a file, an option, a value. Exit code 2. The text says what, why, and what would be right.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// It failed although the input was fine: a shader that does not compile, a device that stopped. Exit code 1.
struct Failure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace lightwalk
