// Names as people write them: small and large letters, words of a search, misspellings.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "common/base/error.h"

namespace lightwalk {

std::string lowercase(std::string_view text);  ///< of ASCII letters

/// Whether a text has all of these words, ignoring case.
bool has_words(std::string_view text, std::string_view words);

/// Edit distance ignoring case (optimal string alignment: Damerau 1964), of the first 64 bytes.
size_t edit_distance(std::string_view a, std::string_view b);

/// Up to `most` names nearest to a misspelt one, nearest first. "shadow.filter" is also found by "filter".
std::vector<std::string> nearest_names(std::string_view wrong, const std::vector<std::string>& names, size_t most = 2);

/// "unknown KIND 'WRONG'; the nearest are A and B; HOW". `how`: how to list all names.
InputError unknown_name(std::string_view kind, std::string_view wrong, const std::vector<std::string>& names,
                        std::string_view how);

}  // namespace lightwalk
