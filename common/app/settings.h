// Hash of knob values, to invalidate derived data.
#pragma once
#include <string>

#include "common/app/module.h"

namespace lightwalk {

std::string settings_of(const Module& module);

}  // namespace lightwalk
