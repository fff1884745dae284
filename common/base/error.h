// Exceptions that end a program. main() prints one line and returns an exit code.
#pragma once
#include <fmt/core.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace lightwalk {

/// Text as is, or libfmt format with arguments: Failure("no mip {} in {}", i, name).
struct FormattedError : std::runtime_error {
    using std::runtime_error::runtime_error;
    template <class... Values>
    requires(sizeof...(Values) > 0) explicit FormattedError(fmt::format_string<Values...> format, Values&&... values)
        : std::runtime_error(fmt::format(format, std::forward<Values>(values)...)) {}
};

/// Invalid input: a file, an option, a value. Exit code 2. The text states fault, reason and remedy.
struct InputError : FormattedError {
    using FormattedError::FormattedError;
};

/// Error despite valid input: a shader that does not compile, a lost device. Exit code 1.
struct Failure : FormattedError {
    using FormattedError::FormattedError;
};

}  // namespace lightwalk
