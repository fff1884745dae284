// Statements of a 3MF file that Assimp takes no notice of.
#pragma once
#include <string>
#include <string_view>

#include "common/scene/mesh.h"

namespace lightwalk {

/// The length of its unit; names colours that are left out. `bytes`: the file, a ZIP of XML.
float metres_of_3mf(std::string_view bytes, Model& model);

}  // namespace lightwalk
