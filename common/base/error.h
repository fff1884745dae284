// Exceptions that end a program. main() prints one line and returns an exit code.
#pragma once
#include <fmt/core.h>

#include <source_location>
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

/// "file:line" of a C++ statement; files are relative to the course's folder (CMakeLists.txt).
inline std::string place_of(const std::source_location& where) {
    return fmt::format("{}:{}", where.file_name(), where.line());
}

/// Runs a check; the message of its Failure begins with the statement's file and line.
template <class Check>
void check_at(const std::source_location& where, const Check& check) {
    try {
        check();
    } catch (const Failure& e) { throw Failure("{}: {}", place_of(where), e.what()); }
}

}  // namespace lightwalk
