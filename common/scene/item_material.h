// Materials of a scene's items: the model's, with the numbers that the scene file states.
#pragma once
#include "common/scene/scene.h"

namespace lightwalk {

/// Numbers and kind of transparency of an item that has its maps. `bare`: SceneFile::bare.
void set_material(DrawItem& item, const MaterialOverride& with, bool bare);

/// For shaders. `emission`: SceneFile::emission.
MaterialData material_data(const DrawItem& item, float emission);

}  // namespace lightwalk
