// Sealed shaders: compiled by one run, for another that may not read the source.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "common/gpu/macros.h"

namespace lightwalk {

/// A stage as it is asked for: its file, all macros that are given to it, and its text where it has no file.
std::string sealed_name(const std::string& shader, const Macros& macros, const std::string& source);

/// Whether $LIGHTWALK_SHADERS_FROM names a folder: then no text is read, and a stage that is not in it throws ShaderError.
bool only_sealed();
std::vector<uint32_t> read_sealed(const std::string& name);

/// Puts a stage into the folder $LIGHTWALK_SHADERS_INTO, where one is named.
void seal(const std::string& name, const std::vector<uint32_t>& spirv);

}  // namespace lightwalk
