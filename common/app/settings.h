// A module's knob settings as bytes.
#pragma once
#include <string>

#include "common/app/module.h"

namespace lightwalk {

/// Values of all its knobs and its modules' knobs: a change invalidates derived data.
std::string settings_of(const Module& module);

}  // namespace lightwalk
