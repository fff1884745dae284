// Detection of exercises that are still unchanged.
#pragma once
#include <cstdint>
#include <string_view>

namespace lightwalk {

/// Hash of the student's file, ignoring white space; 0 if missing. Cached by modification time and size.
uint64_t answer_digest(std::string_view id);

/// True if the file equals the starter in tests/starters.txt, ignoring white space; false if none is recorded.
bool is_untouched(std::string_view id);

}  // namespace lightwalk
