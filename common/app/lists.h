// Output of --list.
#pragma once
#include "common/app/options.h"

namespace lightwalk {

int print_list(const Options& options, Chapter& chapter);

}  // namespace lightwalk
