// Outcome of a student's C++ call in another process that never came back.
#pragma once
#include "common/base/error.h"

namespace lightwalk {

/// The process crashed, timed out or sent an invalid answer. The text is a whole sentence.
struct Lost : Failure {
    using Failure::Failure;
};

}  // namespace lightwalk
