// What a call of a student's C++ in another process ends with where it does not come back.
#pragma once
#include "common/base/error.h"

namespace lightwalk {

/// The process crashed, gave no answer in time or said what is no answer. The text is a whole sentence.
struct Lost : Failure {
    using Failure::Failure;
};

}  // namespace lightwalk
