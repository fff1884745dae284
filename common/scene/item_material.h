// Materials of scene items: the model's material with the scene file's overrides.
#pragma once
#include "common/scene/scene.h"

namespace lightwalk {

/// Sets material and transparency of an item whose maps are set. `bare`: SceneFile::bare.
void set_material(DrawItem& item, const MaterialOverride& with, bool bare);

MaterialData material_data(const DrawItem& item, float emission);

}  // namespace lightwalk
