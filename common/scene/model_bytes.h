// Serialisation of models between processes, and validation of untrusted values.
#pragma once
#include <string>
#include <string_view>

#include "common/scene/mesh.h"

namespace lightwalk {

std::string model_bytes(const Model& model);

/// Throws Failure, naming `file`, if the bytes are truncated or an index is out of range.
void read_bytes(std::string_view bytes, const std::string& file, Model& model);

/// Clamps to usable ranges (colours 0 to 1e4, shininess to 1e5, others 0 to 1) with one warning, starting with `where`.
void limit_numbers(Material& material, const std::string& where);

}  // namespace lightwalk
