// Town module: as many objects as wanted, most of them hidden behind the houses of a street.
#pragma once
#include "common/app/module.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// Houses in rows along streets parallel to z: bodies, roofs, doors, windows, columns. Equal numbers
/// give equal towns on every machine.
std::vector<SceneObject> town_objects(int count);

// [town]
/// Adds a town to the scene's objects; declared before the modules that prepare them.
struct Town : Module {
    Town(Module& owner, std::string name) : Module(owner, std::move(name)) {}
    Knob<int> objects{*this, "objects", 0, {0, 1000000}, "Number of objects in a town added to the scene"};

    void prepare(Gpu& gpu, Scene& scene) override;
    std::string load_key() const override { return objects.text(); }
};
// [/town]

}  // namespace lightwalk
