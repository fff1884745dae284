// The two ways a program ends early. main() turns each into one line and an exit code.
#pragma once
#include <fmt/core.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace lightwalk {

/// Its text is given as is, or as a libfmt format with arguments: Failure("no mip {} in {}", i, name).
struct FormattedError : std::runtime_error {
    using std::runtime_error::runtime_error;
    template <class... Values>
    requires(sizeof...(Values) > 0) explicit FormattedError(fmt::format_string<Values...> format, Values&&... values)
        : std::runtime_error(fmt::format(format, std::forward<Values>(values)...)) {}
};

/// Bad input from outside: a file, an option, a value. Exit code 2. The text states the fault, the reason and the
/// remedy.
struct InputError : FormattedError {
    using FormattedError::FormattedError;
};

/// It failed although the input was fine: a shader that does not compile, a device that stopped. Exit code 1.
struct Failure : FormattedError {
    using FormattedError::FormattedError;
};

}  // namespace lightwalk
