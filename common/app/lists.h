// The lists that --list prints.
#pragma once
#include "common/app/options.h"

namespace lightwalk {

/// Returns the exit code.
int print_list(const Options& options, Chapter& chapter);

}  // namespace lightwalk
