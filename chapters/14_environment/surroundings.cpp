#include "14_environment/surroundings.h"

namespace lightwalk {

Surroundings::Surroundings(Module& owner, Music* heard)
    : World(owner), sphere(*this, "sphere", light, heard ? *heard : music) {
    objects.maps.method.change_default("normal");
    music.in_use = [this, heard] { return !heard && sphere.shown; };
}

// [frame]
void Surroundings::record(Frame& frame) {
    // Cubes of light, made once from the picture of the surroundings, or from six views of the scene itself.
    light.record(frame, scene());
    probe.record(frame, scene(), light, {backdrop, objects});
}
// [/frame]

}  // namespace lightwalk
