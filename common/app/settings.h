// What a module's knobs are set to, as text.
#pragma once
#include <string>

#include "common/app/module.h"

namespace lightwalk {

/// All of its knobs' values and those of its modules: where it changes, what was made with them is made again.
std::string settings_of(const Module& module);

}  // namespace lightwalk
