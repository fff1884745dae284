// Messages with untrusted text, safe for terminals.
#pragma once
#include <fmt/core.h>

#include <exception>
#include <string>
#include <string_view>

namespace lightwalk {

/// Replaces control characters and invalid UTF-8 by \xNN. `lines`: keeps line breaks and tabs.
std::string printable(std::string_view text, bool lines = false);

/// Prints "warning: TEXT" on stderr, in one line. Within run_guarded(), the waiting process prints it.
void warn(std::string_view text);
template <class... Values>
requires(sizeof...(Values) > 0) void warn(fmt::format_string<Values...> format, Values&&... values) {
    warn(std::string_view(fmt::format(format, std::forward<Values>(values)...)));
}

void warn_once(const std::string& text);

/// Prints "PREFIX: WHY" on stderr for an exception in main(). Returns the exit code: 2 for invalid input, including
/// names that the system rejects (too long, circular links); 1 otherwise.
int report_exception(const std::exception& exception, const char* prefix = "error");

/// Collects warnings, one per line, instead of printing them; null: print. For run_guarded().
std::string*& collected_warnings();

}  // namespace lightwalk
