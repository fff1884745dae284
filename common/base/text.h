// Messages to a person: text from files and options, made safe for a terminal.
#pragma once
#include <fmt/core.h>

#include <exception>
#include <string>
#include <string_view>

namespace lightwalk {

/// The text with every control character, and every byte that is not part of UTF-8, as \xNN: a name from outside can
/// then neither end a line of a message nor move the cursor. With `lines` line breaks and tabs stay.
std::string printable(std::string_view text, bool lines = false);

/// "warning: TEXT" on stderr, one line. Within run_guarded() it is said by the process that waits.
void warn(std::string_view text);
template <class... Values>
requires(sizeof...(Values) > 0) void warn(fmt::format_string<Values...> format, Values&&... values) {
    warn(std::string_view(fmt::format(format, std::forward<Values>(values)...)));
}

/// The same, but each text once per run.
void warn_once(const std::string& text);

/// Reports an exception from main(): "PREFIX: WHY" on stderr. Returns the exit code: 2 for bad input (one line), 1
/// for other failures. A name that the system refuses (too long, links in a circle) is bad input.
int report_exception(const std::exception& exception, const char* prefix = "error");

/// Where warnings go instead of stderr while this points somewhere: a line each. For run_guarded().
std::string*& collected_warnings();

}  // namespace lightwalk
