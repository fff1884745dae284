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

/// File and line of a C++ statement, relative to the course's folder (CMakeLists.txt). It stands for std::source_location, which
/// Debian 12's Clang lacks.
struct SourceLocation {
    const char* file = "";
    unsigned line = 0;

    /// As a function's default argument: the statement that calls it.
    static constexpr SourceLocation current(const char* file = __builtin_FILE(), unsigned line = __builtin_LINE()) {
        return {file, line};
    }
};

/// "file:line".
inline std::string place_of(const SourceLocation& where) { return fmt::format("{}:{}", where.file, where.line); }

/// Runs a check; the message of its Failure begins with the statement's file and line.
template <class Check>
void check_at(const SourceLocation& where, const Check& check) {
    try {
        check();
    } catch (const Failure& e) { throw Failure("{}: {}", place_of(where), e.what()); }
}

}  // namespace lightwalk
