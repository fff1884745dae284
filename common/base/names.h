// Names that a person may have meant.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "common/base/error.h"

namespace lightwalk {

/// How many letters to insert, delete, replace or swap with their neighbour make one text the other, case aside
/// (optimal string alignment: Damerau 1964). Texts of more than 64 bytes are compared by their first 64.
size_t edit_distance(std::string_view a, std::string_view b);

/// The `most` names nearest to a misspelt one, the nearest first. A name with a module before it, "shadow.filter", is
/// also found by its last part.
std::vector<std::string> nearest_names(std::string_view wrong, const std::vector<std::string>& names, size_t most = 2);

/// "unknown KIND 'WRONG'; the nearest are A and B; HOW": for a name that is not among `names`. `how` says how to list
/// all of them.
InputError unknown_name(std::string_view kind, std::string_view wrong, const std::vector<std::string>& names,
                        std::string_view how);

}  // namespace lightwalk
