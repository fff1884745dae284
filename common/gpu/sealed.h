// Sealed shaders: compiled by one run, for another that may not read the source.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "common/gpu/macros.h"

namespace lightwalk {

/// A stage as it is asked for: its file, all macros that are given to it, and its text where it has no file.
std::string sealed_name(const std::string& shader, const Macros& macros, const std::string& source);

/// Folders, before the first shader; empty: none. `into` is given each stage that is compiled. With `from` no text is read,
/// and a stage that is not in it throws ShaderError.
void use_sealed(std::string into, std::string from);

bool only_sealed();
std::vector<uint32_t> read_sealed(const std::string& name);

void seal(const std::string& name, const std::vector<uint32_t>& spirv);

}  // namespace lightwalk
