// A model as bytes, handed over by the process that reads it, and validation of outside numbers.
#pragma once
#include <string>
#include <string_view>

#include "common/base/guarded.h"
#include "common/scene/mesh.h"

namespace lightwalk {

void write_model(const Model& model, GuardReply& reply);

/// Throws Failure, naming `file`, if the bytes are no model: too few of them, or an index out of range.
void read_bytes(std::string_view bytes, const std::string& file, Model& model);

/// Draws numbers of a material that no picture can be made of into their range (colours 0 to 1e4, shininess to 1e5,
/// opacity, roughness and metalness to 1, NaN to the default), with one warning that starts with `where`.
void limit_numbers(Material& material, const std::string& where);

}  // namespace lightwalk
