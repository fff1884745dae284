// Sealed shaders: SPIR-V compiled in one run for another that has no access to the source.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "common/gpu/macros.h"

namespace lightwalk {

/// File name of a stage, from its path, macros and inline source.
std::string sealed_name(const std::string& shader, const Macros& macros, const std::string& source);

/// Output and input folder, set before the first shader; empty: none. With `from`, a missing stage throws ShaderError.
void use_sealed(std::string into, std::string from);

bool only_sealed();
std::vector<uint32_t> read_sealed(const std::string& name);

void seal(const std::string& name, const std::vector<uint32_t>& spirv);

}  // namespace lightwalk
