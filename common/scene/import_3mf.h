// Parts of 3MF files that Assimp ignores.
#pragma once
#include <string>
#include <string_view>

#include "common/scene/mesh.h"

namespace lightwalk {

/// Unit of length in metres; adds ignored colours to Model::left_out. `bytes`: the 3MF file, a ZIP archive of XML.
float metres_of_3mf(std::string_view bytes, Model& model);

}  // namespace lightwalk
