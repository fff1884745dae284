// Our three loaders must make the same of any bytes at all. For tests and fuzzing.
#pragma once
#include <string>
#include <string_view>

#include "01_obj/obj.h"

namespace lightwalk {

/// A loader's result for a text: data, or the position of its first error.
struct Outcome {
    ObjData data;
    std::string error;  ///< the whole message; empty where it read the text
    std::string place;  ///< "name:line" of the error
};
Outcome outcome_of(std::string_view text, Loader loader, ParseOptions options = {});

/// The first difference between the loaders' results for the text, with chunks of several sizes and one to three
/// threads; empty if they agree. Passes on exceptions other than InputError.
std::string disagreement(std::string_view text);

}  // namespace lightwalk
