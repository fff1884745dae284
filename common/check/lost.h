// Failure of a process that runs student C++.
#pragma once
#include "common/base/error.h"

namespace lightwalk {

/// A process running student C++ crashed, timed out or sent invalid data. The text is a full sentence.
struct Lost : Failure {
    using Failure::Failure;
};

}  // namespace lightwalk
